#include "time/step/branch_memory.hpp"

#include <cmath>

namespace softwet {
namespace {

/// h = a_n + af kept a'_n
KOKKOS_FORCEINLINE_FUNCTION double held_value(const AlphaStep& step, double memory, double rate) {
  return memory + step.af * step.kept * rate;
}

/// pull = scale sum w_i h_i
struct SumPulls {
  Array pull;
  ConstArray memory, rate;
  Branches branches;
  AlphaStep step;
  int size;
  double scale;
  KOKKOS_FUNCTION void operator()(int i) const {
    double sum = 0;
    for (int b = 0; b < branches.count; ++b)
      sum += branches.weight(b, step.af * step.taken) * held_value(step, memory(b * size + i), rate(b * size + i));
    pull(i) = scale * sum;
  }
};

/// The memory and its rate at n + 1.
struct MoveMemory {
  Array memory, rate;
  ConstArray memory_before, rate_before, followed;
  Branches branches;
  AlphaStep step;
  int size;
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int b = 0; b < branches.count; ++b) {
      const int k = b * size + i;
      const double a = memory_before(k), r = rate_before(k);
      const double middle = (followed(i) - held_value(step, a, r)) / (branches.time[b] + step.af * step.taken);
      memory(k) = a + step.kept * r + step.taken * middle;
      rate(k) = step.old * r + step.fresh * middle;
    }
  }
};

/// a + faded (x_0 - a) + followed (x_1 - x_0)
struct FollowMemory {
  Array out;
  ConstArray before, after, memory;
  int count, size;
  FollowFactors factors;
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int b = 0; b < count; ++b) {
      const double a = memory(b * size + i);
      out(b * size + i) = a + factors.faded[b] * (before(i) - a) + factors.followed[b] * (after(i) - before(i));
    }
  }
};

struct SumLags {
  Array lag;
  ConstArray displacement, memory;
  Branches branches;
  int size;
  KOKKOS_FUNCTION void operator()(int i) const {
    double sum = 0;
    for (int b = 0; b < branches.count; ++b) sum += 2 * branches.modulus[b] * (displacement(i) - memory(b * size + i));
    lag(i) = sum;
  }
};

struct RateOfMemory {
  Array rate;
  ConstArray followed, memory;
  Branches branches;
  int size;
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int b = 0; b < branches.count; ++b)
      rate(b * size + i) = (followed(i) - memory(b * size + i)) / branches.time[b];
  }
};

}  // namespace

void BranchMemory::rest(const State& state) const {
  if (empty()) return;
  const ConstArray x = followed(state.displacement);
  for (int b = 0; b < branches_.count; ++b)
    Kokkos::deep_copy(Exec(), Kokkos::subview(state.memory, Kokkos::make_pair(b * size_, (b + 1) * size_)), x);
  Kokkos::deep_copy(Exec(), state.memory_rate, 0.0);
}

void BranchMemory::begin(const State& state, const AlphaStep& step, const Array& lag) {
  step_ = step;
  const double scale = strain_ ? 1 / weight(step.af * step.taken) : 1;
  Kokkos::parallel_for(
      "softwet::sum_pulls", Items(0, size_),
      SumPulls{strain_ ? lag : pull_, state.memory, state.memory_rate, branches_, step_, size_, scale});
}

void BranchMemory::finish(const State& start, const ConstArray& displacement, const State& end) const {
  const ConstArray x = followed(displacement);
  Kokkos::parallel_for(
      "softwet::move_memory", Items(0, size_),
      MoveMemory{end.memory, end.memory_rate, start.memory, start.memory_rate, x, branches_, step_, size_});
}

void BranchMemory::find_factors(double dt, double* numbers) const {
  for (int b = 0; b < branches_.count; ++b) {
    const double times = dt / branches_.time[b], faded = -std::expm1(-times);
    numbers[2 * b] = faded;
    numbers[2 * b + 1] = 1 - faded / times;
  }
}

void BranchMemory::follow(const FollowFactors& factors, const ConstArray& before, const ConstArray& after,
                          const ConstArray& memory, const Array& out) const {
  Kokkos::parallel_for(
      "softwet::follow_memory", Items(0, size_),
      FollowMemory{out, followed(before, 0), followed(after, 1), memory, branches_.count, size_, factors});
}

void BranchMemory::set_lag(const ConstArray& displacement, const ConstArray& memory, const Array& lag) const {
  if (strain_) {
    // h_i is the memory itself where no step is taken.
    Kokkos::parallel_for("softwet::sum_pulls", Items(0, size_),
                         SumPulls{lag, memory, memory, branches_, AlphaStep{}, size_, 1 / weight(0)});
  } else {
    Kokkos::parallel_for("softwet::sum_lags", Items(0, size_), SumLags{lag, displacement, memory, branches_, size_});
  }
}

void BranchMemory::set_rate(const ConstArray& displacement, const ConstArray& memory, const Array& rate) const {
  Kokkos::parallel_for("softwet::rate_of_memory", Items(0, size_),
                       RateOfMemory{rate, followed(displacement), memory, branches_, size_});
}

}  // namespace softwet
