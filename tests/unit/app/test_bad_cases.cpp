// Every way a case can be wrong: the message names place, key and remedy, in one line, with exit code 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <sstream>

#include "app/host/case_file.hpp"
#include "app/host/problems.hpp"
#include "case/error.hpp"
#include "unit/app/pull.hpp"

namespace softwet {
namespace {

using testing_tools::pull_text;

/// The pull scene with one text replaced, and what the message must contain.
struct Bad {
  const char* name;
  std::string from, to;
  std::vector<std::string> parts;
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  return position == std::string::npos ? text : text.replace(position, from.size(), to);
}

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_case(text, "case.toml", overrides);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::invalid_input);
    return error.what();
  }
  return "(accepted)";
}

class BadCase : public testing::TestWithParam<Bad> {};

TEST_P(BadCase, IsRefusedWithPlaceKeyAndRemedy) {
  const std::string message = message_of(replaced(pull_text(), GetParam().from, GetParam().to));
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(message.rfind("case.toml", 0), 0u) << message;
  for (const std::string& part : GetParam().parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

INSTANTIATE_TEST_SUITE_P(
    Pull, BadCase,
    testing::Values(
        Bad{"UnknownKey",
            "viscosity =",
            "viscosty =",
            {"fluid.viscosty", "unknown key", "did you mean fluid.viscosity"}},
        Bad{"UnknownTable", "[fluid]", "[fluids]", {"fluids", "did you mean the table [fluid]"}},
        Bad{"UnknownWord", "\"no_slip\"", "\"noslip\"", {"boundary.top", "\"noslip\"", "did you mean \"no_slip\""}},
        Bad{"MissingKey", "viscosity = \"1/256\"", "", {"fluid.viscosity is missing", "viscosity = \"1/256\""}},
        Bad{"WrongType",
            "elements = [128, 64]",
            "elements = \"many\"",
            {"domain.elements", "whole numbers", "[128, 64]"}},
        Bad{"NoWholeNumber", "[128, 64]", "[128.5, 64]", {"domain.elements", "whole numbers"}},
        Bad{"BrokenRatio", "\"1/256\"", "\"1/0\"", {"fluid.viscosity = \"1/0\"", "number in (0, inf)"}},
        Bad{"Boolean", "radius = 0.155", "radius = true", {"droplet[0].radius = true", "number"}},
        Bad{"Infinite", "radius = 0.155", "radius = inf", {"droplet[0].radius = inf", "(0, inf)"}},
        Bad{"NotANumber", "young = 0.7554", "young = nan", {"substrate.young = nan", "(0, inf)"}},
        Bad{"Huge", "young = 0.7554", "young = 1e300", {"substrate.young = 1e+300", "between 1e-30 and 1e+30"}},
        Bad{"Tiny", "[1.0, 0.5]", "[1.0, 1e-300]", {"domain.size = [1, 1e-300]", "between 1e-30 and 1e+30"}},
        Bad{"HugeInABox", "[0.8, 0.125]]", "[0.8, -1e31]]", {"load[0].box", "between 1e-30 and 1e+30"}},
        Bad{"SingleBrackets", "[[droplet]]", "[droplet]", {"droplet", "[[droplet]]"}},
        Bad{"DoubleBrackets", "[fluid]", "[[fluid]]", {"fluid", "stands once", "[fluid]"}},
        Bad{"BrokenToml", "[fluid]", "[fluid", {"not TOML"}},
        Bad{"NegativeSize", "size = [1.0, 0.5]", "size = [1.0, -0.5]", {"domain.size = [1, -0.5]", "(0, inf)"}},
        Bad{"OneAxis", "size = [1.0, 0.5]", "size = [1.0]", {"domain.size", "2 numbers"}},
        Bad{"ElementsOfOtherLength", "[128, 64]", "[128, 64, 4]", {"domain.elements", "2 numbers"}},
        Bad{"ZeroElements", "[128, 64]", "[128, 0]", {"domain.elements", "[1, 100000]"}},
        Bad{"MoreUnknownsThanNumbers",
            "[128, 64]",
            "[100000, 100000]",
            {"domain.elements", "4e+10 unknowns", "2147483647"}},
        Bad{"Degree", "degree = 2", "degree = 4", {"domain.degree = 4", "[2, 3]"}},
        Bad{"Critical", "temperature = 0.39", "temperature = 1.0", {"fluid.temperature", "[0.3, 1)", "choose below 1"}},
        Bad{"TooCold", "temperature = 0.39", "temperature = 0.1", {"fluid.temperature", "[0.3, 1)"}},
        Bad{"AngleHigh", "contact_angle = 75.0", "contact_angle = 180", {"fluid.contact_angle = 180", "(0, 180)"}},
        Bad{"AngleLow", "contact_angle = 75.0", "contact_angle = 0", {"fluid.contact_angle = 0", "(0, 180)"}},
        Bad{"Poisson", "poisson = 0.45", "poisson = 0.5", {"substrate.poisson = 0.5", "(-1, 0.5)"}},
        Bad{"ThicknessNoMultiple",
            "thickness = 0.125",
            "thickness = 0.13",
            {"substrate.thickness = 0.13", "0.0078125", "0.125 or 0.1328125"}},
        Bad{"ThicknessAll", "thickness = 0.125", "thickness = 0.5", {"substrate.thickness", "(0, 0.5)"}},
        Bad{"LoadOutside", "[0.8, 0.125]]", "[0.8, 0.2]]", {"load[0].box", "outside the solid", "[0, 0.125]"}},
        Bad{"LoadEmpty", "[0.8, 0.125]]", "[0.7, 0.125]]", {"load[0].box", "empty along axis 0"}},
        Bad{"LoadNoBox",
            "[[0.7, 0.0], [0.8, 0.125]]",
            "[0.7, 0.8]",
            {"load[0].box", "[[lower corner], [upper corner]]"}},
        Bad{"ForceOfOtherLength", "[0.16215, 0.0]", "[0.1, 0, 0]", {"load[0].force", "2 numbers"}},
        Bad{"NegativeRamp", "ramp = 5.0", "ramp = -5.0", {"load[0].ramp = -5", "[0, inf)"}},
        Bad{"NegativeStart", "start = 30.0", "start = -1", {"load[0].start = -1", "[0, inf)"}},
        Bad{"DropletInSolid",
            "centre = [0.5, 0.125]",
            "centre = [0.5, 0.1]",
            {"droplet[0].centre", "outside the fluid"}},
        Bad{"DropletOutside",
            "centre = [0.5, 0.125]",
            "centre = [1.5, 0.125]",
            {"droplet[0].centre", "outside the fluid"}},
        Bad{"DropletThroughSide",
            "centre = [0.5, 0.125]",
            "centre = [0.1, 0.125]",
            {"droplet[0].radius", "left side", "0.1"}},
        Bad{"DropletThroughTop",
            "centre = [0.5, 0.125]",
            "centre = [0.5, 0.4]",
            {"droplet[0].radius", "top side", "0.1"}},
        Bad{"HalfPeriodic",
            "right = \"slip\"",
            "right = \"periodic\"",
            {"boundary.right", "boundary.left = \"periodic\""}},
        Bad{"FreeSideOfTheFluid",
            "right = \"slip\"",
            "right = \"free\"",
            {"boundary.right", "closed to mass", "no_slip"}},
        Bad{"FrontIn2D", "right = \"slip\"", "front = \"slip\"", {"boundary.front", "3D"}},
        Bad{"EndZero", "end = 1884.0", "end = 0", {"time.end = 0", "(0, inf)"}},
        Bad{"RhoInf", "rho_inf = 0.5", "rho_inf = 1.5", {"time.rho_inf = 1.5", "[0, 1]"}},
        Bad{"StepsOutOfOrder", "dt_max = 50", "dt_max = 1e-3", {"time.dt", "dt_max"}},
        Bad{"TimesNotSorted", "[0.0, 235.0,", "[235.0, 0.0,", {"output.fields.times", "increase"}},
        Bad{"TimesTooEarly", "[0.0, 235.0,", "[-31.0, 235.0,", {"output.fields.times", "-30"}},
        Bad{"TimesOfNoRange",
            "times = [0.0, 235.0, 471.0, 1884.0]",
            "times = '0:5'",
            {"output.fields.times", "first:last:count", "[0.0, 235.0"}},
        Bad{"TimesRepeated",
            "times = [0.0, 235.0,",
            "times = ['0:235:3', '100:235:3',",
            {"output.fields.times", "increase"}},
        Bad{"FieldMisspelt",
            "fields.select = []",
            "fields.select = ['velocity', 'presure']",
            {"output.fields.select", "\"pressure\""}},
        Bad{"IntervalNegative", "fields.every = 0", "fields.every = -1", {"output.fields.every = -1", "[0, inf)"}},
        Bad{"TooManyFieldFiles",
            "fields.every = 0",
            "fields.every = 0.1",
            {"output.fields.every = 0.1", "1.88e+04", "10000", "write every = 0.19"}},
        Bad{"BadName", "\"tensotaxis_pull_2d\"", "\"../x\"", {"name = \"../x\"", "letters"}}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(BadCases, NameTheLine) {
  EXPECT_EQ(message_of("name = 'x'\n\n[fluid]\nviscosity = -1\n").rfind("case.toml:4: fluid.viscosity = -1", 0), 0u);
}

TEST(BadCases, TextThatTheTomlLibraryOnlyAssertsOnIsASyntaxErrorOfItsLine) {
  EXPECT_EQ(message_of("name = 'x'\nb = [ }\nc = 1\n").rfind("case.toml:2: this is not TOML", 0), 0u);
  EXPECT_NE(message_of(pull_text(), {"load[0].force=[ }"}).find("load[0].force"), std::string::npos);
}

TEST(BadCases, LongTextIsRefusedSoonWithAShortMessage) {
  std::string lines;
  for (int i = 0; i < 20000; ++i) lines += "a" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(message_of(lines + "b = [ }\nc = 1\n").rfind("case.toml:20001: this is not TOML", 0), 0u);
  const std::string name(1000000, 'x');
  for (const std::string& message : {message_of(name + " = 1"), message_of(pull_text(), {name + "=1"}),
                                     message_of(replaced(pull_text(), "\"no_slip\"", "\"" + name + "\""))}) {
    EXPECT_LT(message.size(), 2000u);
    EXPECT_EQ(message.find("did you mean"), std::string::npos);
  }
}

/// The lines of a message, without the place of each.
std::vector<std::string> lines_of(const std::string& message) {
  std::vector<std::string> lines;
  std::istringstream stream(message);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(BadCases, AllMistakesAreToldInTheOrderOfTheFile) {
  std::string text = replaced(pull_text(), "viscosity = \"1/256\"", "viscosity = 1/256");
  text = replaced(text, "temperature = 0.39", "temprature = 0,39");
  text = replaced(text, "poisson = 0.45", "poisson = 0.5");
  text = replaced(text, "radius = 0.155", "");
  text = replaced(text, "[0.8, 0.125]]", "[0.8, 0.2]]");
  const std::vector<std::string> lines = lines_of(message_of(text, {"time.end=-1", "name=\"../x\""}));
  const std::vector<std::string> expected{"fluid.viscosity = 1/256",
                                          "fluid.temprature = 0,39",
                                          "substrate.poisson = 0.5",
                                          "--set time.end=-1",
                                          "droplet[0].radius is missing",
                                          "name = \"../x\"",
                                          "load[0].box"};
  for (const std::string& part : expected) {
    const bool told = std::any_of(lines.begin(), lines.end(),
                                  [&](const std::string& line) { return line.find(part) != std::string::npos; });
    EXPECT_TRUE(told) << part << "\n" << message_of(text, {"time.end=-1", "name=\"../x\""});
  }
}

TEST(BadCases, NoMistakeIsToldTwiceNorOneThatFollowsFromAnother) {
  const auto count = [](const std::string& from, const std::string& to, const std::vector<std::string>& set = {}) {
    return lines_of(message_of(replaced(pull_text(), from, to), set)).size();
  };
  EXPECT_EQ(count("viscosity =", "viscosty ="), 1u) << "not also missing";
  EXPECT_EQ(count("[fluid]", "[fluids]"), 1u) << "nor a droplet without a fluid";
  EXPECT_EQ(count("[substrate]", "[substrat]"), 1u) << "nor a load without a solid, a droplet in the air";
  EXPECT_EQ(count("size = [1.0, 0.5]", "size = [1.0]"), 1u);
  EXPECT_EQ(count("size = [1.0, 0.5]", "size = [1,0, 0,5]"), 1u);
  EXPECT_EQ(count("thickness = 0.125", "thickness = 0.13"), 1u) << "nor a load outside the solid";
  EXPECT_EQ(count("radius = 0.155", "radius = -1"), 1u);
  EXPECT_EQ(count("start = 30.0", "start = -1", {"output.fields.times=[-20,0]"}), 1u);
}

TEST(BadCases, TwentyMistakesAreEnough) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  const std::vector<std::string> lines = lines_of(message_of(text));
  EXPECT_EQ(lines.size(), Problems::most + 1);
  EXPECT_NE(lines.back().find("20 mistakes"), std::string::npos);
}

TEST(BadCases, ClearMistakesInTheSyntaxAreCalledByTheirName) {
  const auto told = [](const std::string& line, const std::vector<std::string>& parts) {
    const std::string message = message_of(replaced(pull_text(), "ramp = 5.0", line));
    for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
    EXPECT_EQ(lines_of(message).size(), 1u) << message;
  };
  told("ramp = 1/2", {"load[0].ramp = 1/2", "a ratio stands in quotes", "ramp = \"1/2\""});
  told("ramp = 0,5  # half", {"load[0].ramp = 0,5:", "a point, not a comma", "ramp = 0.5"});
  told("ramp = .5", {"load[0].ramp = .5", "digits on both sides", "ramp = 0.5"});
  told("ramp = 5 s", {"load[0].ramp = 5 s", "no units", "ramp = 5 ", "softwet units"});
  told("ramp =", {"load[0].ramp", "has no value"});
  told("ramp: 5", {"load[0].ramp", "joined by '='", "ramp = 5"});
  EXPECT_NE(message_of(replaced(pull_text(), "left = \"slip\"", "left = slip")).find("left = \"slip\""),
            std::string::npos);
  EXPECT_NE(message_of(replaced(pull_text(), "force = [0.16215, 0.0]", "force = [1/8, 0.0]")).find("[\"1/8\", 0.0]"),
            std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"load.ramp=0,5"}).find("write ramp = 0.5"), std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"droplet.centre=[0,5, 0,125]"}).find("a comma begins the next number"),
            std::string::npos);
}

