// Needles in any scene: force against the derivative of the energy, product against differences, energy law, matrix.
#pragma once

#include "scene/initial.hpp"
#include "unit/scene/formulas.hpp"
#include "unit/scene/rates.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {

constexpr double stiff = 40, soft = 3;

/// A needle that moves, and one that rests over a part of it and cuts elements.
inline Case with_needles(Case c) {
  const std::size_t axes = c.domain.size.size();
  Needle moving{c.loads[0].lower, c.loads[0].upper, stiff}, resting{moving.lower, moving.upper, soft};
  resting.lower[0] = 0.45;
  resting.upper[0] = 0.73;
  resting.upper[axes - 1] *= 1.3;
  for (std::size_t d = 0; d < axes; ++d) {
    const double speed = c.axisymmetric() && d == 0 ? 0 : 0.05 - 0.02 * static_cast<double>(d);
    moving.path.push_back(
        varying([speed](const std::array<double, 3>&, double t) { return speed * (t + 0.3 * t * t); }));
  }
  c.needles = {moving, resting};
  return c;
}

inline double volume(const Needle& needle, bool axisymmetric) {
  double v = 1;
  for (std::size_t d = 0; d < needle.lower.size(); ++d) v *= needle.upper[d] - needle.lower[d];
  return axisymmetric ? 0.5 * v * (needle.lower[0] + needle.upper[0]) : v;
}

/// Velocities of the unknowns where the solid is, as a vector of displacements.
template <int D>
std::vector<double> solid_part_of(const Layout<D>& l, const std::vector<double>& unknown) {
  std::vector<double> u(l.solid_size());
  const int nodes = l.solid_rows() * l.row_size;
  for (int d = 0; d < D; ++d)
    for (int i = 0; i < nodes; ++i) u[l.displacement_offset(d) + i] = unknown[l.velocity_offset(d) + i];
  return u;
}

template <int D>
std::vector<double> product_of(const Scene<D, 2>& scene, const Stage& stage, const Array& z) {
  Array out("out", scene.layout().size()), copy = to_device<Array>(to_host(z));
  scene.equations().product(stage, copy, out, Geometry::exact);
  return to_host(out);
}

template <int D>
void check_needles(const Case& plain) {
  RandomSceneIn<D> s(with_needles(plain));
  const Layout<D>& l = s.layout();
  const Scene<D, 2> without(plain);
  const std::vector<double> x = to_host(s.stage().unknown);
  std::vector<double> force = s.residual(s.stage());
  Array other("other", l.size());
  without.equations().residual(s.stage(), other);
  const std::vector<double> bare = to_host(other);
  for (std::size_t i = 0; i < force.size(); ++i) force[i] -= bare[i];

  const auto energy = [&](double of_solid, double of_time) {
    Stage moved = s.stage();
    moved.displacement = plus(moved.displacement, of_solid, solid_part_of(l, x));
    moved.time += of_time;
    return s.scene.balance().measure(moved).integrals["energy_needle"] / s.scene.regions().turn();
  };
  const std::vector<NeedleReading> readings = s.scene.balance().measure(s.stage()).needles;
  double power = 0, on_solid = 0;
  for (const NeedleReading& reading : readings) {
    power += reading.power / s.scene.regions().turn();
    on_solid += reading.power_on_solid / s.scene.regions().turn();
  }
  const double gained = slope([&](double e) { return energy(e, 0); }, 1e-3);
  EXPECT_GT(std::abs(gained), 1e-4);
  EXPECT_NEAR(contract(force, x, 0, l.velocity_size()), gained, 1e-9 * std::abs(gained));
  EXPECT_NEAR(-on_solid, gained, 1e-9 * std::abs(gained));
  EXPECT_GT(std::abs(power), 1e-4);
  EXPECT_NEAR(power, slope([&](double e) { return energy(0, e); }, 1e-3), 1e-6 * std::abs(power));

  const Array z = s.direction();
  EXPECT_LT(distance(s.product(z, Geometry::exact), s.difference(z, 1e-4)), 1e-9);
  EXPECT_GT(distance(s.product(z, Geometry::exact), product_of(without, s.stage(), z)), 1e-4);
}

/// The reading of an undeformed solid is the stiffness times the volume times the place, along each axis.
template <int D>
void check_reading(const Case& plain) {
  const Case c = with_needles(plain);
  const Scene<D, 2> scene(c);
  State state = empty_state(scene.layout());
  state.time = c.clock_zero() + 2;
  const NeedleReading reading = scene.balance().measure(stage_at(scene.layout(), state)).needles[0];
  double square = 0;
  for (int d = 0; d < D; ++d) {
    const double place = c.needles[0].place(d, 2);
    square += place * place;
    EXPECT_NEAR(reading.force[d], scene.regions().turn() * stiff * volume(c.needles[0], c.axisymmetric()) * place,
                1e-13);
  }
  EXPECT_NEAR(reading.energy, 0.5 * scene.regions().turn() * stiff * volume(c.needles[0], c.axisymmetric()) * square,
              1e-13);
}

/// The matrix of a scene with needles has the diagonal of the product more, and nothing else.
template <int D>
void check_matrix(const Case& plain) {
  RandomSceneIn<D> s(with_needles(plain));
  const Scene<D, 2> without(plain);
  const Stencil<D> stencil(s.layout());
  const StencilValues with("with", stencil.size()), bare("bare", stencil.size());
  const StageOf<float> stage = single_stage(s.stage());
  s.scene.equations().jacobian(stage, with);
  without.equations().jacobian(stage, bare);
  const auto a = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), with);
  const auto b = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), bare);
  const Array z = s.direction();
  const std::vector<double> of_all = s.product(z, Geometry::exact), of_bare = product_of(without, s.stage(), z);
  const std::vector<double> direction = to_host(z);
  double found = 0;
  for (int d = 0; d < D; ++d)
    for (int i = 0; i < stencil.points; ++i)
      for (int o = 0; o < stencil.offsets; ++o) {
        const auto at = stencil.index(d, d, o, i);
        const double more = static_cast<double>(a(at)) - b(at);
        if (stencil.neighbour(i, o) != i) {
          EXPECT_EQ(more, 0);
        } else {
          const int row = s.layout().velocity_offset(d) + i;
          EXPECT_NEAR(more * direction[row], of_all[row] - of_bare[row], 1e-4);
          found += std::abs(more);
        }
      }
  EXPECT_GT(found, 0.01);
}

}  // namespace softwet::testing_tools
