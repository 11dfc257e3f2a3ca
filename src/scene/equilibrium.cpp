#include "scene/equilibrium.hpp"

#include <cmath>

#include "case/case.hpp"
#include "case/error.hpp"
#include "spline/axis.hpp"

namespace softwet {

namespace {

/// Root of an increasing function on [lo, hi] by bisection to the last bit.
template <class F>
double bisect(const F& f, double lo, double hi) {
  for (int i = 0; i < 300; ++i) {
    const double middle = 0.5 * (lo + hi);
    if (middle <= lo || middle >= hi) break;
    (f(middle) < 0 ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

/// Integral of f(sqrt(2 D(rho))) over the density, from vapour to liquid.
template <class F>
double integral_over_interface(const Fluid& fluid, const F& f) {
  const VanDerWaals gas{fluid.temperature, 0};
  const Coexistence s = coexistence(fluid.temperature);
  const Gauss rule(12);
  // D vanishes quadratically at both ends: the substitution rho = middle - half cos(phi) keeps the integrand smooth.
  const double middle = 0.5 * (s.density_vapour + s.density_liquid), half = 0.5 * (s.density_liquid - s.density_vapour);
  double sum = 0;
  const int panels = 64;
  for (int p = 0; p < panels; ++p)
    for (int q = 0; q < 12; ++q) {
      const double phi = M_PI * (p + rule.point[q]) / panels;
      const double rho = middle - half * std::cos(phi);
      sum +=
          rule.weight[q] * M_PI / panels * half * std::sin(phi) * f(std::sqrt(2 * std::max(s.excess(gas, rho), 0.0)));
    }
  return sum;
}

}  // namespace

PhaseDensities spinodal(double theta) {
  const auto excess = [theta](double r) { return r * (1 - r) * (1 - r) - 4 * theta / 27; };
  return {bisect(excess, 0.0, 1.0 / 3), bisect([&](double r) { return -excess(r); }, 1.0 / 3, 1.0)};
}

PhaseDensities densities_at(double theta, double potential) {
  const VanDerWaals gas{theta, 0};
  const PhaseDensities limit = spinodal(theta);
  const auto excess = [&](double r) { return gas.derivative(r) - potential; };
  // The vapour branch is searched in ln(rho): at low temperature its density spans many decades.
  const double vapour = std::exp(bisect([&](double s) { return excess(std::exp(s)); }, -700.0, std::log(limit.vapour)));
  return {vapour, bisect(excess, limit.liquid, 1.0 - 1e-16)};
}

Coexistence coexistence(double theta) {
  if (!(theta > 0 && theta < 1))
    throw Error(Exit::invalid_input, "fluid.temperature = " + std::to_string(theta) +
                                         ": two phases coexist only for temperatures in (0, 1)");
  const VanDerWaals gas{theta, 0};
  const PhaseDensities limit = spinodal(theta);
  const auto pressure_jump = [&](double mu) {
    const PhaseDensities r = densities_at(theta, mu);
    return gas.pressure(r.liquid) - gas.pressure(r.vapour);
  };
  const double mu = bisect(pressure_jump, gas.derivative(limit.liquid), gas.derivative(limit.vapour));
  const PhaseDensities r = densities_at(theta, mu);
  if (!(r.liquid - r.vapour > 1e-4))  // closer to 1 the pressures, alike to the cube of this, cannot be told apart
    throw Error(Exit::invalid_input,
                "fluid.temperature is so close to the critical temperature, 1, that liquid and vapour differ by less "
                "than 1e-4 in density; choose 0.99999 or less");
  return {r.vapour, r.liquid, gas.pressure(r.vapour), mu};
}

double surface_tension(const Fluid& fluid) {
  return fluid.capillarity * integral_over_interface(fluid, [](double root) { return root; });
}

double mean_interface_slope(const Fluid& fluid) {
  return integral_over_interface(fluid, [](double root) { return root * root; }) / surface_tension(fluid);
}

double interface_half_width(const Fluid& fluid) {
  const VanDerWaals gas{fluid.temperature, 0};
  const Coexistence s = coexistence(fluid.temperature);
  const double jump = s.density_liquid - s.density_vapour, middle = 0.5 * (s.density_liquid + s.density_vapour);
  return 0.5 * jump * fluid.capillarity / std::sqrt(2 * s.excess(gas, middle));
}

}  // namespace softwet
