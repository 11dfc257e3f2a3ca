// The shape of the interface between liquid and vapour at rest.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/fluid/contact_angle.hpp"

namespace softwet {

/// The planar interface in equilibrium: along the distance s from the middle density (rho_l + rho_v)/2 towards the
/// vapour
///   g d rho/ds = -sqrt(2 D(rho)),   f = (rho - rho_v)/(rho_l - rho_v): 1 in the liquid, 1/2 at s = 0, 0 in the vapour.
/// On either side f tends to its end exponentially, and faster in the phase with the larger W''. It is tabulated once,
/// on the host, by t = ln((1 - f)/f), in which
///   ds/dt = g (rho_l - rho_v) f (1 - f) / sqrt(2 D)
/// is smooth and tends to g/sqrt(W'') at both ends; beyond the table t is linear in s. The error of f is below 1e-8.
/// Tested: tests/unit/fluid/test_interface_profile.cpp
class InterfaceProfile {
 public:
  InterfaceProfile(const VanDerWaals& gas, const Coexistence& state, double capillarity) {
    const double vapour = state.density_vapour, liquid = state.density_liquid, jump = liquid - vapour;
    // Where the distance from a phase is 1e-8 of the distance to the end of its branch, D is a parabola.
    const double beyond = 18;
    low_ = -beyond - std::log(std::max(1.0, jump / (1 - liquid)));
    const double high = beyond + std::log(std::max(1.0, jump / vapour));
    const int count = static_cast<int>(std::ceil((high - low_) / step)) + 1;
    const auto rate = [&](double t) {
      const double f = 1 / (1 + std::exp(t)), rho = t < 0 ? liquid - jump / (1 + std::exp(-t)) : vapour + jump * f;
      return capillarity * jump * f * (1 - f) / std::sqrt(2 * state.excess(gas, rho));
    };
    double distance = 0, origin = 0;
    for (int i = 0; i < count; ++i) {
      const double t = low_ + i * step;
      distance_.push_back(distance);
      slope_.push_back(1 / rate(t));
      if (t <= 0 && t + step > 0) origin = distance + integral(rate, t, 0);
      distance += integral(rate, t, t + step);
    }
    for (double& s : distance_) s -= origin;
  }

  /// f at a distance from the middle density, positive in the vapour; scale L0.
  double liquid(double distance) const { return 1 / (1 + std::exp(logit(distance))); }
  /// 1 - f, with all its digits.
  double vapour(double distance) const { return 1 / (1 + std::exp(-logit(distance))); }

 private:
  static constexpr double step = 1.0 / 16;

  /// Three-point Gauss-Legendre.
  template <class F>
  static double integral(const F& f, double from, double to) {
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from), away = std::sqrt(0.6) * half;
    return half / 9 * (5 * f(middle - away) + 8 * f(middle) + 5 * f(middle + away));
  }

  /// t of a distance: the cubic with the values and slopes of the table.
  double logit(double s) const {
    const auto last = static_cast<int>(distance_.size()) - 1;
    const auto above = std::upper_bound(distance_.begin(), distance_.end(), s);
    const int i = static_cast<int>(above - distance_.begin()) - 1;
    if (i < 0) return low_ + slope_.front() * (s - distance_.front());
    if (i >= last) return low_ + last * step + slope_.back() * (s - distance_.back());
    const double length = distance_[i + 1] - distance_[i], x = (s - distance_[i]) / length;
    const double begin = length * slope_[i] - step, end = step - length * slope_[i + 1];
    return low_ + (i + x) * step + x * (1 - x) * (begin * (1 - x) + end * x);
  }

  double low_;                            ///< t of the first entry
  std::vector<double> distance_, slope_;  ///< s and dt/ds at equidistant t
};

}  // namespace softwet
