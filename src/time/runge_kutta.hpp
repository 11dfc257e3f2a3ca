// Explicit and implicit-explicit Runge-Kutta schemes for an evolution equation. They know no physics.
#pragma once

#include "time/evolution.hpp"

namespace softwet {

/// A one-step scheme: from y at t, with its rates k = f(t, y) to y at t + dt. On failure (a text) y is not to be used.
class RungeKutta {
 public:
  virtual ~RungeKutta() = default;
  virtual Refusal advance(Evolution&, double t, double dt, const Array& y, const Array& k) = 0;

  /// Largest dt for eigenvalues of f up to `radius` in size that are real and negative, or imaginary: a first guess, see
  /// StabilityLimit.
  virtual double limit(double radius, bool imaginary) const = 0;
  virtual const char* name() const = 0;

  /// True where the stiff part is treated apart: `k` and the limit are then those of the gentle rates.
  virtual bool treats_stiff_part() const { return false; }
  /// True where the scheme has to know the spectral radius of the stiff part before it advances.
  virtual bool needs_stiff_radius() const { return false; }
  virtual void set_stiff_radius(double) {}
};

/// Strong-stability-preserving scheme of third order with three stages.
/// Source: Shu and Osher 1988.   Tested: tests/unit/time/test_runge_kutta.cpp
class SspRk3 final : public RungeKutta {
 public:
  explicit SspRk3(int size) : stage_("ssp_rk3.stage", size), rate_("ssp_rk3.rate", size) {}
  Refusal advance(Evolution&, double t, double dt, const Array& y, const Array& k) override;
  double limit(double radius, bool imaginary) const override { return (imaginary ? 1.73 : 2.51) / radius; }
  const char* name() const override { return "ssp_rk3"; }

 private:
  Array stage_, rate_;
};

/// Strang splitting of second order: half a step of the stiff part by the Runge-Kutta-Legendre scheme with s stages, a step
/// of the gentle part by SspRk3, half a step of the stiff part. s follows from the spectral radius r of the stiff part,
/// dt/2 r <= (s^2 + s - 2) / 2. Nothing is solved for, and waves without damping stay bounded, which stabilised schemes of
/// second order for the whole equation do not achieve: |P(i w dt)| > 1 there.
/// Source: Meyer, Balsara and Aslam 2014 (RKL2).   Tested: tests/unit/time/test_runge_kutta.cpp
class StrangRkl2 final : public RungeKutta {
 public:
  explicit StrangRkl2(int size);
  Refusal advance(Evolution&, double t, double dt, const Array& y, const Array& k) override;
  double limit(double radius, bool imaginary) const override { return gentle_.limit(radius, imaginary); }
  const char* name() const override { return "rkl2"; }
  bool treats_stiff_part() const override { return true; }
  bool needs_stiff_radius() const override { return true; }
  void set_stiff_radius(double radius) override { stiff_radius_ = radius; }

  /// Stages of the stiff part for a step of its own.
  static int stages(double step, double radius);

 private:
  Refusal stiff_step(Evolution&, double dt, const Array& y);

  SspRk3 gentle_;
  Array gentle_rate_, first_rate_, rate_, before_, now_, next_;
  double stiff_radius_ = 0;
};

/// Implicit-explicit scheme of third order: four explicit evaluations whose stability polynomial is that of the classical
/// Runge-Kutta scheme, three implicit solves that damp stiff parts completely (L-stable).
/// Source: Ascher, Ruuth and Spiteri 1997, section 2.7 (3,4,3).   Tested: tests/unit/time/test_runge_kutta.cpp
class ImexArs343 final : public RungeKutta {
 public:
  explicit ImexArs343(int size);
  Refusal advance(Evolution&, double t, double dt, const Array& y, const Array& k) override;
  double limit(double radius, bool imaginary) const override { return (imaginary ? 2.82 : 2.78) / radius; }
  const char* name() const override { return "imex"; }
  bool treats_stiff_part() const override { return true; }

 private:
  Array stage_, gentle_[3], stiff_[3];
};

}  // namespace softwet
