// How the displacements of the branches of a viscoelastic solid go through a step.
#pragma once

#include "field/stage.hpp"
#include "scene/coefficients.hpp"
#include "time/step/sum_of.hpp"

namespace softwet {

/// How a step of generalized-alpha changes a field a with the rate a':
///   a_{n+1} = a_n + kept a'_n + taken a'_{n+am},   a_{n+af} = a_n + af (a_{n+1} - a_n),   a'_{n+1} = old a'_n + fresh a'_{n+am}
struct AlphaStep {
  double af, kept, taken, old, fresh;
};

/// Each branch has the equation tau a' = u - a. Under generalized-alpha a' is that at n + am, u and a are those at n + af; eliminated, with
/// c = af taken:
///   h = a_n + af kept a'_n,   u_{n+af} - a_{n+af} = tau / (tau + c) (u_{n+af} - h),   a'_{n+am} = (u_{n+af} - h) / (tau + c)
/// It is of second order and stable for any step over tau, as the scheme is. Explicit steps take the exact solution for a displacement that
/// moves at one speed, of second order too.
/// Tested: tests/unit/time/step/test_branch_memory.cpp
class BranchMemory {
 public:
  BranchMemory(const Branches& branches, int solid_size) : branches_(branches), size_(solid_size) {
    if (branches.count > 0) pull_ = Array("branches.pull", solid_size);
  }

  bool empty() const { return branches_.count == 0; }
  int size() const { return branches_.count * size_; }
  /// Branches that carry nothing: a = u, a' = 0.
  void rest(const State&) const;

  // A step of generalized-alpha.
  /// d lag / d u at n + af
  double weight(double c) const { return branches_.weight(c); }
  void begin(const State&, const AlphaStep&);
  /// q = sum w_i (u - h_i) of BranchStress. @param displacement  at n + af
  void set_lag(const ConstArray& displacement, const Array& lag) const {
    sum_of(lag, weight(step_.af * step_.taken), displacement, -1, pull_, 0, pull_);
  }
  /// @param start  the state from which the step began;  @param displacement  at n + af
  void finish(const State& start, const ConstArray& displacement, const State& end) const;

  // An explicit step.
  /// The memory at its end. @param before, after  displacements between which the solid moves at one speed
  void follow(double dt, const ConstArray& before, const ConstArray& after, const ConstArray& memory,
              const Array& out) const;
  /// q = sum 2 G_i (u - a_i)
  void set_lag(const ConstArray& displacement, const ConstArray& memory, const Array& lag) const;
  /// a' = (u - a) / tau
  void set_rate(const ConstArray& displacement, const ConstArray& memory, const Array& rate) const;

 private:
  Branches branches_;
  int size_;
  AlphaStep step_{};
  Array pull_;  ///< sum w_i h_i
};

}  // namespace softwet
