// Body forces on the solid: loads on boxes over time, and gravity.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "field/layout.hpp"
#include "field/vector.hpp"
#include "kernels/solid/body_force.hpp"

namespace softwet {

/// rho_0^s int_box N_i dX of all functions on the solid's rows, exact, with the weight of each axis. Round a periodic
/// axis the box comes in on the other side; what lies outside of the solid counts nothing.
template <int D>
std::vector<double> weights_on_box(const Layout<D>& l, const std::vector<double>& lower,
                                   const std::vector<double>& upper, double density) {
  std::vector<double> w(static_cast<std::size_t>(l.solid_rows()) * l.row_size, density);
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const Axis& axis = l.axis[d];
    const int last = d == D - 1 ? l.solid_elements : axis.elements();
    const double turns = axis.periodic() ? std::floor(lower[d] / axis.length()) : 0;
    const double from = lower[d] - turns * axis.length(), to = upper[d] - turns * axis.length();
    std::vector<double> factor = axis.integrals(from, to, 0, last);
    if (axis.periodic() && to > axis.length()) {
      const std::vector<double> beyond = axis.integrals(0, to - axis.length(), 0, last);
      for (std::size_t i = 0; i < factor.size(); ++i) factor[i] += beyond[i];
    }
    for (int g = axis.owned(); g < axis.functions(); ++g) factor[g - axis.owned()] += std::exchange(factor[g], 0.0);
    const int n = d == D - 1 ? l.solid_rows() : l.extent(d);
    for (std::size_t i = 0; i < w.size(); ++i) w[i] *= factor[l.function((i / stride) % n, d)];
    stride *= n;
  }
  return w;
}

/// A body force per unit mass on a box of the solid that may move.
template <int D>
class LoadVector {
 public:
  LoadVector(const Layout<D>& layout, const Load& load, double density, double clock_zero)
      : load_(load),
        density_(density),
        clock_zero_(clock_zero),
        weight_(to_device<Array>(weights_on_box(layout, load.lower, load.upper, density), "load")) {}

  /// Force at a time of the computation, by axis; the ramp and the factor count.
  std::vector<double> force(double time) const {
    const double fraction = load_fraction(time, load_.start, load_.ramp);
    const double part = fraction == 0 ? 0 : fraction * load_.factor.at({0, 0, 0}, time - clock_zero_);
    std::vector<double> f = load_.force;
    for (double& x : f) x *= part;
    return f;
  }
  /// Weights of the box where `move` has put it last.
  ConstArray weight() const { return weight_; }
  /// The box goes to where it is at a time of the computation. Where it moves its weights are made on the host.
  void move(const Layout<D>& layout, double time) const {
    if (load_.path.empty()) return;
    std::vector<double> lower = load_.lower, upper = load_.upper;
    for (int d = 0; d < D; ++d) {
      const double shift = load_.path[d].at({0, 0, 0}, time - clock_zero_);
      lower[d] += shift;
      upper[d] += shift;
    }
    Kokkos::deep_copy(weight_, to_device<Array>(weights_on_box(layout, lower, upper, density_), "load"));
  }

 private:
  Load load_;
  double density_, clock_zero_;
  Array weight_;
};

/// A uniform force per unit mass on all of the solid; no force: empty.
struct SolidGravity {
  static constexpr const char* energy_column = "energy_gravity";

  Array weight;  ///< rho_0^s int N_i dX
  std::vector<double> force;
};

}  // namespace softwet
