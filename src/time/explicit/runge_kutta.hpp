// Explicit Runge-Kutta schemes for an evolution equation. They know no physics.
#pragma once

#include <functional>

#include "time/explicit/evolution.hpp"

namespace softwet {

/// Strong-stability-preserving scheme of third order with three stages: from y at t, with its rates k = f(t, y), to y
/// at t + dt. Stable for eigenvalues z / dt with |z| <= 1.73 on the imaginary axis and 2.51 on the negative one.
/// Source: Shu and Osher 1988.   Tested: tests/unit/time/explicit/test_runge_kutta.cpp
class SspRk3 {
 public:
  explicit SspRk3(int size) : stage_("ssp_rk3.stage", size), rate_("ssp_rk3.rate", size) {}
  /// On a refusal y is not to be used.
  Refusal advance(Evolution&, double t, double dt, const Array& y, const Array& k);

 private:
  Array stage_, rate_;
};

/// Runge-Kutta-Legendre scheme of second order for equations y' = g(y) with real negative eigenvalues down to -r. Its s
/// stages bear dt r <= (s^2 + s - 2) / 2, so that a step is as long as wanted. Nothing is solved for.
/// Source: Meyer, Balsara and Aslam 2014 (RKL2).   Tested: tests/unit/time/explicit/test_runge_kutta.cpp
class Rkl2 {
 public:
  using Rates = std::function<Refusal(const Array& y, const Array& out)>;

  explicit Rkl2(int size);
  /// @param radius  r, or more
  Refusal advance(const Rates&, double dt, const Array& y, double radius);
  /// Stages of a step.
  static int stages(double dt, double radius);

 private:
  Array first_rate_, rate_, before_, now_, next_;
};

}  // namespace softwet
