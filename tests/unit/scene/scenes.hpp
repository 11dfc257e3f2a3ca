// Small scenes for tests of scenes, the solvers and the time integrator.
#pragma once

#include "scene/scene.hpp"
#include "unit/operator/term_cases.hpp"
#include "unit/scene/rates.hpp"

namespace softwet::testing_tools {

enum class SceneKind { coupled, rigid, solid };

/// theta = 0.85 keeps densities and energies of order one; element counts are no multiples of a pack.
inline Case small_case(SceneKind kind, WallLaw law = WallLaw::gradient, bool periodic = false) {
  Case c;
  c.domain.size = {0.9, 0.8};
  c.domain.elements = {9, 6};
  if (kind != SceneKind::solid) {
    c.fluid = Fluid{};
    c.fluid->viscosity = 0.3;
    c.fluid->capillarity = 0.2;
    c.fluid->temperature = 0.85;
    c.fluid->contact_angle = 60;
    c.fluid->wall_law = law;
    c.fluid->stabilisation = 2.0;
    c.fluid->smoothing = 1e-2;
  }
  if (kind != SceneKind::rigid) {
    c.substrate = Substrate{};
    c.substrate->thickness = kind == SceneKind::solid ? 0.8 : 0.8 / 3;
    c.substrate->density = 1.3;
    c.substrate->young = 2.0;
    c.substrate->poisson = 0.3;
    const double top = c.substrate->thickness;
    c.loads.push_back({{0.3, 0.0}, {0.6, top / 2}, {0.7, -0.4}, 1.0, 4.0});  // cut along element borders
  }
  c.boundary.side[1] = {Side::slip, Side::no_slip};
  if (kind == SceneKind::solid) c.boundary.side[1][1] = Side::free;
  if (periodic) c.boundary.side[0] = {Side::periodic, Side::periodic};
  return c;
}

/// The case in the coordinates (r, z), without the forces along r.
inline Case axisymmetric(Case c) {
  c.domain.coordinates = Coordinates::axisymmetric;
  for (Load& load : c.loads) load.force[0] = 0;
  return c;
}

/// `small_case` in 3D, three elements deep.
inline Case small_case_in_3d(SceneKind kind, WallLaw law = WallLaw::gradient) {
  Case c = small_case(kind, law);
  c.domain.size.insert(c.domain.size.begin() + 1, 0.5);
  c.domain.elements = {5, 3, 6};
  for (Load& load : c.loads) {
    load.lower.insert(load.lower.begin() + 1, 0.0);
    load.upper.insert(load.upper.begin() + 1, 0.5);
    load.force.insert(load.force.begin() + 1, 0.0);
  }
  c.boundary.side[2] = c.boundary.side[1];
  c.boundary.side[1] = {Side::slip, Side::slip};
  return c;
}

/// A scene with a random stage whose velocity and acceleration respect the sides.
template <int D>
struct RandomSceneIn {
  Case data;
  Scene<D, 2> scene;
  TermCases<D> terms;

  explicit RandomSceneIn(const Case& c)
      : data(c),
        scene(c),
        terms(Patch<D>(scene.layout(), Blend{scene.regions().wall_height(), 0.8 - scene.regions().wall_height()})) {
    hold(stage().unknown);
    hold(stage().acceleration);
    stage().time = 3.0;  // half of the load's ramp
    if (!layout().axisymmetric()) return;
    keep_axis(stage().displacement);
    keep_axis(stage().displacement_end);
  }
  Stage& stage() { return terms.patch.stage; }
  const Layout<D>& layout() const { return scene.layout(); }

  /// Zero where a velocity is prescribed.
  void hold(const Array& a) {
    std::vector<double> v = to_host(a);
    const std::vector<double> mask = to_host(scene.mask());
    const Axis& x = layout().axis[0];
    for (int i = 0; i < layout().velocity_size(); ++i) {
      const bool ghost = x.periodic() && i % x.functions() >= x.owned();
      v[i] *= mask[ghost ? i - x.owned() : i];
    }
    Kokkos::deep_copy(a, to_device<Array>(v));
  }
  /// Zero radial displacements on the axis of symmetry.
  void keep_axis(const Array& displacement) {
    std::vector<double> u = to_host(displacement);
    for (int i = 0; i < layout().solid_rows(); ++i) u[i * layout().row_size] = 0;
    Kokkos::deep_copy(displacement, to_device<Array>(u));
  }
  /// A random direction of the unknowns, zero where prescribed and on ghosts.
  Array direction() {
    const Array z = terms.patch.draw(layout().size(), -1, 1);
    std::vector<double> v = to_host(z);
    const std::vector<double> mask = to_host(scene.mask());
    for (std::size_t i = 0; i < v.size(); ++i) v[i] *= mask[i];
    return to_device<Array>(v);
  }
  /// Fills a matrix with the Jacobian at the stage.
  auto jacobian() {
    return [this](const StencilValues& values) { scene.equations().jacobian(single_stage(stage()), values); };
  }
  std::vector<double> residual(const Stage& s) const {
    Array out("out", layout().size());
    scene.equations().residual(s, out);
    return to_host(out);
  }
  std::vector<double> product(const Array& z, Geometry geometry) const {
    Array out("out", layout().size()), copy = to_device<Array>(to_host(z));
    scene.equations().product(terms.patch.stage, copy, out, geometry);
    return to_host(out);
  }
  /// Rate of the energies while the solid moves with the velocities and these change with the accelerations of the
  /// stage; the other fields rest. @param e  step of the differences
  double rate_of_energy(double e) {
    const std::vector<double> velocity = to_host(stage().unknown), acceleration = to_host(stage().acceleration);
    const auto energy = [&](double time) {
      Stage moved = stage();
      moved.unknown = plus(moved.unknown, time, acceleration);
      moved.displacement = plus(moved.displacement, time, velocity);
      return scene.balance().measure(moved).integrals.energy();
    };
    return slope(energy, e);
  }
  /// Fourth-order central difference of the residual along z.
  std::vector<double> difference(const Array& z, double e) const {
    Array full = to_device<Array>(to_host(z));
    move_ghosts(layout(), full, GhostAction::update);
    const auto at = [&](double step) { return residual(terms.patch.moved(full, step)); };
    const std::vector<double> a = at(e), b = at(-e), c = at(2 * e), d = at(-2 * e);
    std::vector<double> r(a.size());
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * e);
    return r;
  }
};

using RandomScene = RandomSceneIn<2>;

inline void add(std::vector<double>& sum, const std::vector<double>& part) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
}

inline double contract(const std::vector<double>& a, const std::vector<double>& b, int first, int last) {
  double sum = 0;
  for (int i = first; i < last; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace softwet::testing_tools
