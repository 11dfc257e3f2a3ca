// Droplets on a wall that is a surface, against spheres and ellipsoids that splines hold exactly.
#include "observe/contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "observe/host/table_columns.hpp"
#include "unit/observe/core/quadric.hpp"

namespace softwet::testing_tools {
namespace {

constexpr double radius = 0.25, capillarity = 0.01, wall = Drawing::wall, diagonal = 0.70710678118654752;
const double angle = 75, rad = M_PI / 180, foot = radius * std::sin(angle * rad);

Quadric cap(double x, double y) { return sphere({x, y, wall - radius * std::cos(angle * rad)}, radius); }

/// The cells of a contact by the names of their columns; nan where they are empty.
class Cells {
 public:
  explicit Cells(const TableRow& row) : row_(row) {}
  double operator[](const std::string& column) const {
    const std::vector<std::string> columns = contact_names(3);
    EXPECT_TRUE(std::find(columns.begin(), columns.end(), column) != columns.end()) << column;
    return row_.cell(column).value_or(std::nan(""));
  }

 private:
  TableRow row_;
};

/// Linear interpolation between samples h apart lowers a quadratic form of trace T by h^2 T / 4 in the middle of a
/// cell, and less elsewhere; a form that is 1 on the rim of an area A changes it by no more than that part of A.
double area_bound(double area, double trace, int n) {
  return area * trace * std::pow(Drawing::length / (4 * n), 2) / 4;
}

/// The cells of the only contact.
Cells only(const Drawing& drawing, const Place& track) {
  const std::vector<Contact> found = find_contacts(drawing.snapshot(), Surface{middle}, capillarity, track);
  EXPECT_EQ(found.size(), 1U);
  return Cells(found.at(0).cells);
}

// Whoever takes a contact adds the velocity.
TEST(Contacts, HaveAllTheirCells) {
  for (const double y : {0.4, 0.0}) {
    const std::vector<Contact> found =
        find_contacts(Drawing(16).density(cap(0.8, y)).snapshot(), Surface{middle}, capillarity, {1, 0});
    ASSERT_EQ(found.size(), 1U);
    TableRow cells = found[0].cells;
    cells.set("velocity", 1);
    EXPECT_EQ(cells.in_order_of(contact_names(3)).size(), 17U);
  }
}

TEST(Contacts, CapAtRest) {
  double before = 0;
  for (int n : {8, 16, 32}) {
    const Cells c = only(Drawing(n).density(cap(0.4, 0.4)), {diagonal, diagonal});
    const double error = std::abs(c["contact_area"] - M_PI * foot * foot);
    if (n > 8) {
      EXPECT_GT(before / error, 3.5) << "second order, " << n << " elements";
    }
    before = error;
    EXPECT_LT(error, area_bound(M_PI * foot * foot, 2 / (foot * foot), n));
    EXPECT_NEAR(c["x_centre"], 0.4, 1e-12);
    EXPECT_NEAR(c["y_centre"], 0.4, 1e-12);
    EXPECT_NEAR(c["track_front"], foot, 1e-12);
    EXPECT_NEAR(c["track_rear"], -foot, 1e-12);
    EXPECT_NEAR(c["angle_front"], angle, 20.0 / (n * n)) << "points of the fit are of second order; " << n;
    EXPECT_NEAR(c["angle_rear"], angle, 20.0 / (n * n)) << n;
  }
}

TEST(Contacts, TiltedEllipseOffTheMiddle) {
  const double turn = 0.5, a = 0.26, b = 0.13, c = std::cos(turn), s = std::sin(turn);
  Quadric q{{0.37, 0.43, wall}, {}};
  q.shape[0] = {c * c / (a * a) + s * s / (b * b), c * s * (1 / (a * a) - 1 / (b * b)), 0};
  q.shape[1] = {q.shape[0][1], s * s / (a * a) + c * c / (b * b), 0};
  q.shape[2] = {0, 0, 100};
  double before[3] = {};
  for (int n : {16, 32}) {
    const Cells cells = only(Drawing(n).density(q), {c, s});
    const double error[3] = {cells["contact_area"] - M_PI * a * b, cells["x_centre"] - 0.37, cells["y_centre"] - 0.43};
    EXPECT_LT(std::abs(error[0]), area_bound(M_PI * a * b, 1 / (a * a) + 1 / (b * b), n));
    for (int k : {1, 2}) EXPECT_LT(std::abs(error[k]), 0.02 / (n * n));
    if (n == 32) {
      EXPECT_GT(before[0] / error[0], 3.5);
    }
    before[0] = error[0];
    EXPECT_NEAR(cells["track_front"] - cells["track_rear"], 2 * a, 1e-4)
        << "the long axis, through a centroid of second order";
    EXPECT_NEAR(0.5 * (cells["track_front"] + cells["track_rear"]), -0.03 * c + 0.03 * s, 1e-4);
  }
}

TEST(Contacts, StretchedWall) {
  Drawing drawing(16);
  drawing.density(cap(0.4, 0.4));
  const Cells flat = only(drawing, {1, 0});
  const Cells c = only(drawing.moved([](const Point& p) { return Point{0.1 * p[0] - 0.03, 0.02, 0}; }), {1, 0});
  EXPECT_NEAR(c["contact_area"], 1.1 * flat["contact_area"], 1e-12);
  EXPECT_NEAR(c["x_centre"], 0.41, 1e-12);
  EXPECT_NEAR(c["y_centre"], 0.42, 1e-12);
  EXPECT_NEAR(c["track_front"], 0.01 + 1.1 * foot, 1e-12);
  EXPECT_NEAR(c["track_rear"], 0.01 - 1.1 * foot, 1e-12);
}

// Lifting the wall by w squeezes the fluid by 1 - w / height; an ellipsoid that is taller by as much becomes a sphere.
TEST(Contacts, SphereOnALiftedWall) {
  const double lift = 0.06, squeeze = 1 - lift / 0.3;
  Quadric q = cap(0.4, 0.4);
  q.centre[2] = wall - radius * std::cos(angle * rad) / squeeze;
  q.shape[2][2] *= squeeze * squeeze;
  const Cells c = only(Drawing(32).density(q).moved([&](const Point&) {
    return Point{0, 0, lift};
  }),
                       {diagonal, diagonal});
  EXPECT_NEAR(c["angle_front"], angle, 0.02);
  EXPECT_NEAR(c["angle_rear"], angle, 0.02);
}

// Four capillarities above its foot a circle is steeper or flatter than there, by what its centre gives.
TEST(Contacts, LocalAngleOfASphere) {
  const double above = 4 * capillarity + radius * std::cos(angle * rad);  // over the centre
  const double local = std::acos(above / radius) / rad;
  const Cells c = only(Drawing(32).density(cap(0.4, 0.4)), {1, 0});
  EXPECT_GT(std::abs(local - angle), 5);
  EXPECT_NEAR(c["liquid_angle_front"], local, 0.02);
  EXPECT_NEAR(c["liquid_angle_rear"], local, 0.02);
  for (const char* flat : {"ridge_rear", "ridge_front", "wall_angle_rear_wet", "wall_angle_rear_dry",
                           "wall_angle_front_wet", "wall_angle_front_dry", "dimple"})
    EXPECT_EQ(c[flat], 0);
}

// The wall rises along the track by k: towards the front line on the wet side, and beyond it away from it.
TEST(Contacts, ShapeOfATiltedWall) {
  const double k = 0.1, tilt = std::atan(k) / rad, reach = 4 * capillarity;
  const Cells c = only(Drawing(32).density(cap(0.4, 0.4)).moved([&](const Point& p) {
    return Point{0, 0, k * p[0]};
  }),
                       {1, 0});
  EXPECT_NEAR(c["wall_angle_front_wet"], tilt, 1e-9);
  EXPECT_NEAR(c["wall_angle_front_dry"], -tilt, 1e-9);
  EXPECT_NEAR(c["wall_angle_rear_wet"], -tilt, 1e-9);
  EXPECT_NEAR(c["wall_angle_rear_dry"], tilt, 1e-9);
  EXPECT_NEAR(c["ridge_front"], k * (0.4 + foot + reach), 1e-12);
  EXPECT_NEAR(c["ridge_rear"], k * (0.4 - foot + reach), 1e-12);
  EXPECT_NEAR(c["dimple"], k * (0.4 - foot), 1e-12);
}

// Stretched along the track, a wall that rises by k in the undeformed state is less steep.
TEST(Contacts, ShapeOfAWallThatIsStretchedToo) {
  const double k = 0.1, stretch = 0.25;
  const Cells c = only(Drawing(32).density(cap(0.4, 0.4)).moved([&](const Point& p) {
    return Point{stretch * p[0], 0, k * p[0]};
  }),
                       {1, 0});
  EXPECT_NEAR(c["wall_angle_front_wet"], std::atan(k / (1 + stretch)) / rad, 1e-9);
  EXPECT_NEAR(c["wall_angle_rear_wet"], -std::atan(k / (1 + stretch)) / rad, 1e-9);
}

// Around a bubble the dry side is the inner one, and the angle is measured in the liquid.
TEST(Contacts, ShapeBesideABubble) {
  const auto tilted = [](const Point& p) { return Point{0, 0, 0.1 * p[0]}; };
  const Cells wet = only(Drawing(16).density(cap(0.4, 0.4)).moved(tilted), {1, 0});
  const Drawing drawing = Drawing(16).density(cap(0.4, 0.4)).mirrored().moved(tilted);
  const auto found = find_contacts(drawing.snapshot(), Surface{middle, Phase::vapour}, capillarity, {1, 0});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(Cells(found[0].cells)["wall_angle_front_dry"], wet["wall_angle_front_wet"], 1e-9);
  EXPECT_NEAR(Cells(found[0].cells)["wall_angle_front_wet"], wet["wall_angle_front_dry"], 1e-9);
  EXPECT_NEAR(Cells(found[0].cells)["liquid_angle_front"], 180 - wet["liquid_angle_front"], 1e-9);
  EXPECT_NEAR(Cells(found[0].cells)["ridge_front"], wet["ridge_front"], 1e-12);
}

TEST(Contacts, CutBySides) {
  const Cells whole = only(Drawing(16).density(cap(0.4, 0.4)), {1, 0});
  const Cells along = only(Drawing(16).density(cap(0.4, 0)), {1, 0});
  EXPECT_NEAR(along["contact_area"], 0.5 * whole["contact_area"], 1e-12);
  EXPECT_NEAR(along["y_centre"], 4 * foot / (3 * M_PI), 1e-3) << "the centroid of half a disc";
  for (const char* column : {"x_centre", "track_rear", "track_front", "angle_rear", "angle_front"})
    EXPECT_NEAR(along[column], whole[column], 1e-9) << "the section is that of the whole droplet, column " << column;
  const Cells across = only(Drawing(16).density(cap(0.8, 0.4)), {1, 0});
  EXPECT_NEAR(across["track_rear"], 0.4 - foot, 1e-12);
  EXPECT_NEAR(across["track_front"], 0.4, 1e-12);
  EXPECT_NEAR(across["angle_rear"], angle, 0.1);
  for (const char* column :
       {"angle_front", "ridge_front", "wall_angle_front_wet", "wall_angle_front_dry", "liquid_angle_front"})
    EXPECT_TRUE(std::isnan(across[column])) << "a side is no contact line, column " << column;
  EXPECT_NEAR(across["liquid_angle_rear"], whole["liquid_angle_rear"], 0.1);
}

// A droplet moved by whole elements of a periodic domain, over its corner, stays the same droplet.
TEST(Contacts, OverAPeriodicCorner) {
  const auto droplet = [](double cx, double cy) {
    return [cx, cy](const Point& p) {
      const double dx = std::remainder(p[0] - cx, 0.8), dy = std::remainder(p[1] - cy, 0.8);
      return middle + 0.3 * std::tanh((0.25 - std::hypot(dx, dy, p[2] - wall + 0.05)) / 0.06);
    };
  };
  const Cells whole = only(Drawing(16, AxisKind::periodic).density_near(droplet(0.4, 0.35)), {diagonal, diagonal});
  const Cells moved = only(Drawing(16, AxisKind::periodic).density_near(droplet(0.0, 0.75)), {diagonal, diagonal});
  EXPECT_NEAR(moved["contact_area"], whole["contact_area"], 1e-12);
  EXPECT_NEAR(std::remainder(moved["x_centre"] - whole["x_centre"] - 0.4, 0.8), 0, 1e-12);
  EXPECT_NEAR(moved["y_centre"], whole["y_centre"] + 0.4, 1e-12);
  EXPECT_NEAR(moved["track_front"] - moved["track_rear"], whole["track_front"] - whole["track_rear"], 1e-9);
  EXPECT_NEAR(moved["angle_front"], whole["angle_front"], 1e-6);
  EXPECT_NEAR(advance(Drawing(16, AxisKind::periodic).layout(), {0.79, 0.4}, {0.01, 0.4}, {1, 0}), 0.02, 1e-12);
}

/// A bubble is a droplet with liquid and vapour exchanged: its foot is dry, and the angle in the liquid is 180 degrees
/// less the angle of the cap inside.
TEST(Contacts, BubblesHaveADryFootAndAnAngleInTheLiquid) {
  for (const Place& at : {Place{0.4, 0.4}, Place{0.4, 0.0}}) {
    const Cells wet = only(Drawing(16).density(cap(at[0], at[1])), {1, 0});
    const Drawing drawing = Drawing(16).density(cap(at[0], at[1])).mirrored();
    const auto found = find_contacts(drawing.snapshot(), Surface{middle, Phase::vapour}, capillarity, {1, 0});
    ASSERT_EQ(found.size(), 1U);
    for (const char* column : {"contact_area", "x_centre", "y_centre", "track_rear", "track_front"})
      EXPECT_NEAR(Cells(found[0].cells)[column], wet[column], 1e-12) << "column " << column;
    for (const char* column : {"angle_rear", "angle_front"})
      EXPECT_NEAR(Cells(found[0].cells)[column], 180 - wet[column], 1e-9) << "column " << column;
    EXPECT_TRUE(found[0].holds({0.4, 0.1 + at[1]}));
  }
}

TEST(Contacts, TwoDropletsMerge) {
  const auto pair = [](double half_distance) {
    return Drawing(32).density_near([=](const Point& p) {
      double rho = middle - 0.3;
      for (double side : {-1, 1}) {
        const double c = 0.4 + side * half_distance * diagonal;
        rho = std::max(rho, middle + 0.3 * std::tanh((0.12 - std::hypot(p[0] - c, p[1] - c, p[2] - wall)) / 0.03));
      }
      return rho;
    });
  };
  const auto contacts = [&](double half_distance) {
    return find_contacts(pair(half_distance).snapshot(), Surface{middle}, capillarity, {diagonal, diagonal});
  };
  const double a = 0.4 - 0.16 * diagonal, b = 0.4 + 0.16 * diagonal;
  std::vector<DropletTrack> tracks{{{a, a}, true, false}, {{b, b}, true, false}};

  std::vector<Contact> found = contacts(0.15);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(assign_contacts(found, tracks), (std::vector<int>{0, 1}));
  EXPECT_TRUE(tracks[0].on_wall && tracks[1].on_wall);
  EXPECT_NEAR(Cells(found[0].cells)["track_front"], -0.03, 2e-3);
  EXPECT_NEAR(Cells(found[1].cells)["track_rear"], 0.03, 2e-3);

  found = contacts(0.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(assign_contacts(found, tracks), (std::vector<int>{0, -1}));
  EXPECT_TRUE(tracks[1].merged);
  EXPECT_FALSE(tracks[0].on_wall) << "its centre jumps to that of both: no velocity in this row";
  EXPECT_NEAR(found[0].centre[0], 0.4, 1e-12);
  EXPECT_NEAR(Cells(found[0].cells)["track_front"], 0.22, 2e-3);
  const double half = 0.1, r = 0.12;  // two discs but for the lens they share
  const double both = 2 * M_PI * r * r - 2 * (r * r * std::acos(half / r) - half * std::sqrt(r * r - half * half));
  EXPECT_NEAR(Cells(found[0].cells)["contact_area"], both, 0.02 * both)
      << "the density between control values is no exact maximum";
}

TEST(Contacts, ADryPlaceIsUnderNoDroplet) {
  const std::vector<Contact> found =
      find_contacts(Drawing(16).density(cap(0.4, 0.4)).snapshot(), Surface{middle}, capillarity, {1, 0});
  EXPECT_TRUE(found[0].holds({0.4, 0.62}));
  EXPECT_FALSE(found[0].holds({0.4, 0.66}));
}

}  // namespace
}  // namespace softwet::testing_tools
