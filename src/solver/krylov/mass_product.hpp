// Products with the mass matrix of the fixed mesh, axis by axis.
#pragma once

#include "field/ghosts.hpp"

namespace softwet {

/// M_x (x) M_y (x) M_z with weight 1 for components of a vector of unknowns: entries (N_i, N_j) of the reference domain. An
/// axis costs 2 degree + 1 products for each value, and no element is visited.
/// Source: tensor products of one-dimensional mass matrices.   Tested: tests/unit/solver/krylov/test_mass_product.cpp
template <int D, int P>
class MassProduct {
 public:
  /// @param points  of the quadrature, for an element and an axis; degree + 1 are exact
  MassProduct(const Layout<D>&, int points);

  /// out = M in for the components [first, last), which are either velocities or scalars. Reads ghosts, which have to be
  /// filled. The sums of periodic axes are not complete: `move_ghosts(.., GhostAction::add)` does that.
  void apply(const Array& in, const Array& out, int first, int last) const;

 private:
  /// Entry (k, i) is M(i, i + k - degree).
  using Band = Kokkos::View<const double**, Kokkos::LayoutRight, Exec>;
  Band band(const Axis&, const std::vector<ElementRun>&, int first_function, int functions, int points) const;

  Layout<D> layout_;
  std::array<Band, D> velocity_, scalar_;
  Array scratch_[2];
};

}  // namespace softwet
