// What is foretold against what was measured: docs/verification/extremes.md, locking.md, and runs of single droplets.
#include "model/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/equilibrium.hpp"

namespace softwet {
namespace {

/// A droplet of so many capillarities (1/32) on a rigid wall, two elements for a capillarity.
Case forecast_droplet(double temperature, double angle, double capillarities, double length = 1) {
  Case c;
  c.domain = {{length, length / 2}, {static_cast<int>(64 * length), static_cast<int>(32 * length)}, 2};
  c.fluid.emplace();
  c.fluid->viscosity = 1.0 / 256;
  c.fluid->capillarity = 1.0 / 32;
  c.fluid->temperature = temperature;
  c.fluid->contact_angle = angle;
  c.droplets = {{{length / 2, 0}, capillarities / 32}};
  return c;
}

Case soft(double young) {
  Case c = forecast_droplet(0.39, 75, 5);
  c.substrate = Substrate{0.125, 1, young, 0.45};
  c.droplets[0].centre[1] = 0.125;
  return c;
}

bool tells(const Case& c, const std::string& part) {
  for (const std::string& sentence : forecast(c))
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

TEST(Forecast, DropletsThatDissolvedAndDropletsThatStayed) {
  const auto dissolves = [](const Case& c) { return tells(c, "dissolves"); };
  EXPECT_TRUE(dissolves(forecast_droplet(0.39, 75, 1.5)));
  EXPECT_FALSE(dissolves(forecast_droplet(0.39, 75, 2)));
  EXPECT_TRUE(dissolves(forecast_droplet(0.39, 75, 0.03 * 32))) << "radius 0.03 at 1/32";
  EXPECT_TRUE(dissolves(forecast_droplet(0.39, 120, 1.5)));
  EXPECT_FALSE(dissolves(forecast_droplet(0.39, 120, 2)));
  EXPECT_TRUE(dissolves(forecast_droplet(0.7, 75, 3)));
  EXPECT_FALSE(dissolves(forecast_droplet(0.7, 75, 3.5)));
  EXPECT_TRUE(dissolves(forecast_droplet(0.85, 75, 4.25)));
  EXPECT_FALSE(dissolves(forecast_droplet(0.85, 75, 4.5)));
  EXPECT_TRUE(dissolves(forecast_droplet(0.85, 75, 6, 2)));
  EXPECT_FALSE(dissolves(forecast_droplet(0.85, 75, 7, 2)));
}

TEST(Forecast, BubblesDissolveToo) {
  Case c = forecast_droplet(0.7, 90, 3);
  c.fluid->ambient = Phase::liquid;
  c.droplets[0].centre[1] = 0.25;
  EXPECT_TRUE(tells(c, "dissolves"));
  c.droplets[0].radius = 4.0 / 32;
  EXPECT_FALSE(tells(c, "dissolves"));
}

/// 2D, free droplet, by hand: R_c^3 = sigma V / (W'' jump^2 2 pi) with W'' = c_v^2 / rho_v.
TEST(Forecast, LeastRadiusByHand) {
  Case c = forecast_droplet(0.85, 90, 5, 2);
  c.droplets[0].centre[1] = 0.5;
  const double curvature = 0.3199521076 * 0.3199521076 / 0.1065766548, jump = 0.6023801091 - 0.1065766548;
  const double sharp = std::cbrt(0.03356246858 / 32 * 2 / (curvature * jump * jump * 2 * M_PI));
  EXPECT_NEAR(least_radius(c, c.droplets[0]), sharp + 0.5 * interface_half_width(*c.fluid), 1e-8);
  c.domain.size = {2, 1e-3};  // next to no vapour to feed
  EXPECT_NEAR(least_radius(c, c.droplets[0]), 1.75 * interface_half_width(*c.fluid), 1e-12);
}

/// docs/limits.md: droplets of five, ten and twenty capillarities.
TEST(Forecast, SolidTooSoftForItsDroplet) {
  const auto stops = [](double radius, double capillarity, double length_over_capillarity) {
    Case c = soft(0.2532027 / length_over_capillarity);  // sigma = 0.2532 capillarity
    c.fluid->capillarity = capillarity;
    c.droplets[0].radius = radius;
    return tells(c, "inside out");
  };
  EXPECT_FALSE(stops(0.155, 1.0 / 32, 0.8));
  EXPECT_TRUE(stops(0.155, 1.0 / 32, 0.9));
  EXPECT_FALSE(stops(0.1, 1.0 / 32, 0.7));
  EXPECT_FALSE(stops(0.155, 1.0 / 48, 1.05));
  EXPECT_FALSE(stops(0.155, 1.0 / 64, 1.6));
  EXPECT_TRUE(stops(0.155, 1.0 / 64, 2.4));
  EXPECT_FALSE(stops(0.155, 1.0 / 512, 2.53)) << "fig1b_soft_droplet_2d";
  EXPECT_TRUE(forecast(soft(0.7554)).empty());
  Case heavy = soft(0.1);
  EXPECT_TRUE(tells(heavy, "inside out"));
  heavy.substrate->density = 8;
  EXPECT_FALSE(tells(heavy, "inside out"));
  EXPECT_TRUE(tells(heavy, "the Young modulus is 0.8 a b^2"));
}

/// Rows and degrees of docs/verification/locking.md, in percent.
TEST(Forecast, LockingAsMeasured) {
  const struct {
    double poisson;
    int rows;
    double measured;
  } table[] = {{0.45, 2, 0.937},   {0.49, 2, 1.845}, {0.499, 2, 4.662},
               {0.4999, 2, 9.327}, {0.45, 4, 0.235}, {0.499, 8, 0.226}};
  for (const auto& row : table) {
    Case c;
    c.domain = {{1, 0.125}, {8 * row.rows, row.rows}, 2};
    c.substrate = Substrate{0.125, 1, 1, row.poisson};
    EXPECT_NEAR(100 * locking_error(c), row.measured, 0.2 * row.measured) << row.poisson;
    EXPECT_EQ(tells(c, "domain.degree = 2"), row.measured > 1) << row.poisson << " " << row.rows;
    c.domain.degree = 3;
    EXPECT_EQ(locking_error(c), 0);
  }
}

TEST(Forecast, AFluidAlone) {
  Case c = forecast_droplet(0.39, 75, 5);
  c.droplets.clear();
  EXPECT_TRUE(tells(c, "the fluid holds vapour alone"));
  c.films.push_back({{0, 0}, {1, 0.2}});
  EXPECT_TRUE(forecast(c).empty());
}

// The pull on 32 x 16 elements took 194 steps with 1e-5 and less, 320 with 1e-4 and 1210 with 1e-3.
TEST(Forecast, ToleranceOfNewtonThatCostsSteps) {
  Case c = forecast_droplet(0.39, 75, 5);
  EXPECT_FALSE(tells(c, "solver.newton.atol"));
  c.solver.newton_atol = 1e-5;
  EXPECT_FALSE(tells(c, "solver.newton.atol"));
  c.solver.newton_atol = 1e-4;
  EXPECT_TRUE(tells(c, "solver.newton.atol = 0.0001"));
  c.time.scheme = "ssp_rk3";
  EXPECT_FALSE(tells(c, "solver.newton.atol"));
}

}  // namespace
}  // namespace softwet
