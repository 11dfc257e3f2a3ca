// The equations of a scene as an evolution: discrete in space, continuous in time, in the parts that explicit schemes
// need.
#pragma once

#include "field/step_memory.hpp"
#include "scene/explicit_terms.hpp"
#include "scene/scene.hpp"
#include "time/explicit/evolution.hpp"
#include "time/explicit/placed.hpp"
#include "time/explicit/step_kernels.hpp"
#include "time/explicit/step_numbers.hpp"
#include "time/masses/mass_inverse.hpp"
#include "time/step/branch_memory.hpp"

namespace softwet {

/// Evaluations of rates, and iterations of conjugate gradients for what they need.
struct MassCounts {
  long rates = 0, density = 0, potential = 0, velocity = 0, viscous = 0;
  long iterations() const { return density + potential + velocity + viscous; }
};

/// y = (v, u, p): velocities, displacements of the solid, and the moments p_i = (q_i, rho J) of the density. Stepping
/// moments keeps the mass exactly, on a moving mesh too. From y follow the density, M[x] rho = p, and the chemical
/// potential; then  u' = v,  p' = -F,  A[rho, x] v' = forces.
/// `rates` is all of that. What it is made of works on the stage, which holds the last values of everything; each call
/// takes and gives what the stage holds by then (Placed).
template <int D, int P>
class SemiDiscrete final : public Evolution {
 public:
  SemiDiscrete(const Scene<D, P>&, MassKind);

  int size() const override { return velocities() + displacements() + moments(); }
  int velocities() const { return scene_.layout().velocity_size(); }
  int displacements() const { return scene_.layout().solid_size(); }
  int moments() const { return scene_.layout().scalar_size(); }
  int memory() const { return branches_.size(); }  ///< of the branches of a solid, which is no part of y
  // Parts of y.
  Array velocities_of(const Array& y) const { return range(y, 0, velocities()); }
  Array displacements_of(const Array& y) const { return range(y, velocities(), velocities() + displacements()); }
  Array moments_of(const Array& y) const { return range(y, velocities() + displacements(), size()); }

  Refusal rates(double t, const Array& y, const Array& out) override;
  /// How `rates` take viscosity, for a scheme that treats it apart.
  void treat_viscosity(Viscosity how) { viscosity_ = how; }

  /// The stage as the last complete evaluation has left it.
  Placed<placed::all> evaluated() const { return Placed<placed::all>(); }
  /// The mesh of the stage. @param memory  of branches of the solid, where it has some
  Placed<placed::mesh> place_mesh(double t, const Array& displacement, const ConstArray& memory = {});
  /// Velocities of the stage, with their ghosts.
  Placed<placed::mesh | placed::velocity> place_velocity(Placed<placed::mesh>&&, const Array& v);
  /// What the host finds for this step; the calls for steps below take it.
  void set_step(double t, double dt);
  StepNumbers& numbers() { return numbers_; }
  /// Whether these calls only start kernels (ExplicitStep::recordable).
  bool recordable() const;
  /// Kernels of a step that was recorded have run to the time t: the stage is that at its end.
  void end_recorded(double t);

  /// Begins a step: velocities are a sum, the stage has this density, and displacements move from u to `to`. The mesh
  /// is the mesh half way through the step.
  Placed<placed::fields> kick_and_move(const SumOf& velocity, const ConstArray& density, double t, double dt,
                                       const ConstArray& u, const Array& to);

