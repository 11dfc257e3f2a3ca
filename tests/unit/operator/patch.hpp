// A small patch with random fields, for tests of terms and pieces in two and three dimensions.
#pragma once

#include <random>

#include "field/ghosts.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/solid/hooke.hpp"
#include "kernels/solid/neo_hookean.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"
#include "scene/piece.hpp"

namespace softwet::testing_tools {

/// A number k that a point remembers, as a function of its place.
template <class Place>
double memory_at(const Place& x, int dimension, int k) {
  double phase = 0.7 * k;
  for (int d = 0; d < dimension; ++d) phase += (3 + d) * x[d];
  return 0.01 * std::sin(phase);
}

/// Solid below, fluid above, with element counts that are no multiples of a pack or of a colour.
template <int D>
struct Patch {
  Layout<D> layout;
  Blend blend;
  Stage stage;
  int points = 3;  ///< Gauss points of an element along each axis
  std::mt19937 random{20240607};

  /// @param uneven  share by which the lengths of the elements differ from their mean; 0: equal
  explicit Patch(const std::array<int, D>& elements, int solid_elements, int degree = 2, double uneven = 0)
      : points(degree + 1) {
    layout.solid_elements = solid_elements;
    layout.row_size = 1;
    for (int d = 0; d < D; ++d) {
      const double length = 0.7 + 0.2 * d;
      const int kink = d == D - 1 ? solid_elements : 0;
      if (uneven == 0) {
        layout.axis.emplace_back(length, elements[d], degree, AxisKind::bounded, kink);
      } else {
        layout.axis.emplace_back(uneven_breaks(length / elements[d], elements[d], uneven), degree, AxisKind::bounded,
                                 kink);
      }
      if (d < D - 1) layout.row_size *= layout.axis[d].functions();
    }
    layout.rows = layout.axis[D - 1].functions();
    layout.wall_row = layout.axis[D - 1].span(solid_elements);
    blend.low = layout.axis[D - 1].lower(solid_elements);
    blend.height = layout.axis[D - 1].length() - blend.low;
    fill();
  }

  static std::vector<double> uneven_breaks(double mean, int elements, double uneven) {
    std::vector<double> breaks{0};
    for (int e = 0; e < elements; ++e) breaks.push_back(breaks.back() + mean * (1 + uneven * std::sin(3.1 * e * e)));
    return breaks;
  }

  Patch(const Layout<D>& l, const Blend& b) : layout(l), blend(b) { fill(); }

  void fill() {
    stage.unknown = draw(layout.size(), -0.5, 0.5);
    std::vector<double> x = to_host(stage.unknown);
    std::uniform_real_distribution<double> density(0.15, 0.8);
    for (int i = layout.density_offset(); i < layout.potential_offset(); ++i) x[i] = density(random);
    repeat(x);
    stage.unknown = to_device<Array>(x);
    stage.acceleration = draw(layout.rate_size(), -2, 2);
    stage.displacement = draw(layout.solid_size(), -0.012, 0.012);
    stage.displacement_end = draw(layout.solid_size(), -0.012, 0.012);
    stage.density_end = draw(layout.scalar_size(), 0.15, 0.8);
    stage.rate_scale = 7;
    stage.displacement_scale = 0.03;
    stage.end_scale = 1.5;
    stage.moment_rate = 5;
    stage.density_rate_scale = stage.rate_scale;
    if (layout.branches > 0) fill_lag();
  }

  void fill_lag() {
    stage.lag = draw(layout.branch_size(), -0.012, 0.012);
    stage.branch_weight = 0.7;
  }

  /// This patch with rates of the density at the wall.
  Patch with_rates() const {
    Patch p = *this;
    p.layout.rate_rows = p.layout.axis[D - 1].degree() + 1;
    p.stage.acceleration = p.draw(p.layout.rate_size(), -2, 2);
    return p;
  }

  /// This patch with branches of the solid.
  Patch with_branches() const {
    Patch p = *this;
    p.layout.branches = 1;
    p.layout.branch_lines = p.layout.solid_size() / p.layout.extent(0);
    p.fill_lag();
    return p;
  }

