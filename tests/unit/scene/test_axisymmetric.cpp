// Scenes in the coordinates (r, z): residual against the reference assembly, product against differences, integrals and
// the energy law.
#include "unit/scene/formulas.hpp"
#include "unit/scene/rates.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// All optional properties of a solid, with a wall whose tension acts.
Case rich(SceneKind kind) {
  Case c = axisymmetric(small_case(kind, WallLaw::energy));
  if (c.substrate) {
    c.substrate->viscosity = 0.2;
    c.substrate->bulk_viscosity = 0.1;
    c.substrate->surface_tension = c.substrate->surface_tension_wet = 0.4;
    c.substrate->surface_modulus = {0.3, 0.2};
    c.boundary.side[1][0] = Side::free;
    c.parts.foundation.springs = {0.6, 0.3};
    c.parts.foundation.dashpots = {0.4, 0.7};
    c.substrate->gravity = {0, -0.8};
    c.substrate->fibre = {0.5, 30, 0};
  }
  if (c.fluid) c.fluid->gravity = {0, -0.8};
  if (c.fluid && c.substrate) c.fluid->wall_tension = WallTensionModel::acts;
  return c;
}

template <class Term>
std::vector<double> naive(const RandomScene& s, const Term& term, int first, int last, bool moves, int row = -1) {
  return s.terms.naive(Axisymmetric<Term>{term}, first, last, moves, row);
}

std::vector<double> naive_solid(RandomScene& s) {
  const Layout<2>& l = s.layout();
  const int wall = l.solid_elements;
  const Substrate& solid = *s.data.substrate;
  std::vector<double> sum =
      std::visit([&](const auto& term) { return naive(s, term, 0, wall, false); }, s.scene.coefficients().solid().law);
  if (solid.surface_tension > 0) add(sum, naive(s, SurfaceTension{solid.surface_tension}, wall - 1, wall, false));
  if (!solid.surface_modulus.empty())
    add(sum, naive(s, SurfaceElasticity{solid.surface_modulus[0], solid.surface_modulus[1]}, wall - 1, wall, false));
  if (const std::vector<double>& springs = s.data.parts.foundation.springs; !springs.empty())
    add(sum, naive(s, Foundation{springs[0], springs[1]}, 0, 1, false));
  if (const std::vector<double>& dashpots = s.data.parts.foundation.dashpots; !dashpots.empty())
    add(sum, naive(s, Dashpots{dashpots[0], dashpots[1]}, 0, 1, false));
  if (solid.viscosity > 0) add(sum, naive(s, KelvinVoigt{solid.viscosity, solid.bulk_viscosity}, 0, wall, false));
  if (solid.fibre.stiffness > 0) {
    const double angle = solid.fibre.angle * M_PI / 180;
    add(sum, naive(s, Fibres{solid.fibre.stiffness, {{std::cos(angle), std::sin(angle), 0}}}, 0, wall, false));
  }
  for_points<2>(l, 3, 0, wall, false, nullptr, [&](const NaivePoint<2>& p, double w) {
    double force = solid.gravity.empty() ? 0 : solid.gravity[1];
    for (const Load& load : s.data.loads)  // the box is cut along element borders, at half of its ramp
      if (p.x[0] > load.lower[0] && p.x[0] < load.upper[0] && p.x[1] < load.upper[1]) force += 0.5 * load.force[1];
    p.for_functions(-1,
                    [&](int i, double b) { sum[l.velocity_offset(1) + i] -= w * p.x[0] * solid.density * force * b; });
  });
  return sum;
}

std::vector<double> naive_fluid(RandomScene& s) {
  const Layout<2>& l = s.layout();
  const int low = l.solid_elements, high = l.axis[1].elements();
  const bool moves = l.has_solid;
  const NavierStokesKorteweg& fluid = s.scene.coefficients().fluid();
  std::vector<double> sum = naive(s, fluid, low, high, moves);
  add(sum, s.terms.naive_moments<Axisymmetric<DensityMoment>>(low, high, moves));
  if (s.data.fluid->wall_law == WallLaw::gradient) {
    add(sum, naive(s, GradientWall{fluid.capillarity, 0.5, 1e-2}, low, low + 1, moves));
  } else {
    add(sum, naive(s, s.scene.coefficients().wall().law(), low, low + 1, moves));
  }
  if (moves) add(sum, naive(s, CapillaryTraction{fluid.gas, fluid.capillarity}, low, low + 1, true, l.wall_row));
  return sum;
}

