// Edit distance over dotted names.
#include "app/host/nearest.hpp"

#include <algorithm>
#include <limits>

namespace softwet {
namespace {

std::string_view last_part(std::string_view name) {
  const auto dot = name.rfind('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

}  // namespace

int edit_distance(std::string_view from, std::string_view to) {
  const std::size_t rows = from.size() + 1, columns = to.size() + 1;
  std::vector<std::vector<int>> cost(rows, std::vector<int>(columns));
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = static_cast<int>(i + j);
        continue;
      }
      const int replace = cost[i - 1][j - 1] + (from[i - 1] != to[j - 1]);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[rows - 1][columns - 1];
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& known) {
  word = word.substr(0, 100);  // longer than any name: the rest tells nothing and would take long
  std::string best;
  int best_distance = std::numeric_limits<int>::max();
  for (const std::string& name : known) {
    const int whole = edit_distance(word, name);
    const int leaf = edit_distance(last_part(word), last_part(name)) + 1;  // right word, wrong table
    // Two leaves at the same distance: the one whose whole name is closer.
    const int distance = std::min(whole, leaf) * 1000 + std::min(whole, 999);
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace softwet
