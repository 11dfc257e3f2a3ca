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
  if (system_.memory() > 0) Kokkos::deep_copy(Exec(), now_.memory, s.memory);
  const Array v = system_.velocities_of(now_.y), p = system_.moments_of(now_.y);
  auto fields =
      system_.find_density(system_.place_velocity(system_.place_mesh(s.time, s.displacement, now_.memory), v), p);
  if (system_.moments() > 0) Kokkos::deep_copy(Exec(), now_.density, system_.stage().density_end);
  auto at = system_.weigh_velocities(system_.find_potential(std::move(fields)), p);
  auto forced = system_.take_rates(system_.pressure(std::move(at), now_.pressure), now_.stabilisation);
  return system_.convection(std::move(forced), Viscosity::among_all, now_.convection).refusal();
}

template <int D, int P>
Refusal KickDrift<D, P>::start(double t, double dt, const StepRates&) {
  const auto& [y, density, pressure, convection, stabilisation, memory] = now_;
  const Array v = system_.velocities_of(y), u = system_.displacements_of(y), p = system_.moments_of(y);
  const Array v_end = system_.velocities_of(next_.y), u_end = system_.displacements_of(next_.y),
              p_end = system_.moments_of(next_.y);
  const StepNumbers& numbers = system_.numbers();
  const Factor half = numbers.factor(StepNumbers::half), whole = numbers.factor(StepNumbers::whole);
  auto start = system_.kick_and_move({half_, 1, half, half, v, pressure, convection}, density, t, dt, u, u_end);
  auto middle = system_.move_moments(system_.find_flux(std::move(start)), half, p, stabilisation, middle_);
  auto fields = system_.move_to_end(system_.find_flux(std::move(middle)), whole, p, stabilisation, p_end);
  auto end = system_.find_potential(system_.move_branches(std::move(fields), u, memory, next_.memory));
  auto predicted = system_.pressure(std::move(end), next_.pressure, next_.stabilisation,
                                    {v_end, 1, half, half, half_, next_.pressure, convection}, next_.density);
  return system_
      .convection(std::move(predicted), next_.convection,
                  {v_end, 1, half, half, half_, next_.pressure, next_.convection})
      .refusal();
}

template <int D, int P>
void KickDrift<D, P>::accept(double t, double dt, State& s, const Array& before) {
  s.time = t;
  std::swap(now_, next_);
  const Array p_before = system_.moments_of(next_.y), p = system_.moments_of(now_.y);
  run_fused(
      "softwet::accept", copied(before, s.unknown), copied(s.unknown, system_.stage().unknown),
      copied(s.displacement, system_.stage().displacement), copied(s.moment, p),
      ForEach{system_.moments(), SumOf{s.moment_rate, 1 / dt, -1 / dt, 0, p, p_before, p}},
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
