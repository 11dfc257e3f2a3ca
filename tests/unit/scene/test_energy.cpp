// Energies: what the integrals are, and the energy law hidden in the residual.
#include "unit/observe/core/homogeneous.hpp"
#include "unit/scene/formulas.hpp"
#include "unit/scene/rates.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

// Testing momentum with v, mass with mu - f . x (f: gravity) and potential with rho_t on a fixed mesh leaves
//   d/dt (kinetic + bulk + gradient + wall energy + energy in gravity) + dissipation = - convection,
// the last being (v, rho (v . grad) v), which the exact rho_t |v|^2/2 of the kinetic energy balances.
void expect_energy_law_on_a_rigid_wall(const Profile& angle) {
  Case c = small_case(SceneKind::rigid, WallLaw::energy);
  c.fluid->gravity = {0.3, -0.8};
  c.fluid->contact_angle = angle;
  RandomScene s(c);
  const Layout<2>& l = s.layout();
  s.stage().moment_rate = 1;  // density_end is then the rate of the density
  const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
  const std::vector<double> rate = to_host(s.stage().density_end), acceleration = to_host(s.stage().acceleration);
  double contraction = contract(r, x, 0, l.velocity_size());
  for (int i = 0; i < l.scalar_size(); ++i) {
    const double height = 0.3 * l.axis[0].greville(i % l.row_size) - 0.8 * l.axis[1].greville(i / l.row_size);
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
      for (int j = 0; j < 2; ++j) convection += w * p.evaluate(field[2], -1) * v[i] * v[j] * p.evaluate(field[i], j);
  });
  const Integrals now = s.scene.balance().measure(s.stage()).integrals;
  EXPECT_GT(std::abs(now["energy_gravity"]), 1e-3);
  EXPECT_GT(now["dissipation_viscous"], 0);
  EXPECT_GT(now["dissipation_stabilisation"], 0);
  const double expected = slope(kinetic, 1e-3) + slope(free, 2e-4) + now["dissipation_viscous"] +
                          now["dissipation_stabilisation"] + convection;
  std::printf("  contraction %.12g, energies %.12g\n", contraction, expected);
  EXPECT_NEAR(contraction, expected, 1e-9 * std::abs(expected));
  EXPECT_GT(std::abs(slope(
                [&](double e) {
                  Stage moved = s.stage();
                  moved.unknown = plus(moved.unknown, e, density_rate);
                  return s.scene.balance().measure(moved).integrals["energy_wall"];
                },
                2e-4)),
            1e-4)
      << "the wall energy takes part";
}

TEST(EnergyLaw, OnAFixedMeshWithWallEnergy) { expect_energy_law_on_a_rigid_wall(60); }
TEST(EnergyLaw, OnAFixedMeshWithAPaintedWall) {
  expect_energy_law_on_a_rigid_wall(varying([](const std::array<double, 3>& x, double) { return 60 + 70 * x[0]; }));
}

// Solid: testing with v gives the rate of kinetic and elastic energy less the power of the load.
TEST(EnergyLaw, OfTheSolid) {
  RandomScene s(small_case(SceneKind::solid));
  const Layout<2>& l = s.layout();
  const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
  const double power = s.scene.balance().measure(s.stage()).load_power;
  EXPECT_GT(std::abs(power), 1e-6);
  const double expected = s.rate_of_energy(1e-3) - power;
  EXPECT_NEAR(contract(r, x, 0, l.size()), expected, 1e-9 * std::abs(expected));
}

/// All optional properties of a solid.
Case rich_solid(SceneKind kind) {
  Case c = small_case(kind, WallLaw::energy);
  c.substrate->viscosity = 0.2;
  c.substrate->bulk_viscosity = 0.1;
  c.substrate->surface_tension = c.substrate->surface_tension_wet = 0.4;
  c.substrate->surface_modulus = {0.3, 0.2};
  c.boundary.side[1][0] = Side::free;
  c.parts.foundation.springs = {0.6, 0.3};
  c.parts.foundation.dashpots = {0.4, 0.7};
  c.substrate->gravity = {0.3, -0.8};
  c.substrate->fibre = {0.5, 30, 0};
  return c;
}

// The energy law of a solid with fibres, viscosity, gravity and the surface tension of its face.
TEST(EnergyLaw, OfARichSolid) {
  for (bool small : {false, true}) {
    Case c = rich_solid(SceneKind::solid);
    if (small) c.substrate->strain = Strain::small;
    if (!small) c.substrate->young = varying([](const std::array<double, 3>& x, double) { return 2 + x[0] - x[1]; });
    RandomScene s(c);
    const Layout<2>& l = s.layout();
    const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
    const Integrals now = s.scene.balance().measure(s.stage()).integrals;
    EXPECT_GT(std::abs(now["energy_gravity"]), 1e-6);
    EXPECT_GT(std::abs(now["energy_surface"]), 1e-6);
    EXPECT_GT(now["energy_foundation"], 1e-6);
    EXPECT_GT(now["dissipation_solid"], 1e-3);
    const double power = s.scene.balance().measure(s.stage()).load_power;
    const double expected = s.rate_of_energy(1e-3) - power + now.dissipation();
    EXPECT_NEAR(contract(r, x, 0, l.size()), expected, 1e-9 * std::abs(expected));
  }
}