  /// This patch, where each point of the solid remembers `size` numbers.
  Patch with_point_memory(int size) const {
    Patch p = *this;
    const Region<D> r = solid();
    const int q3 = points * (D == 3 ? points * points : points), rows = D == 3 ? r.axis[1].elements : 1;
    std::vector<double> all(std::size_t(layout.solid_elements) * rows * size * q3 * r.stride[1]);
    for_all_points(r, [&](const std::array<int, D>& element, const std::array<int, D>& q) {
      std::array<double, D> x;
      std::size_t line = element[D - 1] * rows + (D == 3 ? element[1] : 0);
      int point = 0;
      for (int d = D - 1; d >= 0; --d) {
        x[d] = r.axis[d].position(q[d], element[d]);
        point = point * points + q[d];
      }
      for (int k = 0; k < size; ++k)
        all[((line * size + k) * q3 + point) * r.stride[1] + element[0]] = memory_at(x, D, k);
    });
    p.stage.lag = to_device<Array>(all);
    p.stage.branch_weight = 1;
    return p;
  }
  /// body(element, point), each by axis. Where kernels run on the host.
  void for_all_points(const Region<D>& r, const auto& body) const {
    int total = 1;
    for (int d = 0; d < D; ++d) total *= r.axis[d].elements * points;
    for (int i = 0; i < total; ++i) {
      std::array<int, D> element, q;
      for (int d = 0, rest = i; d < D; ++d) {
        element[d] = rest % r.axis[d].elements;
        rest /= r.axis[d].elements;
        q[d] = rest % points;
        rest /= points;
      }
      body(element, q);
    }
  }

  Array draw(int n, double low, double high) {
    std::uniform_real_distribution<double> uniform(low, high);
    std::vector<double> v(n);
    for (double& x : v) x = uniform(random);
    repeat(v);
    return to_device<Array>(v);
  }

  /// Ghosts of a periodic first axis; all components share its index, so one rule serves every array.
  void repeat(std::vector<double>& v) const {
    const Axis& x = layout.axis[0];
    for (std::size_t i = 0; i < v.size(); ++i)
      if (x.periodic() && static_cast<int>(i) % x.functions() >= x.owned()) v[i] = v[i - x.owned()];
  }

  Region<D> region(int first, int last) const {
    Region<D> r;
    int stride = 1;
    for (int d = 0; d < D; ++d) {
      const Axis& axis = layout.axis[d];
      const bool along = d < D - 1;
      r.axis[d] = gauss_rule(axis, along ? 0 : first, along ? axis.elements() : last, points);
      if (d == 0 && layout.columns.stored() > 0) r.axis[d] = gauss_rule(axis, layout.columns.elements, points);
      r.stride[d] = stride;
      stride *= layout.extent(d);
    }
    r.columns = layout.columns.elements;
    r.test = r.axis[D - 1];
    return r;
  }
  Region<D> fluid() const { return region(layout.solid_elements, layout.axis[D - 1].elements()); }
  Region<D> solid() const { return region(0, layout.solid_elements); }
  /// The elements of the solid, where terms see means over each.
  Region<D> means() const {
    Region<D> r = solid();
    for (int d = 0; d < D; ++d)
      r.axis[d] = mean_rule(layout.axis[d], 0, d < D - 1 ? layout.axis[d].elements() : layout.solid_elements, points);
    r.test = r.axis[D - 1];
    return r;
  }
  Region<D> layer() const {
    Region<D> r = region(layout.solid_elements, layout.solid_elements + 1);
    r.test = restricted_to(r.test, 0);
    return r;
  }
  Region<D> face() const {
    Region<D> r = fluid();
    r.axis[D - 1] = low_face_rule(layout.axis[D - 1], layout.solid_elements);
    r.test = r.axis[D - 1];
    return r;
  }

  Region<D> top() const {
    Region<D> r = region(layout.solid_elements - 1, layout.solid_elements);
    r.axis[D - 1] = high_face_rule(layout.axis[D - 1], layout.solid_elements - 1);
    r.test = r.axis[D - 1];
    return r;
  }

  Region<D> bottom() const {
    Region<D> r = region(0, 1);
    r.axis[D - 1] = r.test = low_face_rule(layout.axis[D - 1], 0);
    return r;
  }

