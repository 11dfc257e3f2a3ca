#include "solver/patches.hpp"

#include "solver/colours.hpp"

#include <algorithm>

namespace softwet {

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

}  // namespace softwet
