// Vector operations of the masses of explicit schemes, by value and by control point.
#pragma once

#include <algorithm>

#include "solver/krylov/mass_product.hpp"

namespace softwet::mass_kernels {

struct ScaleByRoot {
  Array x;
  ConstArray a, b;
  int nodes;
  KOKKOS_FUNCTION void operator()(int i) const {
    x(i) = b(i % nodes) > 0 ? x(i) * Kokkos::sqrt(a(i % nodes) / b(i % nodes)) : 0.0;
  }
};
/// x(i) *= sqrt(a(i) / b(i)) by control point, 0 where b is.
inline void scale_by_root(const Array& x, const ConstArray& a, const ConstArray& b) {
  const int nodes = static_cast<int>(a.extent(0));
  Kokkos::parallel_for("softwet::scale_by_root", Items(0, x.extent(0)), ScaleByRoot{x, a, b, nodes});
}

struct Divide {
  Array z;
  double factor;
  ConstArray b, a, mask;
  int nodes, components;
  KOKKOS_FUNCTION void operator()(int node) const {
    const double inverse = factor / a(node);
    for (int c = 0, i = node; c < components; ++c, i += nodes) z(i) = mask(i) != 0 ? b(i) * inverse : 0.0;
  }
};
/// z = factor mask b / a
inline void divide(const Array& z, double factor, const ConstArray& b, const ConstArray& a, const ConstArray& mask) {
  const int nodes = static_cast<int>(a.extent(0)), components = static_cast<int>(z.extent(0)) / std::max(1, nodes);
  Kokkos::parallel_for("softwet::divide", Items(0, nodes), Divide{z, factor, b, a, mask, nodes, components});
}

struct Weigh {
  Array y;
  ConstArray a;
  int nodes;
  KOKKOS_FUNCTION void operator()(int i) const { y(i) *= a(i % nodes); }
};
/// y = a y by control point.
inline void weigh(const Array& y, const ConstArray& a) {
  const int nodes = static_cast<int>(a.extent(0));
  Kokkos::parallel_for("softwet::weigh", Items(0, y.extent(0)), Weigh{y, a, nodes});
}

struct SumVelocityRows {
  Array sums;
  ConstArray solid, moments, volume;
  double floor;
  int shift, count;
  KOKKOS_FUNCTION void operator()(int i) const {
    const int k = i - shift;
    sums(i) = solid(i) + (k >= 0 && k < count ? Kokkos::max(moments(k), floor * volume(k)) : 0.0);
  }
};
/// Row sums of velocities: those of the solid, and where there is fluid its moments, at least the floor.
inline void sum_velocity_rows(const Array& sums, const ConstArray& solid, const ConstArray& moments,
                              const ConstArray& volume, double floor, int shift) {
  const int count = static_cast<int>(volume.extent(0));
  Kokkos::parallel_for("softwet::velocity_sums", Items(0, sums.extent(0)),
                       SumVelocityRows{sums, solid, moments, volume, floor, shift, count});
}

struct FindRoots {
  Array root;
  ConstArray sums, unit;
  KOKKOS_FUNCTION void operator()(int i) const { root(i) = Kokkos::sqrt(sums(i) / unit(i)); }
};
/// root = sqrt(sums / unit)
inline void find_roots(const Array& root, const ConstArray& sums, const ConstArray& unit) {
  Kokkos::parallel_for("softwet::mass_roots", Items(0, root.extent(0)), FindRoots{root, sums, unit});
}

struct FindFactors {
  Array left, right;
  ConstArray image, root, sums;
  KOKKOS_FUNCTION void operator()(int i) const {
    right(i) = root(i) / sums(i);
    left(i) = 1 - image(i) * right(i);
  }
};
/// From image = M root: the factors of A c = a (left c + right M (root c)).
inline void find_factors(const Array& left, const Array& right, const ConstArray& image, const ConstArray& root,
                         const ConstArray& sums) {
  Kokkos::parallel_for("softwet::mass_factors", Items(0, left.extent(0)), FindFactors{left, right, image, root, sums});
}

}  // namespace softwet::mass_kernels
