// Precisions that do not go with the schemes and solvers of a case.
#include "case/precision.hpp"
#include "unit/casefile/bad_case.hpp"

namespace softwet::testing_tools {
namespace {

TEST(BadPrecision, UnknownWord) {
  expect_parts(message_of(pull_text(), {"solver.precision=half"}),
               {"solver.precision = \"half\"", "\"automatic\"", "\"double\"", "\"mixed\""});
}

TEST(BadPrecision, ExplicitSchemesAreDouble) {
  for (const char* scheme : {"ssp_rk3", "kick_drift"})
    expect_parts(message_of(pull_text(), {"solver.precision=mixed", std::string("time.scheme=") + scheme}),
                 {"solver.precision", "mixed", "generalized_alpha", scheme, "write \"automatic\""});
  EXPECT_EQ(message_of(pull_text(), {"solver.precision=mixed"}), "(accepted)");
  EXPECT_EQ(message_of(pull_text(), {"solver.precision=double", "time.scheme=kick_drift"}), "(accepted)");
}

TEST(BadPrecision, DifferencesOfResidualsAreDouble) {
  expect_parts(message_of(pull_text(), {"solver.precision=mixed", "solver.krylov.jacobian=difference"}),
               {"solver.precision", "solver.krylov.jacobian", "\"exact\"", "write \"automatic\""});
}

TEST(BadPrecision, LinearSolvesToTheRoundOffAreDouble) {
  expect_parts(message_of(pull_text(), {"solver.precision=mixed", "solver.krylov.rtol=1e-6"}),
               {"solver.precision", "solver.krylov.rtol = 1e-05 or more, not 1e-06", "write \"automatic\""});
}

// What "automatic" takes may be written, and where it does not take single precision neither may be written.
TEST(BadPrecision, AutomaticTakesWhatMayBeWritten) {
  for (const char* scheme : {"generalized_alpha", "ssp_rk3", "rkl2", "kick_drift"})
    for (const char* jacobian : {"exact", "difference"})
      for (const char* rtol : {"1e-2", "1e-5", "9e-6"}) {
        const std::vector<std::string> words{std::string("time.scheme=") + scheme,
                                             std::string("solver.krylov.jacobian=") + jacobian,
                                             std::string("solver.krylov.rtol=") + rtol};
        const bool mixed = precision_of(parse_case(pull_text(), "case.toml", words)) == Precision::mixed;
        for (const char* precision : {"mixed", "double"}) {
          std::vector<std::string> written = words;
          written.push_back(std::string("solver.precision=") + precision);
          const bool accepted = message_of(pull_text(), written) == "(accepted)";
          EXPECT_EQ(accepted, mixed || precision == std::string("double")) << scheme << jacobian << rtol << precision;
        }
      }
}

TEST(BadPrecision, ProductsWithoutTheMotionOfTheMeshAreGone) {
  expect_parts(message_of(pull_text(), {"solver.krylov.jacobian=frozen"}),
               {"solver.krylov.jacobian", "\"exact\"", "\"difference\""});
}

}  // namespace
}  // namespace softwet::testing_tools
