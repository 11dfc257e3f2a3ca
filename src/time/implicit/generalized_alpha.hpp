// Generalized-alpha for first-order systems (Jansen, Whiting, Hulbert 2000), with the mass moments carried along.
#pragma once

#include "field/step_memory.hpp"
#include "field/vector.hpp"
#include "scene/scene.hpp"
#include "time/implicit/line_friction_newton.hpp"
#include "time/step/branch_memory.hpp"

namespace softwet {

/// Parameters of the scheme for a spectral radius at infinity rho_inf in [0, 1].
struct AlphaParameters {
  double am, af, ga;
  explicit AlphaParameters(double rho_inf)
      : am((3 - rho_inf) / (2 * (1 + rho_inf))), af(1 / (1 + rho_inf)), ga(0.5 + am - af) {}

  /// am = af = ga = 1: uses no rate of the state it starts from.
  static AlphaParameters backward_euler() {
    AlphaParameters a(1);
    a.am = a.af = a.ga = 1;
    return a;
  }
};

/// Whether the rates v', u', p' of a state obey the equations. Those of a first state do not. To start from v' = 0
/// would leave an error of first order for the whole run; a first step of backward Euler, which needs no rates, does
/// not.
enum class Rates { known, unknown };

/// The algebraic system of one step. Unknowns are v, rho and mu at n + af; displacement is eliminated:
///   v'_{n+am} = (1 - am/ga) v'_n + am/(ga dt af) (v_{n+af} - v_n)
///   u_{n+1}   = u_n + dt (1 - ga/am) u'_n + dt (ga/am) v_{n+af},   u_{n+af} = u_n + af (u_{n+1} - u_n)
///   x_{n+1}   = x_n + (x_{n+af} - x_n) / af   for v, rho, mu
///   mass      (1 - am/ga) p'_n + am/(ga dt) (M[x_{n+1}] rho_{n+1} - p_n) + F = 0
template <int D, int P>
class GeneralizedAlpha {
 public:
  GeneralizedAlpha(const Scene<D, P>& scene, double rho_inf);

  /// Moments and rates of a state given by its unknowns and displacements alone: v' = 0, u' = v, p = M rho, p' = -F. Branches of the solid
  /// carry nothing.
  void initialise(State& state);

  /// Starts a step from `state` to state.time + dt; with unknown rates it is one of backward Euler.
  void begin(const State& state, double dt, Rates rates = Rates::known);
  /// Starts a step of backward Euler, as long as one likes, in which time stands still: loads are those of the time of
  /// the state, at which the step ends too. Rates of the density beside the wall count as 0: contact lines have no friction. Branches of
  /// the solid carry nothing.
  void begin_still(const State& state, double dt);

  void residual(const Array& x, const Array& r);
  /// What the last digit of the fields changes in the residual at x: the residual at a point whose values, and positions of the
  /// solid, differ by one unit of their last place, up or down, minus the one at x. Positions have the size of the scene's
  /// height.
  /// @param near  a vector to work in
  void last_digits(const Array& x, const Array& near, const Array& out);
  /// dR/dx z at the point of the last residual. Where contact lines have friction, with what LineFrictionBend adds.
  void product(const Array& z, const Array& out) const;
  /// The same in single precision. Only for models that have it.
  void product(const ArrayOf<float>& z, const ArrayOf<float>& out) const;
  /// The same as a matrix, with frozen geometry, for preconditioners. It follows from the rounded stage, which is kept.
  /// @param stretch  the matrix is that of a step this many times shorter, at the same values
  void jacobian(const StencilValues& values, double stretch = 1);
  /// The matrix of the last `jacobian` once more.
  void last_jacobian(const StencilValues& values) const { scene_.equations().jacobian(jacobian_stage_, values); }
  /// What `last_jacobian` needs.
  void visit_memory(StepMemory&);

  /// Ends the step: writes the state at t + dt from the solution x. Conserves the sum of the moments exactly, and the
  /// integral of the density with it.
  void finish(const Array& x, State& state);

  int size() const { return scene_.layout().size(); }
  const Scene<D, P>& scene() const { return scene_; }
  const Stage& stage() const { return stage_; }
  const StageOf<float>& single_stage() const { return single_stage_; }
  double dt() const { return dt_; }
  ConstArray moment() const { return start_.moment; }  ///< that the step starts from

 private:
  void fill_stage(const Array& x);
  /// Shifts the density by a constant so that its integral is the sum of the moments. The constant is as small as the
  /// residual that Newton's method has left.
  void match_mass(const State& state) const;

  const Scene<D, P>& scene_;
  AlphaParameters scheme_, alpha_;  ///< of rho_inf, and of the current step
  LineFrictionNewton<D> friction_;
  BranchMemory branches_;
  Stage stage_;
  StageOf<float> single_stage_;    ///< the stage, rounded; not in double precision
  StageOf<float> jacobian_stage_;  ///< that of the last Jacobian as a matrix; allocated by the first one
  State start_;
  Array work_;
  double dt_ = 0, end_time_ = 0;
};

}  // namespace softwet
