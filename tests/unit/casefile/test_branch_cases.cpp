// Cases with a viscoelastic solid, accepted and refused.
#include "case/gel.hpp"
#include "unit/casefile/bad_case.hpp"

namespace softwet::branch_cases {
namespace {

using testing_tools::expect_parts;
using testing_tools::message_of;
using testing_tools::pull_text;
using testing_tools::replaced;

std::string small() { return replaced(pull_text(), "strain = \"finite\"", "strain = \"small\""); }
const std::string two =
    "\n[[substrate.branch]]\nmodulus = 0.26\ntime = 1.0\n[[substrate.branch]]\nmodulus = \"1/8\"\ntime = 0.1\n";
const std::vector<std::string> gel{"substrate.gel.exponent=0.5", "substrate.gel.time=0.3"};

void tells(const std::string& text, const std::vector<std::string>& settings, const std::vector<std::string>& parts) {
  expect_parts(message_of(text, settings), parts);
}
std::vector<std::string> with(std::vector<std::string> settings, const std::string& more) {
  settings.push_back(more);
  return settings;
}

TEST(BranchCase, IsReadAndWritten) {
  const Case c = parse_case(small() + two, "case.toml", {"substrate.branch.time=2", "substrate.branch[1].time=0.2"});
  ASSERT_EQ(c.substrate->branches.size(), 2);
  EXPECT_EQ(c.substrate->branches[0].modulus, 0.26);
  EXPECT_EQ(c.substrate->branches[0].time, 2);
  EXPECT_EQ(c.substrate->branches[1].modulus, 0.125);
  EXPECT_EQ(c.substrate->branches[1].time, 0.2);
  const Case again = parse_case(write_case(c), "again.toml");
  EXPECT_EQ(write_case(again), write_case(c));
  EXPECT_TRUE(parse_case(pull_text(), "case.toml").substrate->branches.empty());
}

TEST(BranchCase, MayBeAListInTheTableOfTheSolid) {
  std::string text = replaced(small(), "strain = \"small\"",
                              "strain = \"small\"\nbranch = [{modulus = 0.26, time = 1}, {modulus = 1, time = 3}]");
  EXPECT_EQ(parse_case(text, "case.toml").substrate->branches[1].time, 3);
}

TEST(BranchCase, OfAGelKeepsItsPowerLaw) {
  const Case c = parse_case(small(), "case.toml", gel);
  EXPECT_TRUE(c.substrate->has_branches());
  EXPECT_TRUE(c.substrate->branches.empty());
  EXPECT_EQ(c.substrate->viscosity, 0);
  const Case again = parse_case(write_case(c), "again.toml");
  EXPECT_EQ(all_branches(*again.substrate).size(), 10);
  EXPECT_EQ(write_case(again), write_case(c));
}

TEST(BranchCase, RefusesWhatIsNone) {
  tells(small() + "\n[[substrate.branch]]\ntime = 1\n", {},
        {"substrate.branch[0].modulus is missing", "write for example modulus = 0.26"});
  tells(small() + two, {"substrate.branch[1].time=0"}, {"substrate.branch[1].time", "(0, inf)"});
  tells(small() + two, {"substrate.branch[2].time=1"}, {"substrate.branch[2].time", "the case has 2 of these tables"});
  tells(small() + "\n[[substrate.branch]]\nmodulos = 1\n", {}, {"substrate.branch[0].modulos", "did you mean"});
  std::string many;
  for (int i = 0; i < 7; ++i) many += two;
  tells(small() + many, {}, {"substrate.branch[0].modulus", "with 14 branches", "there may be 12"});
  tells(small() + two, with(gel, "substrate.gel.decades=[-3,2]"), {"with 14 branches", "substrate.gel makes 12"});
}

TEST(BranchCase, RefusesAGelThatIsNone) {
  tells(small(), {"substrate.gel.exponent=1"}, {"substrate.gel.exponent", "[0, 1)", "substrate.viscosity = G time"});
  tells(small(), {"substrate.gel.exponent=0.5"}, {"substrate.gel.time", "above 0"});
  tells(small(), with(gel, "substrate.gel.decades=[2,-2]"), {"substrate.gel.decades", "1 to 8 decades, not -4"});
  tells(small(), with(gel, "substrate.gel.decades=[2]"), {"substrate.gel.decades", "must be 2 numbers"});
}

TEST(BranchCase, RefusesWhatBranchesDoNotGoWith) {
  const std::string stretched = "substrate.prestretch=[1.1]";
  tells(pull_text() + two, {stretched}, {"substrate.branch[0].modulus", "substrate.prestretch"});
  EXPECT_EQ(message_of(pull_text() + two), "(accepted)") << "finite strains";
  EXPECT_EQ(message_of(pull_text(), gel), "(accepted)") << "finite strains";
  for (const char* scheme : {"rkl2", "ssp_rk3"})
    tells(small() + two, {std::string("time.scheme=") + scheme},
          {"substrate.branch[0].modulus", "generalized_alpha", scheme});
  tells(small() + two, {"substrate.young=1 + x"}, {"substrate.branch[0].modulus", "the same substrate.young"});
  for (const char* scheme : {"automatic", "kick_drift"})
    EXPECT_EQ(message_of(small() + two, {std::string("time.scheme=") + scheme}), "(accepted)");
}

}  // namespace
}  // namespace softwet::branch_cases
