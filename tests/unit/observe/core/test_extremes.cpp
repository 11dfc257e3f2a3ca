// Extremes of control values against a loop over all of them, on the whole patch and on parts of it.
#include "observe/extremes.hpp"

#include "field/exchange.hpp"
#include "scene/initial.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

constexpr double level = 0.5;

Layout<2> part_of(const Layout<2>& whole, int rank, int ranks) {
  Layout<2> part = whole;
  part.columns = cut_columns(whole.axis[0], rank, ranks);
  part.row_size = part.columns.stored();
  return part;
}

State random_state(const RandomScene& s) {
  State state = empty_state(s.layout());
  Patch<2> draws = s.terms.patch;
  Kokkos::deep_copy(state.unknown, draws.draw(s.layout().size(), -1, 1));
  return state;
}

State part_of(const State& whole, const Layout<2>& layout) {
  State part;
  part.unknown = from_patch(layout, to_host(whole.unknown));
  return part;
}

/// The largest speed at the control points [first, last) of component 0, which are followed by component 1.
double largest_speed(const std::vector<double>& x, const Layout<2>& l, int first, int last, bool above) {
  double largest = 0;
  for (int i = first; i < last; ++i) {
    if (above && !(x[l.density_offset() + i - l.fluid_shift()] > level)) continue;
    largest = std::max(largest, std::hypot(x[l.velocity_offset(0) + i], x[l.velocity_offset(1) + i]));
  }
  return largest;
}

TEST(Extremes, AreThoseOfAllControlPoints) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid, SceneKind::solid}) {
    const RandomScene s(small_case(kind));
    const Layout<2>& l = s.layout();
    const State state = random_state(s);
    const std::vector<double> x = to_host(state.unknown);
    const Extremes found = find_extremes(l, state, level);
    const int all = l.rows * l.row_size, wall = l.fluid_shift();
    if (l.has_fluid) {
      const auto rho = x.begin() + l.density_offset();
      EXPECT_EQ(found.density_min, *std::min_element(rho, rho + l.scalar_size()));
      EXPECT_EQ(found.density_max, *std::max_element(rho, rho + l.scalar_size()));
      EXPECT_DOUBLE_EQ(found.speed_fluid, largest_speed(x, l, wall, all, false));
      EXPECT_DOUBLE_EQ(found.speed_liquid, largest_speed(x, l, wall, all, true));
    } else {
      EXPECT_EQ(found.density_max, 0);
    }
    EXPECT_DOUBLE_EQ(found.speed_solid, largest_speed(x, l, 0, l.solid_rows() * l.row_size, false));
  }
}

TEST(Extremes, NoSpeedWhereNothingIsDenseEnough) {
  const RandomScene s(small_case(SceneKind::coupled));
  const Extremes found = find_extremes(s.layout(), random_state(s), 2.0);
  EXPECT_EQ(found.speed_liquid, 0);
  EXPECT_GT(found.speed_fluid, 0);
}

// Each process looks at its own columns: the largest value of all parts is the largest value of the whole.
TEST(Extremes, OfThePartsAreThoseOfTheWhole) {
  for (const bool periodic : {false, true}) {
    Case c = small_case(SceneKind::coupled, WallLaw::gradient, periodic);
    c.domain.elements = {26, 6};
    const RandomScene s(c);
    const State state = random_state(s);
    const Extremes expected = find_extremes(s.layout(), state, level);
    Extremes found = {1, -1, 0, 0, 0};
    for (int rank = 0; rank < 3; ++rank) {
      const Layout<2> part = part_of(s.layout(), rank, 3);
      const Extremes e = find_extremes(part, part_of(state, part), level);
      found.density_min = std::min(found.density_min, e.density_min);
      found.density_max = std::max(found.density_max, e.density_max);
      found.speed_fluid = std::max(found.speed_fluid, e.speed_fluid);
      found.speed_solid = std::max(found.speed_solid, e.speed_solid);
      found.speed_liquid = std::max(found.speed_liquid, e.speed_liquid);
    }
    EXPECT_EQ(found.density_min, expected.density_min);
    EXPECT_EQ(found.density_max, expected.density_max);
    EXPECT_EQ(found.speed_fluid, expected.speed_fluid);
    EXPECT_EQ(found.speed_solid, expected.speed_solid);
    EXPECT_EQ(found.speed_liquid, expected.speed_liquid);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
