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

/// Those of the boxes of the first axis that touch a range of columns.
std::vector<int> touching(const Axis& axis, const std::vector<int>& start, int width, ColumnRange wanted) {
  std::vector<int> found;
  for (int s : start) {
    bool touches = false;
    for (int i = s; i < s + width; ++i) {
      const int column = axis.periodic() ? i % axis.owned() : i;
      touches = touches || (column >= wanted.first && column < wanted.last);
    }
    if (touches) found.push_back(s);
  }
  return found;
}

/// The unknowns of a box at an origin, as visit(site, unknown).
template <int D, class Visit>
void for_box(const Layout<D>& layout, const Stencil<D>& stencil, const UnknownTable<D>& table, const int* origin,
             int width, int sites, const Visit& visit) {
  const int shared = layout.has_solid && layout.has_fluid ? layout.wall_row : -1;
  for (int s = 0; s < sites; ++s) {
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
    if (unknown >= 0) visit(s, unknown);
  }
}

/// The boxes in order, as visit(origin): the first axis is the fastest.
template <int D, class Visit>
void for_origins(const std::vector<int> (&starts)[D], const Visit& visit) {
  int count = 1;
  for (int d = 0; d < D; ++d) count *= static_cast<int>(starts[d].size());
  for (int box = 0; box < count; ++box) {
    int origin[D];
    for (int d = 0, rest = box; d < D; ++d) {
      origin[d] = starts[d][rest % starts[d].size()];
      rest /= static_cast<int>(starts[d].size());
    }
    visit(origin);
  }
}

}  // namespace

template <int D>
PatchTables make_patches(const Layout<D>& layout, const UnknownTable<D>& table, int width, int stride,
                         ColumnRange wanted) {
  const Stencil<D> stencil(layout);
  std::vector<int> starts[D];
  PatchTables t;
  t.sites = stencil.components;
  for (int d = 0; d < D; ++d) {
    const bool on_wall = d == D - 1 && layout.has_solid && layout.has_fluid;
    starts[d] = box_starts(layout.axis[d], width, stride, on_wall ? layout.wall_row : 0);
    t.sites *= width;
  }
  t.holders.assign(layout.size(), 0);
  for_origins<D>(starts, [&](const int* origin) {
    for_box(layout, stencil, table, origin, width, t.sites, [&](int, int unknown) { ++t.holders[unknown]; });
  });
  starts[0] = touching(layout.axis[0], starts[0], width, wanted);
  t.row = static_cast<int>(starts[0].size());
  std::vector<std::vector<int>> dof;
  for_origins<D>(starts, [&](const int* origin) {
    t.start.insert(t.start.end(), origin, origin + D);
    const std::size_t first = t.local.size();
    t.local.resize(first + t.sites, -1);
    std::vector<int>& unknowns = dof.emplace_back();
    for_box(layout, stencil, table, origin, width, t.sites, [&](int site, int unknown) {
      t.local[first + site] = static_cast<int>(unknowns.size());
      unknowns.push_back(unknown);
    });
    t.size.push_back(static_cast<int>(unknowns.size()));
    t.unknowns = std::max(t.unknowns, t.size.back());
  });
  t.count = static_cast<int>(dof.size());
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

template PatchTables make_patches<2>(const Layout<2>&, const UnknownTable<2>&, int, int, ColumnRange);
template PatchTables make_patches<3>(const Layout<3>&, const UnknownTable<3>&, int, int, ColumnRange);

}  // namespace softwet