  /// The density of moments.
  template <unsigned has>
    requires Ready<has, placed::mesh>
  auto find_density(Placed<has>&& at, const ConstArray& moments) {
    return std::move(at).template after<(has | placed::density) & ~placed::of_density>(
        [&] { return density_of(RightSide::of(moments)); });
  }
  /// The chemical potential.
  template <unsigned has>
    requires Ready<has, placed::mesh | placed::density>
  auto find_potential(Placed<has>&& at) {
    return std::move(at).template after<has | placed::potential>([&] { return potential(); });
  }
  /// The masses of velocities, by moments.
  template <unsigned has>
    requires Ready<has, placed::mesh | placed::density>
  auto weigh_velocities(Placed<has>&& at, const ConstArray& moments) {
    return std::move(at).template after<has | placed::weights>([&] { return weigh(moments); });
  }
  /// The flux of mass G.
  template <unsigned has>
    requires Ready<has, placed::fields>
  auto find_flux(Placed<has>&& at) {
    return std::move(at).template after<has | placed::flux>([&] { return flux(); });
  }
  /// out = moments + dt (G + rates), and the density of these moments.
  template <unsigned has>
    requires Holding<has, placed::fields | placed::flux>
  auto move_moments(Placed<has>&& at, const Factor& dt, const ConstArray& moments, const ConstArray& rates,
                    const Array& out) {
    return std::move(at).template after<placed::fields>([&] { return density_of(moved(dt, moments, rates, out)); });
  }
  /// As `move_moments`, at the end of the step that began with `kick_and_move`, on the mesh there; it also finds the
  /// masses of velocities.
  template <unsigned has>
    requires Holding<has, placed::fields | placed::flux>
  auto move_to_end(Placed<has>&& at, const Factor& dt, const ConstArray& moments, const ConstArray& rates,
                   const Array& out) {
    return std::move(at).template after<placed::fields | placed::weights>(
        [&] { return end_of(moved(dt, moments, rates, out)); });
  }
  /// Branches of the solid follow it from displacements u to the displacements of the stage, at one speed.
  template <unsigned has>
    requires Ready<has, placed::mesh>
  auto move_branches(Placed<has>&& at, const ConstArray& u, const ConstArray& memory, const Array& out) {
    return std::move(at).template after<has>([&] { return follow(u, memory, out); });
  }
  /// Acceleration by pressure, capillarity, elasticity and loads. Rates of the moments by the stabilisation are left.
  template <unsigned has>
    requires Ready<has, placed::all>
  auto pressure(Placed<has>&& at, const Array& acceleration) {
    return std::move(at).template after<has | placed::rates>([&] { return pressure(acceleration); });
  }
  template <unsigned has>
    requires Holding<has, placed::rates>
  auto take_rates(Placed<has>&& at, const Array& moment_rates) {
    return std::move(at).template after<has & ~placed::rates>([&] { return take(moment_rates); });
  }
  /// `pressure` and `take_rates`, then velocities that are a sum with this acceleration; and a copy of the density.
  template <unsigned has>
    requires Ready<has, placed::all>
  auto pressure(Placed<has>&& at, const Array& acceleration, const Array& moment_rates, const SumOf& velocity,
                const Array& density) {
    return std::move(at).template after<has>([&] { return pressure(acceleration, moment_rates, velocity, density); });
  }
  /// Acceleration by convection and viscosity, or by one alone.
  template <unsigned has>
    requires Ready<has, placed::fields | placed::weights>
  auto convection(Placed<has>&& at, Viscosity how, const Array& acceleration) {
    return std::move(at).template after<has>([&] { return convection(how, acceleration, {}); });
  }
  /// Acceleration by convection and viscosity, then velocities that are a sum with it.
  template <unsigned has>
    requires Ready<has, placed::fields | placed::weights>
  auto convection(Placed<has>&& at, const Array& acceleration, const SumOf& velocity) {
    return std::move(at).template after<has>(
        [&] { return convection(Viscosity::among_all, acceleration, {kick(velocity)}); });
  }
  /// Acceleration of velocities by viscosity alone.
  template <unsigned has>
    requires Ready<has, placed::mesh | placed::density | placed::weights> Refusal viscosity(const Placed<has>& at,
                                                                                            const Array& v,
                                                                                            const Array& acceleration) {
      return at.refusal().empty() ? viscosity(v, acceleration) : at.refusal();
    }

