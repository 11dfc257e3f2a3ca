// The Jacobian with frozen geometry as a matrix, and where its rows and columns lie among the unknowns.
#pragma once

#include <functional>
#include <vector>

#include "field/ghosts.hpp"
#include "field/stencil.hpp"

namespace softwet {

/// Writes the values of the Jacobian with frozen geometry at the current point, ordered as in Stencil<D>.
using Jacobian = std::function<void(const StencilValues& values)>;

/// Which unknown each component of each control point is. Prescribed values and ghosts are none.
template <int D>
class UnknownTable {
 public:
  UnknownTable(const Layout<D>& layout, const std::vector<double>& mask);
  int unknowns() const { return static_cast<int>(point_.size()); }
  int unknown(int component, int point) const { return unknown_[component * points_ + point]; }  ///< -1: none
  int component(int unknown) const { return component_[unknown]; }                               ///< -1: prescribed
  int point(int unknown) const { return point_[unknown]; }

 private:
  int points_;
  std::vector<int> unknown_, component_, point_;
};

/// The matrix. Values are allocated by the first fill, so that its size can be counted before.
template <int D>
class StencilMatrix {
 public:
  StencilMatrix(const Layout<D>& layout, const ConstArray& mask);

  void fill(const Jacobian& jacobian);
  /// Rows of the copies of other processes' columns: fill makes only a process's own rows.
  void update_copies() const;
  /// y = A x; prescribed values and ghosts of x count as zero, and are zero in y.
  void multiply(const ConstArray& x, const Array& y) const;

  const Layout<D>& layout() const { return layout_; }
  const Stencil<D>& stencil() const { return stencil_; }
  const StencilValues& values() const { return values_; }
  ConstArray mask() const { return mask_; }
  double bytes() const { return 4.0 * stencil_.size(); }

 private:
  Layout<D> layout_;
  Stencil<D> stencil_;
  ConstArray mask_;
  StencilValues values_;
  StencilValues spread_;  ///< the vector of a product, line by line
  int stored_;            ///< of a line
};

/// Calls visit(row point, place) for every control point whose rows have entries in the columns of another. The entry
/// of the components a and u is the value place + pair(a, u) offsets points. Around a short periodic axis a row may
/// come more than once; its entry is the sum.
template <int D, class Visit>
void for_column_point(const Stencil<D>& stencil, int column, const Visit& visit) {
  for (int offset = 0; offset < stencil.offsets; ++offset) {
    const int from = stencil.neighbour(column, stencil.offsets - 1 - offset);  // the opposite offset
    if (from >= 0) visit(from, stencil.index(0, 0, offset, from));
  }
}

/// Calls visit(row unknown, index of the value) for every entry in the column of an unknown, also as above.
template <int D, class Visit>
void for_column(const Stencil<D>& stencil, const UnknownTable<D>& table, int column, const Visit& visit) {
  const int u = table.component(column);
  for_column_point(stencil, table.point(column), [&](int from, std::int64_t place) {
    for (int a = 0; a < stencil.components; ++a) {
      if (!stencil.couples(a, u)) continue;
      const int row = table.unknown(a, from);
      if (row >= 0) visit(row, place + stencil.index(a, u, 0, 0));
    }
  });
}

}  // namespace softwet
