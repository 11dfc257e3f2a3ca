// A box of elements of the patch with its quadrature: where a term is integrated.
#pragma once

#include "spline/columns.hpp"
#include "spline/rule.hpp"

namespace softwet {

/// Element rules per axis; `test` replaces the last axis' rule for the test functions (same points). Where one test
/// function of that axis lives on all elements (`shared_test`), a column of elements adds to the same control values.
/// Control values of a component lie at [k][j][i], i fastest, with these strides over all that is stored. The tables of
/// the first axis have a place for each stored column: element l begins at column l.
template <int D, class Real = double>
struct Region {
  AxisRuleOf<Real> axis[D];
  AxisRuleOf<Real> test;
  bool shared_test = false;
  int stride[D] = {};
  ElementColumns columns = {};  ///< along the first axis; left out: all elements

  ElementColumns first_axis() const { return columns.strips > 0 ? columns : whole_elements(axis[0].elements); }
  int elements() const {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= axis[d].elements;
    return n;
  }
};

/// The region with tables of the precision Real.
template <class Real, int D>
Region<D, Real> rounded(const Region<D>& region) {
  if constexpr (std::is_same_v<Real, double>) {
    return region;
  } else {
    Region<D, Real> r;
    for (int d = 0; d < D; ++d) r.axis[d] = in_single(region.axis[d]);
    r.test = in_single(region.test);
    r.shared_test = region.shared_test;
    r.columns = region.columns;
    for (int d = 0; d < D; ++d) r.stride[d] = region.stride[d];
    return r;
  }
}

}  // namespace softwet
