// The scheme ssp_rk3 on a scene.
#pragma once

#include "time/explicit_step.hpp"
#include "time/runge_kutta.hpp"

namespace softwet {

template <int D, int P>
class RungeKuttaStep final : public ExplicitStep<D, P> {
 public:
  explicit RungeKuttaStep(SemiDiscrete<D, P>& system) : ExplicitStep<D, P>(system), scheme_(system.size()) {
    for (Array* a : {&y_, &rates_, &next_, &next_rates_}) *a = Array("ssp_rk3.vector", system.size());
  }

  StepFormula formula() const override { return StepFormula::runge_kutta; }
  Refusal begin(const State& s) override {
    Kokkos::deep_copy(system_.velocities_of(y_), part(s.unknown, 0, system_.velocities()));
    Kokkos::deep_copy(system_.displacements_of(y_), s.displacement);
    Kokkos::deep_copy(system_.moments_of(y_), s.moment);
    return system_.rates(s.time, y_, rates_);
  }
  Refusal advance(double t, double dt, const StepRates&) override {
    Kokkos::deep_copy(Exec(), next_, y_);
    const Refusal problem = scheme_.advance(system_, t, dt, next_, rates_);
    return problem.empty() ? system_.rates(t + dt, next_, next_rates_) : problem;
  }
  ConstArray moments() const override { return system_.moments_of(y_); }
  ConstArray next_moments() const override { return system_.moments_of(next_); }
  void accept(double t, double, State& s) override {
    s.time = t;
    std::swap(y_, next_);
    std::swap(rates_, next_rates_);
    Kokkos::deep_copy(s.unknown, system_.stage().unknown);
    Kokkos::deep_copy(s.displacement, system_.stage().displacement);
    Kokkos::deep_copy(s.moment, system_.moments_of(y_));
    Kokkos::deep_copy(s.velocity_rate, system_.velocities_of(rates_));
    Kokkos::deep_copy(s.displacement_rate, system_.displacements_of(rates_));
    Kokkos::deep_copy(s.moment_rate, system_.moments_of(rates_));
    system_.fill_rate_ghosts(s);
  }
  void visit_memory(StepMemory& memory) override {
    memory.vector("rates/at", y_);
    memory.vector("rates/values", rates_);
  }

 private:
  using ExplicitStep<D, P>::system_;
  SspRk3 scheme_;
  Array y_, rates_, next_, next_rates_;
};

}  // namespace softwet
