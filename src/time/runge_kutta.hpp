// Explicit and implicit-explicit Runge-Kutta schemes for an evolution equation. They know no physics.
#pragma once

#include "time/evolution.hpp"

namespace softwet {

/// A one-step scheme: from y at t, with its rates k = f(t, y) to y at t + dt. On failure (a text) y is not to be used.
class RungeKutta {
 public:
  virtual ~RungeKutta() = default;
  virtual std::string advance(Evolution&, double t, double dt, const Array& y, const Array& k) = 0;

  /// Largest dt for eigenvalues of f up to `radius` in size, anywhere in the left half of the complex plane.
  virtual double limit(double radius) const = 0;
  virtual const char* name() const = 0;

  /// True where the stiff part is implicit: `k` and the limit are then those of the gentle rates.
  virtual bool treats_stiff_part() const { return false; }
};

/// Strong-stability-preserving scheme of third order with three stages.
/// Source: Shu and Osher 1988.   Tested: tests/unit/time/test_runge_kutta.cpp
class SspRk3 final : public RungeKutta {
 public:
  explicit SspRk3(int size) : stage_("ssp_rk3.stage", size), rate_("ssp_rk3.rate", size) {}
  std::string advance(Evolution&, double t, double dt, const Array& y, const Array& k) override;
  double limit(double radius) const override { return 1.73 / radius; }
  const char* name() const override { return "ssp_rk3"; }

 private:
  Array stage_, rate_;
};

/// Implicit-explicit scheme of third order: four explicit evaluations whose stability polynomial is that of the classical
/// Runge-Kutta scheme, three implicit solves that damp stiff parts completely (L-stable).
/// Source: Ascher, Ruuth and Spiteri 1997, section 2.7 (3,4,3).   Tested: tests/unit/time/test_runge_kutta.cpp
class ImexArs343 final : public RungeKutta {
 public:
  explicit ImexArs343(int size);
  std::string advance(Evolution&, double t, double dt, const Array& y, const Array& k) override;
  double limit(double radius) const override { return 2.61 / radius; }
  const char* name() const override { return "imex"; }
  bool treats_stiff_part() const override { return true; }

 private:
  Array stage_, gentle_[3], stiff_[3];
};

}  // namespace softwet
