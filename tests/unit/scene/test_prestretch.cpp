// The stretched state of a layer, and scenes that begin from it.
#include "scene/prestretch.hpp"

#include "case/error.hpp"
#include "foresight/forecast.hpp"
#include "unit/scene/formulas.hpp"
#include "unit/scene/stretched.hpp"

namespace softwet::testing_tools {
namespace {

/// A layer of Young's modulus 0.7554 and Poisson's ratio 0.45.
Case layer(std::vector<double> along, MaterialModel material, bool in_space = false) {
  Case c = in_space ? small_case_in_3d(SceneKind::solid) : small_case(SceneKind::solid);
  c.substrate->density = 1;
  c.substrate->young = 0.7554;
  c.substrate->poisson = 0.45;
  c.loads.clear();
  return stretched(c, std::move(along), material);
}

// Roots of P_vv by Brent's method and stresses from the laws written in Python, to all of their digits.
TEST(PrestretchedLayer, IsFreeOfStressUpright) {
  struct Known {
    MaterialModel material;
    std::vector<double> along;
    double upright, stress;
  };
  const MaterialModel neo = MaterialModel::neo_hookean, svk = MaterialModel::saint_venant_kirchhoff;
  for (const Known& k : std::vector<Known>{{neo, {0.8}, 1.192678036263, -0.2136188233},
                                           {neo, {0.9}, 1.088519815381, -0.0996751878},
                                           {neo, {1.0}, 1, 0},
                                           {neo, {1.1}, 0.923984574806, 0.0913018345},
                                           {neo, {1.2}, 0.858106727411, 0.1779978995},
                                           {neo, {1.3}, 0.800545943837, 0.2625893441},
                                           {svk, {0.8}, 1.137780934339, -0.1198809370},
                                           {svk, {0.9}, 1.074920715892, -0.0753417964},
                                           {svk, {1.0}, 1, 0},
                                           {svk, {1.1}, 0.910044953935, 0.1202168730},
                                           {svk, {1.2}, 0.8, 0.3125793103},
                                           {svk, {1.3}, 0.659889797962, 0.6437797650},
                                           {neo, {1.2, 0.9}, 0.938309914653, 0.1438357494},
                                           {neo, {1.1, 1.1}, 0.852002570470, 0.1223151555},
                                           {neo, {0.9, 0.9}, 1.181448266685, -0.1594569503},
                                           {svk, {1.2, 0.9}, 0.891882585016, 0.2509941419}}) {
    const bool in_space = k.along.size() == 2;
    const Case c = layer(k.along, k.material, in_space);
    const LameParameters stiffness = stiffest_of(*c.substrate);
    const Prestretch p = prestretch_of(c, stiffness);
    EXPECT_TRUE(p.acts);
    const int up = in_space ? 2 : 1;
    EXPECT_NEAR(p.stretch[up], k.upright, 2e-12) << word_of(k.material) << " " << k.along[0];
    if (!in_space) {
      EXPECT_EQ(p.stretch[2], 1) << "plane strain";
    }
    const auto stress = stress_at_rest(c, stiffness);
    EXPECT_NEAR(stress(up, up), 0, 1e-15) << word_of(k.material) << " " << k.along[0];
    EXPECT_NEAR(stress(0, 0), k.stress, 1e-9) << word_of(k.material) << " " << k.along[0];
  }
  const Prestretch around = prestretch_of(axisymmetric(layer({1.1}, neo)), LameParameters::from(0.7554, 0.45));
  EXPECT_NEAR(around.stretch[1], 0.852002570470, 2e-12);
  EXPECT_EQ(around.stretch[2], 1.1);
  EXPECT_FALSE(prestretch_of(layer({}, neo), {1, 1}).acts);
}

TEST(PrestretchedLayer, ExistsForAllMaterials) {
  for (const double poisson : {-0.2, 0.0, 0.3, 0.4999})
    for (const double stretch : {0.4, 0.7, 1.0, 1.6, 3.0}) {
      Case c = layer({stretch}, MaterialModel::neo_hookean);
      c.substrate->poisson = poisson;
      const LameParameters stiffness = stiffest_of(*c.substrate);
      EXPECT_NEAR(stress_at_rest(c, stiffness)(1, 1), 0, 1e-14 * (stiffness.lambda + 1)) << poisson << " " << stretch;
      if (poisson == 0) {
        EXPECT_NEAR(prestretch_of(c, stiffness).stretch[1], 1, 1e-15);
      }
    }
  Case c = layer({0.4}, MaterialModel::neo_hookean);
  c.substrate->poisson = -0.99;
  EXPECT_THROW(prestretch_of(c, stiffest_of(*c.substrate)), Error);
}

TEST(PrestretchedLayer, IsAtRestWhereItsDisplacementIsZero) {
  for (const MaterialModel material : {MaterialModel::neo_hookean, MaterialModel::saint_venant_kirchhoff})
    for (const double stretch : {0.85, 1.15}) {
      EXPECT_LT(largest_at_rest<2>(stretched(small_case(SceneKind::solid), {stretch}, material)), 1e-15);
      EXPECT_LT(largest_at_rest<2>(stretched(small_case(SceneKind::solid, WallLaw::energy, true), {stretch}, material)),
                1e-15);
      EXPECT_LT(largest_at_rest<2>(axisymmetric(stretched(small_case(SceneKind::solid), {stretch}, material))), 1e-15);
    }
  Case fibres = stretched(small_case(SceneKind::solid), {1.2});
  fibres.substrate->fibre = {0.5, 0, 0};
  EXPECT_LT(largest_at_rest<2>(fibres), 2e-15);
  fibres.substrate->fibre.angle = 30;
  EXPECT_GT(largest_at_rest<2>(fibres), 1e-3) << "inclined fibres, which a case may not have, pull at the top";
  Case layered = stretched(small_case(SceneKind::solid), {1.2});
  layered.substrate->young = varying([](const std::array<double, 3>& x, double) { return 2 + x[1]; });
  EXPECT_LT(largest_at_rest<2>(layered), 2e-15) << "stiffer above";
}

TEST(PrestretchedLayer, StiffnessOfItsFace) {
  const auto face = [](double stretch, double poisson, bool in_space = false) {
    Case c = layer(in_space ? std::vector<double>{stretch, stretch} : std::vector<double>{stretch},
                   MaterialModel::neo_hookean, in_space);
    c.substrate->poisson = poisson;
    return stiffness_of_face(c, prestretch_of(c, stiffest_of(*c.substrate)));
  };
  EXPECT_NEAR(face(1, 0.45), 1, 1e-15);
  // The root is where Biot's half space is unstable, 0.5437 in plane strain.
  EXPECT_GT(face(0.546, 0.4999), 0);
  EXPECT_LT(face(0.541, 0.4999), 0);
  EXPECT_GT(face(0.669, 0.4999, true), 0);
  EXPECT_LT(face(0.663, 0.4999, true), 0);
  // Waves of the wave number 60 on a layer of height 0.25 by small-on-large theory, C_yy(1) / C_yy(l) at Poisson's
  // ratio 0.4999.
  for (const auto& [stretch, expected] :
       {std::pair{0.6, 0.26175}, {0.7, 0.56681}, {0.8, 0.75824}, {0.9, 0.89267}, {1.2, 1.19240}, {1.4, 1.40045}})
    EXPECT_NEAR(face(stretch, 0.4999), expected, 2e-3) << stretch;
}

TEST(PrestretchedLayer, WhatIsKnownBeforeARun) {
  const auto tells = [](const Case& c, const std::string& part) {
    for (const std::string& sentence : forecast(c))
      if (sentence.find(part) != std::string::npos) return true;
    return false;
  };
  const Case svk = layer({1.1}, MaterialModel::saint_venant_kirchhoff);
  EXPECT_TRUE(tells(svk, "0.91 of its height")) << "with the numbers of both laws";
  EXPECT_TRUE(tells(svk, "0.924; write substrate.material = \"neo_hookean\""));
  EXPECT_FALSE(tells(layer({1.1}, MaterialModel::neo_hookean), "prestretch"));
  EXPECT_FALSE(tells(layer({0.7}, MaterialModel::neo_hookean), "creases"));
  EXPECT_TRUE(tells(layer({0.6}, MaterialModel::neo_hookean), "creases"));
  EXPECT_TRUE(tells(layer({1.3, 0.5}, MaterialModel::neo_hookean, true), "creases"));
  Case graded = layer({1.2}, MaterialModel::neo_hookean);
  graded.substrate->young = varying([](const std::array<double, 3>& x, double) { return 2 + x[1]; });
  graded.substrate->young.lowest = 2, graded.substrate->young.highest = 3;
  EXPECT_FALSE(tells(graded, "prestretch"));
  graded.substrate->young.formula = varying([](const std::array<double, 3>& x, double) { return 2 + x[0]; }).formula;
  EXPECT_TRUE(tells(graded, "time.start = \"equilibrium\""));
  // A compressed layer bears less below a droplet.
  Case droplet = small_case(SceneKind::coupled);
  droplet.fluid->temperature = 0.39;
  droplet.droplets = {{{0.45, 0.8 / 3}, 0.3}};
  const double bears = longest_elastocapillary_length(droplet);
  EXPECT_NEAR(longest_elastocapillary_length(stretched(droplet, {1.2})), bears, 1e-12);
  EXPECT_LT(longest_elastocapillary_length(stretched(droplet, {0.8})), 0.9 * bears);
}

}  // namespace
}  // namespace softwet::testing_tools
