// A time scheme as the stepper sees it: it tries a step, and the stepper decides whether the step counts.
#pragma once

#include <limits>
#include <string>

#include "case/refusal.hpp"
#include "field/stage.hpp"
#include "field/step_memory.hpp"
#include "solver/preconditioner.hpp"
#include "time/step/solver_counts.hpp"

namespace softwet {

/// What a step is made from: the last state, and the unknowns one accepted step before it.
struct StepHistory {
  const State& state;
  Array previous;
  double previous_dt = 0;  ///< 0: there is no state before
};

/// How an attempted step went.
struct StepAttempt {
  Refusal refusal;       ///< empty: the step is admissible
  double indicator = 0;  ///< of the local error, see StepControl
  int newton = 0, krylov = 0;
  bool laborious = false;  ///< the solver was close to giving up
};

template <int D, int P>
class Scheme {
 public:
  virtual ~Scheme() = default;

  /// Moments and rates of a state that is given by its unknowns and displacements alone.
  virtual void initialise(State&) = 0;

  virtual StepAttempt attempt(const StepHistory&, double dt) = 0;
  /// Writes the result of the last attempt to the state that it started from, and the unknowns of that to `before`.
  virtual void accept(State&, const Array& before) = 0;
  /// The last attempt was refused; a smaller step follows. @param why  empty: for its error
  virtual void refuse(const Refusal& why) = 0;

  /// Forgets the rates of the last accepted state: the loads have jumped.
  virtual void begin_anew() {}

  /// Largest step that is stable from a state. @param wish  the step that the control of the error would take
  virtual double largest_step(const State&, [[maybe_unused]] double wish) {
    return std::numeric_limits<double>::infinity();
  }

  /// Visits all that the next steps need of the last ones in addition to the states. @param state  the last one, into
  /// which a restart writes
  virtual void visit_memory(StepMemory&, const State& state) = 0;

  /// How this program computes what it remembers: the memory of another one would have other bits.
  virtual std::string memory_format() const { return {}; }

  virtual SolverCounts& counts() = 0;
  /// What limits the largest step, and where: the words behind "for".
  virtual std::string limit(const State&) { return {}; }
  /// Null where nothing is preconditioned.
  virtual const Preconditioner* preconditioner() const { return nullptr; }
};

}  // namespace softwet
