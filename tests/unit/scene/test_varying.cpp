// Numbers of a case that vary: loads in time, fields at the start, and what the kernels do not take.
#include "case/error.hpp"
#include "scene/equilibrium.hpp"
#include "scene/initial.hpp"

#include "unit/io/expect_error.hpp"
#include "unit/scene/formulas.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

Profile in_x(double a, double b) {
  return varying([=](const std::array<double, 3>& x, double) { return a + b * x[0]; });
}

TEST(Varying, FactorOfALoadMultipliesItsRampInForceAndPower) {
  Case c = small_case(SceneKind::coupled);  // the load starts at 1 and has a ramp of 4, so t = time - 1
  const RandomScene without(c);
  c.loads[0].factor = varying([](const std::array<double, 3>&, double t) { return 1 - 2 * t; });
  const RandomScene with(c);
  c.loads.clear();
  const RandomScene none(c);
  Stage stage = RandomScene(small_case(SceneKind::coupled)).stage();
  for (const double time : {0.5, 1.0, 2.5, 7.0}) {
    const double fraction = std::clamp((time - 1) / 4, 0.0, 1.0);
    EXPECT_DOUBLE_EQ(with.scene.forces().loads()[0].force(time)[0],
                     fraction == 0 ? 0 : 0.7 * (fraction * (1 - 2 * (time - 1))));
    stage.time = time;
    const double power = without.scene.balance().measure(stage).load_power;
    EXPECT_NEAR(with.scene.balance().measure(stage).load_power, (1 - 2 * (time - 1)) * power, 1e-14);
    const std::vector<double> full = without.residual(stage), varied = with.residual(stage),
                              bare = none.residual(stage);
    for (std::size_t i = 0; i < full.size(); ++i)
      EXPECT_NEAR(varied[i] - bare[i], (1 - 2 * (time - 1)) * (full[i] - bare[i]), 1e-12);
  }
}

/// Along a periodic axis of length 0.9 the box [0.3, 0.6] is moved by 0.4 to [0.7, 0.9] and [0, 0.1].
TEST(Varying, BoxOfALoadMovesAlongItsPath) {
  Case c = small_case(SceneKind::coupled, WallLaw::gradient, true);
  c.loads[0].path = {varying([](const std::array<double, 3>&, double t) { return 0.1 * t; }), Profile(0)};
  const RandomScene moving(c);
  c.loads[0].path.clear();
  c.loads[0].lower[0] = 0.7, c.loads[0].upper[0] = 0.9;
  c.loads.push_back(c.loads[0]);
  c.loads[1].lower[0] = 0, c.loads[1].upper[0] = 0.1;
  const RandomScene two(c);
  Stage stage = RandomScene(small_case(SceneKind::coupled, WallLaw::gradient, true)).stage();
  stage.time = 5;  // t = 4
  EXPECT_LT(distance(moving.residual(stage), two.residual(stage)), 1e-13);
  const double power = moving.scene.balance().measure(stage).load_power;
  EXPECT_NEAR(power, two.scene.balance().measure(stage).load_power, 1e-13);
  stage.time = 6;
  EXPECT_GT(std::abs(power - moving.scene.balance().measure(stage).load_power), 1e-4);
}

/// Greville points of the control values of a component in 2D, round a periodic axis inside of the domain.
std::vector<std::array<double, 2>> points_of(const Layout<2>& l, int first, int rows) {
  std::vector<std::array<double, 2>> all;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < l.row_size; ++i) {
      double x = l.axis[0].greville(l.function(i, 0));
      if (x < 0) x += l.axis[0].length();
      if (l.axis[0].periodic() && x >= l.axis[0].length()) x -= l.axis[0].length();
      all.push_back({x, l.axis[1].greville(first + j)});
    }
  return all;
}

TEST(Varying, GivenDensityIsTheOneOfTheControlPoints) {
  for (const bool periodic : {false, true}) {
    Case c = small_case(SceneKind::coupled, WallLaw::gradient, periodic);
    c.initial.emplace().density =
        varying([](const std::array<double, 3>& x, double) { return 0.2 + 0.3 * x[0] + 0.1 * x[1]; });
    const Scene<2, 2> scene(c);
    const Layout<2>& l = scene.layout();
    const std::vector<double> unknown = to_host(initial_state(c, scene).unknown);
    const auto points = points_of(l, l.wall_row, l.fluid_rows());
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(unknown[l.density_offset() + i], 0.2 + 0.3 * points[i][0] + 0.1 * points[i][1], 1e-14);
  }
}

