#include "solver/patches.hpp"

#include <algorithm>

namespace softwet {

namespace {

/// Calls visit(unknown, component, point) for every stored unknown; point: control point of the patch.
template <int D, class Visit>
void for_unknowns(const Layout<D>& layout, const Visit& visit) {
  const std::vector<Box<D>> all = boxes(layout);
  for (std::size_t c = 0; c < all.size(); ++c) {
    int points = 1;
    for (int d = 0; d < D; ++d) points *= all[c].extent[d];
    for (int p = 0; p < points; ++p) {
      int point[3] = {0, 0, 0};
      for (int d = 0, rest = p; d < D; ++d) {
        point[d] = rest % all[c].extent[d];
        rest /= all[c].extent[d];
      }
      if (c >= static_cast<std::size_t>(D)) point[D - 1] += layout.wall_row;
      visit(all[c].offset + p, static_cast<int>(c), point);
    }
  }
}

}  // namespace

std::vector<int> axis_colours(const Axis& axis) {
  const int width = 2 * axis.degree() + 1, n = axis.owned();
  const int regular = axis.periodic() ? n - n % width : n;
  std::vector<int> colour(axis.functions());
  for (int i = 0; i < n; ++i) colour[i] = i < regular ? i % width : width + i - regular;
  for (int i = n; i < axis.functions(); ++i) colour[i] = colour[i - n];
  return colour;
}

template <int D>
Colours make_colours(const Layout<D>& layout, const std::vector<double>& mask) {
  Colours result;
  result.of.assign(layout.size(), -1);
  result.point.assign(3 * static_cast<std::size_t>(layout.size()), 0);
  std::vector<int> colour[D];
  int total[D];
  for (int d = 0; d < D; ++d) {
    colour[d] = axis_colours(layout.axis[d]);
    total[d] = *std::max_element(colour[d].begin(), colour[d].end()) + 1;
  }
  for_unknowns(layout, [&](int unknown, int component, const int* point) {
    int key = component;
    for (int d = 0; d < D; ++d) {
      key = key * total[d] + colour[d][point[d]];
      result.point[3 * unknown + d] = point[d];
    }
    if (mask[unknown] == 0) return;
    result.of[unknown] = key;
    result.count = std::max(result.count, key + 1);
  });
  return result;
}

template <int D>
PatchTables make_patches(const Layout<D>& layout, const std::vector<double>& mask, int core, int overlap) {
  int boxes_of[D], total = 1;
  for (int d = 0; d < D; ++d) {
    boxes_of[d] = std::max(1, (layout.axis[d].owned() + core / 2) / core);
    total *= boxes_of[d];
  }
  // Boxes of an axis whose core (overlap 0) or whole holds control point i, periodically.
  const auto holds = [&](int d, int box, int i, int reach) {
    const Axis& axis = layout.axis[d];
    const int n = axis.owned(), first = box * n / boxes_of[d] - reach, last = (box + 1) * n / boxes_of[d] + reach;
    if (i >= first && i < last) return true;
    return axis.periodic() && ((i + n >= first && i + n < last) || (i - n >= first && i - n < last));
  };
  std::vector<std::vector<int>> inner(total), outer(total);
  for_unknowns(layout, [&](int unknown, int, const int* point) {
    if (mask[unknown] == 0) return;
    for (int b = 0; b < total; ++b) {
      bool in_core = true, in_box = true;
      for (int d = 0, rest = b; d < D; ++d) {
        in_core = in_core && holds(d, rest % boxes_of[d], point[d], 0);
        in_box = in_box && holds(d, rest % boxes_of[d], point[d], overlap);
        rest /= boxes_of[d];
      }
      if (in_box) (in_core ? inner : outer)[b].push_back(unknown);
    }
  });
  PatchTables t;
  t.count = total;
  for (int b = 0; b < total; ++b) {
    t.core.push_back(static_cast<int>(inner[b].size()));
    inner[b].insert(inner[b].end(), outer[b].begin(), outer[b].end());
    t.size.push_back(static_cast<int>(inner[b].size()));
    t.unknowns = std::max(t.unknowns, t.size[b]);
    t.cores = std::max(t.cores, t.core[b]);
  }
  t.dof.assign(static_cast<std::size_t>(total) * t.unknowns, -1);
  for (int b = 0; b < total; ++b)
    std::copy(inner[b].begin(), inner[b].end(), t.dof.begin() + static_cast<std::size_t>(b) * t.unknowns);
  return t;
}

template PatchTables make_patches<2>(const Layout<2>&, const std::vector<double>&, int, int);
template PatchTables make_patches<3>(const Layout<3>&, const std::vector<double>&, int, int);
template Colours make_colours<2>(const Layout<2>&, const std::vector<double>&);
template Colours make_colours<3>(const Layout<3>&, const std::vector<double>&);

}  // namespace softwet
