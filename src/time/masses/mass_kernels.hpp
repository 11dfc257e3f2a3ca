// Vector operations of the masses of explicit schemes, by value and by control point.
#pragma once

#include <algorithm>

#include "field/fused.hpp"
#include "field/vector.hpp"

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

/// Row sums of velocities: those of the solid, and where there is fluid its moments, at least the floor.
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

/// Row sums of scalars from an assembled product, of which zero is left.
struct TakeScalarRows {
  Array sums, product;
  ConstArray mask;
  KOKKOS_FUNCTION void operator()(int i) const {
    sums(i) = mask(i) * product(i);
    product(i) = 0;
  }
};

/// root = sqrt(sums / unit)
struct FindRoots {
  Array root;
  ConstArray sums, unit;
  KOKKOS_FUNCTION void operator()(int i) const { root(i) = Kokkos::sqrt(sums(i) / unit(i)); }
};

/// The moments b + dt (rates - mask force), or a vector b as it is. A force is taken: zero is left for the next sum of terms.
struct RightSide {
  ConstArray b;
  Array taken;  ///< b itself, or empty
  double dt = 0;
  ConstArray rates, force_mask;  ///< empty: no moments
  Array force, moments;

  static RightSide of(const ConstArray& b) { return {b, {}, 0, {}, {}, {}, {}}; }
  static RightSide take(const Array& force) { return {force, force, 0, {}, {}, {}, {}}; }

  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i) const {
    if (moments.data()) {
      const double p = b(i) + dt * (rates(i) - force_mask(i) * force(i));
      force(i) = 0;
      return moments(i) = p;
    }
    const double value = b(i);
    if (taken.data()) taken(i) = 0;
    return value;
  }
};

/// out = factor b, and 0 where the mask is.
struct StoreRightSide {
  RightSide side;
  double factor;
  ConstArray mask;
  Array out;
  KOKKOS_FUNCTION void operator()(int i) const {
    const double value = factor * side(i);
    out(i) = mask(i) * value;
  }
};

}  // namespace softwet::mass_kernels
