// Line friction and hysteresis: the force on a line that moves, what it dissipates, and the exact product.
#include "kernels/fluid/line_friction.hpp"

#include "scene/line_friction.hpp"
#include "spline/axis.hpp"
#include "unit/fluid/resisting.hpp"

namespace softwet::testing_tools {
namespace {

Fluid fluid_with(double line_friction, const std::vector<double>& range) {
  Fluid f;
  f.viscosity = 1.0 / 256;
  f.capillarity = 1.0 / 64;
  f.temperature = 0.39;
  f.wall_law = WallLaw::energy;
  f.line_friction = line_friction;
  f.contact_angle_range = range;
  f.creep_speed = 1e-3;
  f.contact_angle = range.empty() ? 60 : f.middle_of_range();
  return f;
}

EnergyWall wall_of(const Fluid& f) {
  const Coexistence state = coexistence(f.temperature);
  return {f.capillarity,
          std::cos(f.contact_angle.number * M_PI / 180),
          1e-5,
          {f.temperature, 0.2 * state.density_vapour},
          state};
}

/// Force along the wall on a line with the profile of the interface at rest that moves with a speed: the integral over
/// the density of what stands in the equation of the potential.
double force_on_line(const Fluid& f, double speed) {
  const EnergyWall wall = wall_of(f);
  const LineFriction term = line_friction_of(f, wall);
  const double sine = std::sin(f.contact_angle.number * M_PI / 180);
  const double low = wall.state.density_vapour, span = wall.state.density_liquid - low;
  const Gauss rule(12);
  const int panels = 200;
  double sum = 0;
  for (int p = 0; p < panels; ++p)
    for (int q = 0; q < 12; ++q) {
      const double rho = low + span * (p + rule.point[q]) / panels;
      const double slope = std::sqrt(2 * std::max(0.0, wall.state.excess(wall.gas, rho))) / f.capillarity;
      sum +=
          rule.weight[q] * span / panels * term.residual(WettingTrial<double, 2>{rho, speed * sine * slope}).potential;
    }
  return sum;
}

TEST(LineFriction, IsProportionalToTheSpeedOfTheLine) {
  const Fluid f = fluid_with(0.03, {});
  for (const double speed : {-0.2, 1e-4, 0.05}) EXPECT_NEAR(force_on_line(f, speed), -0.03 * speed, 1e-6 * 0.03);
}

// The smoothing 1e-5 of the root is a part of 3e-5 of the surface tension.
TEST(LineFriction, HysteresisHoldsALineByTheDifferenceOfTheCosines) {
  const Fluid f = fluid_with(0, {65, 85});
  const double sigma = surface_tension(f), half = 0.5 * (std::cos(65 * M_PI / 180) - std::cos(85 * M_PI / 180));
  EXPECT_NEAR(f.hysteresis(), half, 1e-15);
  EXPECT_NEAR(std::cos(f.contact_angle.number * M_PI / 180) + half, std::cos(65 * M_PI / 180), 1e-14);
  EXPECT_NEAR(force_on_line(f, 1e3), -sigma * half, 1e-4 * sigma * half);
  EXPECT_NEAR(force_on_line(f, -1e3), sigma * half, 1e-4 * sigma * half);
}

TEST(LineFriction, LinesCreepInProportionToALoadThatTheyHold) {
  const Fluid f = fluid_with(0, {65, 85});
  const double most = surface_tension(f) * f.hysteresis(), sine = std::sin(f.contact_angle.number * M_PI / 180);
  EXPECT_NEAR(force_on_line(f, 0.01 * f.creep_speed / sine) / most, -0.01, 1e-5);
}

TEST(LineFriction, Dissipates) {
  const Fluid f = fluid_with(0.02, {40, 120});
  const LineFriction term = line_friction_of(f, wall_of(f));
  for (const double rho : {-0.01, 0.0, 0.001, 0.3, 0.6, 0.87, 0.95}) {
    EXPECT_EQ(term.dissipation(WettingTrial<double, 2>{rho, 0}), 0);
    for (const double rate : {-3.0, -1e-5, 1e-9, 0.4, 1e6}) {
      const WettingTrial<double, 3> t{rho, rate};
      EXPECT_GT(term.dissipation(t), 0) << rho << " " << rate;
      EXPECT_EQ(term.dissipation(t), -rate * term.residual(t).potential);
      EXPECT_EQ(term.residual(WettingTrial<double, 3>{rho, -rate}).potential, -term.residual(t).potential);
    }
  }
}

TEST(LineFriction, TangentAgainstDifferences) {
  const Fluid f = fluid_with(0.02, {40, 120});
  LineFriction term = line_friction_of(f, wall_of(f));
  term.rest_rate = 0.3;
  for (const double rho : {0.05, 0.3, 0.6})
    for (const double rate : {-0.7, 0.0, 0.2}) {
      const auto at = [&](double e) {
        return term.residual(WettingTrial<double, 2>{rho + 0.4 * e, rate - 1.3 * e}).potential;
      };
      const double e = 1e-3, difference = (8 * (at(e) - at(-e)) - at(2 * e) + at(-2 * e)) / (12 * e);
      const Dual<double> exact =
          term.residual(WettingTrial<Dual<double>, 2>{Dual<double>(rho, 0.4), Dual<double>(rate, -1.3)}).potential;
      EXPECT_NEAR(exact.tangent, difference, 1e-8 * std::abs(difference));
    }
}

/// The slope of R by the rate in a product, R = F - K h, with the addition of LineFrictionBend.
double slope(const LineFriction& law, double rho, double rate, double unbalanced) {
  const Dual<double> of_law =
      law.residual(WettingTrial<Dual<double>, 2>{Dual<double>(rho, 0.0), Dual<double>(rate, 1.0)}).potential;
  const UnbalancedTrial<Dual<double>, 2> t{{Dual<double>(rho, 0.7), Dual<double>(rate, 1.0)},
                                           Dual<double>(unbalanced, -0.4)};
  return of_law.tangent + LineFrictionBend{law}.residual(t).potential.tangent;
}

TEST(LineFriction, ProductsHaveTheSlopeOfTheEquationWithoutABend) {
  Fluid f = fluid_with(0, {40, 120});
  const LineFriction law = line_friction_of(f, wall_of(f));
  const double r0 = law.rest_rate, rho = 0.3, most = law.barrier.force(rho);
  for (const double s : {-30.0, -1.0, -0.1, 0.2, 3.0, 100.0}) {
    const double root = std::sqrt(1 + s * s), h = s / root;
    EXPECT_NEAR(slope(law, rho, s * r0, 0), -most / (root * root * root) / r0, 1e-12 * most / r0) << "where R is 0";
    for (const double force : {-0.9, 0.0, 0.5, 0.99}) {  // F / K
      const double e = 1e-5, R = most * (force - h);
      const auto without_bend = [&](double q) { return (most * force * std::sqrt(1 + q * q) - most * q) / root; };
      const double smooth = (without_bend(s + e) - without_bend(s - e)) / (2 * e * r0);
      const double exact = -most / (root * root * root) / r0;
      EXPECT_NEAR(slope(law, rho, s * r0, R), std::min(smooth, exact), 1e-7 * most / r0) << s << " " << force;
    }
    for (const double force :
         {-50.0, 50.0}) {  // never flatter than the law, at most twice as steep as a line through 0
      const double found = slope(law, rho, s * r0, most * (force - h));
      EXPECT_LE(found, -most / (root * root * root) / r0 * (1 - 1e-9));
      EXPECT_GE(found, -2.0001 * most / root / r0);
    }
  }
}

TEST(LineFriction, OfScenes) {
  for (const SceneKind kind : {SceneKind::rigid, SceneKind::coupled}) {
    check_scene<2>(small_case(kind, WallLaw::energy));
    check_scene<2>(small_case(kind, WallLaw::energy, true));
    check_scene<2>(axisymmetric(small_case(kind, WallLaw::energy)));
  }
}

}  // namespace
}  // namespace softwet::testing_tools
