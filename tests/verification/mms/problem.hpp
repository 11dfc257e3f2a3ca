// A scene with its exact solution: the case, the state at the start, and the errors at the end.
#pragma once

#include "interpolation.hpp"
#include "load.hpp"
#include "scene/initial.hpp"
#include "time/stepper.hpp"

namespace softwet::mms {

struct Settings {
  SceneKind scene = SceneKind::fluid;
  Course course = Course::linear;
  int dimension = 2, degree = 2, elements = 8;
  double dt = 0.1, end = 0.2, rho_inf = 0.5, stabilisation = 0.002;
  PreconditionerKind preconditioner = PreconditionerKind::automatic;
  TimeScheme scheme = TimeScheme::generalized_alpha;
  MassKind mass = MassKind::corrected;
  softwet::Quadrature quadrature = softwet::Quadrature::full;
  double coarsest = 1;  ///< longest element over the shortest; above 1: graded
  double against = 0;   ///< above 0: step of a second computation that takes the place of the exact solution
};

/// A box of fine elements off the middle, and around it lengths that are nearly the same function of the place for any
/// number of elements: there are coarsest^(8 / elements) between neighbours, or a little less, since a whole number of
/// them fills an axis.
inline Grading grading_of(const Settings& s, const std::vector<double>& size) {
  Grading grading;
  if (s.coarsest == 1) return grading;
  grading.fine = FineElements::box;
  grading.coarsest = s.coarsest;
  grading.ratio = std::pow(s.coarsest, 8.0 / s.elements);
  for (const double length : size) {
    grading.lower.push_back(0.375 * length);
    grading.upper.push_back(0.75 * length);
  }
  return grading;
}

/// @param elements  per axis; the coupled scene needs an even number
inline Case make_case(const Settings& s) {
  Case c;
  c.domain.size = s.dimension == 2 ? std::vector<double>{1.0, 0.9} : std::vector<double>{1.0, 0.8, 0.9};
  c.domain.elements.assign(s.dimension, s.elements);
  c.domain.degree = s.degree;
  c.domain.quadrature = s.quadrature;
  c.domain.grading = grading_of(s, c.domain.size);
  if (s.scene != SceneKind::solid) {
    c.fluid = Fluid{};
    c.fluid->viscosity = 0.1;
    c.fluid->capillarity = 0.15;
    c.fluid->temperature = 0.85;
    c.fluid->contact_angle = s.scene == SceneKind::coupled ? 60 : 90;
    c.fluid->stabilisation = s.stabilisation;
    c.fluid->smoothing = 0.05;
  }
  if (s.scene != SceneKind::fluid) {
    c.substrate = Substrate{};
    c.substrate->thickness = c.domain.size.back() * (s.scene == SceneKind::coupled ? 0.5 : 1.0);
    c.substrate->density = 1.3;
    c.substrate->young = 2.0;
    c.substrate->poisson = 0.3;
  }
  if (s.scene == SceneKind::coupled) c.boundary.side[s.dimension - 1][1] = Side::no_slip;
  c.time.rho_inf = s.rho_inf;
  c.time.scheme = s.scheme;
  c.time.mass = s.mass;
  c.time.dt_initial = c.time.dt_min = c.time.dt_max = s.dt;
  c.time.tolerance = 1e30;  // steps of one size
  c.solver.newton_rtol = 1e-8;
  c.solver.newton_atol = 1e-12;
  c.solver.newton_max = 20;
  c.solver.krylov_rtol = 1e-3;
  c.solver.preconditioner = s.preconditioner;
  return c;
}

inline Material material_of(const Case& c) {
  Material m{};
  if (c.fluid) {
    double h = 1e30;
    for (std::size_t d = 0; d < c.domain.size.size(); ++d) h = std::min(h, c.domain.size[d] / c.domain.elements[d]);
    m.viscosity = c.fluid->viscosity;
    m.capillarity = c.fluid->capillarity;
    m.temperature = c.fluid->temperature;
    m.stabilisation = c.fluid->stabilisation * h * h / m.viscosity;
    m.cosine = std::cos(c.fluid->contact_angle.number * std::numbers::pi / 180);
    m.smoothing = c.fluid->smoothing;
  }
  if (c.substrate) {
    const double young = c.substrate->young_modulus(), nu = c.substrate->poisson;
    m.lame = nu * young / ((1 + nu) * (1 - 2 * nu));
    m.shear = young / (2 * (1 + nu));
    m.solid_density = c.substrate->density;
  }
  return m;
}

/// L2 norms over the domain: of the fluid as deformed, of the solid as undeformed. nan: the scene has no such field.
struct Errors {
  double velocity = 0, density = NAN, potential = NAN, displacement = NAN;
};

template <int D, int P>
class Problem {
 public:
  explicit Problem(const Settings& s)
      : data_(make_case(s)),
        scene_(data_),
        exact_(exact_of(s, data_)),
        load_(scene_.layout(), exact_, material_of(data_)),
        stepper_(scene_, data_, {s.end}) {
    scene_.set_source([this](double t, const Array& out) { add_scaled(out, 0, -1, to_device<Array>(load_.at(t))); });
    State state = initial();
    stepper_.scheme().initialise(state);
    stepper_.restore(state, state.unknown, s.dt, s.dt);  // all rates are known: no first step of backward Euler
  }