TEST(BadCases, OnlyWhatIsNearIsSuggested) {
  const auto in_fluid = [](const std::string& line) {
    return message_of(replaced(pull_text(), "[fluid]", "[fluid]\n" + line));
  };
  for (const std::string& message : {in_fluid("magnetism = 1"), message_of(pull_text(), {"substrate.model=\"neo\""})}) {
    EXPECT_EQ(message.find("did you mean"), std::string::npos) << message;
    EXPECT_NE(message.find("has the keys"), std::string::npos) << message;
  }
  EXPECT_NE(in_fluid("density = 1").find("density is a key of [substrate]; [fluid] has the keys"), std::string::npos);
  EXPECT_NE(in_fluid("angle = 1").find("did you mean fluid.contact_angle"), std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"magnetism=1"}).find("the tables are [domain], [fluid]"), std::string::npos);
  const std::string load = message_of(replaced(pull_text(), "[boundary]", "[boundary]\nload = { box = 1 }"));
  EXPECT_NE(load.find("boundary.load"), std::string::npos) << load;
}

TEST(BadCases, ATableInlineThatStandsOnceIsAskedForInDoubleBrackets) {
  const std::string message = message_of("load = { box = [[0,0],[1,1]], force = [1,0] }\n" +
                                         pull_text().substr(0, pull_text().find("[[load]]")) +
                                         pull_text().substr(pull_text().find("[boundary]")));
  EXPECT_NE(message.find("load = {...}: is a list of tables"), std::string::npos) << message;
  EXPECT_NE(message.find("[[load]]"), std::string::npos) << message;
}

