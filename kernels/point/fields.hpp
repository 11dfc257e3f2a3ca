// Trial and test bundles: what a term sees at a point, and which discrete fields feed it.
//
// A *slot* is one scalar field interpolated to the point. Slot s has a tangent that is a multiple of the tangent of one
// unknown: d(slot) = scale * d(unknown), with the scale of the time scheme. A *reader* (src/operator) hands out values
// and physical gradients of slots, as plain or dual numbers.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// Factor between the tangent of an unknown and that of a slot; the time scheme sets the numbers.
enum class Scale { one, rate, displacement, end };
inline constexpr int scale_count = 4;

struct Slot {
  bool value;
  bool gradient;
  int unknown;
  Scale scale;
};

/// Fluid at a point. Unknowns: velocity (D), density, chemical potential; gradients are with respect to x.
template <class N, int D>
struct FluidTrial {
  Vector<N, D> velocity;           ///< v, sqrt(ab)
  Matrix<N, D> velocity_gradient;  ///< (grad v)_ij = dv_i/dx_j
  Vector<N, D> acceleration;       ///< dv/dt at fixed mesh coordinate
  N density;                       ///< rho, b
  Vector<N, D> density_gradient;
  N chemical_potential;  ///< mu, a b
  Vector<N, D> chemical_potential_gradient;
  N density_end;               ///< rho at the end of the step
  Vector<N, D> mesh_velocity;  ///< vh
  N volume_ratio_end;          ///< J(t_{n+1}) / J(t_{n+af}) of the mesh map

  static constexpr int density_slot = 2 * D, potential_slot = 2 * D + 1, density_end_slot = 2 * D + 2;
  static constexpr int slot_count = 2 * D + 3, unknown_count = D + 2;

  static constexpr Slot slot(int s) {
    if (s < D) return {true, true, s, Scale::one};
    if (s < 2 * D) return {true, false, s - D, Scale::rate};
    if (s == density_slot) return {true, true, D, Scale::one};
    if (s == potential_slot) return {true, true, D + 1, Scale::one};
    return {true, false, D, Scale::end};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION FluidTrial read(const Reader& at) {
    FluidTrial t;
    for (int i = 0; i < D; ++i) {
      t.velocity[i] = at.value(i);
      const Vector<N, D> g = at.gradient(i);
      for (int j = 0; j < D; ++j) t.velocity_gradient(i, j) = g[j];
      t.acceleration[i] = at.value(D + i);
    }
    t.density = at.value(density_slot);
    t.density_gradient = at.gradient(density_slot);
    t.chemical_potential = at.value(potential_slot);
    t.chemical_potential_gradient = at.gradient(potential_slot);
    t.density_end = at.value(density_end_slot);
    t.mesh_velocity = at.mesh_velocity();
    t.volume_ratio_end = at.volume_ratio_end();
    return t;
  }
};

/// Integrand against (w, grad w) of momentum, (q, grad q) of mass and (q, grad q) of the potential equation.
template <class N, int D>
struct FluidTest {
  Vector<N, D> momentum;
  Matrix<N, D> momentum_flux;
  N mass;
  Vector<N, D> mass_flux;
  N potential;
  Vector<N, D> potential_flux;

  static constexpr int channel_count = D + 2;
  static constexpr bool has_flux = true;

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    for (int i = 0; i < D; ++i) {
      Vector<N, D> row;
      for (int j = 0; j < D; ++j) row[j] = momentum_flux(i, j);
      to.add(i, momentum[i], row);
    }
    to.add(D, mass, mass_flux);
    to.add(D + 1, potential, potential_flux);
  }
};

/// Density at a point of the fluid or of the wall Gamma. Unknown: density.
template <class N, int D>
struct DensityTrial {
  N density;
  Vector<N, D> density_gradient;

  static constexpr int slot_count = 1, unknown_count = 1;
  static constexpr Slot slot(int) { return {true, true, 0, Scale::one}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION DensityTrial read(const Reader& at) {
    return {at.value(0), at.gradient(0)};
  }
};

template <class N, int D>
struct WallTest {
  N potential;
  static constexpr int channel_count = 1;
  static constexpr bool has_flux = false;
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, potential);
  }
};

