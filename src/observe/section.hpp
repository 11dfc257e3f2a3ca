// A vertical plane through the domain, in which droplets are seen from the side.
#pragma once

#include "observe/snapshot.hpp"
#include "observe/surface.hpp"
#include "observe/wetted_wall.hpp"

namespace softwet {

/// The part of a line inside the domain; an end lies on a side, or where a periodic axis is cut open.
struct Reach {
  double low, high;
  bool low_is_side, high_is_side;
};

/// The points (origin + s direction, height) of the reference domain, s inside the reach, from the wall up.
template <int D>
class Section {
 public:
  Section(const Snapshot<D>& snapshot, const Place& origin, const Place& direction, const Reach& reach)
      : snapshot_(snapshot), origin_(origin), direction_(direction), reach_(reach) {}

  const Reach& reach() const { return reach_; }
  /// Whether a place is where a side of the domain ends the reach.
  bool at_low_side(double s) const;
  bool at_high_side(double s) const;
  /// `per_element` equidistant values of s per element, or slightly more, from low to high.
  std::vector<double> abscissas(int per_element) const;
  /// Values at all pairs of s and height, s fastest.
  std::vector<double> density(const std::vector<double>& s, const std::vector<double>& height) const;
  /// Where the point is now: (s, height), projected on to the plane.
  std::array<double, 2> current(double s, double height) const;
  /// Vertical displacement of the wall. Only with a solid.
  std::vector<double> rise(const std::vector<double>& s) const;
  /// Derivative of the position of the wall in the section by s. Only with a solid.
  std::array<double, 2> tangent(double s) const;
  const Snapshot<D>& snapshot() const { return snapshot_; }

 private:
  double coordinate(double s, int axis) const;       ///< horizontal one, inside a periodic domain
  typename Snapshot<D>::Grid point(double s) const;  ///< all horizontal ones
  double spacing() const;                            ///< of the shortest elements along a horizontal axis

  const Snapshot<D>& snapshot_;
  Place origin_, direction_;
  Reach reach_;
};

/// The whole of a 2D domain: s = x. A periodic axis is cut open at 0 or, where that lies inside a droplet or bubble, a
/// turn before the column whose largest depth is the smallest.
Section<2> side_view(const Snapshot<2>&, const Surface&);

/// The plane through a point of the wall along a direction (a unit vector), from side to side. s counts from the foot
/// of the perpendicular from the middle of the domain. A periodic axis is cut half a period before and after the point.
Section<3> side_view(const Snapshot<3>&, const Place& point, const Place& direction);

/// s of a point of the wall in a section along `direction`.
double along_track(const Layout<3>&, const Place& point, const Place& direction);

/// Places from `low` to `high` in `count` equal steps, ends included.
std::vector<double> equidistant(double low, double high, int count);

}  // namespace softwet
