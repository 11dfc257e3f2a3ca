// Field files of a solid that is deformed by the same gradient everywhere, against stresses worked out by hand.
#include "observe/output_fields.hpp"

#include <gtest/gtest.h>

#include "io/hdf5_file.hpp"
#include "unit/io/scratch_folder.hpp"
#include "unit/observe/core/homogeneous.hpp"

namespace softwet::testing_tools {
namespace {

using Tensor = std::array<double, 9>;

/// The field files of a scene at time 1.5, `names` of them (none: all).
struct Written {
  ScratchFolder folder;

  explicit Written(const Homogeneous& run, const std::vector<std::string>& names = {}) {
    write_field_files(folder / "", {"scene", "1.0", "abc"}, names, run.data, run.scene.coefficients(), run.snapshot(),
                      {1.5});
  }
  Hdf5File open(const std::string& part) const {
    return Hdf5File::open(folder / ("fields/" + part + "_0000.hdf"), "write it again");
  }
};

/// Every point of a tensor field has these components.
void expect_everywhere(const Hdf5File& file, const std::string& name, const Tensor& expected) {
  const std::vector<double> found = file.read<double>("/VTKHDF/PointData/" + name);
  ASSERT_EQ(found.size() % 9, 0U);
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i % 9], 1e-12) << name << " " << i;
}

// x = 1.2 X, y = 0.9 Y in plane strain: E = diag(0.22, -0.095, 0), S = lambda tr(E) I + 2 G E, P = F S, and
// sigma_ii = P_ii F_ii / J. Young 2.0 times density 1.3, nu = 0.3: lambda = 1.5, G = 1.
TEST(FieldFiles, StressOfAHomogeneousStretch) {
  const Written written(Homogeneous(small_case(SceneKind::coupled), {{{0.2, 0}, {0, -0.1}}}));
  const Hdf5File file = written.open("solid");
  const double sx = 1.5 * 0.125 + 2 * 0.22, sy = 1.5 * 0.125 - 2 * 0.095, sz = 1.5 * 0.125, j = 1.2 * 0.9;
  expect_everywhere(file, "green_lagrange_strain", {0.22, 0, 0, 0, -0.095, 0, 0, 0, 0});
  expect_everywhere(file, "first_piola_stress", {1.2 * sx, 0, 0, 0, 0.9 * sy, 0, 0, 0, sz});
  expect_everywhere(file, "cauchy_stress", {1.44 * sx / j, 0, 0, 0, 0.81 * sy / j, 0, 0, 0, sz / j});
  for (double ratio : file.read<double>("/VTKHDF/PointData/volume_ratio")) ASSERT_NEAR(ratio, j, 1e-13);
  EXPECT_EQ(file.read_text("/VTKHDF/PointData/cauchy_stress", "unit"), "a b^2");
  EXPECT_EQ(file.read_text("/", "case"), "scene");
}

// x = X + k Y: rows are the direction of the force, so P_xy = k S_yy + S_xy and P_yx = S_xy.
TEST(FieldFiles, RowsOfTheFirstPiolaStressAreDirectionsOfTheForce) {
  const double k = 0.4, tr = 0.08, sxx = 1.5 * tr, sxy = k, syy = 1.5 * tr + 2 * tr;
  const Written written(Homogeneous(small_case(SceneKind::solid), {{{0, k}, {0, 0}}}));
  expect_everywhere(written.open("solid"), "first_piola_stress",
                    {sxx + k * sxy, sxy + k * syy, 0, sxy, syy, 0, 0, 0, 1.5 * tr});
}

TEST(FieldFiles, RotationHasNoStrainAndNoStress) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Written written(Homogeneous(small_case(SceneKind::solid), {{{c - 1, -s}, {s, c - 1}}}));
  const Hdf5File file = written.open("solid");
  for (const char* name : {"green_lagrange_strain", "first_piola_stress", "cauchy_stress"})
    expect_everywhere(file, name, {});
}

// A solid that is half as stiff at the left as at the right has half the stress there.
TEST(FieldFiles, StressWhereTheStiffnessVaries) {
  struct Linear : Formula {
    double at(const std::array<double, 3>& x, double) const override { return 2.0 * (0.5 + 0.5 * x[0] / 0.9); }
  };
  Case graded = small_case(SceneKind::solid);
  graded.substrate->young.text = "linear";
  graded.substrate->young.formula = std::make_shared<Linear>();
  graded.substrate->young.lowest = 1, graded.substrate->young.highest = 2;
  const Matrix<double, 2> gradient{{{0.2, 0.1}, {0, -0.1}}};
  const Written uniform(Homogeneous(small_case(SceneKind::solid), gradient)), varying(Homogeneous(graded, gradient));
  for (const char* name : {"first_piola_stress", "cauchy_stress"}) {
    const std::string data = std::string("/VTKHDF/PointData/") + name;
    const auto even = uniform.open("solid").read<double>(data), half = varying.open("solid").read<double>(data);
    for (int i = 0; i < 19; ++i)  // along the bottom, from left to right
      for (int k : {0, 1, 3, 4, 8}) EXPECT_NEAR(half[9 * i + k], (0.5 + i / 36.0) * even[9 * i + k], 1e-12) << i;
  }
}

