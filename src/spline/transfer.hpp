// Splines of one axis as splines of another axis of the same length (host).
#pragma once

#include <vector>

#include "spline/axis.hpp"

namespace softwet {

/// One control value as a sum of control values of the other axis: sum_k weight[k] c[function[k]].
struct TransferRow {
  std::vector<int> function;
  std::vector<double> weight;
};

/// For each stored function of `to` its control value by Bezier projection (Thomas et al. 2015), which keeps the
/// integral of the spline with the weight of `to`:
///   c_i = sum_e int_e N_i w dx c_i^e / int N_i w dx,   c^e: coefficients of the best polynomial on element e,
/// best in the integral over e of w times the square of the error. Where the spline is one polynomial on each element
/// of `to`, as on elements that divide the elements of `from`, with a degree that is not smaller, the function is the
/// same. Elsewhere the error is of order h^(p+1).
/// @param low, high            elements of `to` on which the spline exists, [low, high)
/// @param from_low, from_high  elements of `from` on which it exists
/// Tested: tests/unit/spline/test_transfer.cpp
std::vector<TransferRow> projection(const Axis& from, int from_low, int from_high, const Axis& to, int low, int high);

/// The rows of a function from the values of a spline of degree 2 at the ends and in the middle of the elements [low,
/// high), which are numbered from 0: `function` is the number of a value. A control value is the blossom, at the knots
/// inside its function, of the polynomial on one element (Ramshaw 1987; de Boor, A Practical Guide to Splines, ch. IX).
std::vector<TransferRow> from_samples(const Axis&, int low, int high);

}  // namespace softwet
