// The scheme kick_drift: one evaluation of the equations for a step.
#pragma once

#include "time/explicit/explicit_step.hpp"

namespace softwet {

/// Kick, drift, kick with a predicted velocity, of second order, but for the stabilisation F, which counts as it was
/// before the step: of first order, with a coefficient that falls with h^2. From v, u, p and the density with its
/// accelerations P (of pressure, capillarity, elasticity and loads) and C (of convection and viscosity) and the rates F
/// of the moments by the stabilisation:
///
///   vh  = v + dt/2 (P + C)                                   first kick
///   u1  = u + dt vh                                          drift, with which branches of the solid go
///   pm  = p + dt/2 (G(rho, vh) + F),   rhom = S pm           on the mesh half way; G is the flux of mass
///   p1  = p + dt (G(rhom, vh) + F),    rho1 = S p1           on the mesh at the end
///   P1, F1 from rho1, mu1 and u1
///   vp  = vh + dt/2 (P1 + C)                                 predicted with the new pressure
///   C1  from rho1 and vp
///   v1  = vh + dt/2 (P1 + C1)                                second kick
///
/// Waves of the frequency w alone are stable up to w dt = 2. The sum of the moments is kept to rounding.
/// Source: Verlet 1967, with Heun's predictor for forces that depend on velocities.
/// Tested: tests/unit/time/explicit/test_kick_drift.cpp
template <int D, int P>
class KickDrift final : public ExplicitStep<D, P> {
 public:
  explicit KickDrift(SemiDiscrete<D, P>&);

  StepFormula formula() const override { return StepFormula::kick_drift; }
  Refusal begin(const State&) override;
  void prepare(double t, double dt) override { system_.set_step(t, dt); }
  bool recordable() const override { return system_.recordable(); }
  Refusal start(double t, double dt, const StepRates&) override;
  ConstArray moments() const override { return system_.moments_of(now_.y); }
  ConstArray next_moments() const override { return system_.moments_of(next_.y); }
  void accept(double t, double dt, State&, const Array& before) override;
  void visit_memory(StepMemory&) override;

 private:
  using ExplicitStep<D, P>::system_;

  /// A state with what the next step needs.
  struct Level {
    Array y, density;
    Array pressure, convection;  ///< accelerations
    Array stabilisation;         ///< rates of the moments
    Array memory;                ///< of branches of the solid
  };
  Level make_level() const;

  Level now_, next_;
  Array half_;    ///< vh
  Array middle_;  ///< pm
};

}  // namespace softwet