TEST(BadCases, TheBeginningOfTheComputationIsNeverMinusZero) {
  const std::string message = message_of(pull_text(), {"load[0].start=0", "output.fields.times=[-1,0]"});
  EXPECT_NE(message.find("must be at least 0,"), std::string::npos) << message;
}

TEST(BadCases, EmptyFileOffersInit) {
  for (const char* text : {"", "# nothing\n"}) {
    EXPECT_NE(message_of(text).find("softwet init"), std::string::npos);
  }
}

TEST(BadCases, NoMaterialAsksForOne) {
  EXPECT_NE(message_of("name = 'x'").find("neither [fluid] nor [substrate]"), std::string::npos);
}

TEST(BadCases, LoadNeedsASubstrateDropletAFluid) {
  const std::string start = "name='x'\ntime.end=1\ndomain={size=[1,1],elements=[8,8]}\n";
  const std::string fluid = "fluid={viscosity=1,capillarity=1,temperature=0.5}\n";
  const std::string solid = "substrate={thickness=1,young=1,poisson=0}\n";
  EXPECT_NE(message_of(start + fluid + "[[load]]\nbox=[[0,0],[1,1]]\nforce=[1,0]").find("[substrate]"),
            std::string::npos);
  EXPECT_NE(message_of(start + solid + "[[droplet]]\ncentre=[0,0]\nradius=1").find("[fluid]"), std::string::npos);
  EXPECT_NE(message_of(start + "substrate={thickness=0.5,young=1,poisson=0}").find("solid alone"), std::string::npos);
}

