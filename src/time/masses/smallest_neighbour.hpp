// The smallest value among the functions that overlap with each function.
#pragma once

#include "field/ghosts.hpp"

namespace softwet {

/// Works on one component by control point. Axes follow each other, for functions overlap where they do on every axis.
/// Tested: tests/unit/time/masses/test_mass_inverse.cpp
template <int D, int P>
class SmallestNeighbour {
 public:
  explicit SmallestNeighbour(const Layout<D>&);

  /// out_i = min(x_i, ratio min_j x_j) in another array.
  void limit(const ConstArray& x, const Array& out, double ratio, bool velocities) const;

 private:
  /// Entry (k, i) is the place of function i + k - degree; at an end or where a process does not store it, i itself.
  using Table = Kokkos::View<const int**, Kokkos::LayoutRight, Exec>;

  Layout<D> layout_;
  std::array<Table, D> velocity_, scalar_;
};

}  // namespace softwet