  Errors run(double end) {
    while (stepper_.state().time < end * (1 - 1e-12)) stepper_.step();
    return errors();
  }

  /// Root mean squares of the differences of the control values: the error of the steps, where the other's are finer.
  Errors difference(const Problem& other) const {
    const Layout<D>& l = scene_.layout();
    const State &a = stepper_.state(), &b = other.stepper_.state();
    const auto rms = [](const ConstArray& x, const ConstArray& y, int first, int last) {
      const Array d = to_device<Array>(to_host(part(x, first, last)));
      combine(d, -1, part(y, first, last), 1);
      return norm(alone, d) / std::sqrt(static_cast<double>(last - first));
    };
    Errors e;
    e.velocity = rms(a.unknown, b.unknown, 0, l.velocity_size());
    if (l.has_fluid) e.density = rms(a.unknown, b.unknown, l.density_offset(), l.potential_offset());
    if (l.has_fluid) e.potential = rms(a.unknown, b.unknown, l.potential_offset(), l.size());
    if (l.has_solid) e.displacement = rms(a.displacement, b.displacement, 0, l.solid_size());
    return e;
  }

 private:
  static Exact<D> exact_of(const Settings& s, const Case& c) {
    Exact<D> e{s.scene, s.course, {}, c.substrate ? c.substrate->thickness : 0.0};
    for (int d = 0; d < D; ++d) e.length[d] = c.domain.size[d];
    return e;
  }

  /// Writes the interpolant of f on the rows of one material into a component that starts at `offset`.
  template <class Function>
  void fill(std::vector<double>& all, int offset, bool fluid, const Function& f) const {
    const std::vector<double> box = interpolate_rows<D>(scene_.layout(), fluid, f);
    std::copy(box.begin(), box.end(), all.begin() + offset);
  }