TEST(BadCases, FieldsNeedTheirMaterial) {
  const std::string start = "name='x'\ntime.end=1\ndomain={size=[1,1],elements=[8,8]}\n";
  const std::string fluid = "fluid={viscosity=1,capillarity=1,temperature=0.5}\n";
  const std::string solid = "substrate={thickness=1,young=1,poisson=0}\n";
  EXPECT_NE(message_of(start + fluid + "output.fields.select=['density','cauchy_stress']").find("add a [substrate]"),
            std::string::npos);
  EXPECT_NE(message_of(start + solid + "output.fields.select=['density']").find("add a [fluid]"), std::string::npos);
}

TEST(BadCases, TooManyListedTimes) {
  std::string times = "output.fields.times=[";
  for (int i = 0; i < 10001; ++i) times += std::to_string(i) + ",";
  EXPECT_NE(message_of(pull_text(), {times + "]"}).find("10001 times, at most 10000"), std::string::npos);
}

TEST(BadCases, WhatIsThereAtTheStartHasToFit) {
  const auto complaint = [](const std::string& table) { return message_of(pull_text() + std::string("\n") + table); };
  const auto tells = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  tells(complaint("[[film]]\nbox=[[0,0.3],[1,0.2]]"), "film[0].box");
  tells(complaint("[[film]]\nbox=[[0,0.3],[1,0.2]]"), "empty along axis 1");
  tells(complaint("[[film]]\nbox=[[0],[1]]"), "2 numbers");
  tells(complaint("[[wave]]\nfield='speed'\namplitude=1\nmode=[1,0]"), "\"velocity_x\"");
  tells(complaint("[[wave]]\nfield='velocity_z'\namplitude=1\nmode=[1,0]"), "3D only");
  tells(complaint("[[wave]]\nfield='velocity_x'\namplitude=1\nmode=[1]"), "2 numbers");
  tells(complaint("[[wave]]\nfield='velocity_x'\namplitude=1\nmode=[0.5,0]"), "whole number along axis 0");
  tells(message_of(pull_text(), {"droplet[0].stretch=[1]"}), "droplet[0].stretch");
  tells(message_of(pull_text(), {"fluid.initial=[0.6,0.1]"}), "fluid.initial");
  tells(message_of(pull_text(), {"fluid.initial=[0.1,1.0]"}), "(0, 0.999]");
  EXPECT_NO_THROW(parse_case(pull_text(), "case.toml", {"droplet[0].centre=[0,0.125]"}))
      << "half a droplet on a slip side";
  EXPECT_NO_THROW(parse_case(pull_text(), "case.toml", {"droplet[0].centre=[1,0.125]"}));
  // A flat cap is narrower than its circle: R sin(30) = 0.4.
  const std::vector<std::string> flat{"fluid.contact_angle=30", "droplet[0].radius=0.8"};
  EXPECT_NO_THROW(parse_case(pull_text(), "case.toml", flat));
  tells(message_of(pull_text(), {"fluid.contact_angle=30", "droplet[0].radius=1.01"}), "crosses the left side");
}

