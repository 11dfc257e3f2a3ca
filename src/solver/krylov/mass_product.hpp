// Products with the mass matrix of the fixed mesh, axis by axis.
#pragma once

#include "field/ghosts.hpp"
#include "solver/krylov/band_product.hpp"

namespace softwet {

/// M = M_x (x) M_y (x) M_z for components of a vector of unknowns: entries (N_i, N_j) of the reference domain, in (r,
/// z) with the weight r.
/// An axis costs 2 degree + 1 products for each value, and no element is visited.
/// Source: tensor products of one-dimensional mass matrices.   Tested: tests/unit/solver/krylov/test_mass_product.cpp
template <int D, int P>
class MassProduct {
 public:
  /// @param points  of the quadrature, for an element and an axis; degree + 1 are exact
  MassProduct(const Layout<D>&, int points);

  /// out = M in for the components [first, last), which are either velocities or scalars; both are arrays of these
  /// alone. Reads ghosts, which have to be filled, and leaves the ghosts of the result open.
  void apply(const ConstArray& in, const Array& out, int first, int last) const;

  /// This product as a part of a kernel of the caller.
  BandProduct<D, P> of(const ConstArray& in, Unknowns) const;

  /// Ghosts of the components [first, last) take the values that they are copies of; the array is of these alone.
  void fill_ghosts(const Array& values, int first, int last) const;

 private:
  using Band = typename BandProduct<D, P>::Band;
  Band band(int d, const std::vector<ElementRun>&, int first_function, int functions, int points) const;
  static Unknowns kind(int first) { return first < D ? Unknowns::velocities : Unknowns::scalars; }
  void copy_ghosts(int axis, const Array& values, int first, int last) const;

  Layout<D> layout_;
  BandProduct<D, P> velocity_, scalar_;
};

}  // namespace softwet
