// Spline interpolation at the Greville points: approximates to the full order and takes boundary values exactly.
#pragma once

#include <Eigen/Dense>

#include "field/layout.hpp"
#include "kernels/algebra/tensor.hpp"

namespace softwet::mms {

/// Interpolation along one axis, restricted to the functions [first, last) that end at interpolating points.
class AxisInterpolation {
 public:
  AxisInterpolation(const Axis& axis, int first, int last, int lowest, int highest) {
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(last - first, last - first);
    for (int i = first; i < last; ++i) {
      const double x = axis.greville(i);
      const int e = std::clamp(axis.element_at(x), lowest, highest - 1);
      const std::vector<double> living = axis.values(e, x);
      for (int a = 0; a <= axis.degree(); ++a) values(i - first, axis.span(e) + a - first) = living[a];
      points_.push_back(x);
    }
    inverse_ = values.inverse();
  }
  const std::vector<double>& points() const { return points_; }
  const Eigen::MatrixXd& inverse() const { return inverse_; }

 private:
  std::vector<double> points_;
  Eigen::MatrixXd inverse_;
};

/// Control values of the spline that interpolates f(x) on the rows of the solid or of the fluid: a box [k][j][i].
template <int D, class Function>
std::vector<double> interpolate_rows(const Layout<D>& layout, bool fluid, const Function& f) {
  std::vector<AxisInterpolation> axes;
  for (const Axis& a : layout.axis) {
    if (axes.size() + 1 < D) {
      axes.emplace_back(a, 0, a.functions(), 0, a.elements());
    } else if (fluid) {
      axes.emplace_back(a, layout.wall_row, layout.rows, layout.solid_elements, a.elements());
    } else {
      axes.emplace_back(a, 0, layout.wall_row + 1, 0, layout.solid_elements);
    }
  }
  std::size_t count = 1;
  for (const AxisInterpolation& a : axes) count *= a.points().size();
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k) {
    Vector<double, D> x;
    std::size_t rest = k;
    for (int d = 0; d < D; ++d) {
      x[d] = axes[d].points()[rest % axes[d].points().size()];
      rest /= axes[d].points().size();
    }
    values[k] = f(x);
  }
  std::size_t inner = 1;
  for (const AxisInterpolation& a : axes) {  // one axis after the other: [outer][n][inner]
    const Eigen::Index n = static_cast<Eigen::Index>(a.points().size()), m = static_cast<Eigen::Index>(inner);
    for (std::size_t o = 0; o < count / (n * inner); ++o) {
      Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> block(
          values.data() + o * n * inner, n, m);
      block = (a.inverse() * block).eval();
    }
    inner *= n;
  }
  return values;
}

}  // namespace softwet::mms
