// The energy of the wall, whose derivative is the law "energy" of the contact angle.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/fluid/contact_angle.hpp"

namespace softwet {

/// f_w(rho) = -cos(alpha) g int_{rho_v}^{rho} (sqrt(2 D + d^2) - d), scale a b^2 L0: minus the integral of the force.
/// It is tabulated once, on the host, by a Chebyshev series on either side of the middle density. The variable of a
/// series is t = arsinh((rho - phase) / width), in which the bend of the root at the phase is as wide as 1.
/// The error is below 1e-12 of the surface tension for temperatures from 0.2 to 0.99. Where a density is outside of
/// [first, last], the force is integrated from there on point by point, with an error below 1e-8 down to -0.1.
/// Tested: tests/unit/fluid/test_wall_energy.cpp
struct WallEnergy {
  static constexpr int terms = 64;

  struct Half {
    double phase = 0, width = 1, centre = 0, radius = 1;  ///< t is within `radius` of `centre`
    double coefficient[terms] = {};
  };

  EnergyWall law;
  Half vapour, liquid;
  double first = 0, last = 1;

  /// The table, on the host.
  static WallEnergy of(const EnergyWall& law) {
    WallEnergy w;
    const double v = law.state.density_vapour, l = law.state.density_liquid, middle = law.state.middle();
    w.law = law;
    w.first = 0.75 * v;
    w.last = l + 0.25 * (1 - l);
    w.vapour = half(law, v, w.first, middle);
    w.liquid = half(law, l, middle, w.last);
    w.vapour.coefficient[0] -= w.value(v);
    w.liquid.coefficient[0] += w.value(std::nextafter(middle, 0.0)) - w.value(middle);
    return w;
  }

  /// The derivative is the force itself, to the last digit, not the derivative of the series.
  template <class S>
  KOKKOS_FORCEINLINE_FUNCTION Dual<S> value(const Dual<S>& rho) const {
    return {value(rho.value), S(0.0) - law.force(rho.value) * rho.tangent};
  }
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N value(const N& rho) const {
    const N above = select(rho < first, N(first), rho), inside = select(above < last, above, N(last));
    const auto lower = inside < law.state.middle();
    const auto either = [&](double v, double l) { return select(lower, N(v), N(l)); };
    const N t = arsinh((inside - either(vapour.phase, liquid.phase)) / either(vapour.width, liquid.width));
    const N x = (t - either(vapour.centre, liquid.centre)) / either(vapour.radius, liquid.radius);
    N next = N(0.0), after = N(0.0);  // Clenshaw's recurrence
    for (int k = terms - 1; k > 0; --k) {
      const N now = either(vapour.coefficient[k], liquid.coefficient[k]) + 2.0 * x * next - after;
      after = next;
      next = now;
    }
    const N energy = either(vapour.coefficient[0], liquid.coefficient[0]) + x * next - after;
    const N rest = rho - inside;
    return any_nonzero(rest) ? N(energy - integral(inside, rest)) : energy;
  }

 private:
  /// The series on [from, to] without its constant: the series of the derivative by t, from its values at the roots of
  /// a Chebyshev polynomial, integrated term by term.
  static Half half(const EnergyWall& law, double phase, double from, double to) {
    const double slope = std::sqrt(law.gas.curvature(phase)), narrowest = 1e-6;
    Half h;
    h.phase = phase;
    h.width = std::min(std::max(law.smoothing, narrowest) / slope, phase);
    const double low = std::asinh((from - phase) / h.width), high = std::asinh((to - phase) / h.width);
    h.centre = 0.5 * (low + high);
    h.radius = 0.5 * (high - low);
    double derivative[terms + 1] = {};
    for (int j = 0; j < terms; ++j) {
      const double angle = M_PI * (j + 0.5) / terms, t = h.centre + h.radius * std::cos(angle);
      const double f = -law.force(phase + h.width * std::sinh(t)) * h.width * std::cosh(t);
      for (int k = 0; k < terms; ++k) derivative[k] += (k == 0 ? 1.0 : 2.0) / terms * f * std::cos(k * angle);
    }
    for (int k = 1; k < terms; ++k) {
      const double before = k == 1 ? 2 * derivative[0] : derivative[k - 1];
      h.coefficient[k] = h.radius * (before - derivative[k + 1]) / (2 * k);
    }
    return h;
  }

  /// Integral of the force from a density over `span` by 8 panels of 8-point Gauss-Legendre in s, rho = from + span
  /// s^2: the points gather where W'' is largest.
  template <class N>
  KOKKOS_FUNCTION N integral(const N& from, const N& span) const {
    // Abscissae and weights on [-1, 1], positive half.
    const double x[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    const double w[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    const int panels = 8;
    N sum = N(0.0);
    for (int p = 0; p < panels; ++p)
      for (int i = 0; i < 8; ++i) {
        const double s = (p + 0.5 * (1.0 + (i < 4 ? x[i] : -x[i - 4]))) / panels;
        sum = sum + (w[i % 4] * s) * law.force(from + (s * s) * span);
      }
    return (1.0 / panels) * (span * sum);
  }
};

}  // namespace softwet
