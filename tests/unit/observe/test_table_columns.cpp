// The headers of history.csv and interface.csv.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(Columns, AreNamedOnceAndExplained) {
  for (const ColumnTable& table : column_tables()) {
    std::set<std::string> names;
    for (const Column& column : table.columns) {
      EXPECT_TRUE(names.insert(column.name).second) << table.name << ": " << column.name << " stands there twice";
      EXPECT_GT(column.meaning.size(), 10u) << column.name;
      EXPECT_EQ(column.meaning.back(), '.') << column.name;
    }
  }
}

TEST(Columns, OfADropletDependOnTheDimension) {
  std::vector<std::string> plane{"x_left", "x_right", "x_centre", "velocity", "angle_left", "angle_right"};
  std::vector<std::string> space{"contact_area", "x_centre",    "y_centre",   "velocity",
                                 "track_rear",   "track_front", "angle_rear", "angle_front"};
  const auto add_shape = [](std::vector<std::string>& names, const std::string& one, const std::string& other) {
    names.insert(names.end(), {"ridge_" + one, "ridge_" + other});
    for (const std::string& side : {one, other})
      names.insert(names.end(), {"wall_angle_" + side + "_wet", "wall_angle_" + side + "_dry", "liquid_angle_" + side});
    names.push_back("dimple");
  };
  add_shape(plane, "left", "right");
  add_shape(space, "rear", "front");
  EXPECT_EQ(contact_names(2), plane);
  EXPECT_EQ(contact_names(3), space);
}

TEST(Columns, OfTheMomentumHaveTheAxesOfTheDomain) {
  const std::vector<std::string> plane = history_names(2, 0), space = history_names(3, 0);
  EXPECT_TRUE(has(plane, "momentum_y") && has(space, "momentum_y") && has(space, "momentum_z"));
  EXPECT_FALSE(has(plane, "momentum_z"));
}

TEST(Columns, OfHistoryGrowWithTheDroplets) {
  const std::vector<std::string> none = history_names(2, 0), two = history_names(2, 2);
  EXPECT_EQ(none.front(), "step");
  EXPECT_EQ(none[1], "t");
  EXPECT_FALSE(has(none, "laplace"));
  EXPECT_FALSE(has(none, "velocity"));
  EXPECT_TRUE(has(two, "velocity"));
  EXPECT_TRUE(has(two, "angle_right_2"));
  EXPECT_EQ(two.back(), "laplace");
  EXPECT_EQ(two.size(), none.size() + 2 * contact_names(2).size() + 1);
}

TEST(Columns, OfFilmsFollowThoseOfDroplets) {
  const std::vector<std::string> film = history_names(2, 0, 1), both = history_names(2, 1, 2);
  EXPECT_TRUE(has(film, "x_left"));
  EXPECT_FALSE(has(film, "laplace"));
  EXPECT_TRUE(has(both, "x_left"));
  EXPECT_TRUE(has(both, "x_left_3"));
  EXPECT_TRUE(has(both, "laplace"));
}

TEST(Columns, OfNeedlesComeLastAndOnlyWithOne) {
  const std::vector<std::string> none = history_names(3, 1), two = history_names(2, 1, 0, 2);
  EXPECT_FALSE(has(none, "energy_needle") || has(none, "needle_force_x"));
  EXPECT_TRUE(has(two, "energy_needle") && has(two, "power_needle"));
  EXPECT_TRUE(has(two, "needle_force_x") && has(two, "needle_force_y_2"));
  EXPECT_FALSE(has(two, "needle_force_z"));
  EXPECT_EQ(two.back(), "needle_force_y_2");
  EXPECT_TRUE(has(history_names(3, 0, 0, 1), "needle_force_z"));
}

TEST(Columns, AreFoundByName) {
  for (int dimension : {2, 3})
    for (const std::string& name : history_names(dimension, 1, 0, 1)) EXPECT_EQ(history_column(name).name, name);
  EXPECT_EQ(history_column("rho_min").needs, Needs::fluid);
  EXPECT_EQ(history_column("energy_surface").needs, Needs::solid);
  EXPECT_EQ(history_column("energy_total").needs, Needs::nothing);
  EXPECT_THROW(history_column("masss"), std::logic_error);
}

TEST(Columns, OfTheInterfaceHaveTheAxesOfTheDomain) {
  const std::vector<std::string> plane{"time",    "x_reference", "displacement_x", "displacement_y",
                                       "density", "traction_x",  "traction_y"};
  EXPECT_EQ(interface_names(2), plane);
  EXPECT_TRUE(has(interface_names(3), "y_reference"));
  EXPECT_TRUE(has(interface_names(3), "traction_z"));
}

}  // namespace
}  // namespace softwet
