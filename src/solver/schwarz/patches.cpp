#include "solver/schwarz/patches.hpp"

#include <algorithm>
#include <numeric>

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

/// Stored column of each function of the first axis, and of `width` more behind it.
template <int D>
std::vector<int> columns_of(const Layout<D>& layout, int width) {
  const Axis& axis = layout.axis[0];
  const std::vector<int> place = places_of_functions(axis, layout.columns);
  std::vector<int> column(axis.owned() + width, -1);
  for (int f = 0; f < axis.owned() + width; ++f)
    if (axis.periodic() || f < axis.owned()) column[f] = place[f % axis.owned()];
  return column;
}

/// The boxes of the first axis that touch a process's own columns.
template <int D>
std::vector<int> touching(const Layout<D>& layout, const std::vector<int>& start, const std::vector<int>& column,
                          int width) {
  std::vector<int> found;
  const int owned = layout.axis[0].owned();  // the copies behind the end of a periodic axis are nobody's own here
  const auto own = [&](int i) { return i >= 0 && layout.own(i, 0) && layout.function(i, 0) < owned; };
  for (int s : start) {
    bool touches = false;
    for (int f = s; f < s + width; ++f) touches = touches || own(column[f]);
    if (touches) found.push_back(s);
  }
  return found;
}

/// Whether a box has no place `along` it, at function i of axis d: it goes once around a periodic axis at most, and
/// leaves out the row that solid and fluid share where that is its first or last one.
template <int D>
bool left_out(const Layout<D>& layout, int d, int i, int along, int width) {
  const bool shared = d == D - 1 && layout.has_solid && layout.has_fluid && i == layout.wall_row;
  return along >= layout.axis[d].owned() || (shared && (along == 0 || along == width - 1));
}

/// The unknowns of a box at an origin, as visit(site, unknown).
template <int D, class Visit>
void for_box(const Layout<D>& layout, const Stencil<D>& stencil, const UnknownTable<D>& table,
             const std::vector<int>& column, const int* origin, int width, int sites, const Visit& visit) {
  for (int s = 0; s < sites; ++s) {
    int point = 0, step = 1, rest = s / stencil.components;
    bool inside = true;
    for (int d = 0; d < D; ++d) {
      const int along = rest % width, i = d == 0 ? column[origin[0] + along] : stencil.moved(origin[d], along, d);
      rest /= width;
      inside = inside && i >= 0 && !left_out(layout, d, i, along, width);
      point += step * i;
      step *= stencil.extent[d];
    }
    const int unknown = inside ? table.unknown(s % stencil.components, point) : -1;
    if (unknown >= 0) visit(s, unknown);
  }
}

/// How many boxes of the whole patch hold each unknown: the product over the axes.
template <int D>
std::vector<int> count_holders(const Layout<D>& layout, const Stencil<D>& stencil, const UnknownTable<D>& table,
                               const std::vector<int> (&starts)[D], int width) {
  std::vector<int> of_function[D], holders(layout.size(), 0);
  for (int d = 0; d < D; ++d) {
    const Axis& axis = layout.axis[d];
    of_function[d].assign(axis.functions(), 0);
    for (int s : starts[d])
      for (int along = 0; along < width; ++along) {
        const int f = wrapped(s + along, axis.owned(), axis.periodic() ? axis.owned() : 0);
        if (f >= 0 && !left_out(layout, d, f, along, width)) ++of_function[d][f];
      }
    for (int f = axis.owned(); f < axis.functions(); ++f) of_function[d][f] = of_function[d][f - axis.owned()];
  }
  for (int point = 0; point < stencil.points; ++point) {
    int count = 1;
    for (int d = 0; d < D; ++d) count *= of_function[d][layout.function(stencil.coordinate(point, d), d)];
    for (int c = 0; c < stencil.components; ++c)
      if (const int unknown = table.unknown(c, point); unknown >= 0) holders[unknown] = count;
  }
  return holders;
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

/// The unknowns of each box, and of each unknown its places in the boxes, in their order.
void store_unknowns(PatchTables& t, const std::vector<int>& unknowns, int all) {
  t.dof.assign(static_cast<std::size_t>(t.count) * t.unknowns, -1);
  t.grouped.assign(all + 1, 0);
  for (int unknown : unknowns) ++t.grouped[unknown + 1];
  std::partial_sum(t.grouped.begin(), t.grouped.end(), t.grouped.begin());
  t.place.resize(unknowns.size());
  std::vector<int> next(t.grouped.begin(), t.grouped.end() - 1);
  auto unknown = unknowns.begin();
  for (int box = 0; box < t.count; ++box)
    for (int i = 0; i < t.size[box]; ++i, ++unknown) {
      const int at = box * t.unknowns + i;
      t.dof[at] = *unknown;
      t.place[next[*unknown]++] = at;
    }
}

}  // namespace

template <int D>
PatchTables make_patches(const Layout<D>& layout, const UnknownTable<D>& table, int width, int stride) {
  const Stencil<D> stencil(layout);
  std::vector<int> starts[D];
  PatchTables t;
  t.sites = stencil.components;
  for (int d = 0; d < D; ++d) {
    const bool on_wall = d == D - 1 && layout.has_solid && layout.has_fluid;
    starts[d] = box_starts(layout.axis[d], width, stride, on_wall ? layout.wall_row : 0);
    t.sites *= width;
  }
  t.holders = count_holders<D>(layout, stencil, table, starts, width);
  t.column = columns_of(layout, width);
  starts[0] = touching(layout, starts[0], t.column, width);
  t.row = static_cast<int>(starts[0].size());
  t.rows = static_cast<int>(starts[1].size());
  std::vector<int> unknowns;  // of all boxes, one box after the other
  for_origins<D>(starts, [&](const int* origin) {
    t.start.insert(t.start.end(), origin, origin + D);
    const std::size_t first = t.local.size(), before = unknowns.size();
    t.local.resize(first + t.sites, -1);
    for_box(layout, stencil, table, t.column, origin, width, t.sites, [&](int site, int unknown) {
      t.local[first + site] = static_cast<int>(unknowns.size() - before);
      unknowns.push_back(unknown);
    });
    t.size.push_back(static_cast<int>(unknowns.size() - before));
    t.unknowns = std::max(t.unknowns, t.size.back());
  });
  t.count = static_cast<int>(t.size.size());
  store_unknowns(t, unknowns, layout.size());
  return t;
}

template PatchTables make_patches<2>(const Layout<2>&, const UnknownTable<2>&, int, int);
template PatchTables make_patches<3>(const Layout<3>&, const UnknownTable<3>&, int, int);

}  // namespace softwet
