// Trial and test bundles: what a term sees at a point, and which discrete fields feed it.
//
// A *slot* is one scalar field interpolated to the point, named by its field and component. Its tangent is a multiple of
// the tangent of one unknown; the stage (src/field/stage.hpp) holds the factors. A *reader* (src/operator) hands out
// values and physical gradients of slots, as plain or dual numbers.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// Unknowns are velocity, density and potential; each has an equation: momentum, mass, and that of the potential.
/// Acceleration and displacement follow from the velocity. An operand is the vector that a linear operator acts on; its
/// components are numbered as those of the unknowns.
enum class Field { velocity, density, potential, acceleration, displacement, operand };

/// A component of a field.
struct Component {
  Field field;
  int index = 0;

  /// Its place among the unknowns, or that of the unknown which it follows from: velocity 0 .. D - 1, density D,
  /// potential D + 1.
  constexpr int unknown(int dimension) const {
    if (field == Field::density) return dimension;
    if (field == Field::potential) return dimension + 1;
    return index;
  }
};

/// What a term needs of a component at its points.
struct Slot {
  Component from;
  bool value;
  bool gradient;
};

/// Where a term is integrated; `beside_wall` is the layer of the fluid that touches the wall Gamma, where the term meets
/// the wall's basis functions alone.
enum class Where { solid, fluid, wall, beside_wall };

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
  Vector<N, D> mesh_velocity;  ///< vh

  static constexpr int density_slot = 2 * D, potential_slot = 2 * D + 1, slot_count = 2 * D + 2;

  static constexpr Slot slot(int s) {
    if (s < D) return {{Field::velocity, s}, true, true};
    if (s < 2 * D) return {{Field::acceleration, s - D}, true, false};
    return {{s == density_slot ? Field::density : Field::potential}, true, true};
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
    t.mesh_velocity = at.mesh_velocity();
    return t;
  }
};

/// Integrand against (w, grad w) of momentum, grad q of mass and (q, grad q) of the potential equation.
template <class N, int D>
struct FluidTest {
  Vector<N, D> momentum;
  Matrix<N, D> momentum_flux;
  Vector<N, D> mass_flux;
  N potential;
  Vector<N, D> potential_flux;

  static constexpr int channel_count = D + 2;
  static constexpr bool has_flux = true;
  static constexpr Component channel(int c) {
    if (c < D) return {Field::velocity, c};
    return {c == D ? Field::density : Field::potential};
  }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    for (int i = 0; i < D; ++i) {
      Vector<N, D> row;
      for (int j = 0; j < D; ++j) row[j] = momentum_flux(i, j);
      to.add(i, momentum[i], row);
    }
    to.add(D, N(0.0), mass_flux);
    to.add(D + 1, potential, potential_flux);
  }
};

/// Density and its gradient at a point of the fluid or of the wall Gamma.
template <class N, int D>
struct DensityTrial {
  N density;
  Vector<N, D> density_gradient;

  static constexpr int slot_count = 1;
  static constexpr Slot slot(int) { return {{Field::density}, true, true}; }

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
  static constexpr Component channel(int) { return {Field::potential}; }
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
  static constexpr Component channel(int) { return {Field::potential}; }
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, potential, potential_flux);
  }
};

/// Density and chemical potential next to the wall.
template <class N, int D>
struct TractionTrial {
  N density;
  Vector<N, D> density_gradient;
  N chemical_potential;
  Vector<N, D> chemical_potential_gradient;

  static constexpr int slot_count = 2;
  static constexpr Slot slot(int s) { return {{s == 0 ? Field::density : Field::potential}, true, true}; }

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
  static constexpr Component channel(int c) { return {Field::velocity, c}; }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    for (int i = 0; i < D; ++i) {
      Vector<N, D> row;
      for (int j = 0; j < D; ++j) row[j] = momentum_flux(i, j);
      to.add(i, momentum[i], row);
    }
  }
};

/// Solid at a point; gradients are with respect to X.
template <class N, int D>
struct SolidTrial {
  Vector<N, D> acceleration;
  Matrix<N, D> displacement_gradient;  ///< (Grad u)_ij = du_i/dX_j

  static constexpr int slot_count = 2 * D;
  static constexpr Slot slot(int s) {
    return s < D ? Slot{{Field::acceleration, s}, true, false} : Slot{{Field::displacement, s - D}, false, true};
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

/// Integrand against w of momentum and grad q of mass.
template <class N, int D>
struct ForceTest {
  Vector<N, D> momentum;
  Vector<N, D> mass_flux;

  static constexpr int channel_count = D + 1;
  static constexpr bool has_flux = true;
  static constexpr Component channel(int c) {
    return c < D ? Component{Field::velocity, c} : Component{Field::density};
  }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    Vector<N, D> none;
    for (int i = 0; i < D; ++i) none[i] = N(0.0);
    for (int i = 0; i < D; ++i) to.add(i, momentum[i], none);
    to.add(D, N(0.0), mass_flux);
  }
};

/// Density alone at a point of the fluid.
template <class N, int D>
struct DensityValueTrial {
  N density;

  static constexpr int slot_count = 1;
  static constexpr Slot slot(int) { return {{Field::density}, true, false}; }

  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION DensityValueTrial read(const Reader& at) {
    return {at.value(0)};
  }
};

/// Integrand against q of the mass equation alone.
template <class N, int D>
struct MassTest {
  N mass;
  static constexpr int channel_count = 1;
  static constexpr bool has_flux = false;
  static constexpr Component channel(int) { return {Field::density}; }
  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    to.add(0, mass);
  }
};

/// A velocity (or acceleration) z in the fluid, and the density that is its weight.
template <class N, int D>
struct WeightedTrial {
  N density;
  Vector<N, D> vector;
  Matrix<N, D> gradient;

  static constexpr int slot_count = D + 1;
  static constexpr Slot slot(int s) {
    return s == 0 ? Slot{{Field::density}, true, false} : Slot{{Field::operand, s - 1}, true, true};
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

  static constexpr int slot_count = D;
  static constexpr Slot slot(int s) { return {{Field::operand, s}, true, false}; }

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
  static constexpr Component channel(int c) { return {Field::velocity, c}; }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    for (int i = 0; i < D; ++i) to.add(i, value[i]);
  }
};

}  // namespace softwet
