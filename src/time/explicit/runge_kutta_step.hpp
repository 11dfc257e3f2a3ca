// The schemes ssp_rk3 and rkl2 on a scene.
#pragma once

#include "time/explicit/explicit_step.hpp"
#include "time/explicit/runge_kutta.hpp"

namespace softwet {

/// A step of SspRk3. With Viscosity::apart it leaves viscosity out, and half a step of viscosity by Rkl2 comes before
/// and after it (Strang). Where a solid is viscous, both halves have an acceleration c by everything else, and the step
/// between them has c less:
///   v' = V(v) + c for dt/2,   y' = f(y) - (c, 0, 0) for dt,   v' = V(v) + c for dt/2,
///   c = the acceleration in f(t_0 + a dt, y_0 + a dt y_0') with the velocities of the start, a = 2/5
/// The scheme is of second order. Its steps are as long as waves allow, however viscous the solid or thin the vapour
/// is: where viscosity balances c, both parts rest, and creep has its true speed. Without c the speed of creep would be
/// wrong by s dt/2 coth(s dt/2), with the rate s of viscosity. Where nothing creeps, c = 0 has the smaller errors.
/// Source: Speth, Green, MacNamara and Strang 2013 (balanced splitting).
/// The value of a is ours. Elasticity of the rate w changes by w^2 v t while the solid creeps at v, so that the step in
/// the middle moves it by dt v (1 - (1/6 - a/2) (w dt)^2) and leaves its velocity too small by (1/2 - a) (w dt)^2 v. As
/// few stages as stability needs damp stiff modes by a half in each half step, not to nothing, so a third of this error
/// is left in the next step: both errors cancel at a = 2/5.
/// Tested: tests/unit/time/explicit/test_kick_drift.cpp
template <int D, int P>
class RungeKuttaStep final : public ExplicitStep<D, P> {
 public:
  RungeKuttaStep(SemiDiscrete<D, P>& system, Viscosity viscosity)
      : ExplicitStep<D, P>(system),
        apart_(viscosity == Viscosity::apart &&
               (system.scene().layout().has_fluid || system.scene().equations().has_viscous_solid())),
        balanced_(apart_ && system.scene().equations().has_viscous_solid()),
        scheme_(system.size()) {
    if (balanced_) ahead_ = Array("rkl2.ahead", system.size());
    for (Array* a : {&y_, &rates_, &next_, &next_rates_}) *a = Array("ssp_rk3.vector", system.size());
    if (apart_) viscous_ = std::make_unique<Rkl2>(system.velocities());
    system.treat_viscosity(apart_ ? Viscosity::apart : Viscosity::among_all);
  }

  StepFormula formula() const override { return apart_ ? StepFormula::without_viscosity : StepFormula::runge_kutta; }
  Refusal begin(const State& s) override {
    Kokkos::deep_copy(Exec(), system_.velocities_of(y_), part(s.unknown, 0, system_.velocities()));
    Kokkos::deep_copy(Exec(), system_.displacements_of(y_), s.displacement);
    Kokkos::deep_copy(Exec(), system_.moments_of(y_), s.moment);
    multiply(system_.velocities_of(y_), part(system_.scene().mask(), 0, system_.velocities()));
    return system_.rates(s.time, y_, rates_);
  }
  Refusal start(double t, double dt, const StepRates& rates) override {
    Kokkos::deep_copy(Exec(), next_, y_);
    Array begin = rates_;
    Refusal problem;
    if (balanced_) problem = look_ahead(t, dt);
    Gentle gentle(system_, balanced_ ? system_.velocities_of(ahead_) : Array());
    if (apart_ && problem.empty()) {
      problem = diffuse(t, dt, rates);
      begin = next_rates_;
      if (problem.empty()) problem = gentle.rates(t, next_, begin);
    }
    if (problem.empty()) problem = scheme_.advance(gentle, t, dt, next_, begin);
    if (apart_ && problem.empty()) problem = diffuse(t + dt, dt, rates);
    return problem.empty() ? system_.rates(t + dt, next_, next_rates_) : problem;
  }
  ConstArray moments() const override { return system_.moments_of(y_); }
  ConstArray next_moments() const override { return system_.moments_of(next_); }
  void accept(double t, double, State& s, const Array& before) override {
    s.time = t;
    Kokkos::deep_copy(Exec(), before, s.unknown);
    std::swap(y_, next_);
    std::swap(rates_, next_rates_);
    Kokkos::deep_copy(Exec(), s.unknown, system_.stage().unknown);
    Kokkos::deep_copy(Exec(), s.displacement, system_.stage().displacement);
    Kokkos::deep_copy(Exec(), s.moment, system_.moments_of(y_));
    Kokkos::deep_copy(Exec(), s.velocity_rate, system_.velocities_of(rates_));
    Kokkos::deep_copy(Exec(), s.displacement_rate, system_.displacements_of(rates_));
    Kokkos::deep_copy(Exec(), s.moment_rate, system_.moments_of(rates_));
    system_.fill_rate_ghosts(s);
  }
  void visit_memory(StepMemory& memory) override {
    memory.vector("rates/at", y_);
    memory.vector("rates/values", rates_);
  }

 private:
  using ExplicitStep<D, P>::system_;

  /// The equations of the step between the two halves of viscosity.
  struct Gentle final : Evolution {
    SemiDiscrete<D, P>& system;
    Array constant;  ///< c; empty: 0

    Gentle(SemiDiscrete<D, P>& s, const Array& c) : system(s), constant(c) {}
    int size() const override { return system.size(); }
    Refusal rates(double t, const Array& y, const Array& out) override {
      const Refusal problem = system.rates(t, y, out);
      if (problem.empty() && constant.data()) add_scaled(system.velocities_of(out), 0, -1, constant);
      return problem;
    }
  };

  /// Finds c. Afterwards the next vector is again the vector at the start.
  Refusal look_ahead(double t, double dt) {
    constexpr double part = 0.4;
    const auto move = [&](const Array& y, const Array& rate) { add_scaled(y, 0, part * dt, rate); };
    move(system_.displacements_of(next_), system_.displacements_of(rates_));
    move(system_.moments_of(next_), system_.moments_of(rates_));
    const Refusal problem = system_.rates(t + part * dt, next_, ahead_);
    Kokkos::deep_copy(Exec(), next_, y_);
    return problem;
  }

  /// Half a step of viscosity, with c, at the density and mesh of the next vector.
  Refusal diffuse(double t, double dt, const StepRates& rates) {
    constexpr double margin = 1.5;  // the rate is a bound where the weights of neighbours are alike
    const Array p = system_.moments_of(next_);
    const auto at =
        system_.weigh_velocities(system_.find_density(system_.place_mesh(t, system_.displacements_of(next_)), p), p);
    const Rkl2::Rates with_constant = [&](const Array& v, const Array& out) {
      const Refusal failure = system_.viscosity(at, v, out);
      if (failure.empty() && balanced_) add_scaled(out, 0, 1, system_.velocities_of(ahead_));
      return failure;
    };
    return viscous_->advance(with_constant, 0.5 * dt, system_.velocities_of(next_), margin * rates.viscosity);
  }

  bool apart_, balanced_;
  SspRk3 scheme_;
  std::unique_ptr<Rkl2> viscous_;
  Array y_, rates_, next_, next_rates_, ahead_;
};

}  // namespace softwet
