// States a run starts from: control values at Greville points against the shapes a case describes.
#include "scene/initial.hpp"

#include "case/error.hpp"
#include "scene/equilibrium.hpp"

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// A fluid in [0, 1] x [0, 0.5], 40 x 20 elements, with a thin interface.
Case fluid_box() {
  Case c = small_case(SceneKind::rigid);
  c.domain.size = {1.0, 0.5};
  c.domain.elements = {40, 20};
  c.fluid->capillarity = 0.005;
  c.fluid->contact_angle = 90;
  c.boundary.side[1] = {Side::slip, Side::slip};
  return c;
}

/// Control value of the density nearest to a point.
double density_at(const Case& c, double x, double y) {
  const Scene<2, 2> scene(c);
  const Layout<2>& l = scene.layout();
  const std::vector<double> values = to_host(initial_state(c, scene).unknown);
  const auto nearest = [&](int d, double at) {
    int best = 0;
    for (int i = 0; i < l.axis[d].functions(); ++i)
      if (std::abs(l.axis[d].greville(i) - at) < std::abs(l.axis[d].greville(best) - at)) best = i;
    return best;
  };
  return values[l.density_offset() + nearest(0, x) + (nearest(1, y) - l.wall_row) * l.row_size];
}

constexpr double vapour = 0.1066, liquid = 0.6024;  // theta = 0.85

TEST(InitialState, FilmHasNoInterfaceOnTheSides) {
  Case c = fluid_box();
  c.films = {{{0.0, 0.0}, {0.4, 2.0}}};
  for (const double y : {0.0, 0.25, 0.5}) {
    EXPECT_NEAR(density_at(c, 0.0, y), liquid, 1e-3);
    EXPECT_NEAR(density_at(c, 0.8, y), vapour, 1e-3);
    EXPECT_NEAR(density_at(c, 0.4, y), 0.5 * (vapour + liquid), 0.25) << "within an element of the face";
  }
}

TEST(InitialState, EllipseIsLongerAlongItsStretchedAxis) {
  Case c = fluid_box();
  c.droplets = {{{0.5, 0.25}, 0.15, {1.4, 0.6}}};
  EXPECT_GT(density_at(c, 0.5 + 0.18, 0.25), 0.55);
  EXPECT_LT(density_at(c, 0.5, 0.25 + 0.13), 0.15);
}

TEST(InitialState, DropletOnAPeriodicSideContinuesOnTheOther) {
  Case c = fluid_box();
  c.boundary.side[0] = {Side::periodic, Side::periodic};
  c.droplets = {{{0.05, 0.25}, 0.15, {}}};
  EXPECT_GT(density_at(c, 0.95, 0.25), 0.55);
  EXPECT_LT(density_at(c, 0.5, 0.25), 0.15);
}

TEST(InitialState, BubbleInLiquid) {
  Case c = fluid_box();
  c.fluid->ambient = Phase::liquid;
  c.droplets = {{{0.5, 0.25}, 0.15, {}}};
  EXPECT_NEAR(density_at(c, 0.5, 0.25), vapour, 0.02);
  EXPECT_NEAR(density_at(c, 0.9, 0.25), liquid, 0.02);
  c.fluid->initial = {0.1, 0.6};
  EXPECT_NEAR(density_at(c, 0.5, 0.25), 0.1, 1e-9);
  EXPECT_NEAR(density_at(c, 0.9, 0.25), 0.6, 1e-9);
}

/// alpha = 60 degrees in the liquid: a droplet on the wall is half as high as its radius, a bubble one and a half
/// times.
TEST(InitialState, CapOnTheWallMeetsItAtTheAngleInTheLiquid) {
  Case c = fluid_box();
  c.fluid->contact_angle = 60;
  c.droplets = {{{0.5, 0.0}, 0.2, {}}};
  EXPECT_GT(density_at(c, 0.5, 0.05), 0.5);
  EXPECT_LT(density_at(c, 0.5, 0.15), 0.2);
  c.fluid->ambient = Phase::liquid;
  EXPECT_LT(density_at(c, 0.5, 0.25), 0.2);
  EXPECT_GT(density_at(c, 0.5, 0.35), 0.5);
}

TEST(InitialState, DropletBelowTheSizeOfAnyEquilibriumStaysBetweenThePhases) {
  Case c = fluid_box();
  c.droplets = {{{0.5, 0.25}, 1e-6, {}}};
  const Scene<2, 2> scene(c);
  const double end = spinodal(c.fluid->temperature).vapour;
  for (const double x : {0.0, 0.5}) EXPECT_LT(density_at(c, x, 0.25), end);
}

