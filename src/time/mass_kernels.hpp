// Vector operations of the masses of explicit schemes, by value and by control point.
#pragma once

#include <algorithm>

#include "solver/krylov/mass_product.hpp"

namespace softwet::mass_kernels {

/// x(i) *= sqrt(a(i) / b(i)) by control point, 0 where b is.
inline void scale_by_root(const Array& x, const ConstArray& a, const ConstArray& b) {
  const int nodes = static_cast<int>(a.extent(0));
  Kokkos::parallel_for(
      "softwet::scale_by_root", Items(0, x.extent(0)),
      KOKKOS_LAMBDA(int i) { x(i) = b(i % nodes) > 0 ? x(i) * Kokkos::sqrt(a(i % nodes) / b(i % nodes)) : 0.0; });
}

/// z = factor mask b / a
inline void divide(const Array& z, double factor, const ConstArray& b, const ConstArray& a, const ConstArray& mask) {
  const int nodes = static_cast<int>(a.extent(0)), components = static_cast<int>(z.extent(0)) / std::max(1, nodes);
  Kokkos::parallel_for(
      "softwet::divide", Items(0, nodes), KOKKOS_LAMBDA(int node) {
        const double inverse = factor / a(node);
        for (int c = 0, i = node; c < components; ++c, i += nodes) z(i) = mask(i) != 0 ? b(i) * inverse : 0.0;
      });
}

/// y = a y by control point.
inline void weigh(const Array& y, const ConstArray& a) {
  const int nodes = static_cast<int>(a.extent(0));
  Kokkos::parallel_for(
      "softwet::weigh", Items(0, y.extent(0)), KOKKOS_LAMBDA(int i) { y(i) *= a(i % nodes); });
}

/// Row sums of velocities: those of the solid, and where there is fluid its moments, at least the floor.
inline void sum_velocity_rows(const Array& sums, const ConstArray& solid, const ConstArray& moments,
                              const ConstArray& volume, double floor, int shift) {
  const int count = static_cast<int>(volume.extent(0));
  Kokkos::parallel_for(
      "softwet::velocity_sums", Items(0, sums.extent(0)), KOKKOS_LAMBDA(int i) {
        const int k = i - shift;
        sums(i) = solid(i) + (k >= 0 && k < count ? Kokkos::max(moments(k), floor * volume(k)) : 0.0);
      });
}

/// root = sqrt(sums / unit)
inline void find_roots(const Array& root, const ConstArray& sums, const ConstArray& unit) {
  Kokkos::parallel_for(
      "softwet::mass_roots", Items(0, root.extent(0)),
      KOKKOS_LAMBDA(int i) { root(i) = Kokkos::sqrt(sums(i) / unit(i)); });
}

/// From image = M root: the factors of A c = a (left c + right M (root c)).
inline void find_factors(const Array& left, const Array& right, const ConstArray& image, const ConstArray& root,
                         const ConstArray& sums) {
  Kokkos::parallel_for(
      "softwet::mass_factors", Items(0, left.extent(0)), KOKKOS_LAMBDA(int i) {
        right(i) = root(i) / sums(i);
        left(i) = 1 - image(i) * right(i);
      });
}

}  // namespace softwet::mass_kernels
