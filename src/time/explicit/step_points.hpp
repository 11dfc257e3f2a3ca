// What the bound of explicit steps sees at a control point of the fluid and in a column of the mesh.
#pragma once

#include <cmath>

#include "time/explicit/step_bound.hpp"

namespace softwet::step_points {

enum Mechanism { combined, sound, capillarity, viscosity, stabilisation, flow, elasticity, mechanisms };

/// See StepFormula: waves w, viscosity s, stabilisation e, flow u.
KOKKOS_INLINE_FUNCTION double combine(StepFormula formula, double w, double s, double e, double u) {
  if (formula == StepFormula::kick_drift) {
    const double waves = w + u;
    return Kokkos::max(0.25 * (Kokkos::sqrt(e * e + 4 * waves * waves) + e + s), s);
  }
  const double turn = (w + u) / 1.73, decay = (formula == StepFormula::runge_kutta ? s + e : e) / 2.51;
  return Kokkos::sqrt(turn * turn + decay * decay);
}

/// Derivative of a field along an axis at a control point, from its neighbour's control value.
KOKKOS_INLINE_FUNCTION double difference(const double* c, int i, int place, int extent, int stride,
                                         const ConstArray& greville) {
  const int from = place + 1 < extent ? place : place - 1, at = i + (from - place) * stride;
  return (c[at + stride] - c[at]) / (greville(from + 1) - greville(from));
}

/// Rates of the fluid where it has a density, a mean density of the control point, `inertia`, and a speed over the
/// mesh.
/// @param many     axes whose symbols add up
/// @param inverse  of the length of elements
KOKKOS_INLINE_FUNCTION void rates_of_fluid(const NavierStokesKorteweg& fluid, const MassSymbols& symbols,
                                           StepFormula formula, double many, double density, double inertia,
                                           double speed, double inverse, double* rate) {
  const double square = inverse * inverse;
  const double rho = Kokkos::max(density, fluid.gas.continuation), c2 = rho * fluid.gas.curvature(rho);
  const double g2 = fluid.capillarity * fluid.capillarity, c2_on = Kokkos::max(c2, 0.0);
  rate[sound] = Kokkos::sqrt(many * symbols.acoustic * symbols.acoustic * c2_on * square);
  rate[capillarity] = many * symbols.capillary * Kokkos::sqrt(g2 * rho) * square;
  const double wave = Kokkos::sqrt(rate[sound] * rate[sound] + rate[capillarity] * rate[capillarity]);
  const double k = many * symbols.diffusive * square;
  rate[viscosity] = 4.0 / 3 * fluid.viscosity / inertia * many * symbols.viscous * square;
  rate[stabilisation] = fluid.stabilisation * rho * rho * k * (c2_on / rho + g2 * k);
  rate[flow] = symbols.convective * Kokkos::sqrt(many) * speed * inverse;
  rate[combined] = combine(formula, wave, rate[viscosity], rate[stabilisation], rate[flow]);
}

/// stretch = 1 / the smallest singular value of F = I + (beta Grad d, slope d e_D) above a column, at the wall and on
/// top.
template <int D>
struct StretchOfColumn {
  const double* displacement;  ///< of the wall's row; null: nothing moves
  ConstArray greville[D];
  Array stretch;
  int extent[D];
  int nodes;
  double slope;

  KOKKOS_FUNCTION void operator()(int i) const { stretch(i) = at(i); }
  /// The stretch of column i: the stored one on the host; on a device it is computed here, since a launch would take
  /// longer.
  KOKKOS_FUNCTION double of(int i) const {
    if constexpr (host_algorithms) return stretch(i);
    return displacement ? at(i) : 1.0;
  }
  KOKKOS_FUNCTION double at(int i) const {
    double worst = 1;
    for (int wall = 0; wall < 2; ++wall) {
      Matrix<double, D> f;
      for (int c = 0; c < D; ++c) {
        int stride = 1;
        for (int d = 0; d + 1 < D; ++d) {
          f(c, d) = (c == d ? 1.0 : 0.0) + wall * difference(displacement + c * nodes, i, i / stride % extent[d],
                                                             extent[d], stride, greville[d]);
          stride *= extent[d];
        }
        f(c, D - 1) = (c == D - 1 ? 1.0 : 0.0) + slope * displacement[c * nodes + i];
      }
      const Matrix<double, D> cofactors = cofactor(f);
      const double volume = determinant(f, cofactors);
      // |F^{-1}|^2 is at most the largest row sum of F^{-1} F^{-T}.
      double largest = 0;
      for (int r = 0; r < D; ++r) {
        double sum = 0;
        for (int s = 0; s < D; ++s) {
          double entry = 0;
          for (int k = 0; k < D; ++k) entry += cofactors(k, r) * cofactors(k, s);
          sum += Kokkos::abs(entry);
        }
        largest = Kokkos::max(largest, sum);
      }
      worst = Kokkos::max(worst, Kokkos::sqrt(largest) / Kokkos::max(volume, 1e-3));
    }
    return worst;
  }
};

template <int D>
struct FluidPoint {
  const double *velocity, *density;
  ConstArray moments, sums;
  StretchOfColumn<D> column;
  ConstArray blend, mask;
  Kokkos::View<const int*, Exec> near_end;
  NavierStokesKorteweg fluid;
  MassSymbols inside, end;
  StepFormula formula;
  int row_size, nodes, shift, axes;
  double length;

  KOKKOS_FUNCTION void operator()(int i, double* rate) const {
    if (mask(i) == 0) return;
    double speed = 0;
    for (int d = 0; d < D; ++d) {
      const int at = d * nodes + shift + i, wall = d * nodes + shift + i % row_size;
      const double slip = velocity[at] - blend(i / row_size) * velocity[wall];
      speed += slip * slip;
    }
    rates_of_fluid(fluid, near_end(i) != 0 ? end : inside, formula, axes, density[i],
                   Kokkos::max(moments(i) / sums(i), fluid.inertia_floor), Kokkos::sqrt(speed),
                   column.of(i % row_size) / length, rate);
  }
};

}  // namespace softwet::step_points
