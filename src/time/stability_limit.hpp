// The largest stable step of a Runge-Kutta scheme on a linear evolution, found from its steps alone.
#pragma once

#include "field/step_memory.hpp"
#include "time/runge_kutta.hpp"

namespace softwet {

/// A step of a scheme on linear equations z' = J z is a linear map of z. It is stable while no vector grows without end. The
/// vector that grows most is found by repeating steps, and the largest stable step by making the steps shorter until that
/// vector grows no longer. So every part of the spectrum counts as the scheme sees it: real, imaginary and in between, and
/// treated apart or not.   Tested: tests/unit/time/test_stability_limit.cpp
class StabilityLimit {
 public:
  /// @param free  1 where vectors of the evolution may be anything, else 0; empty: everywhere
  explicit StabilityLimit(const VectorSpace&, int size, ConstArray free = {});

  /// @param near  a step of the size of the limit. A search goes on from the mode that the last one has found.
  /// @return at most the limit, and at most some per cent less; 0: not found
  double search(RungeKutta&, Evolution& linear, double t, double near);

  /// far: looks long enough for a mode that has become the fastest since the last search, which costs twice as many steps.
  enum class Sight { near, far };

  /// The limit at a state near that of the last search, from the growth of the mode that was found: costs some steps.
  /// @return as `search`; 0: the state has changed too much
  double follow(RungeKutta&, Evolution& linear, double t, Sight sight = Sight::near);

  /// The next search begins anew: the state has changed in a way that the modes so far do not tell of.
  void forget() { known_ = false; }

  /// What the next search goes on from.
  void visit_memory(StepMemory&);

  int steps() const { return steps_; }  ///< of the scheme, in all searches so far

 private:
  /// What one step does to the vector that grows most.
  struct Growth {
    double size = 1;
    bool of_scheme = false;  ///< whether the equations themselves grow less
    bool unstable() const { return of_scheme && size > 1.01; }
  };
  /// An eigenvalue: its size and its real part.
  struct Eigenvalue {
    double size = 0, real = 0;
  };

  /// Repeats steps of the size dt until the growth has settled. `valid_` becomes false where a step fails.
  /// @param sure   steps before nothing counts as growing: a mode that is about to grow shows late among those that decay
  /// @param least  steps before a growth counts as that of the fastest mode
  Growth growth(RungeKutta&, Evolution&, double t, double dt, int sure = 14, int least = 4);
  void step(RungeKutta&, Evolution&, double t, double dt);
  /// Whether z' = J z lets the last vector grow as much by itself, as where a film breaks.
  bool grows_by_itself(Evolution&, double t, double dt, double size);
  /// Where repeated steps begin: the mode that was found last, with noise.
  void begin();
  /// Lengthens dt until the growth is clear. @return that growth, or none
  Growth climb(RungeKutta&, Evolution&, double t, double& dt);
  /// Of the map that takes a to b and b to c, where these vectors are made of one pair of modes.
  Eigenvalue pair(const ConstArray& a, const ConstArray& b, const ConstArray& c) const;

  VectorSpace space_;
  Array first_, second_, third_;  ///< vectors of three steps in a row
  Array mode_;                    ///< that grew at the shortest unstable step
  Array rates_, first_rates_;
  ConstArray free_;
  bool valid_ = true, known_ = false;
  int steps_ = 0;
  double unstable_ = 0;  ///< the step at which that mode grew
  double exponent_ = 4;  ///< near the limit the growth is like this power of the step
};

}  // namespace softwet
