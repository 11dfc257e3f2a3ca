// What a case becomes where keys depend on each other: schemes, tolerances, and a joint on its mesh.
#include <gtest/gtest.h>

#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "unit/casefile/pull.hpp"

namespace softwet {
namespace {

using testing_tools::pull_text;

/// With 1e-3 and rho_inf = 0.99 the swinging beam of tests/verification/studies/csm.py gains energy until it fails.
TEST(CaseFile, SchemesThatHardlyDampAreSolvedFurther) {
  const double usual = parse_case(pull_text(), "init").solver.newton_rtol;
  EXPECT_EQ(parse_case(pull_text(), "init", {"time.rho_inf=0.9"}).solver.newton_rtol, usual);
  EXPECT_LT(parse_case(pull_text(), "init", {"time.rho_inf=0.95"}).solver.newton_rtol, usual);
  EXPECT_EQ(parse_case(pull_text(), "init", {"time.rho_inf=1", "solver.newton.rtol=1e-2"}).solver.newton_rtol, 1e-2);
}

// A joint looks for the ends of elements, which there may be none of.
TEST(CaseFile, AJointDoesNotHideWhatIsWrongWithTheMesh) {
  for (const char* elements : {"domain.elements=[8]", "domain.elements=[0,8]", "domain.elements=[]", "domain.size=[1]"})
    try {
      parse_case(pull_text(), "init", {"substrate.joint=0.0625", elements});
      ADD_FAILURE() << elements;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("domain."), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find("end of a row"), std::string::npos) << error.what();
    }
  try {
    parse_case(pull_text(), "init", {"substrate.joint=0.0625", "domain.elements=[8,4]"});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("two rows of elements"), std::string::npos) << error.what();
  }
}

// Whoever runs it decides by the number of steps; until then it is a scheme that knows every scene.
TEST(CaseFile, AnAutomaticSchemeIsTheImplicitOneUntilItIsChosen) {
  const Case c = parse_case(pull_text(), "init", {"time.scheme=\"automatic\"", "substrate.inertia=\"none\""});
  EXPECT_TRUE(c.time.automatic);
  EXPECT_EQ(c.time.scheme, TimeScheme::generalized_alpha);
  EXPECT_EQ(c.domain.quadrature, parse_case(pull_text(), "init").domain.quadrature);
  EXPECT_NE(write_case(c).find("scheme = \"generalized_alpha\""), std::string::npos);
  EXPECT_FALSE(parse_case(pull_text(), "init").time.automatic);
}

}  // namespace
}  // namespace softwet
