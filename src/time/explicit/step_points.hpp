// What the bound of explicit steps sees at a control point of the fluid and in a column of the mesh.
#pragma once

#include <algorithm>
#include <cmath>

#include "time/explicit/step_bound.hpp"

namespace softwet::step_points {

enum Mechanism { combined, sound, capillarity, viscosity, stabilisation, flow, elasticity, mechanisms };

template <class N>
KOKKOS_FORCEINLINE_FUNCTION N larger(const N& a, const N& b) {
  return select(a < b, b, a);
}

/// See StepFormula: waves w, viscosity s, stabilisation e, flow u. N is a number or a pack of them.
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N combine(StepFormula formula, const N& w, const N& s, const N& e, const N& u) {
  if (formula == StepFormula::kick_drift) {
    const N waves = w + u;
    return larger(N(0.25 * (square_root(N(e * e + 4.0 * waves * waves)) + e + s)), s);
  }
  const N turn = (w + u) / 1.73, decay = (formula == StepFormula::runge_kutta ? N(s + e) : e) / 2.51;
  return square_root(N(turn * turn + decay * decay));
}

/// Derivative of a field along an axis at a control point, from its neighbour's control value.
KOKKOS_INLINE_FUNCTION double difference(const double* c, int i, int place, int extent, int stride,
                                         const ConstArray& greville) {
  const int from = place + 1 < extent ? place : place - 1, at = i + (from - place) * stride;
  return (c[at + stride] - c[at]) / (greville(from + 1) - greville(from));
}

/// The symbols that count in the fluid.
template <class N>
struct FluidSymbols {
  N acoustic, capillary, viscous, diffusive, convective;

  /// @param near_end  1 near an end, else 0
  KOKKOS_FORCEINLINE_FUNCTION FluidSymbols(const N& near_end, const MassSymbols& inside, const MassSymbols& end)
      : acoustic(of(near_end, inside.acoustic, end.acoustic)),
        capillary(of(near_end, inside.capillary, end.capillary)),
        viscous(of(near_end, inside.viscous, end.viscous)),
        diffusive(of(near_end, inside.diffusive, end.diffusive)),
        convective(of(near_end, inside.convective, end.convective)) {}

 private:
  KOKKOS_FORCEINLINE_FUNCTION static N of(const N& near_end, double inside, double end) {
    return select(0.0 < near_end, N(end), N(inside));
  }
};

/// W'' of each density.
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N curvature(const VanDerWaals& gas, const N& density) {
  if constexpr (is_one_number<N>) {
    return gas.curvature(density);
  } else {
    double lane[Lanes<N>::count] = {};
    add_to(lane, density);
    for (double& value : lane) value = gas.curvature(value);
    return load<N>(lane);
  }
}

/// Rates of the fluid where it has a density, a mean density of the control point, `inertia`, and a speed over the
/// mesh.
/// @param many     axes whose symbols add up
/// @param inverse  of the length of elements
template <class N>
KOKKOS_FORCEINLINE_FUNCTION void rates_of_fluid(const NavierStokesKorteweg& fluid, const FluidSymbols<N>& symbols,
                                                StepFormula formula, double many, const N& density, const N& inertia,
                                                const N& speed, const N& inverse, N* rate) {
  const N square = inverse * inverse;
  const N rho = larger(density, N(fluid.gas.continuation)), c2 = rho * curvature(fluid.gas, rho);
  const double g2 = fluid.capillarity * fluid.capillarity;
  const N c2_on = larger(c2, N(0.0));
  rate[sound] = square_root(N(many * symbols.acoustic * symbols.acoustic * c2_on * square));
  rate[capillarity] = many * symbols.capillary * square_root(N(g2 * rho)) * square;
  const N wave = square_root(N(rate[sound] * rate[sound] + rate[capillarity] * rate[capillarity]));
  const N k = many * symbols.diffusive * square;
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
  template <class N>
  KOKKOS_FUNCTION N of(int i) const {
    if constexpr (host_algorithms) {
      return load<N>(&stretch(i));
    } else {
      return displacement ? at(i) : 1.0;
    }
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
  ConstArray blend, mask, near_end;  ///< the last: 1 near an end, else 0
  NavierStokesKorteweg fluid;
  MassSymbols inside, end;
  StepFormula formula;
  int row_size, nodes, shift, axes;
  double length;

  KOKKOS_FUNCTION void operator()(int i, double* rate) const {
    if (mask(i) != 0) rates<double>(i, blend(i / row_size), i % row_size, rate);
  }

  /// Takes the largest rates of the points [first, last) on a processor, in packs: the last one of a row ends with it and
  /// may repeat points, so that a rate has the same bits wherever its point stands in a row.
  void take_largest(int first, int last, double* best) const {
    using S = Pack<double>;
    constexpr int lanes = Lanes<S>::count;
    if (row_size < lanes) return take_one_by_one(first, last, best);
    S most[mechanisms], found[mechanisms];
    for (S& rate : most) rate = S(0.0);
    for (S& rate : found) rate = S(0.0);
    while (first < last) {
      const int row = first / row_size, end = (row + 1) * row_size;
      for (; first < std::min(last, end); first += lanes) {
        const int at = std::min(first, end - lanes);
        rates<S>(at, blend(row), at - row * row_size, found);
        const S free = load<S>(mask.data() + at);
        for (int m = 0; m < mechanisms; ++m) most[m] = larger(most[m], S(select(free == S(0.0), S(0.0), found[m])));
      }
      first = std::min(first, end);
    }
    for (int m = 0; m < mechanisms; ++m) {
      double lane[lanes] = {};
      add_to(lane, most[m]);
      for (const double rate : lane) best[m] = best[m] < rate ? rate : best[m];
    }
  }

 private:
  void take_one_by_one(int first, int last, double* best) const {
    for (; first < last; ++first) {
      double rate[mechanisms] = {};
      (*this)(first, rate);
      for (int m = 0; m < mechanisms; ++m) best[m] = best[m] < rate[m] ? rate[m] : best[m];
    }
  }
  /// @param blended  blend of the row
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION void rates(int i, double blended, int at_wall, N* rate) const {
    const auto at = [](const double* p) { return load<N>(p); };
    N square = N(0.0);
    for (int d = 0; d < D; ++d) {
      const double* v = velocity + d * nodes + shift;
      const N slip = at(v + i) - blended * at(v + at_wall);
      square = square + slip * slip;
    }
    const N inertia = larger(N(at(&moments(i)) / at(&sums(i))), N(fluid.inertia_floor));
    rates_of_fluid<N>(fluid, {at(&near_end(i)), inside, end}, formula, axes, at(density + i), inertia,
                      square_root(square), N(column.template of<N>(at_wall) / length), rate);
  }
};

}  // namespace softwet::step_points