// The energy law of solids that are stretched before: their energy counts from where nothing is displaced.
TEST(EnergyLaw, OfAStretchedSolid) {
  for (const MaterialModel material : {MaterialModel::neo_hookean, MaterialModel::saint_venant_kirchhoff})
    for (const bool around : {false, true}) {
      Case c = small_case(SceneKind::solid);
      c.substrate->prestretch = {1.15};
      c.substrate->material = material;
      if (!around) c.substrate->fibre = {0.5, 0, 0};
      RandomScene s(around ? axisymmetric(c) : c);
      const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
      const double power = s.scene.balance().measure(s.stage()).load_power;
      const double expected = s.rate_of_energy(2e-4) - power;
      EXPECT_NEAR(s.scene.regions().turn() * contract(r, x, 0, s.layout().size()), expected, 1e-9 * std::abs(expected))
          << word_of(material);
      Stage still = s.stage();
      still.displacement = Array("still", still.displacement.extent(0));
      EXPECT_NEAR(s.scene.balance().measure(still).integrals["energy_elastic"], 0, 1e-15) << word_of(material);
    }
}

// What the wall energy gains by the stretch of the wall is what the tension of the wall costs the solid.
TEST(EnergyLaw, OfTheTensionOfTheWall) {
  Case c = rich_solid(SceneKind::coupled);
  RandomScene none(c);
  c.fluid->wall_tension = WallTensionModel::acts;
  RandomScene acts(c);
  const std::vector<double> x = to_host(none.stage().unknown), before = none.residual(none.stage()),
                            after = acts.residual(acts.stage());
  const double stretch = none.scene.balance().measure(none.stage()).integrals["wall_stretch"];
  EXPECT_GT(std::abs(stretch), 1e-4);
  double work = 0;
  for (int i = 0; i < none.layout().velocity_size(); ++i) work += x[i] * (after[i] - before[i]);
  EXPECT_NEAR(work, stretch, 1e-12);
  EXPECT_EQ(acts.scene.balance().measure(acts.stage()).integrals["wall_stretch"], 0);
}

// A tension below liquid that is given by hand: on a face of uniform density it is a surface tension of its own.
TEST(WallTension, ByHandIsSurfaceTensionWhereAllIsWet) {
  Case c = small_case(SceneKind::coupled, WallLaw::energy);
  c.substrate->surface_tension = 0.3;
  c.substrate->surface_tension_wet = 0.45;
  RandomScene by_hand(c);
  c.substrate->surface_tension = c.substrate->surface_tension_wet;
  RandomScene uniform(c);
  std::vector<double> x = to_host(by_hand.stage().unknown);
  const Layout<2>& l = by_hand.layout();
  for (int i = 0; i < l.scalar_size(); ++i)
    x[l.density_offset() + i] = by_hand.scene.coefficients().coexistence().density_liquid;
  by_hand.stage().unknown = uniform.stage().unknown = to_device<Array>(x);
  const std::vector<double> a = by_hand.residual(by_hand.stage()), b = uniform.residual(uniform.stage());
  EXPECT_LT(distance(a, b), 1e-12);
}

