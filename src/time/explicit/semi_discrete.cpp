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
      force_("explicit.force", scene.layout().size()),
      potential_("explicit.potential", scene.layout().has_fluid ? scene.layout().size() : 0),
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
}

template <int D, int P>
void SemiDiscrete<D, P>::set_moments(State& s) {
  const Layout<D>& l = scene_.layout();
  move_ghosts(l, s.unknown, GhostAction::update);
  branches_.rest(s);
  if (!l.has_fluid) return;
  place_mesh(s.time, s.displacement);
  Kokkos::deep_copy(Exec(), stage_.unknown, s.unknown);  // where the searches for density and potential begin
  masses_.find_moments(stage_, stage_.density_end, s.moment);
}

template <int D, int P>
void SemiDiscrete<D, P>::place_mesh(double t, const Array& displacement) {
  stage_.time = t;
  if (scene_.layout().has_solid) Kokkos::deep_copy(Exec(), stage_.displacement, displacement);
  masses_.set_mesh(stage_);
}

template <int D, int P>
void SemiDiscrete<D, P>::move_mesh(double t, double dt, const ConstArray& from, const Array& to) {
  const Layout<D>& l = scene_.layout();
  const int nodes = l.solid_rows() * l.row_size;
  run_fused("softwet::move_mesh",
            ForEach{nodes, MoveMesh{to, stage_.displacement, dt, from, stage_.unknown, D, nodes, l.rows * l.row_size}});
  stage_.time = t;
  masses_.set_mesh(stage_);
}

template <int D, int P>
void SemiDiscrete<D, P>::place_branches(const ConstArray& memory) {
  if (!branches_.empty()) branches_.set_lag(stage_.displacement, memory, stage_.lag);
}

template <int D, int P>
void SemiDiscrete<D, P>::move_branches(double dt, const ConstArray& from, const ConstArray& memory, const Array& out) {
  if (branches_.empty()) return;
  branches_.follow(dt, from, stage_.displacement, memory, out);
  place_branches(out);
}

template <int D, int P>
void SemiDiscrete<D, P>::take_branches(const ConstArray& memory, const State& state) const {
  if (branches_.empty()) return;
  Kokkos::deep_copy(Exec(), state.memory, memory);
  branches_.set_rate(stage_.displacement, memory, state.memory_rate);
}

template <int D, int P>
void SemiDiscrete<D, P>::place_velocity(const Array& v) {
  Kokkos::deep_copy(Exec(), velocities_of(stage_.unknown), v);
  fill_ghosts();
}

template <int D, int P>
void SemiDiscrete<D, P>::fill_ghosts() {
  move_ghosts(scene_.layout(), stage_.unknown, GhostAction::update);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::find_density(const mass_kernels::RightSide& moments) {
  if (!scene_.layout().has_fluid) return {};
  const int iterations = masses_.scalar(stage_, 1, moments, stage_.density_end, scalar_tolerance);
  if (iterations < 0) return {Refusal::density_of_moments};
  counts_.density += iterations;
  fill_ghosts();
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::find_potential() {
  const Layout<D>& l = scene_.layout();
  if (!l.has_fluid) return {};
  const int first = l.potential_offset();
  scene_.equations().potential_moments(stage_, potential_);
  const int iterations = masses_.scalar(stage_, 1, mass_kernels::RightSide::of(part(potential_, first, l.size())),
                                        range(stage_.unknown, first, l.size()), scalar_tolerance);
  if (iterations < 0) return {Refusal::potential};
  counts_.potential += iterations;
  fill_ghosts();
  return {};
}

template <int D, int P>
void SemiDiscrete<D, P>::find_flux() {
  if (!scene_.layout().has_fluid) return;
  terms_.add_mass_flux(stage_, force_);
  terms_.collect(force_);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::move_moments(double dt, const ConstArray& moments, const ConstArray& rates,
                                         const Array& out) {
  return find_density(mass_kernels::RightSide{moments, {}, dt, rates, scalar_mask(), scalars_of(force_), out});
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::accelerate(const Array& out, Refusal::Cause why, long& count) {
  if (masses_.kind() == MassKind::consistent) Kokkos::deep_copy(Exec(), out, 0.0);  // where the search begins
  const int iterations =
      masses_.velocity(stage_, -1, mass_kernels::RightSide::take(velocities_of(force_)), out, velocity_tolerance);
  if (iterations < 0) {
    Kokkos::deep_copy(Exec(), force_, 0.0);
    return {why};
  }
  count += iterations;
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::pressure(const Array& acceleration) {
  terms_.add_pressure(stage_, force_);
  terms_.collect(force_);
  return accelerate(acceleration, Refusal::acceleration, counts_.velocity);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::pressure(const Array& acceleration, const Array& moment_rates) {
  const Refusal problem = pressure(acceleration);
  if (problem.empty()) run_fused("softwet::take_rates", taken_rates(moment_rates));
  return problem;
}

template <int D, int P>
ForEach<TakeRates> SemiDiscrete<D, P>::taken_rates(const Array& out) const {
  return {moments(), {out, scalars_of(force_), scalar_mask()}};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::convection(bool viscous, const Array& acceleration) {
  if (!scene_.layout().has_fluid && !scene_.equations().has_viscous_solid()) {
    Kokkos::deep_copy(Exec(), acceleration, 0.0);
    return {};
  }
  terms_.add_convection(stage_, viscous, force_);
  terms_.collect(force_);
  return accelerate(acceleration, Refusal::acceleration, counts_.velocity);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::viscosity(const Array& v, const Array& acceleration) {
  Kokkos::deep_copy(Exec(), velocities_of(velocity_), v);
  viscous_.velocity(stage_, 0, scene_.coefficients().fluid().viscosity, velocity_, force_);
  if (scene_.equations().has_viscous_solid()) {
    Stage moving = stage_;
    moving.unknown = velocity_;
    scene_.equations().add_viscosity_of_solid(moving, force_);
    terms_.collect(force_);
  }
  return accelerate(acceleration, Refusal::viscous_rate, counts_.viscous);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::rates(double t, const Array& y, const Array& out) {
  ++counts_.rates;
  place_mesh(t, displacements_of(y));
  place_velocity(velocities_of(y));
  Refusal problem = find_density(moments_of(y));
  if (problem.empty()) problem = find_potential();
  if (!problem.empty()) return problem;
  weigh_velocities(moments_of(y));
  run_fused("softwet::take_motion", taken_motion(displacements_of(out)));
  terms_.add_mass_flux(stage_, force_);
  terms_.add_pressure(stage_, force_);
  terms_.add_convection(stage_, !gentle_, force_);
  terms_.collect(force_);
  run_fused("softwet::take_rates", taken_rates(moments_of(out)));
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
  place_mesh(state.time, state.displacement);
}

template class SemiDiscrete<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
