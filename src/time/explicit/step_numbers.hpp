// What changes from step to step in the kernels of an explicit step.
#pragma once

#include <algorithm>
#include <limits>

#include "field/factor.hpp"

namespace softwet {

/// Numbers that the host finds for each step. Kernels have them as arguments, or, where steps are recorded, read them
/// in memory of the device, to which `send` copies all of them.
/// Tested: tests/unit/time/explicit/test_recorded_steps.cpp
class StepNumbers {
 public:
  /// Half a step, a step, and the factors of the two previous states in the error of the step; the numbers of branches
  /// and of forces follow.
  enum Place { half, whole, last, before, fixed };

  /// @param branches, forces  how many numbers they have
  StepNumbers(int branches, int forces)
      : found_("explicit.found", fixed + branches + forces),
        sent_("explicit.sent", fixed + branches + forces),
        first_of_forces_(fixed + branches) {}

  void keep_in_memory() { in_memory_ = true; }
  bool in_memory() const { return in_memory_; }

  double& operator[](int k) { return found_(k); }
  double* of_branches() { return found_.data() + fixed; }
  double* of_forces() { return found_.data() + first_of_forces_; }

  Factor factor(int k) const { return factor_at(place(k), found_(k)); }
  /// Where kernels read the numbers of forces; null: forces follow from the time.
  const double* place_of_forces() const { return place(first_of_forces_); }
  /// Copies the numbers before the kernels of a step start. The host may find the numbers of the next step once it has
  /// waited for this one.
  void send() const {
    if (!in_memory_) return;
    Kokkos::deep_copy(Exec(), sent_, found_);
    // Without a device the copy is made: whoever takes a number as an argument from now on is seen.
    if constexpr (on_host) std::fill_n(found_.data(), found_.extent(0), std::numeric_limits<double>::quiet_NaN());
  }

 private:
  const double* place(int k) const { return in_memory_ ? sent_.data() + k : nullptr; }

  HostArray found_;
  Array sent_;
  int first_of_forces_;
  bool in_memory_ = false;
};

}  // namespace softwet
