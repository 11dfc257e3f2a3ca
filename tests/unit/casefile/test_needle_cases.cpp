// Cases with needles, accepted and refused.
#include <fmt/core.h>

#include "casefile/checks/stiff_parts.hpp"
#include "unit/casefile/bad_case.hpp"

namespace softwet::testing_tools {
namespace {

std::string with(const std::string& more) {
  return pull_text() + "\n[[needle]]\nbox = [[0.7, 0.0], [0.8, 0.125]]\n" + more;
}
std::string needle() { return with("stiffness = 2e5\npath = [\"0.01*t\", 0]\n"); }

void tells(const std::string& text, const std::vector<std::string>& settings, const std::vector<std::string>& parts) {
  expect_parts(message_of(text, settings), parts);
}

TEST(NeedleCase, IsReadAndWritten) {
  const Case c = parse_case(needle(), "case.toml");
  ASSERT_EQ(c.needles.size(), 1);
  EXPECT_EQ(c.needles[0].stiffness, 2e5);
  EXPECT_DOUBLE_EQ(c.needles[0].place(0, 3), 0.03);
  EXPECT_EQ(c.needles[0].place(0, -3), 0) << "it stands still before t = 0";
  EXPECT_EQ(c.needles[0].place(1, 3), 0);
  const Case again = parse_case(write_case(c), "again.toml");
  EXPECT_EQ(write_case(again), write_case(c));
  EXPECT_EQ(parse_case(with("stiffness = 1"), "case.toml").needles[0].place(1, 3), 0) << "without a path it rests";
}

// A path as a table in the case: rows [t, x, y].
TEST(NeedleCase, HasAPathAsATable) {
  const Case c = parse_case(with("stiffness = 2e5\npath = [[0, 0, 0], [2, 0.1, 0], [4, 0.1, \"-1/16\"]]\n"),
                            "case.toml", {"load.path=[[0,0,0],[3,0.3,0]]", "load.factor=[[0,1],[4,3]]"});
  EXPECT_DOUBLE_EQ(c.needles[0].place(0, 1), 0.05);
  EXPECT_DOUBLE_EQ(c.needles[0].place(0, 3), 0.1);
  EXPECT_DOUBLE_EQ(c.needles[0].place(1, 3), -1.0 / 32);
  EXPECT_DOUBLE_EQ(c.needles[0].place(1, 9), -1.0 / 16) << "behind its end it stays";
  EXPECT_EQ(c.needles[0].path[0].formula->kinks(), (std::vector<double>{0, 2, 4}));
  EXPECT_DOUBLE_EQ(c.loads[0].path[0].at({}, 1), 0.1);
  EXPECT_DOUBLE_EQ(c.loads[0].factor.at({}, 2), 2);
  const Case again = parse_case(write_case(c), "again.toml");
  EXPECT_EQ(write_case(again), write_case(c));
  EXPECT_DOUBLE_EQ(again.needles[0].place(1, 3), -1.0 / 32);
}

TEST(NeedleCase, RefusesTablesThatAreNone) {
  tells(needle(), {"needle.path=[[0,0],[1,1]]"}, {"needle[0].path", "must be 2 numbers"});
  tells(needle(), {"needle.path=[[0,0,0],[1,1]]"}, {"needle[0].path", "[[t, x, y], ...]"});
  tells(needle(), {"needle.path=[[0,0,0],[0,1,0]]"}, {"needle[0].path", "t = 0 after 0", "times that increase"});
  tells(needle(), {"needle.path=['[[0, a]]',0]"}, {"needle[0].path", "'a'", "not a number"});
  tells(needle(), {"substrate.young=[[0,1],[1,2]]"}, {"substrate.young", "does not vary in time"});
  tells(needle(), {"load.factor=[[0,1,2],[1,2,3]]"}, {"load[0].factor", "[[t, value], ...]"});
}

// Where the last digit of a displacement is a thousandth of what the solid resists.
TEST(NeedleCase, RefusesAStiffnessWhoseReadingLacksDigits) {
  Case c = parse_case(needle(), "case.toml");
  const double young = c.substrate->young_modulus(), last = 2.220446049250313e-16, most = 1e-3 * young / last;
  EXPECT_DOUBLE_EQ(largest_needle_stiffness(c, {}), most) << "the layer is 1 long";
  c.needles[0].path[0] = -4;
  EXPECT_DOUBLE_EQ(largest_needle_stiffness(c, c.needles[0]), most / 4);
  const auto asks = [&](double times) { return message_of(with(fmt::format("stiffness = {:.17g}", times * most))); };
  EXPECT_EQ(asks(0.99), "(accepted)");
  expect_parts(asks(1.01),
               {"needle[0].stiffness", fmt::format("(0, {:.2g}]", most), "three digits", "write for example"});
}

TEST(NeedleCase, RefusesWhatIsNone) {
  tells(with(""), {}, {"needle[0].stiffness is missing", "stiffness = 1e5"});
  tells(needle(), {"needle.stiffness=0"}, {"needle[0].stiffness", "(0, inf)"});
  tells(needle(), {"needle.box=[[0.7,0],[0.7,0.1]]"}, {"needle[0].box", "empty along axis 0"});
  tells(needle(), {"needle.box=[[0.7,0],[0.8,0.2]]"}, {"needle[0].box", "outside the solid", "[0, 0.125]"});
  tells(needle(), {"needle.path=[0.1]"},
        {"needle[0].path", "must be 2 numbers", "write one displacement for each axis"});
  tells(needle(), {"needle.path=[\"x\",0]"}, {"needle[0].path", "'x' is not known", "known are t"});
  tells(needle(), {"needle.path=[\"ln(5 - t)\",0]"}, {"needle[0].path", "at t = "});
  EXPECT_EQ(message_of(needle(), {"needle.path=[\"ln(t + 1e-9)\",0]"}), "(accepted)") << "before t = 0 it stands still";
}

TEST(NeedleCase, NeedsASolid) {
  const std::string rigid =
      "[domain]\nsize = [1, 0.5]\nelements = [16, 8]\n[fluid]\nviscosity = 0.01\ncapillarity = 0.1\n"
      "temperature = 0.5\n[time]\nend = 1\n[[needle]]\nbox = [[0.7, 0.0], [0.8, 0.125]]\nstiffness = 1\n";
  tells(rigid, {}, {"needle[0].box", "a needle holds a part of the solid", "remove the [[needle]]"});
}

TEST(NeedleCase, OnAnAxisOfSymmetryMovesAlongIt) {
  std::string text = replaced(needle(), "coordinates = \"plane\"", "coordinates = \"axisymmetric\"");
  text = replaced(text, "centre = [0.5, 0.125]", "centre = [0.0, 0.125]");
  text = replaced(text, "force = [0.16215, 0.0]", "force = [0.0, 0.16215]");
  tells(text, {}, {"needle[0].path", "must be 0 along the first axis", "along the axis of symmetry alone"});
  tells(text, {"needle.path=[0.1,0]"}, {"needle[0].path", "write 0 there"});
  EXPECT_EQ(message_of(text, {"needle.path=[0,\"0.1*t\"]"}), "(accepted)");
}

TEST(NeedleCase, NamesOfItsColumnsAreTaken) {
  const std::string probe = "[[probe]]\nname = \"needle_force_x\"\nquantity = \"density\"\npoint = [0.5, 0.3]\n";
  tells(needle() + probe, {}, {"probe[0].name", "is the name of a column"});
  EXPECT_EQ(message_of(pull_text() + "\n" + probe), "(accepted)");
}

}  // namespace
}  // namespace softwet::testing_tools
