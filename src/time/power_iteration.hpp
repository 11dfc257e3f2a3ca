// The largest eigenvalue of a linear operator in size, from products alone: what limits the steps of explicit schemes.
#pragma once

#include <algorithm>
#include <cmath>

#include "field/vector.hpp"

namespace softwet {

/// Adds numbers that look random to the entries of a vector where `free` is 1; empty: to all.
struct AddNoise {
  Array a;
  ConstArray free;
  double scale;
  KOKKOS_FUNCTION void operator()(int i) const {
    const unsigned mixed = (static_cast<unsigned>(i) * 2654435761u) ^ (static_cast<unsigned>(i) >> 7);
    a(i) += scale * (free.extent(0) > 0 ? free(i) : 1.0) * ((mixed % 20011u) / 10005.0 - 1.0);
  }
};

/// Keeps its vector from one measurement to the next, which then takes few products.
class PowerIteration {
 public:
  /// @param free  1 where the operator's vectors may be anything, else 0; empty: everywhere
  explicit PowerIteration(int size, ConstArray free = {})
      : direction_("power.direction", size), product_("power.product", size), free_(std::move(free)) {}

  /// @param apply  apply(z, out) writes the product with z and tells whether there is one
  template <class Apply>
  void measure(const Apply& apply) {
    // The length of one product swings where the parts of the vector trade places, as in an oscillation. The mean growth
    // over a window does not. Its cosine changes its sign then, and stays at -1 for a real negative eigenvalue.
    constexpr int window = 8, most = 80;
    constexpr double settled = 0.01;
    double growth[most + 1] = {}, cosine[most + 1] = {};  // growth: logarithm of that since the beginning
    add_noise();
    radius_ = 0;
    for (int k = 1; k <= most; ++k) {
      const double length = norm(direction_);
      if (!(length > 0) || !apply(direction_, product_)) break;
      const double size = norm(product_);
      if (!(size > 0) || !std::isfinite(size)) break;
      growth[k] = growth[k - 1] + std::log(size / length);
      cosine[k] = dot(product_, direction_) / (size * length);
      combine(direction_, 1 / size, product_, 0);
      const int first = std::max(0, k - window);
      const double now = std::exp((growth[k] - growth[first]) / (k - first));
      const bool still = k >= window + window / 2 && std::abs(now - radius_) < settled * now;
      radius_ = now;
      imaginary_ = *std::max_element(cosine + first + 1, cosine + k + 1) > -0.9;
      if (still) break;
    }
  }

  double radius() const { return radius_; }
  /// Whether the vector turns instead of changing its sign: the eigenvalue is not real and negative.
  bool imaginary() const { return imaginary_; }

 private:
  /// Adds numbers that look random and are the same in every run, so that modes grow that have become the largest since
  /// the last time.
  void add_noise() {
    constexpr double part = 0.1;
    const double length = norm(direction_), size = direction_.extent(0) > 0 ? direction_.extent(0) : 1;
    const double scale = length > 0 ? part * length / std::sqrt(size) : 1;
    Kokkos::parallel_for("softwet::noise", Kokkos::RangePolicy<Exec>(0, direction_.extent(0)),
                         AddNoise{direction_, free_, scale});
  }

  Array direction_, product_;
  ConstArray free_;
  double radius_ = 0;
  bool imaginary_ = false;
};

}  // namespace softwet
