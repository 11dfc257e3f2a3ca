#include "time/explicit/semi_discrete.hpp"

#include "time/explicit/step_kernels.hpp"

namespace softwet {

template <int D, int P>
SemiDiscrete<D, P>::SemiDiscrete(const Scene<D, P>& scene, MassKind kind)
    : scene_(scene),
      terms_(scene.regions(), scene.coefficients(), scene.equations()),
      viscous_(scene.regions(), scene.coefficients()),
      masses_(scene.regions(), scene.coefficients(), kind),
      branches_(scene.coefficients().solid().branches, scene.layout().branch_size(),
                strain_followed<P>(scene.regions())),
      numbers_(2 * branches_.count(), scene.forces().numbers()),
      force_("explicit.force", scene.layout().size()),
      potential_force_("explicit.potential", scene.layout().has_fluid ? scene.layout().size() : 0),
      velocity_("explicit.velocity", scene.layout().size()) {
  const Layout<D>& l = scene.layout();
  stage_.unknown = Array("explicit.unknown", l.size());
  stage_.acceleration = Array("explicit.zero", l.velocity_size());
  stage_.displacement = stage_.displacement_end = Array("explicit.displacement", l.solid_size());
  if (l.branches > 0) {
    stage_.lag = Array("explicit.lag", l.branch_size());
    stage_.branch_weight = branches_.weight(0);
  }
  if (l.has_fluid) stage_.density_end = range(stage_.unknown, l.density_offset(), l.potential_offset());
  other_ = stage_;
  other_.displacement = other_.displacement_end = Array("explicit.displacement", l.solid_size());
}

template <int D, int P>
void SemiDiscrete<D, P>::set_moments(State& s) {
  const Layout<D>& l = scene_.layout();
  move_ghosts(l, s.unknown, GhostAction::update);
  branches_.rest(s);
  if (!l.has_fluid) return;
  (void)place_mesh(s.time, s.displacement);
  Kokkos::deep_copy(Exec(), stage_.unknown, s.unknown);  // where the searches for density and potential begin
  masses_.find_moments(stage_, stage_.density_end, s.moment);
}

template <int D, int P>
Placed<placed::mesh> SemiDiscrete<D, P>::place_mesh(double t, const Array& displacement, const ConstArray& memory) {
  stage_.time = t;
  if (scene_.layout().has_solid) Kokkos::deep_copy(Exec(), stage_.displacement, displacement);
  masses_.set_mesh(stage_);
  if (memory.extent(0) > 0) set_lag(memory);
  return Placed<placed::mesh>();
}

template <int D, int P>
Placed<placed::mesh | placed::velocity> SemiDiscrete<D, P>::place_velocity(Placed<placed::mesh>&& at, const Array& v) {
  return std::move(at).template after<placed::mesh | placed::velocity>([&] {
    Kokkos::deep_copy(Exec(), velocities_of(stage_.unknown), v);
    fill_ghosts();
    return Refusal{};
  });
}

template <int D, int P>
void SemiDiscrete<D, P>::set_step(double t, double dt) {
  numbers_[StepNumbers::half] = 0.5 * dt;
  numbers_[StepNumbers::whole] = dt;
  branches_.find_factors(dt, numbers_.of_branches());
  if (numbers_.in_memory()) scene_.forces().find(t + dt, numbers_.of_forces());
}

template <int D, int P>
bool SemiDiscrete<D, P>::recordable() const {
  return !host_algorithms && masses_.kind() != MassKind::consistent && scene_.layout().whole() &&
         !scene_.equations().has_source();
}

template <int D, int P>
void SemiDiscrete<D, P>::take_stage(bool at_end) {
  if (at_end_ == at_end) return;
  at_end_ = at_end;
  std::swap(stage_.displacement, other_.displacement);
  std::swap(stage_.displacement_end, other_.displacement_end);
  masses_.take_other();
}

template <int D, int P>
void SemiDiscrete<D, P>::end_recorded(double t) {
  take_stage(true);
  stage_.time = t;
}

template <int D, int P>
Placed<placed::fields> SemiDiscrete<D, P>::kick_and_move(const SumOf& velocity, const ConstArray& density, double t,
                                                         double dt, const ConstArray& u, const Array& to) {
  const Layout<D>& l = scene_.layout();
  const int nodes = l.solid_rows() * l.row_size;
  take_stage(false);
  const ForEach kicked{velocities(), kick(velocity)};
  const MoveMeshes moved{
      to,    stage_.displacement, other_.displacement, numbers_.factor(StepNumbers::half), u, stage_.unknown, D,
      nodes, l.rows * l.row_size};
  if (has_ghosts(l)) {
    run_fused("softwet::kick", kicked, copied(stage_.density_end, density));
    fill_ghosts();
    run_fused("softwet::move_meshes", ForEach{nodes, moved});
  } else {
    run_fused("softwet::kick", kicked, ForEach{nodes > 0 ? velocities() : 0, MoveMeshesByVelocity{moved}},
              copied(stage_.density_end, density));
  }
  stage_.time = t + 0.5 * dt;
  other_.time = t + dt;
  masses_.set_meshes(stage_, other_);
  return Placed<placed::fields>();
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::end_of(const RightSide& moments) {
  take_stage(true);
  stage_.time = other_.time;
  if (scene_.layout().has_fluid && masses_.weighs_beside()) {
    masses_.scalar_and_weights(moments, stage_.density_end);
    return {};
  }
  const Refusal problem = density_of(moments);
  return problem.empty() ? weigh(moments.moments) : problem;
}

template <int D, int P>
void SemiDiscrete<D, P>::set_lag(const ConstArray& memory) {
  branches_.set_lag(stage_.displacement, memory, stage_.lag);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::follow(const ConstArray& u, const ConstArray& memory, const Array& out) {
  if (branches_.empty()) return {};
  FollowFactors factors{};
  for (int b = 0; b < branches_.count(); ++b) {
    factors.faded[b] = numbers_.factor(StepNumbers::fixed + 2 * b);
    factors.followed[b] = numbers_.factor(StepNumbers::fixed + 2 * b + 1);
  }
  branches_.follow(factors, u, stage_.displacement, memory, out);
  set_lag(out);
  return {};
}

template <int D, int P>
void SemiDiscrete<D, P>::take_branches(const ConstArray& memory, const State& state) const {
  if (branches_.empty()) return;
  Kokkos::deep_copy(Exec(), state.memory, memory);
  branches_.set_rate(stage_.displacement, memory, state.memory_rate);
}

template <int D, int P>
void SemiDiscrete<D, P>::fill_ghosts() {
  move_ghosts(scene_.layout(), stage_.unknown, GhostAction::update);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::density_of(const RightSide& moments) {
  if (!scene_.layout().has_fluid) return {};
  const int iterations = masses_.scalar(stage_, 1, moments, stage_.density_end, scalar_tolerance);
  if (iterations < 0) return {Refusal::density_of_moments};
  counts_.density += iterations;
  fill_ghosts();
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::potential() {
  const Layout<D>& l = scene_.layout();
  if (!l.has_fluid) return {};
  const int first = l.potential_offset();
  terms_.add_potential(stage_, potential_force_);
  const TakenForce force{range(potential_force_, first, l.size()), terms_.taken(potential_force_), first};
  const int iterations = masses_.scalar(stage_, 1, RightSide::minus(force, part(scene_.mask(), first, l.size())),
                                        range(stage_.unknown, first, l.size()), scalar_tolerance);
  if (iterations < 0) return {Refusal::potential};
  counts_.potential += iterations;
  fill_ghosts();
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::weigh(const ConstArray& moments) {
  masses_.set_weights(moments, density());
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::flux() {
  if (!scene_.layout().has_fluid) return {};
  terms_.add_mass_flux(stage_, force_);
  take_forces();
  return {};
}

template <int D, int P>
typename SemiDiscrete<D, P>::RightSide SemiDiscrete<D, P>::moved(const Factor& dt, const ConstArray& moments,
                                                                 const ConstArray& rates, const Array& out) const {
  return RightSide::moved(moments, dt, rates, scalar_forces(), scalar_mask(), out);
}

template <int D, int P>
void SemiDiscrete<D, P>::take_forces() {
  tiles_ = {};
  if (masses_.kind() == MassKind::consistent)
    return terms_.collect(force_);  // a search evaluates other terms before all is read
  tiles_ = terms_.taken(force_);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::accelerate(const Array& out, Refusal::Cause why, long& count, const Companions& with) {
  if (masses_.kind() == MassKind::consistent) Kokkos::deep_copy(Exec(), out, 0.0);  // where the search begins
  const RightSide side = RightSide::take(velocity_forces());
  const bool alone = !with.kick.sum.y.data();
  const int iterations = alone ? masses_.velocity(stage_, -1, side, out, velocity_tolerance)
                               : masses_.velocity(stage_, -1, side, out, velocity_tolerance, with);
  if (iterations < 0) {
    Kokkos::deep_copy(Exec(), force_, 0.0);
    return {why};
  }
  count += iterations;
  if (!alone) fill_ghosts();
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::pressure(const Array& acceleration) {
  terms_.add_pressure(stage_, force_);
  take_forces();
  return accelerate(acceleration, Refusal::acceleration, counts_.velocity);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::pressure(const Array& acceleration, const Array& moment_rates, const SumOf& velocity,
                                     const Array& density) {
  terms_.add_pressure(stage_, force_, numbers_.place_of_forces());
  take_forces();
  return accelerate(acceleration, Refusal::acceleration, counts_.velocity,
                    {kick(velocity), taken_rates(moment_rates), copied(density, stage_.density_end)});
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::take(const Array& moment_rates) {
  run_fused("softwet::take_rates", taken_rates(moment_rates));
  return {};
}

template <int D, int P>
ForEach<mass_kernels::TakeRates<D>> SemiDiscrete<D, P>::taken_rates(const Array& out) const {
  return {moments(), {out, scalar_forces(), scalar_mask()}};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::convection(Viscosity how, const Array& acceleration, const Companions& with) {
  if (!scene_.layout().has_fluid && !scene_.equations().has_viscous_solid()) {
    Kokkos::deep_copy(Exec(), acceleration, 0.0);
    if (!with.kick.sum.y.data()) return {};
    run_fused("softwet::kick", ForEach{velocities(), with.kick});
    fill_ghosts();
    return {};
  }
  terms_.add_convection(stage_, how, force_);
  take_forces();
  return accelerate(acceleration, Refusal::acceleration, counts_.velocity, with);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::viscosity(const Array& v, const Array& acceleration) {
  Kokkos::deep_copy(Exec(), velocities_of(velocity_), v);
  viscous_.velocity(stage_, 0, scene_.coefficients().fluid().viscosity, velocity_, force_);
  if (scene_.equations().has_viscous_solid()) {
    Stage moving = stage_;
    moving.unknown = velocity_;
    terms_.add_viscosity_of_solid(moving, force_);
  }
  take_forces();
  return accelerate(acceleration, Refusal::viscous_rate, counts_.viscous);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::rates(double t, const Array& y, const Array& out) {
  ++counts_.rates;
  auto fields = find_density(place_velocity(place_mesh(t, displacements_of(y)), velocities_of(y)), moments_of(y));
  const auto at = weigh_velocities(find_potential(std::move(fields)), moments_of(y));
  if (!at.refusal().empty()) return at.refusal();
  run_fused("softwet::take_motion", taken_motion(displacements_of(out)));
  terms_.add_mass_flux(stage_, force_);
  terms_.add_pressure(stage_, force_);
  terms_.add_convection(stage_, viscosity_, force_);
  take_forces();
  take(moments_of(out));
  return accelerate(velocities_of(out), Refusal::acceleration, counts_.velocity);
}

template <int D, int P>
ForEach<TakeMotion> SemiDiscrete<D, P>::taken_motion(const Array& rate) const {
  const Layout<D>& l = scene_.layout();
  const int nodes = l.solid_rows() * l.row_size;
  return {nodes, {rate, stage_.unknown, D, nodes, l.rows * l.row_size}};
}

template <int D, int P>
void SemiDiscrete<D, P>::fill_rate_ghosts(State& s) {
  if (!has_ghosts(scene_.layout())) return;
  Kokkos::deep_copy(Exec(), velocity_, 0.0);
  Kokkos::deep_copy(Exec(), velocities_of(velocity_), s.velocity_rate);
  move_ghosts(scene_.layout(), velocity_, GhostAction::update);
  Kokkos::deep_copy(Exec(), s.velocity_rate, velocities_of(velocity_));
}

template <int D, int P>
void SemiDiscrete<D, P>::visit_memory(StepMemory& memory, const State& state) {
  if (!memory.restores()) return;
  Kokkos::deep_copy(Exec(), stage_.unknown, state.unknown);
  (void)place_mesh(state.time, state.displacement);
}

template class SemiDiscrete<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
