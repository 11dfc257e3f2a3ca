// The equations of a scene as an evolution y' = f(t, y): discrete in space, continuous in time.
#pragma once

#include "field/step_memory.hpp"
#include "model/mass_products.hpp"
#include "solver/krylov/conjugate_gradient.hpp"
#include "solver/krylov/kronecker_mass.hpp"
#include "time/evolution.hpp"

namespace softwet {

/// How the masses of velocity, density and chemical potential are inverted: as they are, by conjugate gradients, or
/// replaced by their row sums, which costs nothing and is of second order in space.
enum class MassKind { consistent, lumped };

/// Evaluations of rates, and iterations of conjugate gradients for what they need.
struct MassCounts {
  long rates = 0, density = 0, potential = 0, velocity = 0, viscous = 0;
  long iterations() const { return density + potential + velocity + viscous; }
};

/// y = (v, u, p): velocities, displacements of the solid, and the moments p_i = (q_i, rho J) of the density. Stepping
/// moments keeps the mass exactly, on a moving mesh too. From y follow the density, M[x] rho = p, and the chemical
/// potential; then  u' = v,  p' = -F,  A[rho, x] v' = forces.
template <int D, int P>
class SemiDiscrete final : public Evolution {
 public:
  SemiDiscrete(const Model<D, P>&, MassKind);

  int size() const override { return velocity_ + solid_ + scalar_; }
  Refusal rates(double t, const Array& y, const Array& out) override { return all_rates(t, y, out, true); }
  Refusal gentle_rates(double t, const Array& y, const Array& out) override { return all_rates(t, y, out, false); }
  Refusal stiff_rates(const Array& y, const Array& out) override;
  /// 1 at the velocities and moments of a vector that are free, 0 where they are held or copies across a periodic side,
  /// and at displacements.
  Array free_values() const;

  Refusal hold(const Array& y) override;
  Refusal implicit_part(double c, const Array& y, const Array& out) override;

  /// -(y, g(y)) / (y, y) with the stiff part g and the mass of the velocities as the inner product.
  double stiff_quotient(const Array& y);
  /// How accurate the solves for the stiff part are: less where its size alone is asked for.
  void set_stiff_tolerance(double tolerance) { stiff_tolerance_ = tolerance; }
  static constexpr double velocity_tolerance = 1e-10;

  /// Moments of a state that is given by its unknowns and displacements: those that give its density back.
  void set_moments(State&);
  void pack(const State&, const Array& y) const;
  /// Where solves begin. @param state  whose rates were evaluated last, at a step that was accepted
  void visit_memory(StepMemory&, const State& state);
  /// Writes y, whose rates were evaluated last, with its density, chemical potential and rates to a state.
  void copy_stage(double t, const Array& y, const Array& rates, State&) const;

  const Model<D, P>& model() const { return model_; }
  const Stage& stage() const { return stage_; }  ///< of the last evaluation
  const MassCounts& counts() const { return counts_; }

 private:
  Refusal all_rates(double t, const Array& y, const Array& out, bool viscous);
  /// Fills the stage from y: velocities, displacements, density, chemical potential.
  Refusal place(double t, const Array& y);
  void place_motion(const Array& y);
  Refusal find_density(const ConstArray& moments);
  Refusal find_potential();
  /// z = M^{-1} b for a scalar, from the part of the density of b to that of z.
  int solve_scalar(const Array& b, const Array& z, double tolerance);
  /// z = (A + c K)^{-1} b for velocities; K the viscous force.
  int solve_velocity(double c, const Array& b, const Array& z, double tolerance);
  void weigh_velocities();

  const Model<D, P>& model_;
  Masses<D, P> masses_;
  MassKind kind_;
  KroneckerMass<D> kronecker_;
  ConjugateGradient solver_;
  int velocity_, solid_, scalar_;  ///< parts of y
  Stage stage_;
  double stiff_tolerance_ = velocity_tolerance;
  Array stiff_;          ///< the last result of implicit_part, velocities
  bool solved_ = false;  ///< there is one
  Array zero_, force_, right_, solution_, ones_, scalar_weight_, velocity_weight_;
  MassCounts counts_;
};

}  // namespace softwet
