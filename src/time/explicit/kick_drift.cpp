#include "time/explicit/kick_drift.hpp"

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
  return {vector(system_.size()),       vector(system_.moments()), vector(system_.velocities()),
          vector(system_.velocities()), vector(system_.moments()), vector(system_.memory())};
}

template <int D, int P>
Refusal KickDrift<D, P>::begin(const State& s) {
  Kokkos::deep_copy(Exec(), system_.velocities_of(now_.y), part(s.unknown, 0, system_.velocities()));
  Kokkos::deep_copy(Exec(), system_.displacements_of(now_.y), s.displacement);
  Kokkos::deep_copy(Exec(), system_.moments_of(now_.y), s.moment);
  multiply(system_.velocities_of(now_.y), part(system_.scene().mask(), 0, system_.velocities()));
  system_.place_mesh(s.time, s.displacement);
  if (system_.memory() > 0) Kokkos::deep_copy(Exec(), now_.memory, s.memory);
  system_.place_branches(now_.memory);
  system_.place_velocity(system_.velocities_of(now_.y));
  Refusal problem = system_.find_density(system_.moments_of(now_.y));
  if (problem.empty()) problem = system_.find_potential();
  if (!problem.empty()) return problem;
  if (system_.moments() > 0) Kokkos::deep_copy(Exec(), now_.density, system_.stage().density_end);
  system_.weigh_velocities(system_.moments_of(now_.y));
  problem = system_.pressure(now_.pressure, now_.stabilisation);
  return problem.empty() ? system_.convection(true, now_.convection) : problem;
}

template <int D, int P>
Refusal KickDrift<D, P>::drift(double t, double dt) {
  const Array u = system_.displacements_of(next_.y), p = system_.moments_of(now_.y), end = system_.moments_of(next_.y);
  system_.move_mesh(t + 0.5 * dt, 0.5 * dt, system_.displacements_of(now_.y), u);
  system_.find_flux();
  const Refusal problem = system_.move_moments(0.5 * dt, p, now_.stabilisation, middle_);
  if (!problem.empty()) return problem;
  system_.find_flux();
  system_.move_mesh(t + dt, 0.5 * dt, u, u);
  system_.move_branches(dt, system_.displacements_of(now_.y), now_.memory, next_.memory);
  return system_.move_moments(dt, p, now_.stabilisation, end);
}

template <int D, int P>
template <class... Others>
void KickDrift<D, P>::kick(const SumOf& sum, const ForEach<Others>&... others) {
  run_fused("softwet::kick", ForEach{system_.velocities(), Kick{sum, system_.placed_velocity()}}, others...);
  system_.fill_ghosts();
}

template <int D, int P>
Refusal KickDrift<D, P>::advance(double t, double dt, const StepRates&) {
  const Array v = system_.velocities_of(next_.y);
  const double half = 0.5 * dt;
  kick({half_, 1, half, half, system_.velocities_of(now_.y), now_.pressure, now_.convection},
       copied(system_.placed_density(), now_.density));
  Refusal problem = drift(t, dt);
  if (problem.empty()) problem = system_.find_potential();
  if (!problem.empty()) return problem;
  system_.weigh_velocities(system_.moments_of(next_.y));
  problem = system_.pressure(next_.pressure);
  if (!problem.empty()) return problem;
  kick({v, 1, half, half, half_, next_.pressure, now_.convection}, system_.taken_rates(next_.stabilisation),
       copied(next_.density, system_.placed_density()));
  problem = system_.convection(true, next_.convection);
  if (!problem.empty()) return problem;
  kick({v, 1, half, half, half_, next_.pressure, next_.convection});
  return {};
}

template <int D, int P>
void KickDrift<D, P>::accept(double t, double dt, State& s) {
  s.time = t;
  std::swap(now_, next_);
  const Array before = system_.moments_of(next_.y), p = system_.moments_of(now_.y);
  run_fused(
      "softwet::accept", copied(s.unknown, system_.stage().unknown),
      copied(s.displacement, system_.stage().displacement), copied(s.moment, p),
      ForEach{system_.moments(), SumOf{s.moment_rate, 1 / dt, -1 / dt, 0, p, before, p}},
      ForEach{system_.velocities(), SumOf{s.velocity_rate, 1, 1, 0, now_.pressure, now_.convection, now_.pressure}},
      system_.taken_motion(s.displacement_rate));
  system_.take_branches(now_.memory, s);
  system_.fill_rate_ghosts(s);
}

template <int D, int P>
void KickDrift<D, P>::visit_memory(StepMemory& memory) {
  memory.vector("kick_drift/at", now_.y);
  if (system_.moments() > 0) memory.vector("kick_drift/density", now_.density);
  memory.vector("kick_drift/pressure", now_.pressure);
  memory.vector("kick_drift/convection", now_.convection);
  if (system_.moments() > 0) memory.vector("kick_drift/stabilisation", now_.stabilisation);
  if (system_.memory() > 0) memory.vector("kick_drift/memory", now_.memory);
}

template class KickDrift<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
