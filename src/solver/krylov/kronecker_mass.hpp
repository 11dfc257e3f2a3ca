// Inverse of the Kronecker product of one-dimensional mass matrices: the preconditioner of consistent masses.
#pragma once

#include "field/ghosts.hpp"

namespace softwet {

/// One-dimensional mass matrix of B-splines as banded factors L D L^T: entry (i, 0) is 1 / D_i, entry (i, k) is
/// L(i, i - k). Functions that are held or ghosts are left out (identity). A periodic axis is treated as if it ended.
using BandedFactors = Kokkos::View<const double**, Kokkos::LayoutRight, Exec>;

/// For each component of a vector of unknowns the mass matrix M_x (x) M_y (x) M_z of the fixed mesh with weight 1, or r
/// in (r, z).
template <int D>
class KroneckerMass {
 public:
  /// @param points  of the quadrature, for an element and an axis
  KroneckerMass(const Layout<D>&, int points, const ConstArray& mask);

  /// Whether the solution is exact: no axis is periodic.
  bool exact() const { return exact_; }

  /// In place: x = M^{-1} x for the components [first, last): velocities 0 .. D - 1, density D, potential D + 1.
  void solve(const Array& x, int first, int last) const;

  /// Row sums of M in the layout of the unknowns: the integrals of the basis functions.
  ConstArray row_sums() const { return row_sums_; }

 private:
  void solve_lines(const Array& x, int first, int last) const;

  Layout<D> layout_;
  Array patch_;                ///< a vector of the whole patch, where a process stores a part of it
  std::vector<Box<D>> boxes_;  ///< of the whole patch
  std::vector<std::array<BandedFactors, D>> factors_;  ///< by component and axis
  Array row_sums_;
  bool exact_ = true;
};

}  // namespace softwet