TEST(BadCases, ATrackIsAHorizontalDirectionIn3D) {
  const std::string box =
      "name='x'\ntime.end=1\ndomain={size=[1,1,1],elements=[8,8,8]}\n"
      "fluid={viscosity=1,capillarity=1,temperature=0.5}\n";
  for (const char* track : {"[0, 0]", "[1]", "[1, 1, 0]"}) {
    const std::string message = message_of(box, {std::string("output.history.track=") + track});
    EXPECT_NE(message.find("output.history.track"), std::string::npos) << message;
    EXPECT_NE(message.find("track = [1, 1]"), std::string::npos) << message;
  }
  EXPECT_NE(message_of(pull_text(), {"output.history.track=[1, 1]"}).find("exists in 3D only"), std::string::npos);
}

TEST(BadCases, OverridesAreNamedAsThePlace) {
  EXPECT_EQ(message_of(pull_text(), {"fluid.viscosity=-1"}).rfind("--set fluid.viscosity=-1: fluid.viscosity = -1", 0),
            0u);
  EXPECT_NE(message_of(pull_text(), {"fluid.viscosty=1"}).find("did you mean fluid.viscosity"), std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"time.end"}).find("key=value"), std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"load[1].ramp=1"}).find("has 1 of these"), std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"load[x].ramp=1"}).find("load[0].ramp"), std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"solver=1"}).find("solver"), std::string::npos);
}

