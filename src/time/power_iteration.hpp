// The largest eigenvalue of a linear operator in size, from products alone: what limits the steps of explicit schemes.
#pragma once

#include <algorithm>
#include <cmath>

#include "field/step_memory.hpp"
#include "time/noise.hpp"

namespace softwet {

/// Keeps its vector from one measurement to the next, which then takes few products.
class PowerIteration {
 public:
  /// @param free  1 where the operator's vectors may be anything, else 0; empty: everywhere
  explicit PowerIteration(const VectorSpace& space, int size, ConstArray free = {})
      : space_(space), direction_("power.direction", size), product_("power.product", size), free_(std::move(free)) {}

  /// @param apply  apply(z, out) writes the product with z and tells whether there is one
  template <class Apply>
  void measure(const Apply& apply) {
    // The length of one product swings where the parts of the vector trade places, as in an oscillation. The mean growth
    // over a window does not. Its cosine changes its sign then, and stays at -1 for a real negative eigenvalue.
    constexpr int window = 8, most = 80;
    constexpr double settled = 0.01;
    double growth[most + 1] = {}, cosine[most + 1] = {};  // growth: logarithm of that since the beginning
    add_noise(space_, direction_, free_);
    radius_ = 0;
    for (int k = 1; k <= most; ++k) {
      const double length = norm(space_, direction_);
      if (!(length > 0) || !apply(direction_, product_)) break;
      const double size = norm(space_, product_);
      if (!(size > 0) || !std::isfinite(size)) break;
      growth[k] = growth[k - 1] + std::log(size / length);
      cosine[k] = dot(space_, product_, direction_) / (size * length);
      combine(direction_, 1 / size, product_, 0);
      const int first = std::max(0, k - window);
      const double now = std::exp((growth[k] - growth[first]) / (k - first));
      const bool still = k >= window + window / 2 && std::abs(now - radius_) < settled * now;
      radius_ = now;
      imaginary_ = *std::max_element(cosine + first + 1, cosine + k + 1) > -0.9;
      if (still) break;
    }
  }

  /// Where the next measurement begins.
  void visit_memory(StepMemory& memory) { memory.vector("spectrum/direction", direction_); }

  double radius() const { return radius_; }
  /// Whether the vector turns instead of changing its sign: the eigenvalue is not real and negative.
  bool imaginary() const { return imaginary_; }

 private:
  VectorSpace space_;
  Array direction_, product_;
  ConstArray free_;
  double radius_ = 0;
  bool imaginary_ = false;
};

}  // namespace softwet
