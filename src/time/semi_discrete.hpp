// The equations of a scene as an evolution: discrete in space, continuous in time, in the parts that explicit schemes need.
#pragma once

#include "field/step_memory.hpp"
#include "model/explicit_terms.hpp"
#include "time/evolution.hpp"
#include "time/mass_inverse.hpp"

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
  SemiDiscrete(const Model<D, P>&, MassKind);

  int size() const override { return velocities() + displacements() + moments(); }
  int velocities() const { return model_.layout().velocity_size(); }
  int displacements() const { return model_.layout().solid_size(); }
  int moments() const { return model_.layout().scalar_size(); }
  // Parts of y.
  Array velocities_of(const Array& y) const { return range(y, 0, velocities()); }
  Array displacements_of(const Array& y) const { return range(y, velocities(), velocities() + displacements()); }
  Array moments_of(const Array& y) const { return range(y, velocities() + displacements(), size()); }

  Refusal rates(double t, const Array& y, const Array& out) override;
  /// Whether `rates` leave viscosity out, for a scheme that treats it apart.
  void leave_viscosity_out(bool out) { gentle_ = out; }

  /// Moves the mesh of the stage, with the row sums of scalars.
  void place_mesh(double t, const Array& displacement);
  /// Velocities of the stage, with their ghosts.
  void place_velocity(const Array& v);
  void place_density(const ConstArray& density);
  /// Density and chemical potential of the stage. `find_density` also weights velocities with the moments.
  Refusal find_density(const ConstArray& moments);
  Refusal find_potential();
  void weigh_velocities(const ConstArray& moments) { masses_.set_weights(moments, density()); }
  /// Displacements by dt times the velocities of the stage.
  void add_motion(double dt, const Array& displacement) const;
  /// out = moments + dt (G + rates), where G are the rates of the moments by the flux of mass.
  void move_moments(double dt, const ConstArray& moments, const ConstArray& rates, const Array& out);
  /// Acceleration by pressure, capillarity, elasticity and loads, and rates of the moments by the stabilisation.
  Refusal pressure(const Array& acceleration, const Array& moment_rates);
  /// Acceleration by convection, and viscosity unless it is treated apart.
  Refusal convection(bool viscous, const Array& acceleration);
  /// Acceleration of velocities by viscosity alone, with the density and mesh of the stage.
  Refusal viscosity(const Array& v, const Array& acceleration);

  /// Rates are zero at ghosts, those of a state are not.
  void fill_rate_ghosts(State&);
  /// Moments of a state that is given by its unknowns and displacements: those that give its density back.
  void set_moments(State&);
  /// Where solves begin. @param state  the one that was accepted last
  void visit_memory(StepMemory&, const State& state);

  const Model<D, P>& model() const { return model_; }
  const Stage& stage() const { return stage_; }  ///< of the last evaluation
  const MassInverse<D, P>& masses() const { return masses_; }
  const MassCounts& counts() const { return counts_; }

 private:
  static Array range(const Array& y, int first, int last) { return Kokkos::subview(y, Kokkos::make_pair(first, last)); }
  /// The rates of the moments of minus the force that the terms have collected.
  void take_rates(const Array& out) const;
  ConstArray density() const { return model_.layout().has_fluid ? ConstArray(stage_.density_end) : ConstArray(); }
  /// out = the acceleration of minus the force that the terms have collected, where `why` tells that there is none.
  Refusal accelerate(const Array& out, Refusal::Cause why, long& count);

  static constexpr double velocity_tolerance = 1e-10, scalar_tolerance = 1e-12;  ///< of conjugate gradients

  const Model<D, P>& model_;
  ExplicitTerms<D, P> terms_;
  Masses<D, P> viscous_;
  MassInverse<D, P> masses_;
  Stage stage_;
  bool gentle_ = false;
  Array force_, velocity_;  ///< vectors of unknowns; of these the velocities, for viscosity
  MassCounts counts_;
};

}  // namespace softwet
