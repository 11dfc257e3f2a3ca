// The largest eigenvalue of a stiff part, for schemes whose number of stages follows from it.
#pragma once

#include <algorithm>

#include "case/refusal.hpp"
#include "field/step_memory.hpp"
#include "time/noise.hpp"

namespace softwet {

/// Stages that are a few per cent too few multiply the stiffest mode by thousands in one step, so the radius must not be too
/// small. Power iteration stops too early where many eigenvalues lie close together. Chebyshev polynomials keep what lies
/// below a bound and multiply what lies above it by cosh(2 n sqrt(r / bound - 1)): a mode that is 2 % above shows at once.
/// The part is symmetric in its own inner product, so its quotient of Rayleigh is never too large.
/// Tested: tests/unit/time/test_stiff_radius.cpp
class StiffRadius {
 public:
  /// @param free  1 where the operator's vectors may be anything, else 0; empty: everywhere
  explicit StiffRadius(const VectorSpace& space, int size, ConstArray free = {})
      : space_(space), free_(std::move(free)) {
    for (Array* a : {&direction_, &before_, &product_}) *a = Array("stiff.vector", size);
  }

  /// @param apply     apply(z, out) writes g(z) and tells why there is none, if so; its eigenvalues are real and not positive
  /// @param quotient  quotient(z) is -(z, g(z)) / (z, z) in the inner product in which g is symmetric
  /// @return empty, or why there is no radius
  template <class Apply, class Quotient>
  Refusal measure(const Apply& apply, const Quotient& quotient) {
    constexpr int products = 6, least = 2, most = 12;
    constexpr double same = 1.005;
    add_noise(space_, direction_, free_);
    for (int k = 0; k < products; ++k) {
      const Refusal problem = apply(direction_, product_);
      if (!problem.empty()) return problem;
      if (!take(product_)) return {};
    }
    radius_ = quotient(direction_);
    for (int k = 0; k < most; ++k) {
      const Refusal problem = filter(apply);
      if (!problem.empty()) return problem;
      if (!take(direction_)) return {};
      const double before = radius_;
      radius_ = std::max(radius_, quotient(direction_));
      if (k + 1 >= least && radius_ < same * before) break;
    }
    measured_ = quotient(direction_);
    return {};
  }

  /// Follows a radius that grows as the operator changes.
  template <class Quotient>
  void follow(const Quotient& quotient) {
    if (!(radius_ > 0)) return;
    const double now = quotient(direction_);
    if (now > measured_) radius_ *= now / measured_, measured_ = now;
  }

  /// What `follow` and the next measurement go on from.
  void visit_memory(StepMemory& memory) {
    memory.number("stiff/radius", radius_);
    memory.number("stiff/measured", measured_);
    memory.vector("stiff/direction", direction_);
  }

  double radius() const { return radius_; }

 private:
  /// direction = z / |z|. @return false where z is zero or not finite; the direction and the radius are 0 then
  bool take(const Array& z) {
    const double length = norm(space_, z);
    if (length > 0 && std::isfinite(length)) {
      combine(direction_, 1 / length, z, 0);
      return true;
    }
    Kokkos::deep_copy(Exec(), direction_, 0.0);
    radius_ = 0;
    return false;
  }

  /// direction = T_n(2 B / radius - 1) direction, B = -g.
  template <class Apply>
  Refusal filter(const Apply& apply) {
    constexpr int degree = 24;
    const double scale = -2 / radius_;
    Refusal problem = apply(direction_, product_);
    Kokkos::deep_copy(Exec(), before_, direction_);
    combine(direction_, scale, product_, -1);
    for (int j = 2; j <= degree && problem.empty(); ++j) {
      problem = apply(direction_, product_);
      combine(product_, -2, direction_, 2 * scale);
      add_scaled(product_, 0, -1, before_);
      std::swap(before_, direction_);
      std::swap(direction_, product_);
    }
    return problem;
  }

  VectorSpace space_;
  Array direction_, before_, product_;
  ConstArray free_;
  double radius_ = 0, measured_ = 0;
};

}  // namespace softwet
