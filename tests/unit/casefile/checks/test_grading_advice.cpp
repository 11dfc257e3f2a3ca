// What graded elements would spare, and in which scenes it was measured that they keep the path of the droplet.
#include "casefile/checks/grading_advice.hpp"

#include <gtest/gtest.h>

#include "case/mesh.hpp"
#include "casefile/case_file.hpp"
#include "unit/casefile/pull.hpp"

namespace softwet {
namespace {

using testing_tools::pull_text;

Case scene_with(const std::vector<std::string>& settings = {}) {
  return parse_case(pull_text(), "case.toml", settings);
}

TEST(GradingAdvice, TellsTheShareThatAutomaticLeaves) {
  const double left = share_of_elements(scene_with({"domain.grading.fine=\"automatic\""}));
  EXPECT_LT(left, 0.5);
  EXPECT_DOUBLE_EQ(share_left_by_grading(scene_with()), left);
  const std::string sentence = advice_on_grading(scene_with());
  EXPECT_NE(sentence.find("domain.grading.fine = \"automatic\""), std::string::npos) << sentence;
  EXPECT_NE(sentence.find(std::to_string(std::lround(100 * left)) + " % of the elements"), std::string::npos)
      << sentence;
}

TEST(GradingAdvice, IsSilentWhereElementsAreGradedOrLittleIsGained) {
  EXPECT_EQ(advice_on_grading(scene_with({"domain.grading.fine=\"automatic\""})), "");
  EXPECT_EQ(advice_on_grading(scene_with({"domain.grading.box=[[0.2,0.05],[0.9,0.4]]"})), "");
  EXPECT_EQ(advice_on_grading(scene_with({"domain.elements=[32,16]", "fluid.capillarity=1/16"})), "");
}

TEST(GradingAdvice, ClaimsNothingOfScenesThatWereNotSampled) {
  EXPECT_TRUE(is_sampled_pull(scene_with()));
  EXPECT_TRUE(is_sampled_pull(scene_with({"load[0].force=[-0.1,0]"})));
  for (const char* setting :
       {"fluid.contact_angle=40", "fluid.contact_angle=\"75 + 10*x\"", "fluid.temperature=0.6", "substrate.young=0.2",
        "substrate.poisson=0.15", "substrate.young=\"0.7 + 0.2*x\"", "domain.degree=3", "droplet[0].centre=[0.5,0.3]",
        "time.scheme=\"kick_drift\"", "time.start=\"equilibrium\"", "substrate.fibre.stiffness=1",
        "substrate.surface_tension=0.1", "substrate.viscosity=1", "substrate.material=\"neo_hookean\"",
        "fluid.wall_law=\"energy\"", "fluid.gravity=[0,-0.01]", "substrate.surface_modulus=[0.1,0.1]",
        "boundary.left=\"no_slip\""}) {
    EXPECT_FALSE(is_sampled_pull(scene_with({setting}))) << setting;
    EXPECT_EQ(advice_on_grading(scene_with({setting})), "") << setting;
  }
}

}  // namespace
}  // namespace softwet
