// Steps in which time stands still: towards rest, and the answer of a state at rest to a disturbance.
#pragma once

#include "time/implicit/implicit_solver.hpp"
#include "time/step/scheme.hpp"

namespace softwet {

/// A step towards rest, and how far its beginning was from it.
struct Settling {
  StepAttempt step;
  /// Ratio of the residual at the start to the residual from the last digit of the fields, the largest of all fields.
  double excess = 0;
  bool still = true;  ///< the step has not moved the solid but by round-off
};

/// Steps of backward Euler of any length, in which loads stand still at the time of the state.
template <int D, int P>
class StillSteps {
 public:
  StillSteps(const Scene<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) { solver_.integrator.initialise(state); }
  /// A step towards rest. Without a solid it takes no iteration where nothing is left to solve: where `excess` is below
  /// `digits_of_rest`. The last digit of a stiff part of a solid may hide the load of a soft one, which a solve finds.
  /// The indicator is not set.
  /// The equations of an endless step are singular: the total mass is left open. Those of a long step nearly are, and
  /// the velocities of the solid have the size of its displacement over the step. So Newton's method sees them as a
  /// step of moderate length, T, stretched s = dt / T times: its unknown is s v in the solid, the sum of the rows of
  /// the mass counts s times, which the solution does not notice, and the preconditioner is that of the step T.
  Settling settle(const State&, double dt);
  /// The answer of a state at rest to a small disturbance: x with A x = -r, to seven digits. A is the Jacobian of a
  /// step dt of backward Euler from there, in which loads stand still.
  NewtonResult respond(const State& rest, double dt, const Array& r, const Array& x);
  /// Writes the result of the last `settle` to the state that it started from.
  void accept(State& state) { solver_.integrator.finish(solver_.x, state); }

  GeneralizedAlpha<D, P>& integrator() { return solver_.integrator; }

 private:
  NonlinearSystem system();
  /// The ranges of the fields of the step that has begun, and how far its start is from rest.
  std::vector<FieldRange> measure(Settling&);
  /// Whether the step that was solved moves the solid.
  bool still_moves() const;
  /// Adds to the residual of a stretched step, or to a product, what makes the total mass count as in one that is not.
  void tie_mass(const Array& r) const;
  /// The unknowns with the velocities of the solid, which Newton's method sees multiplied with the stretch.
  Array unstretched(const Array& x) const;
  void product(const Array& z, const Array& out);
  void product(const ArrayOf<float>& z, const ArrayOf<float>& out);

  ImplicitSolver<D, P> solver_;
  double stretch_ = 1;  ///< of this step: how many times it is as long as one that is not nearly singular
  Array unstretched_;
  Array wide_, product_;  ///< a direction in double precision, and its product
  Array round_off_;
};

}  // namespace softwet