  std::vector<double> residual(const Piece<D>& piece, const Stage& at) const {
    Array out("out", layout.size());
    piece.residual(Evaluation<D>{layout, at, {}, out});
    return to_host(out);
  }
  std::vector<double> product(const Piece<D>& piece, const Array& z, Geometry geometry = Geometry::exact) const {
    Array out("out", layout.size());
    piece.product(Evaluation<D>{layout, stage, z, out, geometry});
    return to_host(out);
  }

  /// The stage with its unknowns moved by e z, and all that the time scheme derives from them.
  Stage moved(const Array& z, double e) const {
    const std::vector<double> step = to_host(z);
    const auto shift = [&](const Array& a, int first, double factor, int count, int offset) {
      std::vector<double> v = to_host(a);
      for (int i = 0; i < count; ++i) v[offset + i] += e * factor * step[first + i];
      return to_device<Array>(v);
    };
    Stage s = stage;
    s.unknown = shift(stage.unknown, 0, 1, layout.size(), 0);
    s.acceleration = shift(stage.acceleration, 0, stage.rate_scale, layout.rate_size(), 0);
    s.density_end = shift(stage.density_end, layout.density_offset(), stage.end_scale, layout.scalar_size(), 0);
    const int count = layout.solid_rows() * layout.row_size;
    for (int d = 0; d < D; ++d) {
      const int from = layout.velocity_offset(d), to = layout.displacement_offset(d);
      s.displacement = shift(s.displacement, from, stage.displacement_scale, count, to);
      s.displacement_end = shift(s.displacement_end, from, stage.displacement_scale * stage.end_scale, count, to);
      if (layout.branches > 0) s.lag = shift(s.lag, from, stage.branch_weight * stage.displacement_scale, count, to);
    }
    return s;
  }

  /// Fourth-order central difference of a piece's residual along z.
  std::vector<double> difference(const Piece<D>& piece, const Array& z, double e) const {
    const std::vector<double> a = residual(piece, moved(z, e)), b = residual(piece, moved(z, -e)),
                              c = residual(piece, moved(z, 2 * e)), d = residual(piece, moved(z, -2 * e));
    std::vector<double> r(a.size());
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * e);
    return r;
  }
};

inline StageOf<float> single_stage(const Stage& s) {
  const auto copy = [](const Array& a) {
    const ArrayOf<float> r("rounded", a.extent(0));
    convert(r, a);
    return r;
  };
  return {s.time,
          copy(s.unknown),
          copy(s.acceleration),
          copy(s.displacement),
          copy(s.displacement_end),
          copy(s.density_end),
          s.rate_scale,
          s.displacement_scale,
          s.end_scale,
          s.moment_rate,
          s.density_rate_scale,
          copy(s.lag),
          s.branch_weight};
}

inline double largest(const std::vector<double>& v) {
  double m = 0;
  for (double x : v) m = std::max(m, std::abs(x));
  return m;
}

/// max |a - b| / max |b|
inline double distance(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference(a);
  for (std::size_t i = 0; i < b.size(); ++i) difference[i] -= b[i];
  return largest(difference) / largest(b);
}

/// One fluid with all its terms; numbers of order one, so that no contribution hides behind another.
struct Terms {
  VanDerWaals gas{0.85, 0.02};
  Coexistence state{0.1065766548, 0.6023801091, 1.868487592e-2, -0.4667444110};
  NavierStokesKorteweg fluid{gas, 0.3, 0.4, 0.2, 0.05, {0.3, -0.7, 0.4}};
  GradientWall gradient_wall{0.4, 0.6, 1e-2};
  EnergyWall energy_wall{0.4, 0.6, 1e-2, gas, state};
  CapillaryTraction traction{gas, 0.4};
  Elastodynamics<SaintVenantKirchhoff> solid{{{0.8, 0.5}}, 1.3};
  Elastodynamics<Hooke> hooke{{{0.8, 0.5}}, 1.3};
  Elastodynamics<NeoHookean> neo_hookean{{{0.8, 0.5}}, 1.3};
};

}  // namespace softwet::testing_tools
