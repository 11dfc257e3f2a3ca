// The Galerkin product of a matrix with the step to a coarse space.
#pragma once

#include "solver/matrix/stencil_matrix.hpp"
#include "solver/schwarz/axis_transfer.hpp"

namespace softwet {

/// Rows and columns of a matrix replaced by coarse sums along one axis. The entry of coarse row j and coarse shift
/// s - degree is the sum over k < count(list) of weight(list, k) times the entry of the fine row(list, k) and the fine
/// shift step(list, k) - degree; list = j (2 degree + 1) + s. Counts are multiples of `terms_at_once`.
struct AxisProduct {
  static constexpr int terms_at_once = 4;
  Kokkos::View<int*, Exec> count;
  Kokkos::View<int**, Kokkos::LayoutRight, Exec> row, step;
  Kokkos::View<float**, Kokkos::LayoutRight, Exec> weight;
};

/// A_c = P^T A P, axis by axis, for one pair of components after another, so that the product between two axes is
/// small. Each of several processes makes the rows of its own columns.
template <int D>
class GalerkinProduct {
 public:
  GalerkinProduct(const Layout<D>& fine, const Layout<D>& coarse, const std::vector<Refinement>& refinement);

  void operator()(const StencilValues& fine, const StencilValues& coarse);
  double bytes() const;  ///< of the buffers, which the first product allocates

 private:
  std::vector<Stencil<D>> stencil_;  ///< the fine one, and D more with one more coarse axis each, the last axis first
  AxisProduct axis_[D];
  StencilValues between_[D - 1];
};

}  // namespace softwet
