// Vector operations of the masses of explicit schemes, by value and by control point.
#pragma once

#include <algorithm>

#include "field/factor.hpp"
#include "field/fused.hpp"
#include "field/vector.hpp"
#include "scene/mass_products.hpp"

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

/// Row sums of velocities: the row sums of the solid, plus the moments of the fluid, at least the floor.
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

/// A part of a vector of forces, which is taken: zero is left for the next sum of terms. What the tiles of a device
/// have summed is added as it is read.
template <int D>
struct TakenForce {
  Array values;
  TileSumsOf<D> tiles = {};
  int first = 0;  ///< of the part in the vector

  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i) const {
    const double force = values(i);
    values(i) = 0;
    return tiles.added_to(force, first + i);
  }
};

/// The right side of a mass: a vector b, a force, minus a force, or the moments b + dt (rates - mask force), which are
/// kept.
template <int D>
struct RightSide {
  ConstArray b;
  TakenForce<D> force = {};
  ConstArray mask = {};  ///< with a force alone: it counts with the other sign
  Factor dt = 0;
  ConstArray rates = {};
  Array moments = {};

  static RightSide of(const ConstArray& b) { return {b}; }
  static RightSide take(const TakenForce<D>& force) { return {{}, force}; }
  static RightSide minus(const TakenForce<D>& force, const ConstArray& mask) { return {{}, force, mask}; }
  static RightSide moved(const ConstArray& b, const Factor& dt, const ConstArray& rates, const TakenForce<D>& force,
                         const ConstArray& mask, const Array& moments) {
    return {b, force, mask, dt, rates, moments};
  }

  /// Calls body(side) with a function of the value's place. On a processor each kind has its own, so that loops over
  /// places are free of choices.
  template <class Body>
  KOKKOS_FORCEINLINE_FUNCTION void visit(const Body& body) const {
    if constexpr (!host_algorithms) {
      body(*this);
    } else if (moments.data()) {
      body([&, rate = static_cast<double>(dt)](int i) { return moved(i, rate); });
    } else if (mask.data()) {
      body([&](int i) { return against(i); });
    } else if (force.values.data()) {
      body(force);
    } else {
      body(b);
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i) const {
    if (moments.data()) return moved(i, dt);
    if (mask.data()) return against(i);
    return force.values.data() ? force(i) : b(i);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION double moved(int i, double rate) const {
    const double p = b(i) + rate * (rates(i) - mask(i) * force(i));
    return moments(i) = p;
  }
  KOKKOS_FORCEINLINE_FUNCTION double against(int i) const { return (0.0 - force(i)) * mask(i); }
};

/// rates = 0 - mask force of a force that is taken. It is +0 where the mask is 0, whatever sign the force has there:
/// ghosts have the same bits in any number of processes.
template <int D>
struct TakeRates {
  Array rates;
  TakenForce<D> force;
  ConstArray mask;
  KOKKOS_FUNCTION void operator()(int i) const { rates(i) = 0.0 - mask(i) * force(i); }
};

/// out = factor b, and 0 where the mask is.
template <int D>
struct StoreRightSide {
  RightSide<D> side;
  double factor;
  ConstArray mask;
  Array out;
  KOKKOS_FUNCTION void operator()(int i) const {
    const double value = factor * side(i);
    out(i) = mask(i) * value;
  }
};

}  // namespace softwet::mass_kernels
