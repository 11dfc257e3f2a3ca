// Edit distance over dotted names.
#include "casefile/schema/nearest.hpp"

#include <algorithm>
#include <limits>

namespace softwet {
namespace {

constexpr int far = std::numeric_limits<int>::max();

std::string_view last_part(std::string_view name) {
  const auto dot = name.rfind('.');
  return dot == std::string_view::npos ? name : name.substr(dot + 1);
}

std::string_view first_part(std::string_view name) { return name.substr(0, name.size() - last_part(name).size()); }

/// Whether `part` occurs in `name` from one '_' to another: "angle" in "contact_angle".
bool is_part(std::string_view part, std::string_view name) {
  constexpr std::size_t least = 3;
  for (auto at = name.find(part); part.size() >= least && at != std::string_view::npos; at = name.find(part, at + 1)) {
    const std::size_t end = at + part.size();
    if ((at == 0 || name[at - 1] == '_') && (end == name.size() || name[end] == '_')) return true;
  }
  return false;
}

/// The letters a word may have wrong and still be meant: one of three, three at most.
int tolerated(std::string_view word) { return std::min(3, static_cast<int>(word.size() + 1) / 3); }

/// How far a word is from a known name; `far` where nobody would take it for that name.
int distance_to(std::string_view word, std::string_view name) {
  const std::string_view leaf = last_part(word), known = last_part(name);
  const int whole = edit_distance(word, name);
  if (whole <= tolerated(leaf)) return 10 * whole;
  if (first_part(word) != first_part(name) && leaf != word) return far;  // a key of another table
  const int letters = edit_distance(leaf, known);
  if (letters <= tolerated(leaf)) return 10 * letters + 1;
  return is_part(leaf, known) || is_part(known, leaf) ? 50 : far;
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
  word = word.substr(0, 100);  // longer than any name: the rest adds nothing and would take long
  std::string best;
  int best_distance = far;
  for (const std::string& name : known) {
    const int distance = distance_to(word, name);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = name;
  }
  return best;
}

}  // namespace softwet
