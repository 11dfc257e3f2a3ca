// How the displacements of the branches of a viscoelastic solid go through a step.
#pragma once

#include "field/stage.hpp"
#include "scene/branch_strains.hpp"
#include "scene/coefficients.hpp"
#include "time/step/sum_of.hpp"

namespace softwet {

/// How a step of generalized-alpha changes a field a with the rate a':
///   a_{n+1} = a_n + kept a'_n + taken a'_{n+am},   a_{n+af} = a_n + af (a_{n+1} - a_n),   a'_{n+1} = old a'_n + fresh
///     a'_{n+am}
struct AlphaStep {
  double af, kept, taken, old, fresh;
};

/// How much each branch fades in an explicit step and how much it follows the solid (BranchMemory::find_factors).
struct FollowFactors {
  Factor faded[Branches::most], followed[Branches::most];
};

/// Each branch has the equation tau a' = x - a, where x is what it follows: under small strains the displacement, under
/// finite ones the Green-Lagrange strain at each point. Under generalized-alpha a' is that at n + am, x and a are those
/// at n + af; eliminated, with c = af taken:
///   h = a_n + af kept a'_n,   x_{n+af} - a_{n+af} = tau / (tau + c) (x_{n+af} - h),   a'_{n+am} = (x_{n+af} - h) /
///     (tau + c)
/// It is of second order and stable for any step over tau, as the scheme is. Explicit steps take the exact solution for
/// an x that moves at one speed, of second order too.
/// Tested: tests/unit/time/step/test_branch_memory.cpp
class BranchMemory {
 public:
  /// @param size    of what a branch remembers
  /// @param strain  what branches follow under finite strains; without it they follow the displacement
  BranchMemory(const Branches& branches, int size, StrainFollowed strain = {})
      : branches_(branches), size_(size), strain_(std::move(strain)) {
    if (branches.count == 0) return;
    if (!strain_) {
      pull_ = Array("branches.pull", size);
    } else {
      for (Array& x : strains_) x = Array("branches.strain", size);
    }
  }

  bool empty() const { return branches_.count == 0; }
  int count() const { return branches_.count; }
  int size() const { return branches_.count * size_; }
  /// Sets a = x, a' = 0: branches carry nothing.
  void rest(const State&) const;

  // A step of generalized-alpha.
  /// W = sum w_i
  double weight(double c) const { return branches_.weight(c); }
  /// @param lag  of finite strains, h = sum w_i h_i / W of FiniteBranchStress, for the whole step
  void begin(const State&, const AlphaStep&, const Array& lag);
  /// For small strains, q = W u - sum w_i h_i of BranchStress. @param displacement  at n + af
  void set_lag(const ConstArray& displacement, const Array& lag) const {
    if (!strain_) sum_of(lag, weight(step_.af * step_.taken), displacement, -1, pull_, 0, pull_);
  }
  /// @param start  the state from which the step began;  @param displacement  at n + af
  void finish(const State& start, const ConstArray& displacement, const State& end) const;

  // An explicit step.
  /// How much a branch fades in a step and how much it follows: two numbers for each branch.
  void find_factors(double dt, double* numbers) const;
  /// The memory at its end. @param before, after  displacements between which the solid moves at one speed
  void follow(const FollowFactors&, const ConstArray& before, const ConstArray& after, const ConstArray& memory,
              const Array& out) const;
  /// q = sum 2 G_i (u - a_i), or h = sum 2 G_i A_i / sum 2 G_i
  void set_lag(const ConstArray& displacement, const ConstArray& memory, const Array& lag) const;
  /// a' = (x - a) / tau
  void set_rate(const ConstArray& displacement, const ConstArray& memory, const Array& rate) const;

 private:
  /// What branches follow, of a displacement. @param room  where it is written, if it is not the displacement itself
  ConstArray followed(const ConstArray& displacement, int room = 0) const {
    if (!strain_) return displacement;
    strain_(displacement, strains_[room]);
    return strains_[room];
  }

  Branches branches_;
  int size_;
  StrainFollowed strain_;
  AlphaStep step_{};
  Array pull_;        ///< sum w_i h_i of small strains
  Array strains_[2];  ///< of finite ones
};

}  // namespace softwet
