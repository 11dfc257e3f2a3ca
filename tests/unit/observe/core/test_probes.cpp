// Probes of a scene that is deformed by the same gradient everywhere, against integrals worked out by hand.
#include "observe/probes.hpp"

#include <gtest/gtest.h>

#include "observe/host/probe_quantity.hpp"
#include "unit/observe/core/homogeneous.hpp"

namespace softwet::testing_tools {
namespace {

using enum ProbeOperation;

constexpr double top_of_solid = 0.8 / 3;
const Matrix<double, 2> gradient{{{0.2, 0.05}, {0.1, -0.1}}};

Probe box(const std::string& quantity, ProbeOperation operation, std::vector<double> lower, std::vector<double> upper) {
  return {"probe", quantity, {}, std::move(lower), std::move(upper), operation};
}

Probe at(const std::string& quantity, std::vector<double> point) {
  return {"probe", quantity, std::move(point), {}, {}, value};
}

double read(Homogeneous& scene, const Probe& probe) {
  scene.data.probes = {probe};
  return evaluate_probes<2, 2>(scene.data, scene.model, scene.snapshot())[0];
}

TEST(Probes, ValueAtAPointOfTheSolid) {
  Homogeneous s(scene(Scene::coupled), gradient);
  EXPECT_NEAR(read(s, at("displacement_y", {0.37, 0.1})), 0.1 * 0.37 - 0.1 * 0.1, 1e-14);
  EXPECT_NEAR(read(s, at("green_lagrange_strain_xy", {0.37, 0.1})), 0.5 * (0.05 + 0.1 + 0.2 * 0.05 - 0.1 * 0.1), 1e-14);
  EXPECT_EQ(read(s, at("speed", {0.37, 0.1})), 0);
  EXPECT_NEAR(read(s, at("density", {0.37, 0.5})), Homogeneous::density, 1e-14);
}

// Of a box that cuts elements, in the undeformed solid.
TEST(Probes, IntegralMeanAndExtremesInTheSolid) {
  Homogeneous s(scene(Scene::coupled), gradient);
  const std::vector<double> low{0.13, 0.02}, high{0.71, 0.23};
  const double area = 0.58 * 0.21, mean_x = 0.42, mean_y = 0.125;
  EXPECT_NEAR(read(s, box("displacement_x", integral, low, high)), area * (0.2 * mean_x + 0.05 * mean_y), 1e-14);
  EXPECT_NEAR(read(s, box("displacement_x", mean, low, high)), 0.2 * mean_x + 0.05 * mean_y, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_x", max, low, high)), 0.2 * 0.71 + 0.05 * 0.23, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_x", min, low, high)), 0.2 * 0.13 + 0.05 * 0.02, 1e-14);
  EXPECT_NEAR(read(s, box("volume_ratio", mean, low, high)), 1.2 * 0.9 - 0.05 * 0.1, 1e-14);
}

// On a line the integral has its length, in the solid the undeformed one.
TEST(Probes, IntegralOnALine) {
  Homogeneous s(scene(Scene::coupled), gradient);
  EXPECT_NEAR(read(s, box("displacement_y", integral, {0.1, top_of_solid}, {0.6, top_of_solid})),
              0.5 * (0.1 * 0.35 - 0.1 * top_of_solid), 1e-14);
  const double length = 0.5 * std::hypot(1.2, 0.1);  // the wall turns and is stretched
  EXPECT_NEAR(read(s, box("density", integral, {0.1, top_of_solid}, {0.6, top_of_solid})),
              Homogeneous::density * length, 1e-13);
}

TEST(Probes, DensityOverAllOfTheFluidIsItsMass) {
  for (Coordinates coordinates : {Coordinates::plane, Coordinates::axisymmetric})
    for (Scene kind : {Scene::coupled, Scene::rigid}) {
      Case c = scene(kind);
      c.domain.coordinates = coordinates;
      Homogeneous s(c, {{{0.2, 0}, {0.1, -0.1}}});
      const double bottom = kind == Scene::rigid ? 0 : top_of_solid, mass = s.model.integrals(s.stage()).mass;
      EXPECT_NEAR(read(s, box("density", integral, {0, bottom}, {0.9, 0.8})), mass, 1e-12 * mass);
      EXPECT_NEAR(read(s, box("density", mean, {0, bottom}, {0.9, 0.8})), Homogeneous::density, 1e-13);
    }
}

// Around the axis a box of the undeformed solid is a ring.
TEST(Probes, RingInTheSolid) {
  Case c = scene(Scene::coupled);
  c.domain.coordinates = Coordinates::axisymmetric;
  Homogeneous s(c, {{{0.2, 0}, {0, 0}}});
  const double low = 0.1, high = 0.5, height = 0.2;
  const double expected = 2 * M_PI * height * 0.2 * (std::pow(high, 3) - std::pow(low, 3)) / 3;
  EXPECT_NEAR(read(s, box("displacement_x", integral, {low, 0.03}, {high, 0.23})), expected, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_x", mean, {0, 0.1}, {0, 0.1})), 0, 1e-14) << "a point on the axis";
  EXPECT_NEAR(read(s, at("volume_ratio", {0, 0.1})), 1.2 * 1.2, 1e-13) << "u_r / r is the slope at the axis";
}

TEST(Probes, TellWhetherTheyNeedTheVelocity) {
  Case c;
  c.probes = {at("pressure", {0, 0})};
  EXPECT_FALSE(probes_need_velocity(c));
  c.probes.push_back(at("speed", {0, 0}));
  EXPECT_TRUE(probes_need_velocity(c));
}

}  // namespace
}  // namespace softwet::testing_tools
