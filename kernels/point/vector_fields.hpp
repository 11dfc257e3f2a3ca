// Bundles of terms that read a vector alone, or act on one, and the integrand against w alone.
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// A velocity (or acceleration) z in the fluid, and the density that is its weight.
template <class N, int D, class M = Matrix<N, D>>
struct WeightedTrial {
  N density;
  Vector<N, D> vector;
  M gradient;

  static constexpr int slot_count = D + 1;
  static constexpr Slot slot(int s) {
    return s == 0 ? Slot{{Field::density}, true, false} : Slot{{Field::operand, s - 1}, true, true};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION WeightedTrial read(const Reader& at) {
    WeightedTrial t;
    t.density = at.value(0);
    for (int i = 0; i < D; ++i) t.vector[i] = at.value(1 + i);
    t.gradient = gradient_of<M, N, D>(at, 1);
    return t;
  }
};

/// A vector at a point: the displacement or the velocity of the solid, or the operand z of a linear operator.
template <Field field, class N, int D>
struct VectorOf {
  Vector<N, D> vector;

  static constexpr int slot_count = D;
  static constexpr Slot slot(int s) { return {{field, s}, true, false}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION VectorOf read(const Reader& at) {
    VectorOf t;
    for (int i = 0; i < D; ++i) t.vector[i] = at.value(i);
    return t;
  }
};
template <class N, int D>
using SolidDisplacement = VectorOf<Field::displacement, N, D>;
template <class N, int D>
using SolidVelocity = VectorOf<Field::velocity, N, D>;
template <class N, int D>
using VectorTrial = VectorOf<Field::operand, N, D>;

/// Integrand against w alone.
template <class N, int D>
struct VectorTest {
  Vector<N, D> value;

  static constexpr int channel_count = D;
  static constexpr bool has_flux = false;
  static constexpr Component channel(int c) { return {Field::velocity, c}; }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    for (int i = 0; i < D; ++i) to.add(i, value[i]);
  }
};

}  // namespace softwet
