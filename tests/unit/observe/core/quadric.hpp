// Snapshots whose droplets are known exactly: quadratic splines hold quadratic polynomials without an error.
#pragma once

#include <cmath>

#include "observe/snapshot.hpp"

namespace softwet::testing_tools {

using Point = std::array<double, 3>;

/// density = middle + (1 - (x - centre) . shape (x - centre)): the level set `middle` is an ellipsoid.
struct Quadric {
  Point centre;
  std::array<Point, 3> shape;  ///< symmetric
};
constexpr double middle = 0.4;

inline Quadric sphere(const Point& centre, double radius) {
  const double s = 1 / (radius * radius);
  return {centre, {{{s, 0, 0}, {0, s, 0}, {0, 0, s}}}};
}

/// A domain [0, 0.8]^2 x [0, 0.4], `n` x `n` x `n`/2 elements, the lowest quarter of it solid.
class Drawing {
 public:
  static constexpr double length = 0.8, wall = 0.1;

  explicit Drawing(int n, AxisKind sides = AxisKind::bounded) {
    layout_.solid_elements = n / 8;
    layout_.axis.emplace_back(length, n, 2, sides);
    layout_.axis.emplace_back(length, n, 2, sides);
    layout_.axis.emplace_back(0.5 * length, n / 2, 2, AxisKind::bounded, n / 8);
    layout_.row_size = layout_.axis[0].functions() * layout_.axis[1].functions();
    layout_.rows = layout_.axis[2].functions();
    layout_.wall_row = layout_.axis[2].span(n / 8);
    unknown_.resize(layout_.size());
    displacement_.resize(layout_.solid_size());
  }

  Drawing& density(const Quadric& q) {
    return each(layout_.wall_row, layout_.fluid_rows(), [&](int i, const std::array<int, 3>& at) {
      double form = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const double product =
              a == b ? square(a, at[a], q.centre[a]) : from(a, at[a], q.centre[a]) * from(b, at[b], q.centre[b]);
          form += q.shape[a][b] * product;
        }
      unknown_[layout_.density_offset() + i] = middle + 1 - form;
    });
  }
  /// Control values of the density: a function of their Greville points.
  template <class Function>
  Drawing& density_near(const Function& f) {
    return each(layout_.wall_row, layout_.fluid_rows(), [&](int i, const std::array<int, 3>& at) {
      unknown_[layout_.density_offset() + i] = f(Point{from(0, at[0], 0), from(1, at[1], 0), from(2, at[2], 0)});
    });
  }
  /// Liquid and vapour changed: the density mirrored at the middle.
  Drawing& mirrored() {
    for (int i = layout_.density_offset(); i < layout_.potential_offset(); ++i) unknown_[i] = 2 * middle - unknown_[i];
    return *this;
  }
  /// The displacement, linear in the place.
  template <class Function>
  Drawing& moved(const Function& u) {
    return each(0, layout_.solid_rows(), [&](int i, const std::array<int, 3>& at) {
      const Point value = u(Point{from(0, at[0], 0), from(1, at[1], 0), from(2, at[2], 0)});
      for (int d = 0; d < 3; ++d) displacement_[layout_.displacement_offset(d) + i] = value[d];
    });
  }
  Snapshot<3> snapshot() const {
    State state;
    state.unknown = to_device<Array>(unknown_);
    state.displacement = to_device<Array>(displacement_);
    return {layout_, state};
  }
  const Layout<3>& layout() const { return layout_; }

 private:
  template <class Visit>
  Drawing& each(int first, int rows, const Visit& visit) {
    const int nx = layout_.axis[0].functions(), ny = layout_.axis[1].functions();
    for (int i = 0; i < rows * nx * ny; ++i) visit(i, {i % nx, i / nx % ny, i / nx / ny + first});
    return *this;
  }
  double from(int axis, int function, double centre) const { return layout_.axis[axis].greville(function) - centre; }
  /// Control value of (x - centre)^2: the product of the two knots under a function, whose mean is its Greville point.
  double square(int axis, int function, double centre) const {
    const Axis& a = layout_.axis[axis];
    const double g = a.greville(function), h = a.spacing();
    const bool repeated = std::abs(std::remainder(g, h)) < 1e-9 * h;
    return (g - centre) * (g - centre) - (repeated ? 0 : 0.25 * h * h);
  }

  Layout<3> layout_;
  std::vector<double> unknown_, displacement_;
};

}  // namespace softwet::testing_tools
