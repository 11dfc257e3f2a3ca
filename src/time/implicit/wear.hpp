// When a preconditioner that was built for an earlier step is no longer worth keeping.
#pragma once

#include "field/step_memory.hpp"
#include "solver/krylov/gmres.hpp"

namespace softwet {

/// How much a lagged preconditioner has wasted. Linear solves that together gain four digits, about those of a step, make a
/// window; one solve would be no measure, because those of a step differ. Waste are the iterations of a window above those of
/// the best one so far and a third more. When it reaches a quarter of the cost of a build a new preconditioner is due
/// (docs/development/solver_choices.md says why). Where a new one is no better than the old one was at its end, it is kept twice as long,
/// up to four times.
class Wear {
 public:
  void renew();
  void add(const KrylovResult& linear);
  /// Whether a new preconditioner is due, where a build costs as much as this many iterations.
  bool due(double cost) const { return waste_ >= allowed(cost); }
  /// Iterations of a solve to `tolerance` at which one becomes due; the solve is given up then.
  int patience(double tolerance, double cost) const;
  void visit_memory(StepMemory&);

 private:
  double allowed(double cost) const { return 0.25 * times_ * cost; }

  double best_ = 0, last_ = 0;          ///< iterations per digit of windows; 0: none is complete
  double iterations_ = 0, digits_ = 0;  ///< of the window that is not
  double waste_ = 0;
  double before_ = 0;  ///< iterations per digit at the end of the preconditioner before; 0: there was none
  int times_ = 1;      ///< how long a preconditioner is kept, see above
};

}  // namespace softwet
