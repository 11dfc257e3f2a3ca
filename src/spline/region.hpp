// A box of elements of the patch with its quadrature: where a term is integrated.
#pragma once

#include "spline/rule.hpp"

namespace softwet {

/// Element rules per axis; `test` replaces the last axis' rule for the test functions (same points). Where one test
/// function of that axis lives on all elements (`shared_test`), a column of elements adds to the same control values.
/// Control values of a component lie at [k][j][i], i fastest, with these strides over the whole patch.
template <int D>
struct Region {
  AxisRule axis[D];
  AxisRule test;
  bool shared_test = false;
  int stride[D] = {};

  int elements() const {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= axis[d].elements;
    return n;
  }
};

/// Vertical blending of the wall's motion into the fluid mesh: displacement(x, y) = d(x) (1 - eta(y)).
/// The control points of row j move by (1 - Greville height) times the wall's, which is this linear blend exactly.
struct Blend {
  double low = 0;     ///< height of the wall
  double height = 1;  ///< of the fluid
  KOKKOS_FORCEINLINE_FUNCTION double value(double y) const { return 1.0 - (y - low) / height; }
  KOKKOS_FORCEINLINE_FUNCTION double slope() const { return -1.0 / height; }
};

}  // namespace softwet
