// Scenes with an axis of symmetry: what such a case may say, and how what breaks the symmetry is refused.
#include "unit/casefile/bad_case.hpp"

namespace softwet::testing_tools {
namespace {

/// The pull with its droplet on the axis and a load that pulls upwards.
std::string axisymmetric() {
  std::string text = replaced(pull_text(), "coordinates = \"plane\"", "coordinates = \"axisymmetric\"");
  text = replaced(text, "centre = [0.5, 0.125]", "centre = [0.0, 0.125]");
  return replaced(text, "force = [0.16215, 0.0]", "force = [0.0, 0.16215]");
}

void expect_refusal(const std::string& setting, const std::vector<std::string>& parts) {
  const std::string message = message_of(axisymmetric(), {setting});
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

TEST(AxisymmetricCase, IsRead) {
  EXPECT_EQ(message_of(axisymmetric()), "(accepted)");
  const Case c = parse_case(axisymmetric(), "case.toml");
  EXPECT_TRUE(c.axisymmetric());
  EXPECT_EQ(c.dimension_of_droplets(), 3);
  EXPECT_EQ(pull().dimension_of_droplets(), 2);
  EXPECT_NE(write_case(c).find("coordinates = \"axisymmetric\""), std::string::npos);
}

TEST(AxisymmetricCase, RefusesWhatHasNoAxisOfSymmetry) {
  expect_refusal("boundary.left=no_slip", {"boundary.left", "axis of symmetry", "write left = \"slip\""});
  expect_refusal("droplet[0].centre=[0.1,0.125]", {"droplet[0].centre", "not 0.1", "write 0 there"});
  expect_refusal("droplet[0].velocity=[0.2,-0.1]", {"droplet[0].velocity", "not 0.2", "write 0 there"});
  expect_refusal("load[0].force=[0.1,0]", {"load[0].force", "not 0.1", "write 0 there"});
  expect_refusal("fluid.gravity=[0.3,-1]", {"fluid.gravity", "not 0.3", "write 0 there"});
  expect_refusal("substrate.gravity=[0.3,-1]", {"substrate.gravity", "not 0.3", "write 0 there"});
}

TEST(AxisymmetricCase, ExistsInTwoDimensionsOnly) {
  const std::string message = message_of(axisymmetric(), {"domain.size=[1,1,0.5]", "domain.elements=[8,8,8]"});
  for (const char* part : {"domain.coordinates", "2D only", "remove it"})
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

}  // namespace
}  // namespace softwet::testing_tools