TEST(Varying, WavesAreAddedToGivenFields) {
  Case c = small_case(SceneKind::rigid);
  c.initial.emplace().density = 0.3;
  c.waves = {{WaveField::density, 0.05, {0, 0}}};
  const Scene<2, 2> scene(c);
  const std::vector<double> unknown = to_host(initial_state(c, scene).unknown);
  EXPECT_DOUBLE_EQ(unknown[scene.layout().density_offset()], 0.35);
}

TEST(Varying, GivenVelocityLeavesSidesAndSolidAtRest) {
  Case c = small_case(SceneKind::coupled);
  c.initial.emplace().velocity = {in_x(0.1, 0.2), Profile(0.3)};
  const Scene<2, 2> scene(c);
  const Layout<2>& l = scene.layout();
  const std::vector<double> unknown = to_host(initial_state(c, scene).unknown), mask = to_host(scene.mask());
  const auto points = points_of(l, 0, l.rows);
  for (int d : {0, 1})
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool fluid = static_cast<int>(i) / l.row_size > l.wall_row;
      const double given = d == 0 ? 0.1 + 0.2 * points[i][0] : 0.3;
      EXPECT_NEAR(unknown[l.velocity_offset(d) + i], fluid ? mask[l.velocity_offset(d) + i] * given : 0, 1e-15);
    }
}

TEST(Varying, GivenDisplacementIsHeldAtTheSides) {
  Case c = small_case(SceneKind::coupled);
  c.initial.emplace().displacement = {in_x(0.01, 0.02), Profile(0.03)};
  const Scene<2, 2> scene(c);
  const Layout<2>& l = scene.layout();
  const std::vector<double> displacement = to_host(initial_state(c, scene).displacement), mask = to_host(scene.mask());
  const auto points = points_of(l, 0, l.solid_rows());
  for (int d : {0, 1})
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double given = d == 0 ? 0.01 + 0.02 * points[i][0] : 0.03;
      EXPECT_NEAR(displacement[l.displacement_offset(d) + i], mask[l.velocity_offset(d) + i] * given, 1e-15);
    }
}

TEST(Varying, GivenFieldsThatCannotBeComputedAreRefused) {
  const auto refuses = [](const Case& c, std::initializer_list<std::string> words) {
    const Scene<2, 2> scene(c);
    expect_error(Exit::invalid_input, words, [&] { initial_state(c, scene); });
  };
  Case dense = small_case(SceneKind::rigid);
  dense.initial.emplace().density = in_x(0.5, 0.6);
  refuses(dense, {"initial.density: the density is 1.04 at (0.9, ", "[0, 0.999)"});
  Case folded = small_case(SceneKind::coupled);
  folded.initial.emplace().displacement = {in_x(0, -1.5), Profile(0)};
  refuses(folded, {"initial:", "inside out"});
}

/// Formulas that are constant give what the constant gives.
TEST(Varying, ConstantFormulasAreNumbers) {
  for (const WallLaw law : {WallLaw::gradient, WallLaw::energy}) {
    Case c = small_case(SceneKind::coupled, law);
    if (law == WallLaw::energy) {
      c.fluid->wall_tension = WallTensionModel::acts;
      c.substrate->surface_tension = c.substrate->surface_tension_wet = 0.5;
    }
    const RandomScene number(c);
    c.substrate->young = in_x(c.substrate->young.number, 0);
    c.fluid->contact_angle = in_x(c.fluid->contact_angle.number, 0);
    const RandomScene formula(c);
    const Stage& stage = number.terms.patch.stage;
    EXPECT_LT(distance(formula.residual(stage), number.residual(stage)), 1e-13);
    const Integrals a = formula.scene.balance().measure(stage).integrals,
                    b = number.scene.balance().measure(stage).integrals;
    EXPECT_NEAR(a["energy_wall"], b["energy_wall"], 1e-14);
    EXPECT_NEAR(a["energy_elastic"], b["energy_elastic"], 1e-14);
  }
}

TEST(Varying, WallThatWouldHaveNoTensionIsRefused) {
  Case c = small_case(SceneKind::coupled, WallLaw::energy);
  c.fluid->wall_tension = WallTensionModel::acts;
  c.fluid->contact_angle = in_x(100, -60);  // 46 degrees at the end
  c.substrate->surface_tension = c.substrate->surface_tension_wet = 0.5 * surface_tension(*c.fluid);
  expect_error(Exit::invalid_input, {"fluid.wall_tension", "surface_tension above"}, [&] { Scene<2, 2>{c}; });
}

