// Vector algebra with sums in one fixed order, so that results do not depend on the number of threads.
#pragma once

#include <cmath>

#include "field/array.hpp"

namespace softwet {

/// Entries per partial sum; fixed, so the order of additions is fixed.
inline constexpr int sum_block = 1024;

/// The vector operations below, for vectors of any precision.
namespace any_precision {

template <class Real>
void combine(const ArrayOf<Real>& y, Real a, const ConstArrayOf<Real>& x, Real b) {
  Kokkos::parallel_for(
      "softwet::combine", Kokkos::RangePolicy<Exec>(0, y.extent(0)),
      KOKKOS_LAMBDA(int i) { y(i) = a * x(i) + (b == 0 ? Real(0) : b * y(i)); });
}

template <class Real>
void add_scaled(const ArrayOf<Real>& y, int offset, Real a, const ConstArrayOf<Real>& x) {
  Kokkos::parallel_for(
      "softwet::add_scaled", Kokkos::RangePolicy<Exec>(0, x.extent(0)),
      KOKKOS_LAMBDA(int i) { y(offset + i) += a * x(i); });
}

template <class Real>
void multiply(const ArrayOf<Real>& y, const ConstArray& x) {
  Kokkos::parallel_for(
      "softwet::multiply", Kokkos::RangePolicy<Exec>(0, y.extent(0)),
      KOKKOS_LAMBDA(int i) { y(i) *= static_cast<Real>(x(i)); });
}

template <class To, class From>
void convert(const ArrayOf<To>& y, const ConstArrayOf<From>& x) {
  Kokkos::parallel_for(
      "softwet::convert", Kokkos::RangePolicy<Exec>(0, y.extent(0)),
      KOKKOS_LAMBDA(int i) { y(i) = static_cast<To>(x(i)); });
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

/// Scratch for partial sums: allocated once, grown when needed, released before Kokkos ends.
struct SumSpace {
  Array device;
  Array::host_mirror_type host;
};
inline SumSpace& sum_space(std::size_t entries) {
  static SumSpace space;
  if (space.device.extent(0) < entries) {
    if (!space.device.data()) Kokkos::push_finalize_hook([] { space = {}; });
    space.device = Array(Kokkos::view_alloc("partial sums", Kokkos::WithoutInitializing), entries);
    space.host = Kokkos::create_mirror_view(space.device);
  }
  return space;
}

/// Sums of x(i) y(i), or of x(i), over one fixed block of entries. They are of double precision, whatever the vectors are.
template <class Real>
struct BlockSum {
  ConstArrayOf<Real> x, y;  ///< y empty: the sum of x
  Array partial;
  int size;
  KOKKOS_FORCEINLINE_FUNCTION double entry(int i) const {
    const double a = x(i);
    return y.data() ? a * y(i) : a;
  }
  KOKKOS_FUNCTION void operator()(int block) const {
    const int first = block * sum_block, last = first + sum_block < size ? first + sum_block : size;
    double sum[8] = {};
    int i = first;
    for (; i + 8 <= last; i += 8)
      for (int l = 0; l < 8; ++l) sum[l] += entry(i + l);
    for (; i < last; ++i) sum[0] += entry(i);
    partial(block) = ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  }
};

template <class Real>
double block_sum(const ConstArrayOf<Real>& x, const ConstArrayOf<Real>& y) {
  const int n = static_cast<int>(x.extent(0)), blocks = (n + sum_block - 1) / sum_block;
  const SumSpace& space = sum_space(blocks);
  Kokkos::parallel_for("softwet::sum", Kokkos::RangePolicy<Exec>(0, blocks), BlockSum<Real>{x, y, space.device, n});
  Kokkos::deep_copy(space.host, space.device);
  double total = 0;
  for (int b = 0; b < blocks; ++b) total += space.host(b);
  return total;
}

inline double dot(const ConstArray& x, const ConstArray& y) { return block_sum<double>(x, y); }
inline double dot(const ConstArrayOf<float>& x, const ConstArrayOf<float>& y) { return block_sum<float>(x, y); }
inline double total(const ConstArray& x) { return block_sum<double>(x, {}); }
inline double norm(const ConstArray& x) { return std::sqrt(dot(x, x)); }
inline double norm(const ConstArrayOf<float>& x) { return std::sqrt(dot(x, x)); }

/// Part [first, last) of a vector.
inline ConstArray part(const ConstArray& x, int first, int last) {
  return Kokkos::subview(x, Kokkos::make_pair(first, last));
}

}  // namespace softwet