  /// Rates of the displacements by the velocities of the stage, as a part of a launch.
  ForEach<TakeMotion> taken_motion(const Array& rate) const;
  /// Fills the ghosts of the rates of a state; the rates of the scheme are zero there.
  void fill_rate_ghosts(State&);
  /// Writes into `state` what the branches carry in the stage.
  void take_branches(const ConstArray& memory, const State& state) const;
  /// Sets the moments that give back the density of a state, which is given by its unknowns and displacements. Branches
  /// of the solid carry nothing.
  void set_moments(State&);
  /// Visits the vectors where solves begin. @param state  the last accepted one
  void visit_memory(StepMemory&, const State& state);

  const Scene<D, P>& scene() const { return scene_; }
  const Stage& stage() const { return stage_; }  ///< of the last evaluation
  const MassInverse<D, P>& masses() const { return masses_; }
  const MassCounts& counts() const { return counts_; }

 private:
  static Array range(const Array& y, int first, int last) { return Kokkos::subview(y, Kokkos::make_pair(first, last)); }
  ConstArray density() const { return scene_.layout().has_fluid ? ConstArray(stage_.density_end) : ConstArray(); }
  Array scalars_of(const Array& unknowns) const {
    return range(unknowns, scene_.layout().density_offset(), scene_.layout().potential_offset());
  }
  ConstArray scalar_mask() const {
    return part(scene_.mask(), scene_.layout().density_offset(), scene_.layout().potential_offset());
  }
  using RightSide = mass_kernels::RightSide<D>;
  using TakenForce = mass_kernels::TakenForce<D>;
  using Companions = typename MassInverse<D, P>::Companions;

  // What the calls above do.
  Refusal density_of(const RightSide& moments);
  Refusal potential();
  Refusal weigh(const ConstArray& moments);
  Refusal flux();
  Refusal end_of(const RightSide& moments);
  Refusal follow(const ConstArray& u, const ConstArray& memory, const Array& out);
  Refusal pressure(const Array& acceleration);
  Refusal pressure(const Array& acceleration, const Array& moment_rates, const SumOf& velocity, const Array& density);
  Refusal take(const Array& moment_rates);
  Refusal convection(Viscosity, const Array& acceleration, const Companions&);
  Refusal viscosity(const Array& v, const Array& acceleration);

  void fill_ghosts();  ///< of all unknowns of the stage
  void set_lag(const ConstArray& memory);
  /// The stage is either half way through a step or at its end. Each of the two has a mesh of its own, always in the
  /// same place.
  void take_stage(bool at_end);
  RightSide moved(const Factor& dt, const ConstArray& moments, const ConstArray& rates, const Array& out) const;
  Kick kick(const SumOf& velocity) const { return {velocity, velocities_of(stage_.unknown)}; }
  ForEach<mass_kernels::TakeRates<D>> taken_rates(const Array& moment_rates) const;
  // The forces of the terms so far.
  void take_forces();
  TakenForce scalar_forces() const { return {scalars_of(force_), tiles_, scene_.layout().density_offset()}; }
  TakenForce velocity_forces() const { return {velocities_of(force_), tiles_, 0}; }
  /// out = the acceleration of minus these forces, where `why` says that there is none.
  Refusal accelerate(const Array& out, Refusal::Cause why, long& count, const Companions& = {});

  static constexpr double velocity_tolerance = 1e-10, scalar_tolerance = 1e-12;  ///< of conjugate gradients

  const Scene<D, P>& scene_;
  ExplicitTerms<D, P> terms_;
  Masses<D, P> viscous_;
  MassInverse<D, P> masses_;
  BranchMemory branches_;
  Stage stage_;
  Stage other_;  ///< the stage at the end of a step while `stage_` is half way, and the other way round
  bool at_end_ = false;
  StepNumbers numbers_;
  Viscosity viscosity_ = Viscosity::among_all;
  Array force_;  ///< of terms, a vector of unknowns; a reader leaves zero where it has read, so that terms can be added
  TileSumsOf<D> tiles_;    ///< forces that are not yet added to `force_`
  Array potential_force_;  ///< force of the chemical potential
  Array velocity_;         ///< a vector of unknowns, of which the velocities count
  MassCounts counts_;
};

}  // namespace softwet
