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

double read(Homogeneous& run, const Probe& probe) {
  run.data.probes = {probe};
  return evaluate_probes(run.data, run.scene.regions(), run.scene.coefficients(), run.snapshot())[0];
}

TEST(Probes, ValueAtAPointOfTheSolid) {
  Homogeneous s(small_case(SceneKind::coupled), gradient);
  EXPECT_NEAR(read(s, at("displacement_y", {0.37, 0.1})), 0.1 * 0.37 - 0.1 * 0.1, 1e-14);
  EXPECT_NEAR(read(s, at("green_lagrange_strain_xy", {0.37, 0.1})), 0.5 * (0.05 + 0.1 + 0.2 * 0.05 - 0.1 * 0.1), 1e-14);
  EXPECT_EQ(read(s, at("speed", {0.37, 0.1})), 0);
  EXPECT_NEAR(read(s, at("density", {0.37, 0.5})), Homogeneous::density, 1e-14);
}

// A box that cuts elements, in the undeformed solid.
TEST(Probes, IntegralMeanAndExtremesInTheSolid) {
  Homogeneous s(small_case(SceneKind::coupled), gradient);
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
  Homogeneous s(small_case(SceneKind::coupled), gradient);
  EXPECT_NEAR(read(s, box("displacement_y", integral, {0.1, top_of_solid}, {0.6, top_of_solid})),
              0.5 * (0.1 * 0.35 - 0.1 * top_of_solid), 1e-14);
  const double length = 0.5 * std::hypot(1.2, 0.1);  // the wall turns and is stretched
  EXPECT_NEAR(read(s, box("density", integral, {0.1, top_of_solid}, {0.6, top_of_solid})),
              Homogeneous::density * length, 1e-13);
}

TEST(Probes, DensityOverAllOfTheFluidIsItsMass) {
  for (Coordinates coordinates : {Coordinates::plane, Coordinates::axisymmetric})
    for (SceneKind kind : {SceneKind::coupled, SceneKind::rigid}) {
      Case c = small_case(kind);
      c.domain.coordinates = coordinates;
      Homogeneous s(c, {{{0.2, 0}, {0.1, -0.1}}});
      const double bottom = kind == SceneKind::rigid ? 0 : top_of_solid,
                   mass = s.scene.balance().measure(s.stage()).integrals["mass"];
      EXPECT_NEAR(read(s, box("density", integral, {0, bottom}, {0.9, 0.8})), mass, 1e-12 * mass);
      EXPECT_NEAR(read(s, box("density", mean, {0, bottom}, {0.9, 0.8})), Homogeneous::density, 1e-13);
    }
}

