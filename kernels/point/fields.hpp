// The parts of trial and test bundles. They say what a term sees at a point, and which discrete fields feed it.
//
// A *slot* is one scalar field interpolated to the point, named by its field and component. Its tangent is a multiple
// of the tangent of one unknown; the stage (src/field/stage.hpp) holds the factors. A *reader* (src/operator) hands out
// values and physical gradients of slots, as plain or dual numbers.
//
// A bundle that holds the gradient of a vector, or a stress, has the kind M of these tensors as a parameter: Matrix<N,
// D>, or AxialMatrix<N> in the coordinates (r, z). The formulas of the terms are the same for both. `Axisymmetric`
// turns a 2D term into a term in (r, z).
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// Unknowns are velocity, density and potential; their equations are the balance of momentum, the balance of mass, and
/// the equation of the potential. Acceleration and displacement follow from the velocity. So does the lag, by which the
/// displacement of a viscoelastic solid is ahead of its branches. The rate of the density at the wall follows from the
/// density. An operand is the vector that a linear operator acts on; its components have the numbers of the unknowns. A
/// given field is known before the run, such as a stiffness that varies in space; a term reads at most one.
enum class Field { velocity, density, potential, acceleration, displacement, lag, density_rate, operand, given };

/// A component of a field.
struct Component {
  Field field;
  int index = 0;

  /// Its place among the unknowns, or the place of the unknown from which it follows: velocity 0 .. D - 1, density D,
  /// potential D + 1. A given field follows from none of them, D + 2.
  constexpr int unknown(int dimension) const {
    if (field == Field::given) return dimension + 2;
    if (field == Field::density || field == Field::density_rate) return dimension;
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

/// Where a term is integrated; `beside_wall` is the layer of the fluid that touches the wall Gamma, where the term
/// meets the wall's basis functions alone. Gamma has two faces: `wall` is the face of the fluid, on the moved mesh, and
/// `top` the face of the solid in its undeformed state. `bottom` is the lower face of the solid, undeformed too.
/// `means` are the elements of the solid, where a term sees the means of fields and gradients over an element.
enum class Where { solid, means, top, bottom, fluid, wall, beside_wall };
constexpr bool on_face(Where where) { return where == Where::wall || where == Where::top || where == Where::bottom; }

/// A term or a functional of the plane in the coordinates (r, z): its tensors have a hoop entry, and integrals have the
/// weight r. A term without tensors takes the weight alone. T stands for Term, so that a name which it lacks is missed
/// where it is used.
template <class Term>
struct Axisymmetric : Term {
  static constexpr bool axisymmetric = true;

  template <class N, int D, class T = Term>
  using Trial = typename T::template Trial<N, D, AxialMatrix<N>>;
  template <class N, int D, class T = Term>
  using Test = typename T::template Test<N, D, AxialMatrix<N>>;
  template <class N, int D, class T = Term>
  using EnergyTrial = typename T::template EnergyTrial<N, D, AxialMatrix<N>>;
};

/// Whether a term or a functional is in the coordinates (r, z).
template <class Term>
inline constexpr bool is_axisymmetric = [] {
  if constexpr (requires { Term::axisymmetric; }) return Term::axisymmetric;
  return false;
}();

/// Whether a channel of a test bundle has a flux. A bundle in which some have none says so by `flux_of`; they then
/// write zeros, which a processor does not integrate.
template <class Test>
constexpr bool channel_has_flux(int c) {
  if constexpr (requires { Test::flux_of(c); }) {
    return Test::flux_of(c);
  } else {
    return Test::has_flux;
  }
}

/// Whether a channel has an integrand against values of test functions. A bundle in which some have none says so by
/// `value_of`; they then write zeros.
template <class Test>
constexpr bool channel_has_value(int c) {
  if constexpr (requires { Test::value_of(c); }) {
    return Test::value_of(c);
  } else {
    return true;
  }
}

/// The gradients of the components of a vector, whose slots follow each other from `first` on, as a tensor of the kind
/// M: Matrix<N, D>, or AxialMatrix<N> in the coordinates (r, z), which has v_r / r too.
template <class M, class N, int D, class Reader>
KOKKOS_FORCEINLINE_FUNCTION M gradient_of(const Reader& at, int first) {
  M all;
  SOFTWET_UNROLL
  for (int i = 0; i < D; ++i) {
    const Vector<N, D> g = at.gradient(first + i);
    SOFTWET_UNROLL
    for (int j = 0; j < D; ++j) all(i, j) = g[j];
  }
  if constexpr (is_axial_matrix<M>) all.hoop = at.over_radius(first);
  return all;
}

/// The slot of component i of a vector of which a term reads gradients alone. For v_r it reads the value too, for v_r /
/// r.
template <class M>
constexpr Slot gradient_slot(Field field, int i) {
  return {{field, i}, is_axial_matrix<M> && i == 0, true};
}

/// Writes the integrands against (w, grad w) of momentum. A hoop entry is met by w_r / r.
template <class M, class N, int D, class Writer>
KOKKOS_FORCEINLINE_FUNCTION void write_momentum(const Writer& to, const Vector<N, D>& momentum, const M& flux) {
  SOFTWET_UNROLL
  for (int i = 0; i < D; ++i) {
    Vector<N, D> row;
    SOFTWET_UNROLL
    for (int j = 0; j < D; ++j) row[j] = flux(i, j);
    if constexpr (is_axial_matrix<M>) {
      i == 0 ? to.add(i, momentum[i], row, flux.hoop) : to.add(i, momentum[i], row);
    } else {
      to.add(i, momentum[i], row);
    }
  }
}

/// Integrand against (w, grad w) of momentum alone; of the fluid and of the solid.
template <class N, int D, class M = Matrix<N, D>>
struct MomentumTest {
  Vector<N, D> momentum;
  M momentum_flux;

  static constexpr int channel_count = D;
  static constexpr bool has_flux = true;
  static constexpr Component channel(int c) { return {Field::velocity, c}; }

  /// A flux without a force.
  static KOKKOS_FORCEINLINE_FUNCTION MomentumTest of_flux(const M& flux) {
    MomentumTest r;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) r.momentum[i] = N(0.0);
    r.momentum_flux = flux;
    return r;
  }

  template <class Writer>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Writer& to) const {
    write_momentum(to, momentum, momentum_flux);
  }
};

}  // namespace softwet
