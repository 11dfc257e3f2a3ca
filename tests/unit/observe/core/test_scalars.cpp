// Rows of history.csv: each scene fills all its columns.
#include "observe/scalars.hpp"

#include <gtest/gtest.h>

#include "observe/host/table_columns.hpp"
#include "unit/observe/core/homogeneous.hpp"

namespace softwet::testing_tools {
namespace {

/// A scene with all energies, and where there is fluid with a droplet and a film.
Case rich_scene(SceneKind kind) {
  Case c = small_case(kind, WallLaw::energy);
  if (c.fluid) {
    c.fluid->gravity = {0.3, -0.8};
    c.droplets.push_back({{0.4, 0.3}, 0.1});
    c.films.resize(1);
    c.films[0].lower = {0, 0};
    c.films[0].upper = {0.9, 0.3};
  }
  if (c.substrate) {
    c.substrate->gravity = {0.3, -0.8};
    c.substrate->viscosity = 0.2;
    c.substrate->surface_tension = c.substrate->surface_tension_wet = 0.4;
  }
  return c;
}

/// Its first row, with the columns of the table.
struct FirstRow {
  std::vector<std::string> columns;
  TableRow row;

  explicit FirstRow(const Case& c) {
    const Homogeneous s(c, {{{0.05, 0.01}, {0, -0.02}}});
    Scalars<2, 2> scalars(s.data, s.scene);
    columns = scalars.columns();
    row = scalars.row_of(scalars.read(0, {0.25, 3, 7, 0}, s.state, s.stage()));
  }
  bool has(const std::string& column) const { return row.cell(column).has_value(); }
};

TEST(Scalars, FillEveryColumn) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid, SceneKind::solid}) {
    const FirstRow first(rich_scene(kind));
    EXPECT_EQ(first.row.in_order_of(first.columns).size(), first.columns.size());
    EXPECT_EQ(first.row.cell("step"), 0);
    EXPECT_EQ(first.row.cell("dt"), 0.25);
    EXPECT_EQ(first.row.cell("newton"), 3);
    EXPECT_EQ(first.row.cell("krylov"), 7);
  }
}

TEST(Scalars, LeaveEmptyWhatTheSceneLacks) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid, SceneKind::solid}) {
    const FirstRow first(rich_scene(kind));
    for (const char* always : {"momentum_x", "energy_kinetic", "energy_elastic", "energy_gravity", "energy_total",
                               "power_load", "dissipation"})
      EXPECT_TRUE(first.has(always)) << always;
    for (const char* of_fluid : {"mass", "energy_free", "energy_wall", "rho_min", "rho_max", "speed_max_fluid",
                                 "mass_drift", "speed_max_liquid", "wall_stretch", "dissipation_wall", "liquid_volume"})
      EXPECT_EQ(first.has(of_fluid), kind != SceneKind::solid) << of_fluid;
    for (const char* of_solid : {"speed_max_solid", "energy_surface", "energy_branches", "dissipation_solid"})
      EXPECT_EQ(first.has(of_solid), kind != SceneKind::rigid) << of_solid;
  }
}

TEST(Scalars, EnergiesOfARowAddUp) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid, SceneKind::solid}) {
    const FirstRow first(rich_scene(kind));
    double sum = 0, size = 0;
    for (const std::string& column : first.columns) {
      if (column.rfind("energy_", 0) != 0 || column == "energy_total") continue;
      sum += first.row.cell(column).value_or(0);
      size += std::abs(first.row.cell(column).value_or(0));
    }
    EXPECT_GT(size, 1e-3);
    EXPECT_NEAR(first.row.cell("energy_total").value(), sum, 1e-14 * size);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
