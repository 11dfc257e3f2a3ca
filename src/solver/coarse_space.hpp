// The space of half as many elements under a layout: transfer of vectors, and the Galerkin product of a matrix.
#pragma once

#include "solver/stencil.hpp"
#include "spline/refinement.hpp"

namespace softwet {

/// The transfer along one axis in both directions: each coarse function as a sum of fine ones, and the part of each fine
/// function in the coarse ones. All sums have the same number of terms; missing coefficients are zero.
struct AxisTransfer {
  Kokkos::View<int*, Exec> first_fine, first_coarse;                     ///< periodic: before wrapping
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> to_fine, to_coarse;  ///< [coarse][k], [fine][k]
  int fine = 0, coarse = 0, fine_owned = 0, coarse_owned = 0;
  bool periodic = false;
};

/// Nested B-spline spaces: z = P z_c with P the refinement of every axis that can be halved, A_c = P^T A P, which is
/// again a matrix of the same stencil.
template <int D>
class CoarseSpace {
 public:
  /// @param least  elements that an axis keeps at least
  CoarseSpace(const Layout<D>& fine, const ConstArray& mask, int least);

  bool exists() const { return exists_; }  ///< whether any axis could be halved
  const Layout<D>& layout() const { return layout_; }
  ConstArray mask() const { return mask_; }

  void restrict_to(const ConstArray& fine, const Array& coarse) const;  ///< coarse = P^T fine
  void prolong(const ConstArray& coarse, const Array& fine) const;      ///< fine = P coarse, zero where prescribed
  void galerkin(const StencilMatrix<D>& fine, const StencilValues& coarse) const;
  /// Memory that galerkin() needs while it runs.
  double transient_bytes() const;

 private:
  Layout<D> fine_, layout_;
  ConstArray fine_mask_, mask_;
  AxisTransfer axis_[D];
  bool exists_ = false;
};

}  // namespace softwet
