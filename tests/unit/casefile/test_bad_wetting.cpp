// Line friction and hysteresis of the contact angle: what a case may ask for, and the angle that follows.
#include "unit/casefile/bad_case.hpp"

namespace softwet::testing_tools {
namespace {

constexpr const char* rigid = R"(
name = "tilted"
domain = { size = [1, 0.5], elements = [32, 16] }
[fluid]
viscosity = "1/256"
capillarity = "1/16"
temperature = 0.39
wall_law = "energy"
[[droplet]]
centre = [0.5, 0]
radius = 0.2
[time]
end = 1
)";

TEST(BadCases, ARangeOfAnglesIsTwoNumbersInOrder) {
  expect_parts(message_of(rigid, {"fluid.contact_angle_range=[65]"}),
               {"fluid.contact_angle_range = [65]", "must be 2 numbers, not 1", "[65, 85]"});
  expect_parts(message_of(rigid, {"fluid.contact_angle_range=[65,75,85]"}), {"must be 2 numbers, not 3"});
  expect_parts(message_of(rigid, {"fluid.contact_angle_range=[85,65]"}), {"receding angle first", "write [65, 85]"});
  expect_parts(message_of(rigid, {"fluid.contact_angle_range=[70,70]"}), {"write contact_angle = 70"});
  expect_parts(message_of(rigid, {"fluid.contact_angle_range=[70,180]"}), {"fluid.contact_angle_range", "(0, 180)"});
}

TEST(BadCases, ARangeOfAnglesHasOneStaticAngle) {
  const double middle = std::acos(0.5 * (std::cos(65 * M_PI / 180) + std::cos(85 * M_PI / 180))) * 180 / M_PI;
  const Case c = parse_case(rigid, "case.toml", {"fluid.contact_angle_range=[65,85]"});
  EXPECT_NEAR(c.fluid->contact_angle.number, middle, 1e-12);
  const Case again = parse_case(write_case(c), "case.toml");
  EXPECT_EQ(again.fluid->contact_angle.number, c.fluid->contact_angle.number);
  EXPECT_EQ(write_case(again), write_case(c));
  expect_parts(
      message_of(rigid, {"fluid.contact_angle_range=[65,85]", "fluid.contact_angle=75"}),
      {"fluid.contact_angle = 75", "contradicts fluid.contact_angle_range = [65, 85]", "75.23311039", "remove"});
  expect_parts(message_of(rigid, {"fluid.contact_angle_range=[65,85]", "fluid.contact_angle=60+10*x"}),
               {"fluid.contact_angle_range", "varies along the wall"});
}

TEST(BadCases, LineFrictionNeedsTheWallEnergyAndImplicitSteps) {
  for (const char* key : {"fluid.line_friction=0.1", "fluid.contact_angle_range=[65,85]"}) {
    EXPECT_NO_THROW(parse_case(rigid, "case.toml", {key}));
    EXPECT_NO_THROW(parse_case(rigid, "case.toml", {key, "time.scheme=automatic"}));
    expect_parts(message_of(rigid, {key, "fluid.wall_law=gradient"}),
                 {"the wall energy", "write wall_law = \"energy\""});
    for (const char* scheme : {"kick_drift", "rkl2", "ssp_rk3"})
      expect_parts(message_of(rigid, {key, std::string("time.scheme=") + scheme}),
                   {"generalized_alpha", scheme, "the rate of the density at the wall"});
    expect_parts(
        message_of(rigid, {key, "boundary.bottom=periodic", "boundary.top=periodic", "droplet[0].centre=[0.5,0.25]"}),
        {"needs a wall"});
  }
  expect_parts(message_of(rigid, {"fluid.line_friction=0.1", "fluid.contact_angle=60+10*x"}),
               {"fluid.line_friction", "the same contact angle along the whole wall"});
  expect_parts(message_of(rigid, {"fluid.line_friction=0.1", "fluid.contact_angle=4"}), {"[5, 175]", "not 4"});
  expect_parts(message_of(rigid, {"fluid.line_friction=-0.1"}), {"fluid.line_friction", "[0, inf)"});
  expect_parts(message_of(rigid, {"fluid.creep_speed=0"}), {"fluid.creep_speed", "[1e-05, 1]"});
}

}  // namespace
}  // namespace softwet::testing_tools
