// The wetted parts of a wall that is a surface: areas, centroids, connectedness. Plain numbers, no state.
#pragma once

#include <array>
#include <vector>

#include "observe/host/history_memory.hpp"

namespace softwet {

/// Depth (Surface::depth) and displacement on an equidistant grid of the undeformed wall, first axis fastest. An axis
/// of n cells has n + 1 points, a periodic one n.
struct WallSamples {
  std::array<double, 2> length;
  std::array<int, 2> cells;
  std::array<bool, 2> periodic;
  std::vector<double> depth;
  std::array<std::vector<double>, 3> displacement;

  int points(int axis) const { return cells[axis] + (periodic[axis] ? 0 : 1); }
};

/// A connected part of the wall under liquid, or under a bubble.
struct WettedRegion {
  double area = 0;           ///< of the deformed wall
  Place centre{};            ///< of that area, now; inside a periodic domain
  Place reference_centre{};  ///< of this area, of the points before they moved
  /// Per axis: -1 where the low side next to the centre is in the region, 1 where the high side is, 0: none, both.
  std::array<int, 2> cut{0, 0};
};

/// Where the depth is 0 or more. Each cell is four triangles around its middle, whose value is the mean of the
/// corners; a triangle is cut along the line where its linear interpolant is 0. Areas and centroids are of
/// second order in the size of a cell, and keep the symmetries of the grid.
class WettedWall {
 public:
  explicit WettedWall(const WallSamples& samples);

  /// Regions in the order of their first points.
  const std::vector<WettedRegion>& regions() const { return regions_; }
  /// The region of the sample nearest to a place of the deformed wall; -1: dry.
  int region_at(const Place& now) const;

 private:
  struct Step;
  struct Vertex;
  Step step(std::array<int, 2> index) const;
  bool wet(int point) const { return samples_.depth[point] >= 0; }
  bool wet_middle(int i, int j) const;
  int corner(int i, int j) const;
  Vertex vertex(int i, int j, const std::array<int, 2>& turn) const;
  void flood(int start);
  void add_cell(int i, int j);
  void add_triangle(const Vertex& first, const Vertex& second, const Vertex& third, WettedRegion& region) const;
  void finish();
  bool beside(int region, int axis, int end) const;

  WallSamples samples_;
  std::vector<int> region_;               ///< of each point; -1: dry
  std::vector<std::array<int, 2>> turn_;  ///< how often a region has gone round a periodic axis when it gets there
  std::vector<WettedRegion> regions_;
};

}  // namespace softwet
