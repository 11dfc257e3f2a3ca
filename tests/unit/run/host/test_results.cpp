// The results of a run as lines for the terminal.
#include "run/host/results.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

Case box(std::vector<double> size) {
  Case c;
  c.domain.size = size;
  c.domain.elements.assign(size.size(), 4);
  c.droplets.resize(1);
  return c;
}

TEST(Results, OfADropletIn2D) {
  const TableRow row({{"x_centre", 0.5623},
                      {"velocity", -1.25e-5},
                      {"x_left", 0.4},
                      {"x_right", 0.7123456},
                      {"angle_left", 70.2},
                      {"angle_right", 71.0},
                      {"ridge_left", 0.0123},
                      {"ridge_right", 0.0131},
                      {"dimple", -0.004},
                      {"liquid_volume", 0.03},
                      {"mass_drift", 2e-16},
                      {"energy_total", 1.5}});
  const std::vector<std::string> expected{"  droplet       x = 0.5623 L0, velocity -1.25e-05 sqrt(ab)",
                                          "  contact line  0.4 to 0.71235 L0",
                                          "  angles        70.2 and 71 degrees",
                                          "  ridge         0.0123 and 0.0131 L0, dimple -0.004 L0",
                                          "  liquid        volume 0.03 L0^2, mass drift 2e-16",
                                          "  energy        total 1.5 a b^2 L0^2"};
  EXPECT_EQ(result_lines(box({1, 0.5}), row), expected);
}

/// L0 = 0.5 mm, a b^2 = 1 kPa and sqrt(ab) = 1 m/s.
TEST(Results, InUnitsOfALaboratory) {
  const TableRow row({{"x_centre", 0.5},
                      {"velocity", 1e-3},
                      {"x_left", -1.0},
                      {"x_right", 1.02},
                      {"angle_right", 86.95},
                      {"ridge_right", 0.03468},
                      {"liquid_volume", 2.0},
                      {"energy_total", 0.02}});
  Case c = box({2, 2});
  c.domain.coordinates = Coordinates::axisymmetric;
  const std::vector<std::string> expected{"  droplet       x = 250 um, velocity 1 mm/s",
                                          "  contact line  -500 to 510 um",
                                          "  angles        86.95 degrees",
                                          "  ridge         17.34 um",
                                          "  liquid        volume 250 nl",
                                          "  energy        total 2.5 nJ"};
  EXPECT_EQ(result_lines(c, row, Scales{5e-4, 1e3, 1e-3}), expected);
}

TEST(Results, OfSeveralDropletsIn3D) {
  Case c = box({1, 1, 0.5});
  c.droplets.resize(3);
  const TableRow row(
      {{"x_centre", 0.5}, {"y_centre", 0.25}, {"velocity", std::nullopt}, {"contact_area", 0.1}, {"angle_rear", 80.0}});
  const std::vector<std::string> expected{"  droplet       x = 0.5, y = 0.25 L0", "  contact line  area 0.1 L0^2",
                                          "  angles        80 degrees", "  droplets      2 more in history.csv"};
  EXPECT_EQ(result_lines(c, row), expected);
}

TEST(Results, OfASolidAlone) {
  Case c = box({1, 0.5});
  c.droplets.clear();
  EXPECT_EQ(result_lines(c, TableRow({{"energy_total", 0.25}, {"energy_elastic", 0.125}})),
            std::vector<std::string>{"  energy        total 0.25 a b^2 L0^2, elastic 0.125"});
}

TEST(Results, FitIntoTheTerminal) {
  TableRow row;
  for (const char* column :
       {"x_centre",       "y_centre",       "velocity",        "x_left",         "x_right",    "contact_area",
        "angle_left",     "angle_right",    "angle_rear",      "angle_front",    "ridge_left", "ridge_right",
        "ridge_rear",     "ridge_front",    "dimple",          "liquid_volume",  "mass_drift", "energy_total",
        "energy_kinetic", "energy_elastic", "speed_max_fluid", "speed_max_solid"})
    row.set(column, -1.23456789e-5);
  for (Case c : {box({1, 0.5}), box({1, 1, 0.5})}) {
    c.droplets.resize(12);
    const std::vector<std::string> lines = result_lines(c, row);
    EXPECT_LE(lines.size(), 9u);
    for (const std::string& line : lines) EXPECT_LE(line.size(), 80u) << line;
  }
}

}  // namespace
}  // namespace softwet