/// int f^n over a plane with the disc of radius R whose profile f is, from the moments of f^n less a sharp step over
/// the capillarity g: R^2 pi + 2 pi (R g m_0 + g^2 m_1). The moments of f and f^2 at 0.85 are from
/// tests/oracle/interface_profile.py.
double integral_of_part(int power, double radius, double g) {
  const double moment[2][2] = {{-0.0622741518429, 2.38339086207}, {-1.27076446611, 2.58342770968}};
  const auto& m = moment[power - 1];
  return M_PI * radius * radius + 2 * M_PI * (radius * g * m[0] + g * g * m[1]);
}

/// Density and velocity fall with the same part f, so the momentum is v int [rho_out f + (rho_in - rho_out) f^2].
/// The mesh resolves the profile with four elements and more; control values at Greville points widen it by O(h^2).
TEST(InitialState, DropletCarriesItsVelocityAsMomentum) {
  Case c = fluid_box();
  c.domain.elements = {200, 100};
  c.fluid->capillarity = 0.012;
  c.droplets = {{{0.5, 0.25}, 0.15, {}, {0.3, -0.2}}};
  const Scene<2, 2> scene(c);
  const State s = initial_state(c, scene);
  const std::vector<double> values = to_host(s.unknown);
  const Layout<2>& l = scene.layout();
  const int middle = l.fluid_rows() / 2 * l.row_size + l.row_size / 2;
  const double inside = values[l.density_offset() + middle], outside = values[l.density_offset()];
  const double mass =
      outside * integral_of_part(1, 0.15, 0.012) + (inside - outside) * integral_of_part(2, 0.15, 0.012);
  const Integrals i = scene.balance().measure(stage_at(l, s)).integrals;
  EXPECT_NEAR(i["momentum_x"], 0.3 * mass, 0.001 * 0.3 * mass);
  EXPECT_NEAR(i["momentum_y"], -0.2 * mass, 0.001 * 0.2 * mass);
  EXPECT_NEAR(values[middle], 0.3, 1e-3);
  EXPECT_NEAR(values[0], 0, 1e-4) << "far away";
}

TEST(InitialState, MovingDropletLeavesWallsAndSolidAtRest) {
  Case c = small_case(SceneKind::coupled);
  const double wall = c.substrate->thickness;
  c.droplets = {{{0.45, wall}, 0.3, {}, {0.3, -0.2}}};
  const Scene<2, 2> scene(c);
  const Layout<2>& l = scene.layout();
  const std::vector<double> v = to_host(initial_state(c, scene).unknown);
  for (int i = 0; i < (l.wall_row + 1) * l.row_size; ++i) {
    EXPECT_EQ(v[i], 0) << "solid";
    EXPECT_EQ(v[l.velocity_offset(1) + i], 0) << "solid";
  }
  EXPECT_LT(v[l.velocity_offset(1) + (l.wall_row + 1) * l.row_size + l.row_size / 2], -0.1) << "fluid next to it";
  for (int row = l.wall_row; row < l.rows; ++row) EXPECT_EQ(v[row * l.row_size], 0) << "a side lets no fluid through";
  for (int i = 0; i < l.row_size; ++i) EXPECT_EQ(v[(l.rows - 1) * l.row_size + i], 0) << "no slip on the top";
}

/// Half of a droplet whose middle density is at R = 0.15, in its vapour: the start has the mass of the droplet at rest.
/// The mass of the droplet alone, beyond the vapour, is from tests/oracle/radial_droplet.py (capillarity 1/64, 0.39).
TEST(InitialState, DropletHasTheMassOfTheOneAtRest) {
  Case c = fluid_box();
  c.domain = {.size = {0.5, 0.5}, .elements = {128, 128}, .degree = 2};
  c.fluid->temperature = 0.39;
  c.fluid->capillarity = 1.0 / 64;
  c.droplets = {{{0.0, 0.25}, 0.15, {}}};
  const double at_rest = 0.0627153148 - 0.0017728232 * M_PI * 0.25;
  const Scene<2, 2> scene(c);
  const State s = initial_state(c, scene);
  const std::vector<double> values = to_host(s.unknown);
  const double outside = values[scene.layout().potential_offset() - 1];
  const double mass = scene.balance().measure(stage_at(scene.layout(), s)).integrals["mass"] - 0.25 * outside;
  EXPECT_NEAR(mass, 0.5 * at_rest, 5e-4 * at_rest);
}

/// Two droplets whose surfaces are 3.165 capillarities apart: in the middle each has a hundredth of its liquid, as the
/// interface of the equation of state has (tests/oracle/interface_profile.py). That is vapour still.
TEST(InitialState, DropletsNearEachOtherHaveVapourBetweenThem) {
  Case c = fluid_box();
  c.domain.elements = {41, 21};
  c.fluid->temperature = 0.39;
  c.fluid->capillarity = 1.0 / 32;
  const double away = 0.15 + 1.58259958745715 / 32;
  c.droplets = {{{0.5 - away, 0.25}, 0.15, {}}, {{0.5 + away, 0.25}, 0.15, {}}};
  const double between = density_at(c, 0.5, 0.25), inside = density_at(c, 0.5 - away, 0.25);
  const double outside = density_at(c, 0.5, 0.0);
  EXPECT_NEAR(between, outside + 0.02 * (inside - outside), 1e-6);
  EXPECT_LT(between, spinodal(0.39).vapour);
}