// Uniform density on a moved mesh: everything is an area or a length, known in closed form.
TEST(Integrals, UniformFluidOnAMovedMesh) {
  RandomScene s(small_case(SceneKind::coupled, WallLaw::energy));
  const Layout<2>& l = s.layout();
  std::vector<double> x(l.size(), 0.0), u(l.solid_size(), 0.0);
  const double rho = 0.5, v = 0.3, rise = 0.04, stretch = 0.1;
  for (int i = 0; i < l.scalar_size(); ++i) x[l.density_offset() + i] = rho;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.row_size; ++i) x[l.velocity_offset(0) + j * l.row_size + i] = v;
  for (int j = 0; j < l.solid_rows(); ++j)
    for (int i = 0; i < l.row_size; ++i) {
      u[l.displacement_offset(0) + j * l.row_size + i] = stretch * l.axis[0].greville(i);
      u[l.displacement_offset(1) + j * l.row_size + i] = rise * l.axis[1].greville(j) / s.scene.regions().wall_height();
    }
  s.stage().unknown = to_device<Array>(x);
  s.stage().displacement = s.stage().displacement_end = to_device<Array>(u);
  const Integrals i = s.scene.balance().measure(s.stage()).integrals;
  // The wall is stretched by 1.1 and lifted by 0.04, the top stays: J = (1 + 0.1 b)(1 - 0.04/H), b from 1 to 0.
  const double height = 0.8 - s.scene.regions().wall_height(), fluid = 0.9 * (1 + stretch / 2) * (height - rise);
  EXPECT_NEAR(i["mass"], rho * fluid, 1e-14);
  EXPECT_NEAR(i["energy_free_bulk"], s.scene.coefficients().fluid().gas.energy(rho) * fluid, 1e-14);
  EXPECT_NEAR(i["energy_free_gradient"], 0, 1e-25);
  EXPECT_NEAR(i["energy_wall"], WallEnergy::of(s.scene.coefficients().wall().law()).value(rho) * 0.9 * (1 + stretch),
              1e-14);
  const double solid = 1.3 * 0.9 * s.scene.regions().wall_height();
  EXPECT_NEAR(i["energy_kinetic"], 0.5 * v * v * (rho * fluid + solid), 1e-14);
  EXPECT_NEAR(i["momentum_x"], v * (rho * fluid + solid), 1e-14);
  EXPECT_NEAR(i["momentum_y"], 0, 1e-16);
  const double exx = 0.5 * (1.1 * 1.1 - 1), k = 1 + rise / s.scene.regions().wall_height(), eyy = 0.5 * (k * k - 1);
  const LameParameters& m = s.scene.coefficients().solid().stiffness;
  EXPECT_NEAR(i["energy_elastic"],
              0.9 * s.scene.regions().wall_height() *
                  (0.5 * m.lambda * (exx + eyy) * (exx + eyy) + m.shear_modulus * (exx * exx + eyy * eyy)),
              1e-14);
}

// A uniform fluid on a moved mesh: the energy is - rho f . (integral of x), known for a stretched rectangle.
TEST(Integrals, GravityOnAMovedMesh) {
  Case c = small_case(SceneKind::coupled);
  c.fluid->gravity = {0.3, -0.8};
  RandomScene s(c);
  const Layout<2>& l = s.layout();
  std::vector<double> x(l.size(), 0.0), u(l.solid_size(), 0.0);
  const double rho = 0.5, rise = 0.04;
  for (int i = 0; i < l.scalar_size(); ++i) x[l.density_offset() + i] = rho;
  for (int j = 0; j < l.solid_rows(); ++j)
    for (int i = 0; i < l.row_size; ++i)
      u[l.displacement_offset(1) + j * l.row_size + i] = rise * l.axis[1].greville(j) / s.scene.regions().wall_height();
  s.stage().unknown = to_device<Array>(x);
  s.stage().displacement = s.stage().displacement_end = to_device<Array>(u);
  const double low = s.scene.regions().wall_height() + rise, area = 0.9 * (0.8 - low);
  EXPECT_NEAR(s.scene.balance().measure(s.stage()).integrals["energy_gravity"],
              -rho * area * (0.3 * 0.45 - 0.8 * 0.5 * (low + 0.8)), 1e-14);
}

/// Liquid volume of a fluid of one density above a wall that widens by a fifth and sinks by a tenth of its height: the
/// mesh follows it by a share that falls from 1 at the wall to 0 at the top, so that the width is 0.9 (1 + 0.2 share)
/// and each height is stretched by 1.05.
TEST(LiquidVolume, OverTheMovedFluid) {
  for (const double part : {-0.1, 0.25, 0.5, 1.1})
    for (const Coordinates coordinates : {Coordinates::plane, Coordinates::axisymmetric}) {
      Case c = small_case(SceneKind::coupled);
      c.domain.coordinates = coordinates;
      Homogeneous s(c, {{{0.2, 0}, {0, -0.1}}});
      const double vapour = s.scene.coefficients().coexistence().density_vapour,
                   liquid = s.scene.coefficients().coexistence().density_liquid;
      s.fill(vapour + part * (liquid - vapour));
      const double share = part < 0 ? 0 : part > 1 ? 1 : part == 0.5 ? 0.5 : 0.15625;
      const double height = 0.8 * 2 / 3 * 1.05;
      const double plane = 0.9 * 1.1 * height, round = M_PI * 0.9 * 0.9 * (1.2 * 1.2 * 1.2 - 1) / 0.6 * height;
      EXPECT_NEAR(s.scene.balance().measure(s.stage()).integrals["liquid_volume"],
                  share * (coordinates == Coordinates::plane ? plane : round), 1e-12)
          << part;
    }
  Homogeneous solid(small_case(SceneKind::solid), {});
  EXPECT_EQ(solid.scene.balance().measure(solid.stage()).integrals["liquid_volume"], 0);
}

}  // namespace
}  // namespace softwet::testing_tools
