// What a scheme counts, and a watch that adds to its seconds.
#pragma once

#include <chrono>
#include <stdexcept>

#include "memory/array.hpp"

namespace softwet {

/// Seconds and counts since the start of the run, for run.json and the benchmark.
struct SolverCounts {
  long newton = 0, krylov = 0, residuals = 0, products = 0, builds = 0, applications = 0;
  double residual_seconds = 0, product_seconds = 0, build_seconds = 0, apply_seconds = 0, krylov_seconds = 0;
};

/// Adds the time of its scope to a counter.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds), start_(Clock::now()) {}

  /// For frequent calls, call number `call`: on a device the host would wait each time, so only one of `sample` calls
  /// is measured and counts for all.
  Stopwatch(double& seconds, long call) : seconds_(seconds) {
    if (!host_algorithms) {
      weight_ = call % sample == 0 ? sample : 0;
      if (weight_ > 0) wait();
    }
    start_ = Clock::now();
  }
  ~Stopwatch() {
    if (weight_ == 0) return;
    wait();
    seconds_ += weight_ * std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int sample = 16;

  static void wait() {
    try {
      Kokkos::fence();
    } catch (const std::runtime_error&) {  // a failed device: the next copy reports it
    }
  }

  double& seconds_;
  int weight_ = 1;
  Clock::time_point start_;
};

}  // namespace softwet