/// A column of two materials between slip sides, under its weight: the stiffness is M below the joint and `ratio` M
/// above.
struct Column {
  static constexpr double height = 0.8, weight = 0.3, poisson = 0.3, ratio = 4;
  Case c;
  double joint, modulus;  ///< modulus of a confined column below the joint

  Column(double where, bool has_joint) : c(small_case(SceneKind::solid)), joint(where) {
    c.loads.clear();
    c.substrate->density = 1;
    c.substrate->strain = Strain::small;
    c.substrate->poisson = poisson;
    c.substrate->joint = has_joint ? where : 0;
    c.substrate->gravity = {0, -weight};
    c.substrate->young =
        varying([where](const std::array<double, 3>& x, double) { return x[1] < where ? 1.0 : ratio; });
    const LameParameters m = LameParameters::from(1, poisson);
    modulus = m.lambda + 2 * m.shear_modulus;
  }
  /// Displacement as a + b (y0 + y1)/2 + c y0 y1 of the part below or above: its control value between two knots.
  double displacement(double y0, double y1, bool above) const {
    const auto of = [&](double stiffness, double from, double from0, double from1) {
      return -weight / stiffness * (height * ((from0 + from1) / 2 - from) - (from0 * from1 - from * from) / 2);
    };
    return above ? of(modulus, 0, joint, joint) + of(ratio * modulus, joint, y0, y1) : of(modulus, 0, y0, y1);
  }
  /// The largest residual of the exact solution, whose parts are splines of degree 2, away from sides that hold it.
  double residual() const {
    RandomScene s(c);
    const Layout<2>& l = s.layout();
    Stage stage = s.stage();
    Kokkos::deep_copy(stage.unknown, 0.0);
    Kokkos::deep_copy(stage.acceleration, 0.0);
    std::vector<double> u(l.solid_size(), 0.0);
    for (int i = 0; i < l.solid_rows() * l.row_size; ++i) {
      const double y0 = l.axis[1].knots()[i / l.row_size + 1], y1 = l.axis[1].knots()[i / l.row_size + 2];
      u[l.displacement_offset(1) + i] = displacement(y0, y1, 0.5 * (y0 + y1) > joint);
    }
    Kokkos::deep_copy(stage.displacement, to_device<Array>(u));
    Kokkos::deep_copy(stage.displacement_end, stage.displacement);
    double largest = 0;
    for (const double r : s.residual(stage)) largest = std::max(largest, std::abs(r));
    return largest;
  }
};

TEST(Varying, TwoMaterialsThatAreJoinedAreExact) {
  for (const int row : {1, 2, 3, 5}) EXPECT_LT(Column(row * 0.8 / 6, true).residual(), 1e-14) << row;
  EXPECT_GT(Column(0.4, false).residual(), 1e-4) << "without a joint the jump is smeared";
}

TEST(Varying, ProductsBesideAJointAreThoseOfDifferences) {
  Case c = small_case(SceneKind::coupled);
  c.domain.elements = {9, 12};
  c.substrate->joint = 0.8 / 6;
  c.substrate->viscosity = 0.1;
  c.substrate->young = varying([](const std::array<double, 3>& x, double) { return x[1] < 0.8 / 6 ? 2.0 : 3 + x[0]; });
  RandomScene s(c);
  EXPECT_EQ(s.layout().solid_rows(), 4 + 2 + 1);
  const Array z = s.direction();
  const std::vector<double> exact = s.product(z, Geometry::exact), difference = s.difference(z, 1e-3);
  EXPECT_LT(distance(exact, difference), 1e-8);
}

// The energy is the sum of the energies of the two parts.
TEST(Varying, EnergyOfJoinedMaterialsIsThatOfTheirParts) {
  Case joined = small_case(SceneKind::solid);
  joined.substrate->joint = 0.4;
  RandomScene all(joined);
  const auto energy = [&](double below, double above) {
    Case c = joined;
    c.substrate->young = varying([=](const std::array<double, 3>& x, double) { return x[1] < 0.4 ? below : above; });
    return RandomScene(c).scene.balance().measure(all.stage()).integrals["energy_elastic"];
  };
  EXPECT_NEAR(energy(2, 6), energy(2, 1e-9) + energy(1e-9, 6), 1e-7 * energy(2, 6));
  EXPECT_NEAR(energy(2, 2), all.scene.balance().measure(all.stage()).integrals["energy_elastic"], 1e-12 * energy(2, 2));
}

}  // namespace
}  // namespace softwet::testing_tools