/// Integrand against (q, grad q) of the potential equation alone.
template <class N, int D>
struct PotentialTest {
  N potential;
  Vector<N, D> potential_flux;
  static constexpr int channel_count = 1;
  static constexpr bool has_flux = true;
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, potential, potential_flux);
  }
};

/// Density and chemical potential next to the wall. Test: momentum, by the wall's basis functions only.
template <class N, int D>
struct TractionTrial {
  N density;
  Vector<N, D> density_gradient;
  N chemical_potential;
  Vector<N, D> chemical_potential_gradient;

  static constexpr int slot_count = 2, unknown_count = 2;
  static constexpr Slot slot(int s) { return {true, true, s, Scale::one}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION TractionTrial read(const Reader& at) {
    return {at.value(0), at.gradient(0), at.value(1), at.gradient(1)};
  }
};

/// Integrand against (w, grad w) of momentum alone; also the test bundle of the solid.
template <class N, int D>
struct MomentumTest {
  Vector<N, D> momentum;
  Matrix<N, D> momentum_flux;

  static constexpr int channel_count = D;
  static constexpr bool has_flux = true;

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    for (int i = 0; i < D; ++i) {
      Vector<N, D> row;
      for (int j = 0; j < D; ++j) row[j] = momentum_flux(i, j);
      to.add(i, momentum[i], row);
    }
  }
};

/// Solid at a point; gradients are with respect to X. Unknown: velocity; the displacement follows from the time scheme.
template <class N, int D>
struct SolidTrial {
  Vector<N, D> acceleration;
  Matrix<N, D> displacement_gradient;  ///< (Grad u)_ij = du_i/dX_j

  static constexpr int slot_count = 2 * D, unknown_count = D;
  static constexpr Slot slot(int s) {
    return s < D ? Slot{true, false, s, Scale::rate} : Slot{false, true, s - D, Scale::displacement};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION SolidTrial read(const Reader& at) {
    SolidTrial t;
    for (int i = 0; i < D; ++i) {
      t.acceleration[i] = at.value(i);
      const Vector<N, D> g = at.gradient(D + i);
      for (int j = 0; j < D; ++j) t.displacement_gradient(i, j) = g[j];
    }
    return t;
  }
};

/// A scalar of the fluid whose mass matrix is applied: density or chemical potential.
template <class N, int D>
struct ScalarTrial {
  N value;

  static constexpr int slot_count = 1, unknown_count = 1;
  static constexpr Slot slot(int) { return {true, false, 0, Scale::one}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION ScalarTrial read(const Reader& at) {
    return {at.value(0)};
  }
};

/// Integrand against q alone.
template <class N, int D>
struct ScalarTest {
  N value;
  static constexpr int channel_count = 1;
  static constexpr bool has_flux = false;
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, value);
  }
};

/// A velocity (or acceleration) z in the fluid, and the density that is its weight.
template <class N, int D>
struct WeightedTrial {
  N density;
  Vector<N, D> vector;
  Matrix<N, D> gradient;

  static constexpr int slot_count = D + 1, unknown_count = D + 1;
  static constexpr Slot slot(int s) {
    return s == 0 ? Slot{true, false, 0, Scale::one} : Slot{true, true, s, Scale::one};
  }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION WeightedTrial read(const Reader& at) {
    WeightedTrial t;
    t.density = at.value(0);
    for (int i = 0; i < D; ++i) {
      t.vector[i] = at.value(1 + i);
      const Vector<N, D> g = at.gradient(1 + i);
      for (int j = 0; j < D; ++j) t.gradient(i, j) = g[j];
    }
    return t;
  }
};

/// A velocity (or acceleration) z in the solid.
template <class N, int D>
struct VectorTrial {
  Vector<N, D> vector;

  static constexpr int slot_count = D, unknown_count = D;
  static constexpr Slot slot(int s) { return {true, false, s, Scale::one}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION VectorTrial read(const Reader& at) {
    VectorTrial t;
    for (int i = 0; i < D; ++i) t.vector[i] = at.value(i);
    return t;
  }
};

/// Integrand against w alone.
template <class N, int D>
struct VectorTest {
  Vector<N, D> value;

  static constexpr int channel_count = D;
  static constexpr bool has_flux = false;

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    for (int i = 0; i < D; ++i) to.add(i, value[i]);
  }
};

}  // namespace softwet