  /// All levels of the integrator at t = 0 but the moments, which follow from them.
  State initial() const {
    const Layout<D>& l = scene_.layout();
    State state = empty_state(l);
    std::vector<double> x(l.size(), 0.0), rate(l.velocity_size()), u(l.solid_size()), u_rate(l.solid_size());
    const auto at = [](const Vector<double, D>& p) { return Point<double, D>{p, 0.0}.seeded(); };
    for (int d = 0; d < D; ++d) {
      if (l.has_fluid) {
        const auto v = [&](const auto& p) { return exact_.velocity(at(p))[d]; };
        fill(x, l.velocity_offset(d) + l.fluid_shift(), true, [&](const auto& p) { return v(p).value; });
        fill(rate, l.velocity_offset(d) + l.fluid_shift(), true, [&](const auto& p) { return v(p).slope[D]; });
      }
      if (!l.has_solid) continue;
      const auto v = [&](const auto& p) { return exact_.solid_velocity(at(p))[d]; };
      fill(x, l.velocity_offset(d), false, [&](const auto& p) { return v(p).value; });
      fill(rate, l.velocity_offset(d), false, [&](const auto& p) { return v(p).slope[D]; });
      fill(u, l.displacement_offset(d), false, [&](const auto& p) { return exact_.displacement(at(p))[d].value; });
      fill(u_rate, l.displacement_offset(d), false, [&](const auto& p) { return v(p).value; });
    }
    if (l.has_fluid) {
      fill(x, l.density_offset(), true, [&](const auto& p) { return exact_.density(at(p)).value; });
      fill(x, l.potential_offset(), true, [&](const auto& p) { return exact_.potential(at(p)).value; });
    }
    state.unknown = to_device<Array>(x);
    state.velocity_rate = to_device<Array>(rate);
    state.displacement = to_device<Array>(u);
    state.displacement_rate = to_device<Array>(u_rate);
    multiply(state.unknown, scene_.mask());
    multiply(state.velocity_rate, part(scene_.mask(), 0, l.velocity_size()));
    return state;
  }

  Errors errors() const {
    const Layout<D>& l = scene_.layout();
    const Axis& vertical = l.axis[D - 1];
    const int points = P + 2;
    double v = 0, rho = 0, mu = 0, u = 0;
    if (l.has_fluid)
      fluid_errors({l, points, gauss_points(vertical, l.solid_elements, vertical.elements(), points)}, v, rho, mu);
    if (l.has_solid) solid_errors({l, points, gauss_points(vertical, 0, l.solid_elements, points)}, v, u);
    Errors e;
    e.velocity = std::sqrt(v);
    if (l.has_fluid) e.density = std::sqrt(rho), e.potential = std::sqrt(mu);
    if (l.has_solid) e.displacement = std::sqrt(u);
    return e;
  }

  /// Adds the squares of the errors.
  void fluid_errors(const Quadrature<D>& rule, double& velocity, double& density, double& potential) const {
    const Layout<D>& l = scene_.layout();
    const State& state = stepper_.state();
    const std::vector<double> x = to_host(state.unknown);
    rule.for_points([&](const Vector<double, D>& at, double weight, const auto& functions) {
      const Point<double, D> p{at, state.time};
      Vector<double, D> v = exact_.velocity(p);
      double rho = exact_.density(p), mu = exact_.potential(p);
      functions([&](int i, double value) {
        for (int d = 0; d < D; ++d) v[d] -= value * x[l.velocity_offset(d) + i];
        rho -= value * x[l.density_offset() + i - l.fluid_shift()];
        mu -= value * x[l.potential_offset() + i - l.fluid_shift()];
      });
      const double w = weight * FluidPoint<double, D>(exact_, p).volume;
      velocity += w * dot(v, v);
      density += w * rho * rho;
      potential += w * mu * mu;
    });
  }

  void solid_errors(const Quadrature<D>& rule, double& velocity, double& displacement) const {
    const Layout<D>& l = scene_.layout();
    const State& state = stepper_.state();
    const std::vector<double> x = to_host(state.unknown), y = to_host(state.displacement);
    rule.for_points([&](const Vector<double, D>& at, double weight, const auto& functions) {
      const Point<double, D> p{at, state.time};
      Vector<double, D> v = exact_.solid_velocity(p), u = exact_.displacement(p);
      functions([&](int i, double value) {
        for (int d = 0; d < D; ++d) {
          v[d] -= value * x[l.velocity_offset(d) + i];
          u[d] -= value * y[l.displacement_offset(d) + i];
        }
      });
      velocity += weight * dot(v, v);
      displacement += weight * dot(u, u);
    });
  }

  Case data_;
  Scene<D, P> scene_;
  Exact<D> exact_;
  Load<D> load_;
  Stepper<D, P> stepper_;
};

}  // namespace softwet::mms