/// @param all  all terms of the scene have their reference here; the reference of the wall's tension depends on a field
///   of the test
void check_axial_scene(const Case& c, bool all = true) {
  RandomScene s(c);
  std::vector<double> expected(s.layout().size(), 0.0);
  if (c.substrate) add(expected, naive_solid(s));
  if (c.fluid) add(expected, naive_fluid(s));
  const std::vector<double> mask = to_host(s.scene.mask());
  for (std::size_t i = 0; i < mask.size(); ++i) expected[i] *= mask[i];
  if (all) {
    EXPECT_LT(distance(s.residual(s.stage()), expected), 1e-13);
  }
  const Array z = s.direction();
  const double error = distance(s.product(z, Geometry::exact), s.difference(z, 1e-4));
  std::printf("  product against differences: %.1e\n", error);
  EXPECT_LT(error, 1e-9);
  if (c.fluid && c.substrate) {
    EXPECT_GT(distance(s.product(z, Geometry::frozen), s.difference(z, 1e-4)), 1e-4);
  }
  const Array free("free", s.layout().size()), y("y", s.layout().size());
  Kokkos::deep_copy(free, 1.0);
  StencilMatrix<2> matrix(s.layout(), free);
  matrix.fill(s.jacobian());
  matrix.multiply(z, y);
  multiply(y, s.scene.mask());
  EXPECT_LT(distance(to_host(y), s.product(z, Geometry::frozen)), 1e-5);
}

TEST(Axisymmetric, Rigid) { check_axial_scene(axisymmetric(small_case(SceneKind::rigid))); }
TEST(Axisymmetric, RigidWithWallEnergyAndGravity) {
  check_axial_scene(axisymmetric(small_case(SceneKind::rigid, WallLaw::energy)));
  check_axial_scene(rich(SceneKind::rigid));
}
TEST(Axisymmetric, Coupled) { check_axial_scene(axisymmetric(small_case(SceneKind::coupled))); }
TEST(Axisymmetric, CoupledWithNeoHookeanSolid) {
  Case c = axisymmetric(small_case(SceneKind::coupled, WallLaw::energy));
  c.substrate->material = MaterialModel::neo_hookean;
  check_axial_scene(c);
}
TEST(Axisymmetric, RichSolid) { check_axial_scene(rich(SceneKind::solid)); }
TEST(Axisymmetric, CoupledWithAllThatAWallCanHave) { check_axial_scene(rich(SceneKind::coupled), false); }
TEST(Axisymmetric, CoupledWithBlendedTraction) {
  Case c = rich(SceneKind::coupled);
  c.fluid->traction = Traction::blended;
  c.fluid->contact_angle = varying([](const std::array<double, 3>& x, double) { return 80 + 30 * x[0]; });
  c.substrate->young = varying([](const std::array<double, 3>& x, double) { return 2 + x[0] - x[1]; });
  check_axial_scene(c, false);
}

// The flux part of the mass equation only moves mass about.
TEST(Axisymmetric, FluxesOfMassSumToZero) {
  for (SceneKind kind : {SceneKind::coupled, SceneKind::rigid}) {
    RandomScene s(axisymmetric(small_case(kind)));
    s.stage().moment_rate = 0;
    const std::vector<double> r = s.residual(s.stage());
    double sum = 0, size = 0;
    for (int i = s.layout().density_offset(); i < s.layout().potential_offset(); ++i) {
      sum += r[i];
      size += std::abs(r[i]);
    }
    EXPECT_GT(size, 1e-3);
    EXPECT_LT(std::abs(sum), 1e-14 * size);
  }
}

// Testing momentum with v gives the rate of the energies less the power of the load and the dissipation; integrals of
// the scene are over a whole turn, integrals of the residual over a radian.
TEST(Axisymmetric, EnergyLawOfARichSolid) {
  for (const MaterialModel material : {MaterialModel::saint_venant_kirchhoff, MaterialModel::neo_hookean}) {
    Case c = rich(SceneKind::solid);
    c.substrate->material = material;
    RandomScene s(c);
    const Layout<2>& l = s.layout();
    const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
    const Integrals now = s.scene.balance().measure(s.stage()).integrals;
    EXPECT_GT(std::abs(now["energy_surface"]), 1e-6);
    EXPECT_GT(now["energy_foundation"], 1e-6);
    EXPECT_GT(now["dissipation_solid"], 1e-3);
    const double power = s.scene.balance().measure(s.stage()).load_power;
    EXPECT_GT(std::abs(power), 1e-6);
    const double expected = s.rate_of_energy(1e-3) - power + now.dissipation();
    EXPECT_NEAR(2 * M_PI * contract(r, x, 0, l.size()), expected, 1e-9 * std::abs(expected)) << word_of(material);
  }
}

TEST(Axisymmetric, WhatAWallGainsByStretchIsWhatItsTensionCosts) {
  Case c = rich(SceneKind::coupled);
  RandomScene acts(c);
  c.fluid->wall_tension = WallTensionModel::none;
  RandomScene none(c);
  const std::vector<double> x = to_host(none.stage().unknown), before = none.residual(none.stage()),
                            after = acts.residual(acts.stage());
  const double stretch = none.scene.balance().measure(none.stage()).integrals["wall_stretch"];
  EXPECT_GT(std::abs(stretch), 1e-4);
  double work = 0;
  for (int i = 0; i < none.layout().velocity_size(); ++i) work += x[i] * (after[i] - before[i]);
  EXPECT_NEAR(2 * M_PI * work, stretch, 1e-11);
  EXPECT_EQ(acts.scene.balance().measure(acts.stage()).integrals["wall_stretch"], 0);
}

