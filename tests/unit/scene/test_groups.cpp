// Dimensionless groups by hand-worked numbers.
#include "scene/groups.hpp"

#include <gtest/gtest.h>

#include <map>

namespace softwet {
namespace {

Case pull() {
  Case c;
  c.domain = {.size = {1, 0.5}, .elements = {128, 64}, .degree = 2};
  c.fluid.emplace();
  c.fluid->viscosity = 1.0 / 256;
  c.fluid->capillarity = 1.0 / 64;
  c.fluid->temperature = 0.39;
  c.substrate = Substrate{.thickness = 0.125, .density = 2, .young = 0.5, .poisson = 0.25};  // Young modulus 1
  c.droplets = {{{0.3, 0.125}, 0.1}, {{0.7, 0.125}, 0.16}};
  return c;
}

TEST(Groups, LiquidByRoundNumbers) {
  const Liquid liquid{4, 2, 9, 0.25};               // density, viscosity, tension, radius
  EXPECT_NEAR(liquid.ohnesorge(), 2.0 / 3, 1e-15);  // 2 / sqrt(4 x 9 x 0.25)
  EXPECT_NEAR(liquid.capillary_number(3), 2.0 / 3, 1e-15);
  EXPECT_NEAR(liquid.reynolds(3), 1.5, 1e-15);
  EXPECT_NEAR(liquid.time_capillary(), 0.5 / 9, 1e-15);
  EXPECT_NEAR(liquid.time_inertia(), 0.25 / 3, 1e-15);  // sqrt(4 / 64 / 9)
  EXPECT_NEAR(liquid.time_viscosity(), 0.125, 1e-15);
}

TEST(Groups, OfASceneWithTheLargestDroplet) {
  std::map<std::string, double> value;
  for (const Group& group : groups(pull())) value[group.name] = group.value;
  const double tension = 0.2532027493 / 64,
               density = 0.8666990997;  // at temperature 0.39, shared with test_equilibrium
  EXPECT_NEAR(value.at("elastocapillary_over_radius"), tension / 0.16, 1e-8);
  EXPECT_NEAR(value.at("elastocapillary_over_thickness"), tension / 0.125, 1e-8);
  EXPECT_NEAR(value.at("elastocapillary_over_interface"), 0.2532027493 / 2, 1e-8);
  EXPECT_NEAR(value.at("radius_over_capillarity"), 10.24, 1e-12);
  EXPECT_NEAR(value.at("ohnesorge"), 1 / 256.0 / std::sqrt(density * tension * 0.16), 1e-7);
  EXPECT_NEAR(value.at("capillary_number"), 1 / 256.0 / tension, 1e-7);
  EXPECT_NEAR(value.at("reynolds"), density * 0.16 * 256, 1e-6);
  // G = 1 / (2 x 1.25) = 0.4, shear waves of speed sqrt(0.4 / 2).
  EXPECT_NEAR(value.at("time_elasticity"), 0.125 / std::sqrt(0.2), 1e-12);
}

TEST(Groups, TheRippleOfASpeedWhereADropletIsDriven) {
  EXPECT_EQ(speed_ripple(pull()), 0) << "at rest";
  Case loaded = pull();
  loaded.loads = {{.lower = {0.7, 0}, .upper = {0.8, 0.125}, .force = {0.1, 0}}};
  EXPECT_NEAR(speed_ripple(loaded), 0.013, 1e-15) << "two elements to the capillarity";
  Case tilted = pull();
  tilted.fluid->gravity = {1e-3, 0};
  EXPECT_NEAR(speed_ripple(tilted), 0.013, 1e-15);
  tilted.fluid->gravity = {0, -1e-3};
  EXPECT_EQ(speed_ripple(tilted), 0) << "downwards";
  loaded.domain.elements = {192, 96};
  EXPECT_NEAR(speed_ripple(loaded), 0.013 * 16 / 81, 1e-15);
  for (Droplet& droplet : loaded.droplets) droplet.centre[1] = 0.3;
  EXPECT_EQ(speed_ripple(loaded), 0) << "droplets in the air";
  loaded.droplets = {{{0, 0.125}, 0.16}};
  EXPECT_EQ(speed_ripple(loaded), 0) << "half a droplet, which stays";
}

TEST(Groups, OnlyWhatThereIs) {
  Case c = pull();
  c.droplets.clear();
  for (const Group& group : groups(c)) EXPECT_EQ(group.name.find("radius"), std::string::npos) << group.name;
  c.fluid.reset();
  ASSERT_EQ(groups(c).size(), 1u);
  EXPECT_EQ(groups(c)[0].name, "time_elasticity");
  EXPECT_EQ(elastocapillary_length(c), 0);
}

}  // namespace
}  // namespace softwet