// x = 1.2 X, y = 0.9 Y of a layer that was stretched by 1.1 before: sigma belongs to the stretches 1.32 and 0.9 l_v,
// where the layer alone has no stress upright: (l_v^2 - 1) (lambda + 2 G) = -lambda (1.1^2 - 1). Strain and volume
// ratio count from the stretched layer.
TEST(FieldFiles, StressOfAStretchedLayer) {
  Case c = small_case(SceneKind::solid);
  c.substrate->prestretch = {1.1};
  const Written written(Homogeneous(c, {{{0.2, 0}, {0, -0.1}}}));
  const Hdf5File file = written.open("solid");
  const double up = std::sqrt(1 - 1.5 / 3.5 * 0.21), fx = 1.32, fy = 0.9 * up, j = fx * fy, j0 = 1.1 * up;
  const double ex = 0.5 * (fx * fx - 1), ey = 0.5 * (fy * fy - 1), tr = ex + ey;
  const double sx = 1.5 * tr + 2 * ex, sy = 1.5 * tr + 2 * ey, sz = 1.5 * tr;
  expect_everywhere(file, "cauchy_stress", {fx * fx * sx / j, 0, 0, 0, fy * fy * sy / j, 0, 0, 0, sz / j});
  expect_everywhere(file, "first_piola_stress", {fx * sx * 1.1 / j0, 0, 0, 0, fy * sy * up / j0, 0, 0, 0, sz / j0});
  expect_everywhere(file, "green_lagrange_strain", {0.22, 0, 0, 0, -0.095, 0, 0, 0, 0});
  for (double ratio : file.read<double>("/VTKHDF/PointData/volume_ratio")) ASSERT_NEAR(ratio, 1.2 * 0.9, 1e-13);
}

// Fibres along x add 2 k (I_4 - 1) F a_0 to the first column of P, and to sigma that times F^T / J.
TEST(FieldFiles, StressOfFibres) {
  Case with = small_case(SceneKind::solid);
  with.substrate->fibre = {0.7, 0.0};
  const Matrix<double, 2> gradient{{{0.2, 0}, {0.1, 0}}};
  const Written bare(Homogeneous(small_case(SceneKind::solid), gradient)), fibres(Homogeneous(with, gradient));
  const double tension = 2 * 0.7 * (1.2 * 1.2 + 0.1 * 0.1 - 1);
  const auto of = [](const Written& w, const char* name) {
    return w.open("solid").read<double>(std::string("/VTKHDF/PointData/") + name);
  };
  const auto p0 = of(bare, "first_piola_stress"), p1 = of(fibres, "first_piola_stress");
  EXPECT_NEAR(p1[0] - p0[0], tension * 1.2, 1e-12);
  EXPECT_NEAR(p1[3] - p0[3], tension * 0.1, 1e-12);
  EXPECT_NEAR(p1[1] - p0[1], 0, 1e-12);
  const auto s0 = of(bare, "cauchy_stress"), s1 = of(fibres, "cauchy_stress");
  EXPECT_NEAR(s1[0] - s0[0], tension * 1.44 / 1.2, 1e-12);
  EXPECT_NEAR(s1[1] - s0[1], tension * 0.12 / 1.2, 1e-12);
}

// The points of a joint are there twice, first as the end of the lower material, then of the upper one.
TEST(FieldFiles, BothSidesOfAJoint) {
  for (int row = 1; row < 6; ++row) {
    const Joined run(row);
    const Written written(run);
    const Hdf5File file = written.open("solid");
    const auto read = [&](const char* name) { return file.read<double>(std::string("/VTKHDF/") + name); };
    const std::vector<double> points = read("Points"), strain = read("PointData/green_lagrange_strain"),
                              stress = read("PointData/cauchy_stress");
    ASSERT_EQ(points.size(), 3 * 19 * 14U);
    for (std::size_t i = 0; i < 19 * 14; ++i) {
      const bool below = i < 19 * (2 * row + 1U);
      const double g = below ? run.below : run.above;
      ASSERT_NEAR(strain[9 * i + 4], g + 0.5 * g * g, 1e-13) << row << " " << i;
      ASSERT_NEAR(stress[9 * i + 4], run.modulus_below * run.below, 1e-13) << row << " " << i;
    }
    for (std::size_t i = 19 * (2 * row); i < 19 * (2 * row + 1U); ++i)
      for (int d = 0; d < 3; ++d) ASSERT_NEAR(points[3 * i + d], points[3 * (i + 19) + d], 1e-15);
    EXPECT_EQ(file.read<std::int64_t>("/VTKHDF/Connectivity").size(), 9 * 9 * 6U);
  }
}

TEST(FieldFiles, HoldTheFieldsAskedFor) {
  const Written written(Homogeneous(small_case(SceneKind::coupled), {}), {"pressure", "velocity", "volume_ratio"});
  const Hdf5File fluid = written.open("fluid"), solid = written.open("solid");
  for (const char* name : {"pressure", "velocity"}) EXPECT_TRUE(fluid.has(std::string("/VTKHDF/PointData/") + name));
  for (const char* name : {"density", "volume_ratio"})
    EXPECT_FALSE(fluid.has(std::string("/VTKHDF/PointData/") + name));
  for (const char* name : {"velocity", "volume_ratio"})
    EXPECT_TRUE(solid.has(std::string("/VTKHDF/PointData/") + name));
  EXPECT_FALSE(solid.has("/VTKHDF/PointData/displacement"));
}

}  // namespace
}  // namespace softwet::testing_tools
