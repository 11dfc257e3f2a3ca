#include "time/kick_drift.hpp"

#include "time/sum_of.hpp"

namespace softwet {

template <int D, int P>
KickDrift<D, P>::KickDrift(SemiDiscrete<D, P>& system)
    : ExplicitStep<D, P>(system),
      now_(make_level()),
      next_(make_level()),
      half_("kick_drift.half", system.velocities()),
      middle_("kick_drift.middle", system.moments()) {}

template <int D, int P>
typename KickDrift<D, P>::Level KickDrift<D, P>::make_level() const {
  const auto vector = [](int size) { return Array("kick_drift.vector", size); };
  return {vector(system_.size()), vector(system_.moments()), vector(system_.velocities()), vector(system_.velocities()),
          vector(system_.moments())};
}

template <int D, int P>
Refusal KickDrift<D, P>::begin(const State& s) {
  Kokkos::deep_copy(system_.velocities_of(now_.y), part(s.unknown, 0, system_.velocities()));
  Kokkos::deep_copy(system_.displacements_of(now_.y), s.displacement);
  Kokkos::deep_copy(system_.moments_of(now_.y), s.moment);
  multiply(system_.velocities_of(now_.y), part(system_.model().mask(), 0, system_.velocities()));
  system_.place_mesh(s.time, s.displacement);
  system_.place_velocity(system_.velocities_of(now_.y));
  Refusal problem = system_.find_density(system_.moments_of(now_.y));
  if (problem.empty()) problem = system_.find_potential();
  if (!problem.empty()) return problem;
  if (system_.moments() > 0) Kokkos::deep_copy(now_.density, system_.stage().density_end);
  system_.weigh_velocities(system_.moments_of(now_.y));
  problem = system_.pressure(now_.pressure, now_.stabilisation);
  return problem.empty() ? system_.convection(true, now_.convection) : problem;
}

template <int D, int P>
Refusal KickDrift<D, P>::drift(double t, double dt) {
  const Array u = system_.displacements_of(next_.y), p = system_.moments_of(now_.y), end = system_.moments_of(next_.y);
  Kokkos::deep_copy(Exec(), u, system_.displacements_of(now_.y));
  system_.place_velocity(half_);
  system_.add_motion(0.5 * dt, u);
  system_.place_mesh(t + 0.5 * dt, u);
  system_.place_density(now_.density);
  system_.move_moments(0.5 * dt, p, now_.stabilisation, middle_);
  Refusal problem = system_.find_density(middle_);
  if (!problem.empty()) return problem;
  system_.move_moments(dt, p, now_.stabilisation, end);
  system_.add_motion(0.5 * dt, u);
  system_.place_mesh(t + dt, u);
  return system_.find_density(end);
}

template <int D, int P>
Refusal KickDrift<D, P>::advance(double t, double dt, const StepRates&) {
  const Array v = system_.velocities_of(next_.y);
  sum_of(half_, 1, system_.velocities_of(now_.y), 0.5 * dt, now_.pressure, 0.5 * dt, now_.convection);
  Refusal problem = drift(t, dt);
  if (problem.empty()) problem = system_.find_potential();
  if (!problem.empty()) return problem;
  if (system_.moments() > 0) Kokkos::deep_copy(Exec(), next_.density, system_.stage().density_end);
  system_.weigh_velocities(system_.moments_of(next_.y));
  problem = system_.pressure(next_.pressure, next_.stabilisation);
  if (!problem.empty()) return problem;
  sum_of(v, 1, half_, 0.5 * dt, next_.pressure, 0.5 * dt, now_.convection);
  system_.place_velocity(v);
  problem = system_.convection(true, next_.convection);
  if (!problem.empty()) return problem;
  sum_of(v, 1, half_, 0.5 * dt, next_.pressure, 0.5 * dt, next_.convection);
  system_.place_velocity(v);
  return {};
}

template <int D, int P>
void KickDrift<D, P>::accept(double t, double dt, State& s) {
  s.time = t;
  std::swap(now_, next_);
  const Array before = system_.moments_of(next_.y), p = system_.moments_of(now_.y);
  Kokkos::deep_copy(s.unknown, system_.stage().unknown);
  Kokkos::deep_copy(s.displacement, system_.stage().displacement);
  Kokkos::deep_copy(s.moment, p);
  sum_of(s.moment_rate, 1 / dt, p, -1 / dt, before, 0, p);
  sum_of(s.velocity_rate, 1, now_.pressure, 1, now_.convection, 0, now_.pressure);
  Kokkos::deep_copy(s.displacement_rate, 0.0);
  system_.add_motion(1, s.displacement_rate);
  system_.fill_rate_ghosts(s);
}

template <int D, int P>
void KickDrift<D, P>::visit_memory(StepMemory& memory) {
  memory.vector("kick_drift/at", now_.y);
  if (system_.moments() > 0) memory.vector("kick_drift/density", now_.density);
  memory.vector("kick_drift/pressure", now_.pressure);
  memory.vector("kick_drift/convection", now_.convection);
  if (system_.moments() > 0) memory.vector("kick_drift/stabilisation", now_.stabilisation);
}

template class KickDrift<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