// On a rigid wall momentum tested with v, mass with mu and potential with the rate of the density: see test_energy.cpp.
TEST(Axisymmetric, EnergyLawOnARigidWall) {
  RandomScene s(rich(SceneKind::rigid));
  const Layout<2>& l = s.layout();
  s.stage().moment_rate = 1;
  const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
  const std::vector<double> rate = to_host(s.stage().density_end), acceleration = to_host(s.stage().acceleration);
  double contraction = contract(r, x, 0, l.velocity_size());
  for (int i = 0; i < l.scalar_size(); ++i) {
    const double height = -0.8 * l.axis[1].greville(i / l.row_size);
    contraction += r[l.density_offset() + i] * (x[l.potential_offset() + i] - height);
    contraction -= r[l.potential_offset() + i] * rate[i];
  }
  const auto kinetic = [&](double e) {
    Stage moved = s.stage();
    moved.unknown = plus(moved.unknown, e, acceleration);
    return s.scene.balance().measure(moved).integrals["energy_kinetic"];
  };
  std::vector<double> density_rate(l.size(), 0.0);
  std::copy(rate.begin(), rate.end(), density_rate.begin() + l.density_offset());
  const auto free = [&](double e) {
    Stage moved = s.stage();
    moved.unknown = plus(moved.unknown, e, density_rate);
    const Integrals i = s.scene.balance().measure(moved).integrals;
    return i["energy_free_bulk"] + i["energy_free_gradient"] + i["energy_wall"] + i["energy_gravity"];
  };
  double convection = 0;
  const std::vector<Grid> field{s.terms.unknown(0), s.terms.unknown(1), s.terms.unknown(2)};
  for_points<2>(l, 3, 0, 6, false, nullptr, [&](const NaivePoint<2>& p, double w) {
    const double v[2] = {p.evaluate(field[0], -1), p.evaluate(field[1], -1)};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        convection += w * p.x[0] * p.evaluate(field[2], -1) * v[i] * v[j] * p.evaluate(field[i], j);
  });
  const Integrals now = s.scene.balance().measure(s.stage()).integrals;
  const double expected = slope(kinetic, 1e-3) + slope(free, 2e-4) + now["dissipation_viscous"] +
                          now["dissipation_stabilisation"] + 2 * M_PI * convection;
  EXPECT_NEAR(2 * M_PI * contraction, expected, 1e-9 * std::abs(expected));
}

// A uniform fluid above a solid that is stretched to a wider cylinder: everything is a volume or an area in closed
// form.
TEST(Axisymmetric, IntegralsOfAStretchedCylinder) {
  RandomScene s(axisymmetric(small_case(SceneKind::coupled, WallLaw::energy)));
  const Layout<2>& l = s.layout();
  std::vector<double> x(l.size(), 0.0), u(l.solid_size(), 0.0);
  const double rho = 0.5, v = 0.3, stretch = 0.1;
  for (int i = 0; i < l.scalar_size(); ++i) x[l.density_offset() + i] = rho;
  for (int i = 0; i < l.rows * l.row_size; ++i) x[l.velocity_offset(1) + i] = v;
  for (int i = 0; i < l.solid_rows() * l.row_size; ++i)
    u[l.displacement_offset(0) + i] = stretch * l.axis[0].greville(i % l.row_size);
  s.stage().unknown = to_device<Array>(x);
  s.stage().displacement = s.stage().displacement_end = to_device<Array>(u);
  const Integrals i = s.scene.balance().measure(s.stage()).integrals;
  // The radius is 0.9 (1 + 0.1 b), b from 1 at the wall to 0 at the top.
  const double height = 0.8 - s.scene.regions().wall_height(), area = M_PI * 0.81;
  const double fluid = area * height * (1 + stretch + stretch * stretch / 3);
  EXPECT_NEAR(i["mass"], rho * fluid, 1e-13);
  EXPECT_NEAR(i["energy_free_bulk"], s.scene.coefficients().fluid().gas.energy(rho) * fluid, 1e-13);
  EXPECT_NEAR(i["energy_wall"], WallEnergy::of(s.scene.coefficients().wall().law()).value(rho) * area * 1.21, 1e-13);
  const double solid = 1.3 * area * s.scene.regions().wall_height();
  EXPECT_NEAR(i["energy_kinetic"], 0.5 * v * v * (rho * fluid + solid), 1e-13);
  EXPECT_NEAR(i["momentum_y"], v * (rho * fluid + solid), 1e-13);
  EXPECT_EQ(i["momentum_x"], 0);
  const double e = 0.5 * (1.21 - 1);  // along r and about the axis
  const LameParameters& m = s.scene.coefficients().solid().stiffness;
  EXPECT_NEAR(i["energy_elastic"],
              area * s.scene.regions().wall_height() * (0.5 * m.lambda * 4 * e * e + m.shear_modulus * 2 * e * e),
              1e-13);
  const Filling filling = s.scene.balance().filling(s.stage());
  EXPECT_NEAR(2 * M_PI * filling.volume, fluid, 1e-13);
  EXPECT_NEAR(2 * M_PI * filling.mass, i["mass"], 1e-13);
}

}  // namespace
}  // namespace softwet::testing_tools
