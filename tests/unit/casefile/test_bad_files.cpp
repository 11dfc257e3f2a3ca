// Mistakes of a whole case: several at once, in the syntax, and of keys that do not go together.
#include <algorithm>
#include <sstream>

#include "casefile/text/problems.hpp"
#include "unit/casefile/bad_case.hpp"

namespace softwet::testing_tools {
namespace {

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

TEST(BadCases, AllMistakesAreReportedInTheOrderOfTheFile) {
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

TEST(BadCases, NoMistakeIsReportedTwiceNorOneThatFollowsFromAnother) {
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
  told("ramp = 1/2", {"load[0].ramp = 1/2", "a ratio has to be in quotes", "ramp = \"1/2\""});
  told("ramp = 0,5  # half", {"load[0].ramp = 0,5:", "a point, not a comma", "ramp = 0.5"});
  told("ramp = .5", {"load[0].ramp = .5", "digits on both sides", "ramp = 0.5"});
  told("ramp = 5 s", {"load[0].ramp = 5 s", "no units", "ramp = 5 ", "softwet units"});
  told("ramp =", {"load[0].ramp", "has no value"});
  told("factor = sin(2*t)", {"load[0].factor = sin(2*t)", "has to be in quotes", "factor = \"sin(2*t)\""});
  told("factor = 2 per unit", {"load[0].factor = 2 per unit", "no units"});
  told("path = [0.05*t, max(0, t)]",
       {"load[0].path = [0.05*t, max(0, t)]", "has to be in quotes", "path = [\"0.05*t\", \"max(0, t)\"]"});
  told("ramp: 5", {"load[0].ramp", "joined by '='", "ramp = 5"});
  EXPECT_NE(message_of(replaced(pull_text(), "left = \"slip\"", "left = slip")).find("left = \"slip\""),
            std::string::npos);
  EXPECT_NE(message_of(replaced(pull_text(), "force = [0.16215, 0.0]", "force = [1/8, 0.0]")).find("[\"1/8\", 0.0]"),
            std::string::npos);
  EXPECT_NE(message_of(pull_text(), {"load.path=[0.05*t,0]"}).find("write path = [\"0.05*t\", 0]"), std::string::npos);
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

TEST(BadCases, AFileWithoutEndIsNotReadToItsEnd) {
  for (const std::string& path : {std::string("/dev/zero"), std::string("/dev/urandom")}) {
    try {
      read_case(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Exit::invalid_input);
      expect_parts(error.what(), {path, "longer than 16 MiB"});
    }
  }
}

TEST(BadCases, OtherEncodingsAreNamed) {
  std::string little = "\xff\xfe", big, plain_little;
  for (const char letter : std::string("name = \"x\"\n")) {
    little += {letter, '\0'};
    big += {'\0', letter};
    plain_little += {letter, '\0'};
  }
  for (const std::string& text : {little, big, plain_little})
    expect_parts(message_of(text), {"case.toml: the file is in UTF-16", "UTF-8"});
  expect_parts(message_of(pull_text() + std::string(3, '\0')), {"case.toml: the file is not text"});
  EXPECT_EQ(message_of("\xef\xbb\xbf" + pull_text()), "(accepted)");
}

}  // namespace
}  // namespace softwet::testing_tools
