#include "time/implicit/wear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

/// Iterations of a lagged preconditioner, above those at its best, that do not count as waste: they vary from step to
/// step.
constexpr double worn = 1.3;

}  // namespace

void Wear::renew() {
  const double end = digits_ > 0 ? std::max(last_, iterations_ / digits_) : last_;
  const int times = times_;
  *this = {};
  before_ = end;
  times_ = times;
}

void Wear::add(const KrylovResult& linear) {
  constexpr double window = 4, no_better = 0.8;
  iterations_ += linear.iterations;
  digits_ -= std::log10(std::clamp(linear.reduction, 1e-16, 0.8));
  if (digits_ < window) return;
  last_ = iterations_ / digits_;
  if (best_ == 0 && before_ > 0) times_ = last_ > no_better * before_ ? std::min(4, 2 * times_) : 1;
  if (best_ == 0 || last_ < best_) best_ = last_;
  waste_ += std::max(0.0, iterations_ - worn * best_ * digits_);
  iterations_ = digits_ = 0;
}

int Wear::patience(double tolerance, double cost) const {
  if (best_ == 0) return std::numeric_limits<int>::max();
  return static_cast<int>(std::ceil(worn * best_ * -std::log10(tolerance) + std::max(0.0, allowed(cost) - waste_))) + 1;
}

void Wear::visit_memory(StepMemory& memory) {
  memory.number("wear/best", best_);
  memory.number("wear/last", last_);
  memory.number("wear/iterations", iterations_);
  memory.number("wear/digits", digits_);
  memory.number("wear/waste", waste_);
  memory.number("wear/before", before_);
  memory.count("wear/times", times_);
}

}  // namespace softwet
