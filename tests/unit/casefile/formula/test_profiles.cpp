// Numbers of a case that vary: texts become formulas and come back, and wrong ones are reported with their place.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "case/cap.hpp"
#include "casefile/formula/profiles.hpp"
#include "run/host/fingerprint.hpp"
#include "unit/casefile/bad_case.hpp"
#include "unit/io/expect_error.hpp"
#include "unit/io/scratch_folder.hpp"

namespace softwet {
namespace {

using testing_tools::message_of;
using testing_tools::pull_text;
using testing_tools::replaced;

Case pull_with(const std::vector<std::string>& settings) { return parse_case(pull_text(), "case.toml", settings); }

TEST(Profiles, ANumberInQuotesIsANumber) {
  const Case c = pull_with({"substrate.young=\"1/4\""});
  EXPECT_FALSE(c.substrate->young.varies());
  EXPECT_EQ(c.substrate->young.number, 0.25);
  EXPECT_EQ(c.substrate->young_modulus(), 0.25);
  EXPECT_NE(write_case(c).find("\nyoung = 0.25\n"), std::string::npos);
}

TEST(Profiles, AnExpressionKnowsThePositionAndTheScene) {
  const Case c = pull_with({"substrate.young=2 + x/Lx + 8*y/H + 0*(g + h + pi + Ly)"});
  const Profile& young = c.substrate->young;
  ASSERT_TRUE(young.varies());
  EXPECT_DOUBLE_EQ(young.at({0.5, 0.0625, 0}), 6.5);
  EXPECT_DOUBLE_EQ(young.least(), 2);
  EXPECT_DOUBLE_EQ(young.most(), 11);
  EXPECT_DOUBLE_EQ(c.substrate->young_modulus(), 2) << "one number stands for the softest place";
  EXPECT_DOUBLE_EQ(pull_with({"substrate.young=h/g"}).substrate->young.number, 0.5);
}

TEST(Profiles, TheResolvedCaseReadsBackAsItself) {
  const Case c = pull_with({"substrate.young=1 + 0.5*x", "fluid.contact_angle=75 + 0*x", "load.factor=cos(t)",
                            "initial.density=0.2 + 0.1*x", "initial.velocity=[0.5, \"x*y\"]"});
  const std::string text = write_case(c);
  for (const char* line : {"\nyoung = \"1 + 0.5*x\"\n", "\nfactor = \"cos(t)\"\n", "\nvelocity = [\"0.5\", \"x*y\"]\n",
                           "\ndensity = \"0.2 + 0.1*x\"\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  const Case again = parse_case(text, "again.toml");
  EXPECT_EQ(write_case(again), text);
  EXPECT_EQ(fingerprint(again), fingerprint(c));
  EXPECT_DOUBLE_EQ(again.initial->velocity[0].at({0, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(again.initial->velocity[1].at({2, 3, 0}), 6);
  EXPECT_DOUBLE_EQ(again.loads[0].factor.at({0, 0, 0}, 1), std::cos(1.0));
}

TEST(Profiles, AConstantExpressionIsANumberAndKeepsItsText) {
  const Case c = pull_with({"substrate.young=48*g"});
  EXPECT_FALSE(c.substrate->young.varies());
  EXPECT_DOUBLE_EQ(c.substrate->young.number, 0.75);
  EXPECT_NE(write_case(c).find("\nyoung = \"48*g\"\n"), std::string::npos);
}

TEST(Profiles, MistakesNameKeyTextAndColumn) {
  const auto tells = [](const std::string& setting, std::initializer_list<std::string> parts) {
    const std::string message = message_of(pull_text(), {setting});
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
  };
  tells("substrate.young=1 + 2*foo",
        {"substrate.young = \"1 + 2*foo\"", "column 7", "'foo' is not known", "Lx", "tanh"});
  tells("substrate.young=1 + z", {"column 5", "'z' is not known"});
  tells("load.factor=1 + x", {"load[0].factor", "column 5", "'x' is not known", "known are t"});
  tells("substrate.young=soft", {"substrate.young", "'soft' is not known"});
  tells("substrate.young=\"0,5\"", {"a decimal number has a point", "write young = 0.5"});
  tells("substrate.young=true", {"substrate.young = true", "number, expression or table"});
  tells("initial.velocity=[0, \"1 +\"]", {"initial.velocity", "number 2 of the list: column 4"});
  tells("initial.velocity=[0, 0, 0]", {"initial.velocity", "2 numbers"});
  tells("initial.velocity=\"x\"", {"initial.velocity", "list of numbers, expressions"});
  const std::string in_file = message_of(replaced(pull_text(), "young = 0.7554", "young = \"x +\""));
  EXPECT_EQ(in_file.rfind("case.toml:", 0), 0u) << in_file;
}

TEST(Profiles, ValuesOutOfRangeAreReportedWithTheirPosition) {
  const auto tells = [](const std::string& setting, std::initializer_list<std::string> parts) {
    const std::string message = message_of(pull_text(), {setting});
    for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
  };
  tells("substrate.young=0.5 - x", {"is 0 at (0.5, 0) and must be a number in (0, inf)"});
  tells("fluid.contact_angle=170 + 20*x", {"is 180 at (0.5, 0.125)", "(0, 180)"});
  tells("substrate.young=1/(x - 0.5)^2", {"substrate.young", "inf at (0.5, 0)"});
  tells("substrate.young=1e31*(1 + x)", {"is 1e+31 at (0, 0)"});
  tells("substrate.young=-2*g", {"is -0.03125 and must be a number in (0, inf)"});
  tells("load.factor=ln(10 - t)", {"load[0].factor", "nan at t = "});
  tells("initial.density=0.5 + x", {"initial.density", "at (0.5, 0.125)", "(0, 0.999]"});
  tells("initial.density=1.5", {"initial.density = 1.5", "(0, 0.999]"});
  tells("initial.displacement=[0, \"sqrt(x - 0.5)\"]", {"initial.displacement", "nan at (0, 0)"});
  EXPECT_EQ(message_of(pull_text(), {"fluid.contact_angle=100 + 1000*(y - H)"}), "(accepted)")
      << "only the wall counts";
  EXPECT_EQ(message_of(pull_text(), {"load.factor=ln(t + 1e-9)"}), "(accepted)") << "the load begins at t = 0";
}

TEST(Profiles, OneOutOfRangeIsFoundInSpaceOnManyElements) {
  const std::string text =
      "name='s'\ndomain={size=[1,1,1],elements=[200,200,200]}\nsubstrate={thickness=1,young='2 - "
      "x*y*z*2.0001',poisson=0}\n"
      "time.end=1\n";
  EXPECT_NE(message_of(text).find("at (1, 1, 1)"), std::string::npos) << "corners are always looked at";
}

TEST(Profiles, InSpaceZIsTheHeight) {
  const Case c = parse_case(
      "name='s'\ndomain={size=[1,2,3],elements=[4,4,6]}\nsubstrate={thickness=3,young='1 + y/Ly + z/Lz',poisson=0}\n"
      "time.end=1\ninitial={displacement=[0,0,'0.1*z']}\n",
      "case.toml");
  EXPECT_DOUBLE_EQ(c.substrate->young.at({0.3, 1, 1.5}), 2);
  EXPECT_DOUBLE_EQ(c.substrate->young.most(), 3);
  EXPECT_DOUBLE_EQ(c.initial->displacement[2].at({0, 0, 2}), 0.2);
}

TEST(Profiles, TheAngleOfACapIsThatAtItsPlace) {
  const Case c = pull_with({"fluid.contact_angle=60 + 60*x", "droplet.centre=[0.4, 0.125]", "droplet.radius=0.1"});
  EXPECT_NEAR(cap_cosine(c, c.droplets[0]), std::cos(84 * std::acos(-1.0) / 180), 1e-14);
  EXPECT_FALSE(c.has_energy_law()) << "the gradient law feeds the energy but at 90 degrees";
}

TEST(Profiles, TablesAreFoundBesideTheCaseAndAgainFromTheResult) {
  const ScratchFolder folder;
  overwrite(folder / "stiffness.csv", "x,value\n0,1\n1,3\n");
  overwrite(folder / "case.toml", replaced(pull_text(), "young = 0.7554", "young = \"stiffness.csv\""));
  const Case c = read_case(folder / "case.toml");
  ASSERT_TRUE(c.substrate->young.varies());
  EXPECT_DOUBLE_EQ(c.substrate->young.at({0.25, 0, 0}), 1.5);
  std::filesystem::create_directory(folder / "out");
  overwrite(folder / "out/case.toml", write_case(c));
  const Case again = read_case(folder / "out/case.toml");
  EXPECT_EQ(write_case(again), write_case(c));
  EXPECT_DOUBLE_EQ(again.substrate->young.at({0.25, 0, 0}), 1.5);
  const Case set = read_case(folder / "case.toml", {"substrate.young=stiffness.csv"});
  EXPECT_EQ(write_case(set), write_case(c)) << "also --set is relative to the folder of the case";
  expect_error(Exit::invalid_input,
               {"substrate.young = \"other.csv\"", "other.csv cannot be read", "folder of the case"},
               [&] { read_case(folder / "case.toml", {"substrate.young=other.csv"}); });
}

TEST(Profiles, ARunGoesOnWithATableOfTheSameValuesOnly) {
  const ScratchFolder folder;
  const auto read = [&](const std::string& name, const std::string& table) {
    overwrite(folder / name, table);
    overwrite(folder / "case.toml", pull_text());
    return read_case(folder / "case.toml", {"load.factor=" + name});
  };
  const std::string stored = fingerprint(read("a.csv", "t,value\n0,1\n10,2\n"));
  EXPECT_NO_THROW(check_fingerprint("checkpoint.h5", stored, read("b.csv", "t,value\n0,1\n10,2\n")));
  expect_error(Exit::invalid_input, {"load[0].factor"},
               [&] { check_fingerprint("checkpoint.h5", stored, read("a.csv", "t,value\n0,1\n10,3\n")); });
}

TEST(Profiles, ACheckpointOfAnOlderProgramHasNoFactor) {
  const Case c = pull_with({});
  std::string stored = fingerprint(c);
  const auto line = stored.find("load[0].factor = 1\n");
  ASSERT_NE(line, std::string::npos);
  stored.erase(line, std::string("load[0].factor = 1\n").size());
  EXPECT_NO_THROW(check_fingerprint("checkpoint.h5", stored, c));
}

TEST(Profiles, AContactAngleThatJumpsIsWarnedOf) {
  const auto told = [](const std::string& angle) {
    const auto found = warnings(pull_with({"fluid.wall_law=energy", "fluid.contact_angle=" + angle}));
    return found.empty() ? std::string() : found.front();
  };
  EXPECT_NE(told("x < 0.3 ? 60 : 100").find("fluid.contact_angle jumps by 40 degrees at x = 0.3,"), std::string::npos)
      << told("x < 0.3 ? 60 : 100");
  for (const char* smooth : {"60 + 40*step((x - 0.3)/h)", "60 + 40*x", "x < 0.3 ? 60 : 60.5", "75"})
    EXPECT_EQ(told(smooth), "") << smooth;
}

TEST(Profiles, ATableOverTimeWithManyPointsIsWarnedOf) {
  const ScratchFolder folder;
  const auto told = [&](int points) {
    std::string table = "t,value\n";
    for (int i = 0; i < points; ++i) table += std::to_string(0.001 * (i + 1)) + ",1\n";
    overwrite(folder / "pulses.csv", table);
    const auto found = warnings(pull_with({"load.factor=" + (folder / "pulses.csv")}));
    return found.empty() ? std::string() : found.front();
  };
  EXPECT_NE(told(20000).find("load[0].factor is a table with 20000 points before time.end, and a step ends at each"),
            std::string::npos);
  EXPECT_EQ(told(1000), "");
}

TEST(Profiles, ASceneIsReadWithoutItsTables) {
  const ScratchFolder folder;
  overwrite(folder / "young.csv", "x,value\n0,1\n1,2\n");
  const Case c = pull_with({"substrate.young=" + (folder / "young.csv")});
  overwrite(folder / "case.toml", write_case(c));
  std::filesystem::remove(folder / "young.csv");
  expect_error(Exit::invalid_input, {"young.csv cannot be read"}, [&] { read_case(folder / "case.toml"); });
  const Case scene = read_scene(folder / "case.toml");
  EXPECT_EQ(scene.domain.elements, c.domain.elements);
  EXPECT_EQ(scene.substrate->thickness, c.substrate->thickness);
}

TEST(Profiles, ExplainSaysWhatIsKnown) {
  for (const char* part : {"x, y", "Lx", "H (substrate.thickness)", "step(s)", "log (both of base e)", "avg", ".csv",
                           "default 90", "(0, 180)"})
    EXPECT_NE(explain("fluid.contact_angle").find(part), std::string::npos) << part;
  EXPECT_NE(explain("load.factor").find("the time t"), std::string::npos);
  EXPECT_EQ(explain("fluid.viscosity").find(".csv"), std::string::npos);
}

}  // namespace
}  // namespace softwet