// Around the axis a box of the undeformed solid is a ring.
TEST(Probes, RingInTheSolid) {
  Case c = small_case(SceneKind::coupled);
  c.domain.coordinates = Coordinates::axisymmetric;
  Homogeneous s(c, {{{0.2, 0}, {0, 0}}});
  const double low = 0.1, high = 0.5, height = 0.2;
  const double expected = 2 * M_PI * height * 0.2 * (std::pow(high, 3) - std::pow(low, 3)) / 3;
  EXPECT_NEAR(read(s, box("displacement_x", integral, {low, 0.03}, {high, 0.23})), expected, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_x", mean, {0, 0.1}, {0, 0.1})), 0, 1e-14) << "a point on the axis";
  EXPECT_NEAR(read(s, at("volume_ratio", {0, 0.1})), 1.2 * 1.2, 1e-13) << "u_r / r is the slope at the axis";
}

/// Strains jump at a joint: a point on it is read from above, a box from its own side, and the stress is the same on
/// both sides.
TEST(Probes, AtAJoint) {
  for (int row = 1; row < 6; ++row) {
    Joined s(row);
    const double strain = s.below + 0.5 * s.below * s.below, strain_above = s.above + 0.5 * s.above * s.above;
    const std::string yy = "green_lagrange_strain_yy", stress = "cauchy_stress_yy";
    for (const double off : {0.0, 1e-13, -1e-13})
      for (const double x : {0.0, 0.31, 0.9}) {
        EXPECT_NEAR(read(s, at(yy, {x, s.joint + off})), strain_above, 1e-13) << row << " " << off;
        EXPECT_NEAR(read(s, at(stress, {x, s.joint + off})), s.modulus_below * s.below, 1e-13) << row << " " << off;
      }
    EXPECT_NEAR(read(s, at(stress, {0.31, s.joint - 1e-7})), s.modulus_below * s.below, 1e-13);
    for (const ProbeOperation operation : {min, max, mean}) {
      EXPECT_NEAR(read(s, box(yy, operation, {0.1, 0.05}, {0.7, s.joint})), strain, 1e-13) << row;
      EXPECT_NEAR(read(s, box(yy, operation, {0.1, s.joint}, {0.7, 0.75})), strain_above, 1e-13) << row;
      EXPECT_NEAR(read(s, box(yy, operation, {0.1, s.joint}, {0.7, s.joint})), strain_above, 1e-13) << row;
      EXPECT_NEAR(read(s, box(stress, operation, {0, 0}, {0.9, 0.8})), s.modulus_below * s.below, 1e-13) << row;
    }
    EXPECT_NEAR(read(s, box(yy, min, {0, 0}, {0.9, 0.8})), strain, 1e-13) << row;
    EXPECT_NEAR(read(s, box(yy, max, {0, 0}, {0.9, 0.8})), strain_above, 1e-13) << row;
    EXPECT_NEAR(read(s, box(yy, integral, {0, 0}, {0.9, 0.8})),
                0.9 * (s.joint * strain + (0.8 - s.joint) * strain_above), 1e-13);
  }
}

/// The axis of symmetry turns into itself: a line on it stays a line, and a point a point.
TEST(Probes, OnTheAxisOfSymmetry) {
  Case c = small_case(SceneKind::coupled);
  c.domain.coordinates = Coordinates::axisymmetric;
  Homogeneous s(c, {{{0.2, 0}, {0, -0.1}}});
  EXPECT_NEAR(read(s, box("displacement_y", mean, {0, 0.05}, {0, 0.19})), -0.1 * 0.12, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_y", integral, {0, 0.05}, {0, 0.19})), -0.1 * 0.12 * 0.14, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_y", min, {0, 0.05}, {0, 0.19})), -0.019, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_y", max, {0, 0.05}, {0, 0.19})), -0.005, 1e-14);
  for (const ProbeOperation operation : {mean, integral, min, max})
    EXPECT_NEAR(read(s, box("displacement_y", operation, {0, 0.1}, {0, 0.1})), -0.01, 1e-14);
  // The fluid above sinks with the wall; a line of it is as long as it is now.
  EXPECT_NEAR(read(s, box("density", mean, {0, top_of_solid}, {0, 0.8})), Homogeneous::density, 1e-14);
  EXPECT_NEAR(read(s, box("density", integral, {0, top_of_solid}, {0, 0.8})),
              Homogeneous::density * (0.8 - 0.9 * top_of_solid), 1e-13);
}

/// Off the axis a line turns into a face, and a point into a circle.
TEST(Probes, LinesAroundTheAxisOfSymmetry) {
  Case c = small_case(SceneKind::coupled);
  c.domain.coordinates = Coordinates::axisymmetric;
  Homogeneous s(c, {{{0.2, 0}, {0, -0.1}}});
  const double turn = 2 * M_PI;
  EXPECT_NEAR(read(s, box("displacement_y", mean, {0.3, 0.05}, {0.3, 0.19})), -0.1 * 0.12, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_y", integral, {0.3, 0.05}, {0.3, 0.19})), -0.1 * 0.12 * 0.14 * turn * 0.3,
              1e-14);
  EXPECT_NEAR(read(s, box("displacement_y", integral, {0.3, 0.1}, {0.3, 0.1})), -0.01 * turn * 0.3, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_x", integral, {0, 0.1}, {0.6, 0.1})), 0.2 * turn * 0.072, 1e-14);
  EXPECT_NEAR(read(s, box("displacement_x", mean, {0, 0.1}, {0.6, 0.1})), 0.2 * 0.4, 1e-14) << "of a disc";
}

TEST(Probes, KnowWhetherTheyNeedTheVelocity) {
  Case c;
  c.probes = {at("pressure", {0, 0})};
  EXPECT_FALSE(probes_need_velocity(c));
  c.probes.push_back(at("speed", {0, 0}));
  EXPECT_TRUE(probes_need_velocity(c));
}

}  // namespace
}  // namespace softwet::testing_tools
