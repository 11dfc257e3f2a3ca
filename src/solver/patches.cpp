#include "solver/patches.hpp"

#include <algorithm>

namespace softwet {

namespace {

/// Appends first + i span / count, i = 1 .. count, with the least count of steps up to `stride`.
void append_evenly(std::vector<int>& start, int last, int stride) {
  const int first = start.back(), span = last - first, count = (span + stride - 1) / stride;
  for (int i = 1; i <= count; ++i) start.push_back(first + i * span / count);
}

/// First control points of the boxes of one axis. One box has `middle` in its middle, as far as the ends allow.
std::vector<int> box_starts(const Axis& axis, int width, int stride, int middle) {
  const int n = axis.owned();
  std::vector<int> start{0};
  if (width >= n) return start;
  if (axis.periodic()) {
    append_evenly(start, n, stride);
    start.pop_back();
    return start;
  }
  append_evenly(start, std::clamp(middle - width / 2, 0, n - width), stride);
  append_evenly(start, n - width, stride);
  return start;
}

}  // namespace

template <int D>
PatchTables make_patches(const Layout<D>& layout, const UnknownTable<D>& table, int width, int stride) {
  const Stencil<D> stencil(layout);
  const int shared = layout.has_solid && layout.has_fluid ? layout.wall_row : -1;
  std::vector<int> starts[D];
  PatchTables t;
  t.count = 1;
  t.sites = stencil.components;
  for (int d = 0; d < D; ++d) {
    starts[d] = box_starts(layout.axis[d], width, stride, d == D - 1 ? std::max(shared, 0) : 0);
    t.count *= static_cast<int>(starts[d].size());
    t.sites *= width;
  }
  t.row = static_cast<int>(starts[0].size());
  std::vector<std::vector<int>> dof(t.count);
  t.local.assign(static_cast<std::size_t>(t.count) * t.sites, -1);
  for (int box = 0; box < t.count; ++box) {
    int origin[D];
    for (int d = 0, rest = box; d < D; ++d) {
      origin[d] = starts[d][rest % starts[d].size()];
      rest /= static_cast<int>(starts[d].size());
      t.start.push_back(origin[d]);
    }
    for (int s = 0; s < t.sites; ++s) {
      int point = 0, step = 1, rest = s / stencil.components;
      bool inside = true;
      for (int d = 0; d < D; ++d) {
        const int along = rest % width, i = along < layout.axis[d].owned() ? stencil.moved(origin[d], along, d) : -1;
        rest /= width;
        inside = inside && i >= 0 && !(d == D - 1 && i == shared && (along == 0 || along == width - 1));
        point += step * i;
        step *= stencil.extent[d];
      }
      const int unknown = inside ? table.unknown(s % stencil.components, point) : -1;
      if (unknown < 0) continue;
      t.local[static_cast<std::size_t>(box) * t.sites + s] = static_cast<int>(dof[box].size());
      dof[box].push_back(unknown);
    }
    t.size.push_back(static_cast<int>(dof[box].size()));
    t.unknowns = std::max(t.unknowns, t.size[box]);
  }
  t.dof.assign(static_cast<std::size_t>(t.count) * t.unknowns, -1);
  std::vector<std::vector<int>> places(layout.size());
  for (int box = 0; box < t.count; ++box)
    for (int i = 0; i < t.size[box]; ++i) {
      const int at = box * t.unknowns + i;
      t.dof[at] = dof[box][i];
      places[dof[box][i]].push_back(at);
    }
  for (const std::vector<int>& group : places) {
    t.grouped.push_back(static_cast<int>(t.place.size()));
    t.place.insert(t.place.end(), group.begin(), group.end());
  }
  t.grouped.push_back(static_cast<int>(t.place.size()));
  return t;
}

template PatchTables make_patches<2>(const Layout<2>&, const UnknownTable<2>&, int, int);
template PatchTables make_patches<3>(const Layout<3>&, const UnknownTable<3>&, int, int);

}  // namespace softwet
