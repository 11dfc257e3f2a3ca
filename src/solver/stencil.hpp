// The Jacobian with frozen geometry as a matrix, and where its rows and columns lie among the unknowns.
#pragma once

#include <functional>
#include <vector>

#include "field/ghosts.hpp"
#include "solver/transfer_sums.hpp"

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

/// What products with a matrix read: its values, or a copy of them in 16 bits, which costs half of the memory traffic.
enum class Products { single, sixteen_bits };

/// How a vector is stored for a product: lines with a margin at both ends. A line is one along the first axis, or all
/// control points where no axis is periodic.
struct StencilLines {
  int length = 0, margin = 0, stored = 0;
};

/// The matrix. Values are allocated by the first fill, so that its size can be counted before.
template <int D>
class StencilMatrix {
 public:
  StencilMatrix(const Layout<D>& layout, const ConstArray& mask, Products products = Products::single);

  void fill(const Jacobian& jacobian);
  /// Rows of the copies of other processes' columns: fill makes only a process's own rows.
  void update_copies() const;
  /// y = A x; prescribed values and ghosts of x count as zero, those of y are zero.
  void multiply(const ConstArray& x, const Array& y) const;
  /// y = r - A x, likewise
  void residual(const ConstArray& r, const ConstArray& x, const Array& y) const;
  /// The same, for a vector whose entries the kernel computes that needs them.
  void residual(const ConstArray& r, const SumAllAxes<D, double>& x, const Array& y) const;

  const Layout<D>& layout() const { return layout_; }
  const Stencil<D>& stencil() const { return stencil_; }
  const StencilValues& values() const { return values_; }
  ConstArray mask() const { return mask_; }
  double bytes() const { return (products_ == Products::single ? 4.0 : 6.0) * stencil_.size(); }

 private:
  template <class Vector>
  void multiply_into(const ConstArray& r, const Vector& x, const Array& y) const;

  Layout<D> layout_;
  Stencil<D> stencil_;
  ConstArray mask_;
  StencilValues values_;
  Products products_;
  Kokkos::View<std::uint16_t*, Exec> narrow_;  ///< the copy in 16 bits
  StencilValues spread_;                       ///< the vector of a product, line by line
  StencilLines lines_;
};

/// Calls visit(row point, place) for every control point whose rows have entries in the columns of another. The entry of the
/// components a and u is the value place + pair(a, u) offsets points. Around a short periodic axis a row may come
/// more than once; its entry is the sum.
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
