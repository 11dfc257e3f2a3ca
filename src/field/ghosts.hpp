// Ghost control points, copies of others: of periodic axes, and of the columns of other processes. The only place that
// moves data between parts of a vector.
#pragma once

#include "field/exchange.hpp"
#include "field/stencil.hpp"

namespace softwet {

/// One component as a box [k][j][i] inside an array.
template <int D>
struct Box {
  int offset = 0;
  int extent[D] = {};
};

/// Boxes of all components of a vector of unknowns.
template <int D>
std::vector<Box<D>> boxes(const Layout<D>& layout) {
  std::vector<Box<D>> result;
  const auto push = [&](int offset, int rows) {
    Box<D> b;
    b.offset = offset;
    for (int d = 0; d + 1 < D; ++d) b.extent[d] = layout.extent(d);
    b.extent[D - 1] = rows;
    result.push_back(b);
  };
  for (int d = 0; d < D; ++d) push(layout.velocity_offset(d), layout.rows);
  if (layout.has_fluid) {
    push(layout.density_offset(), layout.fluid_rows());
    push(layout.potential_offset(), layout.fluid_rows());
  }
  return result;
}

enum class GhostAction { update, add };

/// Index of ghost `g` (0 .. ghosts x cross section) of a box along an axis, and of the owned value it repeats.
template <int D>
struct GhostPair {
  Box<D> box;
  int axis, owned;

  KOKKOS_FUNCTION void operator()(int g, int& ghost, int& own) const {
    int stride = 1, s[D];
    for (int d = 0; d < D; ++d) {
      s[d] = stride;
      stride *= box.extent[d];
    }
    const int ghosts = box.extent[axis] - owned;
    int index = box.offset;
    for (int d = 0; d < D; ++d) {
      const int n = d == axis ? ghosts : box.extent[d];
      index += (g % n) * s[d];
      g /= n;
    }
    own = index;
    ghost = index + owned * s[axis];
  }
};

template <int D, class Real>
struct MoveGhosts {
  GhostPair<D> pair;
  ArrayOf<Real> vector;
  GhostAction action;
  KOKKOS_FUNCTION void operator()(int g) const {
    int ghost = 0, own = 0;
    pair(g, ghost, own);
    if (action == GhostAction::update) {
      vector(ghost) = vector(own);
    } else {
      vector(own) += vector(ghost);
      vector(ghost) = 0;
    }
  }
};

/// Whether the last stored functions of an axis are ghosts whose sums belong to its first ones: on a periodic axis.
/// Among several processes only the first has them (spline/columns.hpp).
template <int D>
bool closes(const Layout<D>& layout, int d) {
  return layout.axis[d].periodic() && (d > 0 || layout.columns.rank == 0);
}

/// Whether anything is a copy of something else.
template <int D>
bool has_ghosts(const Layout<D>& layout) {
  bool any = !layout.whole();
  for (const Axis& axis : layout.axis) any = any || axis.periodic();
  return any;
}

/// update: ghosts take the value of the control point they repeat. add: its transpose for the ghosts of periodic axes,
/// which are left at zero; copies of the columns of other processes mean nothing then.
template <int D, class Real>
void move_ghosts(const Layout<D>& layout, const ArrayOf<Real>& vector, GhostAction action) {
  for (int d = 0; d < D; ++d) {
    if (d == 0 && !layout.whole() && action == GhostAction::update) {
      update_columns(layout.columns, *layout.exchange, vector);
      continue;
    }
    if (!closes(layout, d)) continue;
    const int ghosts = layout.axis[d].degree();
    for (const Box<D>& box : boxes(layout)) {
      int items = ghosts;
      for (int e = 0; e < D; ++e) items *= e == d ? 1 : box.extent[e];
      Kokkos::parallel_for("softwet::ghosts", Items(0, items),
                           MoveGhosts<D, Real>{{box, d, box.extent[d] - ghosts}, vector, action});
    }
  }
}

template <int D>
struct FoldGhosts {
  GhostPair<D> pair;
  StencilValues values;
  int ghosts, points;
  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    int ghost = 0, own = 0;
    pair(static_cast<int>(item % ghosts), ghost, own);
    const std::int64_t entry = item / ghosts * points;
    values(entry + own) += values(entry + ghost);
    values(entry + ghost) = 0;
  }
};

/// Adds the rows of ghosts to the rows of the control points that they repeat.
template <int D>
void fold_ghosts(const Layout<D>& layout, const Stencil<D>& stencil, const StencilValues& values) {
  for (int d = 0; d < D; ++d) {
    if (!closes(layout, d)) continue;
    Box<D> box;
    int ghosts = layout.axis[d].degree();
    const int owned = stencil.extent[d] - ghosts;
    for (int e = 0; e < D; ++e) {
      box.extent[e] = stencil.extent[e];
      ghosts *= e == d ? 1 : stencil.extent[e];
    }
    Kokkos::parallel_for("softwet::fold_ghosts", LongItems(0, stencil.size() / stencil.points * ghosts),
                         FoldGhosts<D>{{box, d, owned}, values, ghosts, stencil.points});
  }
}

}  // namespace softwet
