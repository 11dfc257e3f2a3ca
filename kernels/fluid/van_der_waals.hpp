// Van der Waals fluid: free energy per volume and its derivatives.
#pragma once

#include "kernels/algebra/dual.hpp"

namespace softwet {

/// W(rho) = (8/27) theta rho ln(rho/(1-rho)) - rho^2                                       scale a b^2
/// Below `continuation` W is continued by its second-order Taylor polynomial, so that it stays convex and finite there.
/// Source: Bueno et al. 2017, eq. (6), scaled as in eqs. (8)-(13).   Tested: tests/unit/fluid/test_van_der_waals.cpp
struct VanDerWaals {
  double temperature = 0;   ///< theta / theta_c, in (0, 1)
  double continuation = 0;  ///< density below which W is continued; 0: nowhere

  /// W'(rho), scale a b: the chemical potential of the homogeneous fluid.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N derivative(const N& rho) const {
    const double r0 = continuation;
    const auto low = rho < r0;
    const N r = select(low, N(r0 > 0 ? r0 : 0.5), rho);
    const N rest = 1.0 - r;
    const N value = factor() * (logarithm(r / rest) + 1.0 / rest) - 2.0 * r;
    return value + select(low, (rho - r0) * curvature(r0), N(0.0));
  }

  /// W(rho), scale a b^2.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N energy(const N& rho) const {
    const double r0 = continuation;
    const auto low = rho < r0;
    const N r = select(low, N(r0 > 0 ? r0 : 0.5), rho);
    const N value = factor() * r * logarithm(r / (1.0 - r)) - r * r;
    const N s = rho - r0;
    return value + select(low, s * (slope(r0) + 0.5 * curvature(r0) * s), N(0.0));
  }

  /// W(rho) - W(r) - W'(r) (rho - r), the height of W above its tangent at r, scale a b^2; not for densities below
  /// `continuation`. With s = rho - r, q = 1 - r, c = (8/27) theta and z = s / (rho q + r (1 - rho)) this is
  ///   c rho ln(rho q / (r (1 - rho))) - c s/q - s^2,  where ln(...)/2 = z + z^3/3 + ...
  /// In what remains of the powers of s, only small numbers are subtracted: their coefficients are taken in double.
  /// @param at  at(f) is f(r), lane by lane
  template <class N, class At>
  KOKKOS_FORCEINLINE_FUNCTION N above_tangent(const N& rho, const At& at) const {
    const double c = factor();
    // r is the sum of a number that fits single precision, and a rest.
    const N s = (rho - at([](double r) { return double(float(r)); })) - at([](double r) { return r - float(r); });
    const N a = rho * at([](double r) { return 1 - r; }), b = (1.0 - rho) * at([](double r) { return r; });
    const N z = s / (at([](double r) { return 2 * r * (1 - r); }) + s * at([](double r) { return 1 - 2 * r; }));
    const N second = at([c](double r) { return c / (1 - r) - 2 * r * (1 - r); });
    const N third = at([c](double r) { return 2 * c * r - 12 * (1 - 2 * r) * r * r * (1 - r) * (1 - r); });
    const N fourth = at([c](double r) { return 2 * c - 12 * (1 - 2 * r) * (1 - 2 * r) * r * (1 - r); });
    const N fifth = at([](double r) { return -3 * (1 - 2 * r) * (1 - 2 * r) * (1 - 2 * r); });
    return s * z * second + (1.0 / 3.0) * (z * z * z) * (third + s * (fourth + s * fifth)) +
           (2.0 * c) * rho * half_logarithm_rest(a, b, z);
  }

  /// p(rho) = rho W' - W, scale a b^2.
  template <class N>
  KOKKOS_FORCEINLINE_FUNCTION N pressure(const N& rho) const {
    return rho * derivative(rho) - energy(rho);
  }

  /// W''(rho) = c^2 / rho, scale a.
  KOKKOS_FORCEINLINE_FUNCTION double curvature(double r) const {
    return r > 0 ? factor() / (r * (1.0 - r) * (1.0 - r)) - 2.0 : 0.0;
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION double factor() const { return 8.0 / 27.0 * temperature; }
  KOKKOS_FORCEINLINE_FUNCTION double slope(double r) const {
    return r > 0 ? factor() * (Kokkos::log(r / (1.0 - r)) + 1.0 / (1.0 - r)) - 2.0 * r : 0.0;
  }
};

}  // namespace softwet
