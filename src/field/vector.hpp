// Vector algebra.
#pragma once

#include <cmath>

#include "field/strip_sums.hpp"

namespace softwet {

/// The vector operations below, for vectors of any precision. Kernels in headers are named structs, not lambdas: see
/// tools/lambdas.
namespace any_precision {

template <class Real>
struct Combine {
  ArrayOf<Real> y;
  Real a;
  ConstArrayOf<Real> x;
  Real b;
  KOKKOS_FUNCTION void operator()(int i) const { y(i) = a * x(i) + (b == 0 ? Real(0) : b * y(i)); }
};
template <class Real>
void combine(const ArrayOf<Real>& y, Real a, const ConstArrayOf<Real>& x, Real b) {
  Kokkos::parallel_for("softwet::combine", Items(0, y.extent(0)), Combine<Real>{y, a, x, b});
}

template <class Real>
struct AddScaled {
  ArrayOf<Real> y;
  int offset;
  Real a;
  ConstArrayOf<Real> x;
  KOKKOS_FUNCTION void operator()(int i) const { y(offset + i) += a * x(i); }
};
template <class Real>
void add_scaled(const ArrayOf<Real>& y, int offset, Real a, const ConstArrayOf<Real>& x) {
  Kokkos::parallel_for("softwet::add_scaled", Items(0, x.extent(0)), AddScaled<Real>{y, offset, a, x});
}

template <class Real>
struct Multiply {
  ArrayOf<Real> y;
  ConstArray x;
  KOKKOS_FUNCTION void operator()(int i) const { y(i) *= static_cast<Real>(x(i)); }
};
template <class Real>
void multiply(const ArrayOf<Real>& y, const ConstArray& x) {
  Kokkos::parallel_for("softwet::multiply", Items(0, y.extent(0)), Multiply<Real>{y, x});
}

template <class To, class From>
struct Convert {
  ArrayOf<To> y;
  ConstArrayOf<From> x;
  KOKKOS_FUNCTION void operator()(int i) const { y(i) = static_cast<To>(x(i)); }
};
template <class To, class From>
void convert(const ArrayOf<To>& y, const ConstArrayOf<From>& x) {
  Kokkos::parallel_for("softwet::convert", Items(0, y.extent(0)), Convert<To, From>{y, x});
}

}  // namespace any_precision

/// y = a x + b y; with b = 0 the old y is not read.
inline void combine(const Array& y, double a, const ConstArray& x, double b) {
  any_precision::combine<double>(y, a, x, b);
}
inline void combine(const ArrayOf<float>& y, double a, const ConstArrayOf<float>& x, double b) {
  any_precision::combine<float>(y, static_cast<float>(a), x, static_cast<float>(b));
}

/// y(i) += a x(i) from offset on, for all i of x.
inline void add_scaled(const Array& y, int offset, double a, const ConstArray& x) {
  any_precision::add_scaled<double>(y, offset, a, x);
}
inline void add_scaled(const ArrayOf<float>& y, int offset, double a, const ConstArrayOf<float>& x) {
  any_precision::add_scaled<float>(y, offset, static_cast<float>(a), x);
}

/// y(i) *= x(i)
inline void multiply(const Array& y, const ConstArray& x) { any_precision::multiply<double>(y, x); }
inline void multiply(const ArrayOf<float>& y, const ConstArray& x) { any_precision::multiply<float>(y, x); }

/// y = x, rounded where y is of single precision.
inline void convert(const Array& y, const ConstArray& x) { Kokkos::deep_copy(Exec(), y, x); }
inline void convert(const ArrayOf<float>& y, const ConstArray& x) { any_precision::convert<float, double>(y, x); }
inline void convert(const Array& y, const ConstArrayOf<float>& x) { any_precision::convert<double, float>(y, x); }

template <class Real>
double strip_sum(const VectorSpace& space, const ConstArrayOf<Real>& x, const ConstArrayOf<Real>& y) {
  return strip_sums<Real>(
      {{space, x.data(), 0, 1, {y.data()}, SquareOfFirst::left_out, static_cast<int>(x.extent(0))}})[0];
}

// Sums over vectors of a space, over all processes where these share them.

inline double dot(const VectorSpace& space, const ConstArray& x, const ConstArray& y) {
  return strip_sum<double>(space, x, y);
}
inline double dot(const VectorSpace& space, const ConstArrayOf<float>& x, const ConstArrayOf<float>& y) {
  return strip_sum<float>(space, x, y);
}
inline double total(const VectorSpace& space, const ConstArray& x) { return strip_sum<double>(space, x, {}); }
inline double norm(const VectorSpace& space, const ConstArray& x) { return std::sqrt(dot(space, x, x)); }
inline double norm(const VectorSpace& space, const ConstArrayOf<float>& x) { return std::sqrt(dot(space, x, x)); }

/// sqrt(sum_i w_i x_i^2)
template <class Real>
double weighted_norm(const VectorSpace& space, const ArrayOf<Real>& x, const RangeFactors& w) {
  return std::sqrt(strip_sums<Real>(
      {{space, x.data(), 0, 1, {x.data()}, SquareOfFirst::left_out, static_cast<int>(x.extent(0)), w}})[0]);
}

/// Part [first, last) of a vector.
inline ConstArray part(const ConstArray& x, int first, int last) {
  return Kokkos::subview(x, Kokkos::make_pair(first, last));
}

/// norm(space, part(x, p.first, p.last)) of several parts p, with the same bits, and one copy to the host.
template <class Part>
std::vector<double> norms(const VectorSpace& space, const ConstArray& x, const std::vector<Part>& parts) {
  std::vector<StripSums<double>> kernels;
  for (const Part& p : parts) {
    const double* start = x.data() + p.first;
    kernels.push_back({space, start, 0, 1, {start}, SquareOfFirst::left_out, p.last - p.first});
  }
  std::vector<double> sums = strip_sums(kernels);
  for (double& sum : sums) sum = std::sqrt(sum);
  return sums;
}

}  // namespace softwet