TEST(InitialState, FilmGoesRoundAPeriodicAxis) {
  Case c = fluid_box();
  c.boundary.side[0] = {Side::periodic, Side::periodic};
  c.films = {{{0.0, 0.0}, {0.4, 2.0}}};
  for (const double shift : {0.0125, 0.0375, 0.0875}) {  // Greville points
    const double low = density_at(c, std::fmod(1.0 - shift, 1.0), 0.25), high = density_at(c, 0.4 + shift, 0.25);
    EXPECT_NEAR(low, high, 1e-9) << "both faces are alike";
  }
  EXPECT_NEAR(density_at(c, 0.2, 0.25), liquid, 1e-3);
  c.films = {{{-0.1, 0.0}, {0.95, 2.0}}};
  EXPECT_NEAR(density_at(c, 0.0, 0.25), liquid, 1e-3) << "as long as the axis";
}

/// What initial_state says of a scene that it refuses.
std::string refusal_of(const Case& c) {
  const Scene<2, 2> scene(c);
  try {
    initial_state(c, scene);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::invalid_input);
    return error.what();
  }
  return "";
}

TEST(InitialState, DensityOutsideOfItsRangeIsRefused) {
  Case c = fluid_box();
  c.films = {{{0.0, 0.0}, {0.4, 2.0}}};
  c.waves = {{WaveField::density, 0.1, {0, 0}}};
  EXPECT_EQ(refusal_of(c), "");
  c.waves = {
      {WaveField::density, 0.3, {0, 0}}, {WaveField::velocity_x, 0.1, {1, 0}}, {WaveField::density, 0.2, {0, 0}}};
  const std::string high = refusal_of(c);
  for (const char* part : {"is 1.1", "at (0, ", "[0, 0.999)", "is 0.6024 there without", "wave[0].amplitude = 0.3",
                           "wave[2].amplitude = 0.2", "by at most 0.78"})
    EXPECT_NE(high.find(part), std::string::npos) << part << " in " << high;
  EXPECT_EQ(high.find("wave[1]"), std::string::npos) << high;
  c.waves = {{WaveField::density, -0.2, {0, 0}}};
  const std::string low = refusal_of(c);
  for (const char* part : {"is -0.09", "by at most 0.5"}) EXPECT_NE(low.find(part), std::string::npos) << low;
  c.waves[0].amplitude *= 0.52;
  EXPECT_EQ(refusal_of(c), "");
}

TEST(InitialState, WavesThatTurnTheSolidInsideOutAreRefused) {
  Case c = small_case(SceneKind::coupled);
  c.waves = {{WaveField::displacement_x, 0.02, {1, 0}}};
  EXPECT_EQ(refusal_of(c), "");
  c.waves[0] = {WaveField::displacement_x, -0.5, {1, 0}};
  EXPECT_NE(refusal_of(c).find("wave[0].amplitude = -0.5) turn the solid inside out"), std::string::npos);
  c.waves[0] = {WaveField::displacement_y, 0.7, {0, 1}};  // lifts the wall beyond the top
  EXPECT_NE(refusal_of(c).find("fold the mesh"), std::string::npos) << refusal_of(c);
}

TEST(InitialState, WavesAddTheirProducts) {
  Case c = small_case(SceneKind::coupled);
  c.waves = {{WaveField::velocity_x, 0.2, {1, 0}}, {WaveField::displacement_y, 0.01, {2, 1}}};
  const Scene<2, 2> scene(c);
  const Layout<2>& l = scene.layout();
  const State s = initial_state(c, scene);
  const std::vector<double> v = to_host(s.unknown), u = to_host(s.displacement);
  const double pi = M_PI, width = 0.9, height = 0.8;
  for (int j = 1; j + 1 < l.solid_rows(); ++j)
    for (int i = 1; i + 1 < l.row_size; ++i) {
      const double x = l.axis[0].greville(i), y = l.axis[1].greville(j);
      const int k = j * l.row_size + i;
      EXPECT_NEAR(v[k], 0.2 * std::sin(pi * x / width), 1e-14);
      EXPECT_NEAR(u[l.displacement_offset(1) + k], 0.01 * std::cos(2 * pi * x / width) * std::sin(pi * y / height),
                  1e-14);
    }
  EXPECT_EQ(v[0], 0) << "held by the side";
}

}  // namespace
}  // namespace softwet::testing_tools