TEST(BadCases, UnreadablePathsSayWhy) {
  for (const char* path : {"/no/such/case.toml", "/"}) {
    try {
      read_case(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Exit::invalid_input);
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    }
  }
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

TEST(BadPrecision, UnknownWord) {
  expect_parts(message_of(pull_text(), {"solver.precision=half"}),
               {"solver.precision = \"half\"", "\"double\"", "\"mixed\"", "\"single\""});
}

TEST(BadPrecision, ExplicitSchemesAreDouble) {
  for (const char* precision : {"mixed", "single"})
    for (const char* scheme : {"ssp_rk3", "imex"})
      expect_parts(
          message_of(pull_text(), {std::string("solver.precision=") + precision, std::string("time.scheme=") + scheme}),
          {"solver.precision", precision, "generalized_alpha", scheme, "write \"automatic\""});
  EXPECT_EQ(message_of(pull_text(), {"solver.precision=mixed"}), "(accepted)");
  EXPECT_EQ(message_of(pull_text(), {"solver.precision=double", "time.scheme=imex"}), "(accepted)");
}

TEST(BadPrecision, DifferencesOfResidualsAreDouble) {
  expect_parts(message_of(pull_text(), {"solver.precision=mixed", "solver.krylov.jacobian=difference"}),
               {"solver.precision", "solver.krylov.jacobian", "\"exact\"", "write \"automatic\""});
}

}  // namespace
}  // namespace softwet
