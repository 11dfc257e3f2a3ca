// Factors that bring the rows and columns of the Jacobian to size one, computed where the matrix lies.
#pragma once

#include "solver/matrix/stencil_matrix.hpp"

namespace softwet {

/// The factors of Equilibration (solver/matrix/equilibration.hpp), to the last bit, by kernels of the device.
template <int D>
class LevelScale {
 public:
  using Factors = Kokkos::View<float*, Exec>;

  LevelScale(const Layout<D>& layout, const UnknownTable<D>& table);
  void compute(const StencilValues& values) const;
  const Factors& row() const { return row_; }        ///< [unknown]
  const Factors& column() const { return column_; }  ///< [unknown]
  double bytes() const { return 9.0 * row_.extent(0); }

 private:
  Stencil<D> stencil_;
  ComponentPlaces<D> places_;
  Kokkos::View<std::int8_t*, Exec> component_;  ///< [unknown] -1: prescribed
  Factors row_, column_;
};

}  // namespace softwet
