// Reference assembly by plain loops: every basis function at every quadrature point, integrated in the current
// configuration with the inverse of the deformation gradient by elimination. No sum factorisation, packs or pull-backs.
#pragma once

#include <functional>

#include "patch.hpp"

namespace softwet::testing_tools {

/// Control values of a component, from `offset` on, whose first row is row `shift` of the patch.
struct Grid {
  std::vector<double> values;
  int offset = 0, shift = 0;
};

/// How the mesh moves: the wall's displacement and velocity as full-patch components, or nothing.
template <int D>
struct NaiveMotion {
  std::vector<Grid> displacement, velocity;
  Blend blend;
};

/// Determinant and solution of A x = b for a few right-hand sides, by Gaussian elimination with pivoting.
template <int D>
double eliminate(std::array<std::array<double, D>, D> a, std::array<double, D>& b) {
  double det = 1;
  for (int k = 0; k < D; ++k) {
    int pivot = k;
    for (int i = k + 1; i < D; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    if (pivot != k) {
      std::swap(a[k], a[pivot]);
      std::swap(b[k], b[pivot]);
      det = -det;
    }
    det *= a[k][k];
    for (int i = k + 1; i < D; ++i) {
      const double f = a[i][k] / a[k][k];
      for (int j = k; j < D; ++j) a[i][j] -= f * a[k][j];
      b[i] -= f * b[k];
    }
  }
  for (int i = D - 1; i >= 0; --i) {
    for (int j = i + 1; j < D; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return det;
}

/// One quadrature point: basis functions of its element and the map there.
template <int D>
struct NaivePoint {
  const Layout<D>& layout;
  std::array<std::vector<double>, D> value, slope;
  std::array<int, D> first;
  std::array<double, D> x;
  std::array<std::array<double, D>, D> f_transposed{};
  std::array<double, D> mesh_velocity{};
  double volume = 1;
  double radius;  ///< distance from the axis, in the coordinates (r, z)

  NaivePoint(const Layout<D>& l, const std::array<int, D>& element, const std::array<double, D>& position,
             const NaiveMotion<D>* motion)
      : layout(l), x(position), radius(position[0]) {
    for (int d = 0; d < D; ++d) {
      value[d] = l.axis[d].values(element[d], x[d]);
      slope[d] = l.axis[d].slopes(element[d], x[d]);
      first[d] = l.axis[d].span(element[d]);
      f_transposed[d][d] = 1;
    }
    if (motion) move(*motion);
  }

  /// Calls body(index in the whole patch, basis value along `derivative`); only the lowest layer of functions if asked.
  template <class Body>
  void for_functions(int derivative, const Body& body) const {
    const int n = layout.axis[0].degree() + 1;
    for (int k = 0; k < (D == 3 ? n : 1); ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const int local[3] = {i, j, k};
          int index = 0, stride = 1;
          double b = 1;
          for (int d = 0; d < D; ++d) {
            index += stride * (first[d] + local[d]);
            stride *= layout.axis[d].functions();
            b *= d == derivative ? slope[d][local[d]] : value[d][local[d]];
          }
          body(index, b);
        }
  }
  double evaluate(const Grid& c, int derivative) const {
    double sum = 0;
    // On the wall the functions of the rows above it are 0; the displacement has no values there.
    for_functions(derivative, [&](int i, double b) {
      if (b != 0) sum += b * c.values[c.offset + i - c.shift * layout.row_size];
    });
    return sum;
  }
  /// Reference gradient to physical gradient: solves F^T g = G.
  std::array<double, D> physical(std::array<double, D> g) const {
    eliminate<D>(f_transposed, g);
    return g;
  }

  /// x(X) = X + beta(Y) d(X_wall): trace on the wall, times the linear blend.
  void move(const NaiveMotion<D>& m) {
    NaivePoint wall = *this;
    const int row = layout.solid_elements;
    wall.value[D - 1] = layout.axis[D - 1].values(row, layout.axis[D - 1].lower(row));
    wall.first[D - 1] = layout.axis[D - 1].span(row);
    const double beta = (m.blend.low + m.blend.height - x[D - 1]) / m.blend.height;
    radius += beta * wall.evaluate(m.displacement[0], -1);
    for (int i = 0; i < D; ++i) {
      mesh_velocity[i] = beta * wall.evaluate(m.velocity[i], -1);
      for (int j = 0; j + 1 < D; ++j) f_transposed[j][i] += beta * wall.evaluate(m.displacement[i], j);
      f_transposed[D - 1][i] -= wall.evaluate(m.displacement[i], -1) / m.blend.height;
    }
    std::array<double, D> none{};
    volume = eliminate<D>(f_transposed, none);
  }
  /// Current area per reference area of a face normal to the last axis, from its tangent vectors.
  double area() const {
    const auto& a = f_transposed[0];
    if constexpr (D == 2) {
      return std::hypot(a[0], a[1]);
    } else {
      const auto& b = f_transposed[1];
      return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    }
  }
};

/// What Trial::read and Test::write see.
template <int D>
struct NaiveReader {
  const NaivePoint<D>& point;
  const std::vector<Grid>& slots;
  bool around = false;  ///< in the coordinates (r, z)
  double value(int s) const { return point.evaluate(slots[s], -1); }
  bool remembers() const { return true; }
  double remembered(int k) const { return memory_at(point.x, D, k); }
  double area_ratio() const { return point.area() * (around ? point.radius / point.x[0] : 1); }
  double over_radius(int s) const { return value(s) / point.radius; }
  Vector<double, D> gradient(int s) const {
    std::array<double, D> g;
    for (int d = 0; d < D; ++d) g[d] = point.evaluate(slots[s], d);
    g = point.physical(g);
    Vector<double, D> r;
    for (int d = 0; d < D; ++d) r[d] = g[d];
    return r;
  }
  Vector<double, D> mesh_velocity() const {
    Vector<double, D> v;
    for (int d = 0; d < D; ++d) v[d] = point.mesh_velocity[d];
    return v;
  }
  Vector<double, D> normal() const {
    Vector<double, D> n;
    const auto& a = point.f_transposed[0];
    if constexpr (D == 2) {
      n = {{-a[1], a[0]}};
    } else {
      const auto& b = point.f_transposed[1];
      n = {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
    }
    return (1 / point.area()) * n;
  }
};

template <int D>
struct NaiveWriter {
  const NaivePoint<D>& point;
  const std::vector<Grid>& tests;  ///< values unused
  double measure;
  int only_row;  ///< row of the patch whose functions are tested, or -1: all
  std::vector<double>& out;

  bool skip(int i) const { return only_row >= 0 && i / point.layout.row_size != only_row; }
  void add(int c, double f) const {
    point.for_functions(-1, [&](int i, double b) {
      if (!skip(i)) out[tests[c].offset + i - tests[c].shift * point.layout.row_size] += measure * f * b;
    });
  }
  /// A hoop entry meets w / r.
  void add(int c, double f, const Vector<double, D>& flux, double hoop) const { add(c, f + hoop / point.radius, flux); }
  void add(int c, double f, const Vector<double, D>& flux) const {
    add(c, f);
    std::array<double, D> g{};  // (F^-T Grad N) . flux = Grad N . (F^-1 flux), by one physical gradient per direction
    for (int d = 0; d < D; ++d) {
      std::array<double, D> unit{};
      unit[d] = 1;
      unit = point.physical(unit);
      for (int e = 0; e < D; ++e) g[d] += unit[e] * flux[e];
    }
    for (int d = 0; d < D; ++d)
      point.for_functions(d, [&](int i, double b) {
        if (!skip(i)) out[tests[c].offset + i - tests[c].shift * point.layout.row_size] += measure * g[d] * b;
      });
  }
};

/// Gauss-Legendre points on [0, 1] and their weights: two, three or four.
struct NaiveRule {
  std::vector<double> point, weight;

  explicit NaiveRule(int points) {
    if (points == 2) {
      point = {0.5 - std::sqrt(1. / 12), 0.5 + std::sqrt(1. / 12)};
      weight = {0.5, 0.5};
    } else if (points == 3) {
      point = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
      weight = {5. / 18, 8. / 18, 5. / 18};
    } else {
      const double near = std::sqrt(3. / 7 - 2. / 7 * std::sqrt(1.2)),
                   far = std::sqrt(3. / 7 + 2. / 7 * std::sqrt(1.2));
      const double more = (18 + std::sqrt(30.)) / 72, less = (18 - std::sqrt(30.)) / 72;
      point = {0.5 - 0.5 * far, 0.5 - 0.5 * near, 0.5 + 0.5 * near, 0.5 + 0.5 * far};
      weight = {less, more, more, less};
    }
  }
};

/// The whole elements, or their face at the low or high end of the last axis.
enum NaiveFace { no_face, low_face, high_face };

/// body(point, weight in the reference) at `points` Gauss points per axis; on a face, at the points of the first
/// element.
template <int D>
void for_points(const Layout<D>& l, int points, int first, int last, int face, const NaiveMotion<D>* motion,
                const std::function<void(const NaivePoint<D>&, double)>& body) {
  const NaiveRule rule(points);
  int extent[D], total = 1;
  for (int d = 0; d < D; ++d) extent[d] = d < D - 1 ? l.axis[d].elements() : (face ? 1 : last - first);
  for (int d = 0; d < D; ++d) total *= extent[d] * (face && d == D - 1 ? 1 : points);
  for (int n = 0; n < total; ++n) {
    std::array<int, D> element;
    std::array<double, D> x;
    double w = 1;
    for (int d = 0, rest = n; d < D; ++d) {
      const bool trace = face && d == D - 1;
      element[d] = rest % extent[d] + (d == D - 1 ? first : 0);
      rest /= extent[d];
      const int q = trace ? 0 : rest % points;
      rest /= trace ? 1 : points;
      const double h = l.axis[d].spacing();
      x[d] = h * (element[d] + (trace ? (face == high_face ? 1.0 : 0.0) : rule.point[q]));
      w *= trace ? 1.0 : h * rule.weight[q];
    }
    body(NaivePoint<D>(l, element, x, motion), w);
  }
}

/// Residual of a term: `slots` and `tests` in the order of its bundles; element rows [first, last).
template <int D, class Term>
std::vector<double> naive_residual(const Layout<D>& l, int points, const Term& term, const std::vector<Grid>& slots,
                                   const std::vector<Grid>& tests, int first, int last, int face,
                                   const NaiveMotion<D>* motion, int only_row = -1) {
  std::vector<double> out(l.size(), 0.0);
  for_points<D>(l, points, first, last, face, motion, [&](const NaivePoint<D>& p, double w) {
    using Trial = typename Term::template Trial<double, D>;
    const auto test = term.residual(Trial::read(NaiveReader<D>{p, slots, is_axisymmetric<Term>}));
    const double measure = w * (face ? p.area() : p.volume) * (is_axisymmetric<Term> ? p.radius : 1.0);
    test.write(NaiveWriter<D>{p, tests, measure, only_row, out});
  });
  return out;
}

}  // namespace softwet::testing_tools
