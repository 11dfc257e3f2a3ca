// The equations of a scene as an evolution: discrete in space, continuous in time, in the parts that explicit schemes need.
#pragma once

#include "field/step_memory.hpp"
#include "scene/explicit_terms.hpp"
#include "scene/scene.hpp"
#include "time/explicit/evolution.hpp"
#include "time/explicit/step_kernels.hpp"
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
/// `rates` is all of that. What it is made of works on the stage, which holds the last values of everything.
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
  /// Whether `rates` leave viscosity out, for a scheme that treats it apart.
  void leave_viscosity_out(bool out) { gentle_ = out; }

  /// Moves the mesh of the stage, with the row sums of scalars.
  void place_mesh(double t, const Array& displacement);
  /// The same to displacements to = from + dt v, with the velocities of the stage.
  void move_mesh(double t, double dt, const ConstArray& from, const Array& to);
  /// Branches of the solid in the mesh of the stage.
  void place_branches(const ConstArray& memory);
  /// The same at the end of a step: they follow the solid from the displacements `from` to those of the stage, at one speed.
  void move_branches(double dt, const ConstArray& from, const ConstArray& memory, const Array& out);
  /// Velocities of the stage, with their ghosts.
  void place_velocity(const Array& v);
  // Parts of the stage, for launches that write them.
  Array placed_velocity() const { return velocities_of(stage_.unknown); }
  Array placed_density() const { return stage_.density_end; }
  /// Ghosts of all unknowns of the stage.
  void fill_ghosts();
  /// Density and chemical potential of the stage.
  Refusal find_density(const ConstArray& moments) { return find_density(mass_kernels::RightSide::of(moments)); }
  Refusal find_potential();
  void weigh_velocities(const ConstArray& moments) { masses_.set_weights(moments, density()); }
  /// The flux of mass G of the stage, which `move_moments` takes before anything else is evaluated.
  void find_flux();
  /// out = moments + dt (G + rates), and the density of the stage from these.
  Refusal move_moments(double dt, const ConstArray& moments, const ConstArray& rates, const Array& out);
  /// Acceleration by pressure, capillarity, elasticity and loads, and rates of the moments by the stabilisation.
  Refusal pressure(const Array& acceleration, const Array& moment_rates);
  /// The same, where the rates have to be taken before anything else is evaluated: as a part of a launch.
  Refusal pressure(const Array& acceleration);
  ForEach<TakeRates> taken_rates(const Array& moment_rates) const;
  /// Rates of the displacements by the velocities of the stage, as a part of a launch.
  ForEach<TakeMotion> taken_motion(const Array& rate) const;
  /// Acceleration by convection, and viscosity unless it is treated apart.
  Refusal convection(bool viscous, const Array& acceleration);
  /// Acceleration of velocities by viscosity alone, with the density and mesh of the stage.
  Refusal viscosity(const Array& v, const Array& acceleration);

  /// Rates are zero at ghosts, those of a state are not.
  void fill_rate_ghosts(State&);
  /// What the state of a branch says beside its displacement, of the stage.
  void take_branches(const ConstArray& memory, const State& state) const;
  /// Moments of a state that is given by its unknowns and displacements: those that give its density back. Branches of the solid carry
  /// nothing.
  void set_moments(State&);
  /// Where solves begin. @param state  the one that was accepted last
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
  Refusal find_density(const mass_kernels::RightSide& moments);
  /// out = the acceleration of minus the force that the terms have collected, where `why` tells that there is none.
  Refusal accelerate(const Array& out, Refusal::Cause why, long& count);

  static constexpr double velocity_tolerance = 1e-10, scalar_tolerance = 1e-12;  ///< of conjugate gradients

  const Scene<D, P>& scene_;
  ExplicitTerms<D, P> terms_;
  Masses<D, P> viscous_;
  MassInverse<D, P> masses_;
  BranchMemory branches_;
  Stage stage_;
  bool gentle_ = false;
  Array force_;      ///< of terms, a vector of unknowns; who reads a part leaves zero there, so that terms can be added
  Array potential_;  ///< moments of the chemical potential, in a vector of unknowns
  Array velocity_;   ///< a vector of unknowns, of which the velocities count
  MassCounts counts_;
};

}  // namespace softwet
