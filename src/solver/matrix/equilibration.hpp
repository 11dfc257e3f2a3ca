// Factors that bring the largest entry of each row and column of the Jacobian to one.
#pragma once

#include "solver/matrix/stencil_matrix.hpp"

namespace softwet {

/// With these factors the largest entry of each row is one, and then the largest entry of each column. Prescribed
/// values have the factor one, and so have rows and columns of zeros.
struct Equilibration {
  std::vector<float> row, column;
};

/// Reads the matrix twice from begin to end.
template <int D>
class Equilibrator {
 public:
  Equilibrator(const Layout<D>& layout, const UnknownTable<D>& table);
  void compute(const Kokkos::View<const float*, Kokkos::HostSpace>& values, Equilibration& result);

 private:
  Stencil<D> stencil_;
  ComponentPlaces<D> places_;
  std::vector<float> free_, weight_;  ///< one for unknowns; what entries are multiplied by
};

}  // namespace softwet
