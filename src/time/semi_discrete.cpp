#include "time/semi_discrete.hpp"

namespace softwet {
namespace {

/// out = 0 - mask force. It is +0 where the mask is 0, whatever sign the force has there: ghosts have the same bits in any number
/// of processes.
void oppose(const Array& out, const ConstArray& force, const ConstArray& mask) {
  Kokkos::parallel_for(
      "softwet::oppose", Items(0, out.extent(0)), KOKKOS_LAMBDA(int i) { out(i) = 0.0 - mask(i) * force(i); });
}

/// out = moments + dt (rates - mask force)
void advance_moments(const Array& out, const ConstArray& moments, double dt, const ConstArray& rates,
                     const ConstArray& force, const ConstArray& mask) {
  Kokkos::parallel_for(
      "softwet::advance_moments", Items(0, out.extent(0)),
      KOKKOS_LAMBDA(int i) { out(i) = moments(i) + dt * (rates(i) - mask(i) * force(i)); });
}

}  // namespace

template <int D, int P>
SemiDiscrete<D, P>::SemiDiscrete(const Model<D, P>& model, MassKind kind)
    : model_(model),
      terms_(model),
      viscous_(model),
      masses_(model, kind),
      force_("explicit.force", model.layout().size()),
      velocity_("explicit.velocity", model.layout().size()) {
  const Layout<D>& l = model.layout();
  stage_.unknown = Array("explicit.unknown", l.size());
  stage_.acceleration = Array("explicit.zero", l.velocity_size());
  stage_.displacement = stage_.displacement_end = Array("explicit.displacement", l.solid_size());
  if (l.has_fluid) stage_.density_end = range(stage_.unknown, l.density_offset(), l.potential_offset());
}

template <int D, int P>
void SemiDiscrete<D, P>::set_moments(State& s) {
  const Layout<D>& l = model_.layout();
  move_ghosts(l, s.unknown, GhostAction::update);
  if (!l.has_fluid) return;
  place_mesh(s.time, s.displacement);
  Kokkos::deep_copy(stage_.unknown, s.unknown);  // where the searches for density and potential begin
  masses_.find_moments(stage_, stage_.density_end, s.moment);
}

template <int D, int P>
void SemiDiscrete<D, P>::place_mesh(double t, const Array& displacement) {
  stage_.time = t;
  Kokkos::deep_copy(Exec(), stage_.displacement, displacement);
  masses_.set_mesh(stage_);
}

template <int D, int P>
void SemiDiscrete<D, P>::place_velocity(const Array& v) {
  Kokkos::deep_copy(Exec(), velocities_of(stage_.unknown), v);
  move_ghosts(model_.layout(), stage_.unknown, GhostAction::update);
}

template <int D, int P>
void SemiDiscrete<D, P>::place_density(const ConstArray& density) {
  if (model_.layout().has_fluid) Kokkos::deep_copy(Exec(), stage_.density_end, density);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::find_density(const ConstArray& moments) {
  const Layout<D>& l = model_.layout();
  if (!l.has_fluid) return {};
  const int iterations = masses_.scalar(stage_, moments, stage_.density_end, scalar_tolerance);
  if (iterations < 0) return {Refusal::density_of_moments};
  counts_.density += iterations;
  move_ghosts(l, stage_.unknown, GhostAction::update);
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::find_potential() {
  const Layout<D>& l = model_.layout();
  if (!l.has_fluid) return {};
  const int first = l.potential_offset();
  model_.potential_moments(stage_, force_);
  const int iterations =
      masses_.scalar(stage_, part(force_, first, l.size()), range(stage_.unknown, first, l.size()), scalar_tolerance);
  if (iterations < 0) return {Refusal::potential};
  counts_.potential += iterations;
  move_ghosts(l, stage_.unknown, GhostAction::update);
  return {};
}

template <int D, int P>
void SemiDiscrete<D, P>::add_motion(double dt, const Array& displacement) const {
  const Layout<D>& l = model_.layout();
  const int count = l.solid_rows() * l.row_size;
  for (int d = 0; d < D && l.has_solid; ++d)
    add_scaled(displacement, l.displacement_offset(d), dt,
               part(stage_.unknown, l.velocity_offset(d), l.velocity_offset(d) + count));
}

template <int D, int P>
void SemiDiscrete<D, P>::move_moments(double dt, const ConstArray& moments, const ConstArray& rates, const Array& out) {
  const Layout<D>& l = model_.layout();
  if (!l.has_fluid) return;
  const Array force = range(force_, l.density_offset(), l.potential_offset());
  Kokkos::deep_copy(Exec(), force, 0.0);
  terms_.add_mass_flux(stage_, force_);
  terms_.collect(force_);
  advance_moments(out, moments, dt, rates, force, part(model_.mask(), l.density_offset(), l.potential_offset()));
}

template <int D, int P>
void SemiDiscrete<D, P>::take_rates(const Array& out) const {
  const Layout<D>& l = model_.layout();
  if (!l.has_fluid) return;
  oppose(out, part(force_, l.density_offset(), l.potential_offset()),
         part(model_.mask(), l.density_offset(), l.potential_offset()));
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::accelerate(const Array& out, Refusal::Cause why, long& count) {
  if (masses_.kind() == MassKind::consistent) Kokkos::deep_copy(Exec(), out, 0.0);  // where the search begins
  const int iterations = masses_.velocity(stage_, -1, velocities_of(force_), out, velocity_tolerance);
  if (iterations < 0) return {why};
  count += iterations;
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::pressure(const Array& acceleration, const Array& moment_rates) {
  Kokkos::deep_copy(Exec(), force_, 0.0);
  terms_.add_pressure(stage_, force_);
  terms_.collect(force_);
  take_rates(moment_rates);
  return accelerate(acceleration, Refusal::acceleration, counts_.velocity);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::convection(bool viscous, const Array& acceleration) {
  if (!model_.layout().has_fluid && !model_.has_viscous_solid()) {
    Kokkos::deep_copy(Exec(), acceleration, 0.0);
    return {};
  }
  Kokkos::deep_copy(Exec(), force_, 0.0);
  terms_.add_convection(stage_, viscous, force_);
  terms_.collect(force_);
  return accelerate(acceleration, Refusal::acceleration, counts_.velocity);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::viscosity(const Array& v, const Array& acceleration) {
  Kokkos::deep_copy(Exec(), velocities_of(velocity_), v);
  viscous_.velocity(stage_, 0, model_.fluid().viscosity, velocity_, force_);
  if (model_.has_viscous_solid()) {
    Stage moving = stage_;
    moving.unknown = velocity_;
    model_.add_viscosity_of_solid(moving, force_);
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
  Kokkos::deep_copy(Exec(), out, 0.0);
  add_motion(1, displacements_of(out));
  Kokkos::deep_copy(Exec(), force_, 0.0);
  terms_.add_mass_flux(stage_, force_);
  terms_.add_pressure(stage_, force_);
  terms_.add_convection(stage_, !gentle_, force_);
  terms_.collect(force_);
  take_rates(moments_of(out));
  return accelerate(velocities_of(out), Refusal::acceleration, counts_.velocity);
}

template <int D, int P>
void SemiDiscrete<D, P>::fill_rate_ghosts(State& s) {
  if (!has_ghosts(model_.layout())) return;
  Kokkos::deep_copy(Exec(), force_, 0.0);
  Kokkos::deep_copy(Exec(), velocities_of(force_), s.velocity_rate);
  move_ghosts(model_.layout(), force_, GhostAction::update);
  Kokkos::deep_copy(s.velocity_rate, velocities_of(force_));
}

template <int D, int P>
void SemiDiscrete<D, P>::visit_memory(StepMemory& memory, const State& state) {
  if (!memory.restores()) return;
  Kokkos::deep_copy(stage_.unknown, state.unknown);
  place_mesh(state.time, state.displacement);
}

template class SemiDiscrete<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
