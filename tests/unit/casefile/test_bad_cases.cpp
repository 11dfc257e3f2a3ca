// Every way a key can be wrong: the message names place, key and remedy, in one line, with exit code 1.
#include <ostream>

#include "unit/casefile/bad_case.hpp"

namespace softwet::testing_tools {
namespace {

/// The pull scene with one text replaced, and what the message must contain.
struct Bad {
  const char* name;
  std::string from, to;
  std::vector<std::string> parts;
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

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
        Bad{"DoubleBrackets", "[fluid]", "[[fluid]]", {"fluid", "appears once", "[fluid]"}},
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
        Bad{"JointAboveTheSolid",
            "joint = 0",
            "joint = 0.125",
            {"substrate.joint = 0.125", "below the thickness 0.125", "write a lower joint"}},
        Bad{"JointInARow",
            "joint = 0",
            "joint = 0.05",
            {"substrate.joint = 0.05", "end of a row of elements", "write joint = 0.046875"}},
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
        Bad{"AzimuthIn2D",
            "fibre.angle = 0",
            "fibre.azimuth = 30",
            {"substrate.fibre.azimuth = 30", "3D", "fibre.angle"}},
        Bad{"OneSurfaceModulus",
            "surface_modulus = []",
            "surface_modulus = [0.1]",
            {"substrate.surface_modulus = [0.1]", "2 numbers", "G_s"}},
        Bad{"OneSpring", "foundation = []", "foundation = [10]", {"boundary.foundation = [10]", "2 numbers", "kap_n"}},
        Bad{"SpringsBelowARoller",
            "foundation = []",
            "foundation = [10, 3]",
            {"boundary.foundation = [10, 3]", "held", "bottom = \"free\"", "[0, 3]"}},
        Bad{"OneDashpot",
            "foundation_damping = []",
            "foundation_damping = [10]",
            {"boundary.foundation_damping = [10]", "2 numbers", "c_n and c_t"}},
        Bad{"DashpotsBelowARoller",
            "foundation_damping = []",
            "foundation_damping = [10, 3]",
            {"boundary.foundation_damping = [10, 3]", "held", "bottom = \"free\"", "[0, 3]", "dashpots"}},
        Bad{"NegativeSpring", "foundation = []", "foundation = [-1, 0]", {"boundary.foundation", "-1", "[0, inf)"}},
        Bad{"WorkbookForATable",
            "factor = 1 ",
            "factor = \"pulses.xlsx\" ",
            {"load[0].factor = \"pulses.xlsx\"", "not a table", "CSV UTF-8", ".csv"}},
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

}  // namespace
}  // namespace softwet::testing_tools
