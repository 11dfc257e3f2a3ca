// Vector algebra with sums in one fixed order, so that results do not depend on the number of threads.
#pragma once

#include <cmath>

#include "field/array.hpp"

namespace softwet {

/// Entries per partial sum; fixed, so the order of additions is fixed.
inline constexpr int sum_block = 1024;

/// y = a x + b y + c z, the one update all others are made of (z unused where c = 0).
inline void combine(const Array& y, double a, const ConstArray& x, double b) {
  Kokkos::parallel_for(
      "softwet::combine", Kokkos::RangePolicy<Exec>(0, y.extent(0)), KOKKOS_LAMBDA(int i) {
        y(i) = a * x(i) + (b == 0 ? 0.0 : b * y(i));
      });
}

/// y(i) += a x(i) from offset on, for all i of x.
inline void add_scaled(const Array& y, int offset, double a, const ConstArray& x) {
  Kokkos::parallel_for(
      "softwet::add_scaled", Kokkos::RangePolicy<Exec>(0, x.extent(0)), KOKKOS_LAMBDA(int i) {
        y(offset + i) += a * x(i);
      });
}

/// y(i) *= x(i)
inline void multiply(const Array& y, const ConstArray& x) {
  Kokkos::parallel_for(
      "softwet::multiply", Kokkos::RangePolicy<Exec>(0, y.extent(0)), KOKKOS_LAMBDA(int i) { y(i) *= x(i); });
}

/// Partial sums of x(i) y(i) over fixed blocks.
inline double dot(const ConstArray& x, const ConstArray& y) {
  const int n = static_cast<int>(x.extent(0)), blocks = (n + sum_block - 1) / sum_block;
  Kokkos::View<double*, Exec> partial(Kokkos::view_alloc("partial", Kokkos::WithoutInitializing), blocks);
  Kokkos::parallel_for(
      "softwet::dot", Kokkos::RangePolicy<Exec>(0, blocks), KOKKOS_LAMBDA(int block) {
        const int first = block * sum_block, last = first + sum_block < n ? first + sum_block : n;
        double sum[8] = {};
        int i = first;
        for (; i + 8 <= last; i += 8)
          for (int l = 0; l < 8; ++l) sum[l] += x(i + l) * y(i + l);
        for (; i < last; ++i) sum[0] += x(i) * y(i);
        partial(block) = ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
      });
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), partial);
  double total = 0;
  for (int b = 0; b < blocks; ++b) total += host(b);
  return total;
}

inline double norm(const ConstArray& x) { return std::sqrt(dot(x, x)); }

/// Part [first, last) of a vector.
inline ConstArray part(const ConstArray& x, int first, int last) {
  return Kokkos::subview(x, Kokkos::make_pair(first, last));
}

}  // namespace softwet
