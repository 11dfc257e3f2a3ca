// The space of half as many elements under a layout: transfer of vectors, and the Galerkin product of a matrix.
#pragma once

#include <optional>

#include "solver/schwarz/axis_transfer.hpp"
#include "solver/schwarz/galerkin.hpp"
#include "solver/schwarz/transfer_sums.hpp"

namespace softwet {

/// How vectors are transferred: along all axes by one kernel, or axis by axis, which is less work in more kernels.
enum class TransferKernels { one, one_for_each_axis };

/// Nested B-spline spaces: z = P z_c with P the refinement of every axis that can be halved, A_c = P^T A P, which is
/// again a matrix of the same stencil. Where a process stores a part of the fine columns, it stores the part of the
/// coarse ones below it. It restricts to its own columns, from those that it stores; copies are left at zero, as in the
/// product. It prolongs to all columns for which it stores the coarse ones.
template <int D>
class CoarseSpace {
 public:
  /// @param least  elements that an axis keeps at least
  CoarseSpace(const Layout<D>& fine, const ConstArray& mask, int least,
              TransferKernels kernels = host_algorithms ? TransferKernels::one_for_each_axis : TransferKernels::one);

  bool exists() const { return exists_; }  ///< whether any axis could be halved
  const Layout<D>& layout() const { return layout_; }
  ConstArray mask() const { return mask_; }
  const AxisTransfer& axis(int d) const { return axis_[d]; }

  void restrict_to(const ConstArray& fine, const Array& coarse) const;  ///< coarse = P^T fine
  void prolong(const ConstArray& coarse, const Array& fine) const;      ///< fine = P coarse, zero where prescribed
  /// Entries of P^T fine, for a kernel that does something else too.
  template <class Real>
  SumAllAxes<D, Real> restriction(const ConstArrayOf<Real>& fine) const {
    SumAllAxes<D, Real> all{{}, places_of(fine_), places_of(layout_), fine, mask_, layout_.components()};
    for (int d = 0; d < D; ++d) all.sums[d] = axis_[d].to_coarse;
    return all;
  }
  /// Entries of P coarse, likewise.
  SumAllAxes<D, double> prolongation(const ConstArray& coarse) const {
    SumAllAxes<D, double> all{{}, places_of(layout_), places_of(fine_), coarse, fine_mask_, fine_.components()};
    for (int d = 0; d < D; ++d) all.sums[d] = axis_[d].to_fine;
    return all;
  }
  /// The values of P^T A P. Buffers are allocated by the first call and kept.
  void galerkin(const StencilMatrix<D>& fine, const StencilValues& coarse) { (*product_)(fine.values(), coarse); }
  double galerkin_bytes() const { return product_->bytes(); }  ///< of these buffers

 private:
  enum class Towards { coarse, fine };
  void transfer(Towards, const ConstArray& from, const Array& to) const;

  Layout<D> fine_, layout_;
  ConstArray fine_mask_, mask_;
  AxisTransfer axis_[D];
  Array between_[D - 1];  ///< vectors on their way, with one more coarse axis each
  std::optional<GalerkinProduct<D>> product_;
  bool exists_ = false;
  TransferKernels kernels_;
};

}  // namespace softwet
