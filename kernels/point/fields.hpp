// What trial and test bundles are made of. They say what a term sees at a point, and which discrete fields feed it.
//
// A *slot* is one scalar field interpolated to the point, named by its field and component. Its tangent is a multiple of
// the tangent of one unknown; the stage (src/field/stage.hpp) holds the factors. A *reader* (src/operator) hands out
// values and physical gradients of slots, as plain or dual numbers.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// Unknowns are velocity, density and potential; each has an equation: momentum, mass, and that of the potential.
/// Acceleration and displacement follow from the velocity. An operand is the vector that a linear operator acts on; its
/// components are numbered as those of the unknowns. A given field is known before the run, such as a stiffness that varies in space;
/// a term reads at most one.
enum class Field { velocity, density, potential, acceleration, displacement, operand, given };

/// A component of a field.
struct Component {
  Field field;
  int index = 0;

  /// Its place among the unknowns, or that of the unknown which it follows from: velocity 0 .. D - 1, density D,
  /// potential D + 1. A given field follows from none of them, D + 2.
  constexpr int unknown(int dimension) const {
    if (field == Field::given) return dimension + 2;
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
/// the wall's basis functions alone. Gamma has two faces: `wall` is that of the fluid, on the moved mesh, and `top` that of the solid
/// in its undeformed state.
enum class Where { solid, top, fluid, wall, beside_wall };
constexpr bool on_face(Where where) { return where == Where::wall || where == Where::top; }

/// The column of the table of energies that the energy of a term is a part of.
enum class EnergyPart { elastic, surface };

/// Whether a channel of a test bundle has a flux. A bundle in which some have none tells by `flux_of`; they then write zeros,
/// which a processor does not integrate.
template <class Test>
constexpr bool channel_has_flux(int c) {
  if constexpr (requires { Test::flux_of(c); }) {
    return Test::flux_of(c);
  } else {
    return Test::has_flux;
  }
}

/// Integrand against (w, grad w) of momentum alone; of the fluid and of the solid.
template <class N, int D>
struct MomentumTest {
  Vector<N, D> momentum;
  Matrix<N, D> momentum_flux;

  static constexpr int channel_count = D;
  static constexpr bool has_flux = true;
  static constexpr Component channel(int c) { return {Field::velocity, c}; }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) {
      Vector<N, D> row;
      SOFTWET_UNROLL
      for (int j = 0; j < D; ++j) row[j] = momentum_flux(i, j);
      to.add(i, momentum[i], row);
    }
  }
};

}  // namespace softwet
