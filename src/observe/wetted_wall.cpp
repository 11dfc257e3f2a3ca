#include "observe/wetted_wall.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "observe/host/places.hpp"

namespace softwet {

/// The corners of a cell, one after the other around it.
static constexpr int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// A neighbour of a point, and the turns around periodic axes on the way. point -1: there is none.
struct WettedWall::Step {
  int point = -1;
  std::array<int, 2> turn{0, 0};
};

/// A corner of a triangle: where it is now (x, y, z), where it was (x, y), its depth.
struct WettedWall::Vertex {
  std::array<double, 6> value;
  double depth() const { return value[5]; }
};

WettedWall::WettedWall(const WallSamples& samples)
    : samples_(samples), region_(samples.depth.size(), -1), turn_(samples.depth.size(), std::array<int, 2>{0, 0}) {
  for (int p = 0; p < static_cast<int>(region_.size()); ++p)
    if (wet(p) && region_[p] < 0) flood(p);
  for (int j = 0; j < samples_.cells[1]; ++j)
    for (int i = 0; i < samples_.cells[0]; ++i) add_cell(i, j);
  finish();
}

int WettedWall::corner(int i, int j) const {
  return i % samples_.points(0) + j % samples_.points(1) * samples_.points(0);
}

bool WettedWall::wet_middle(int i, int j) const {
  double sum = 0;
  for (const auto& [di, dj] : around) sum += samples_.depth[corner(i + di, j + dj)];
  return 0.25 * sum >= 0;
}

/// The point with these indices along the axes.
inline auto WettedWall::step(std::array<int, 2> index) const -> Step {
  Step found;
  for (int d : {0, 1}) {
    const int n = samples_.points(d);
    if (index[d] >= 0 && index[d] < n) continue;
    if (!samples_.periodic[d]) return {};
    found.turn[d] = index[d] < 0 ? -1 : 1;
    index[d] -= found.turn[d] * n;
  }
  found.point = index[0] + index[1] * samples_.points(0);
  return found;
}

/// Marks all that is connected with a wet point: along the lines of the grid, and across a cell whose middle is wet.
void WettedWall::flood(int start) {
  const int label = static_cast<int>(regions_.size());
  regions_.emplace_back();
  std::vector<int> open{start};
  region_[start] = label;
  while (!open.empty()) {
    const int p = open.back(), i = p % samples_.points(0), j = p / samples_.points(0);
    open.pop_back();
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) {
        const Step next = step({i + di, j + dj});
        if (next.point < 0 || region_[next.point] >= 0 || !wet(next.point)) continue;
        // The cell between p and a diagonal neighbour begins at the lower of their indices.
        const int cell = di != 0 && dj != 0 ? step({std::min(i, i + di), std::min(j, j + dj)}).point : -1;
        if (cell >= 0 && !wet_middle(cell % samples_.points(0), cell / samples_.points(0))) continue;
        region_[next.point] = label;
        for (int d : {0, 1}) turn_[next.point][d] = turn_[p][d] + next.turn[d];
        open.push_back(next.point);
      }
  }
}

/// The corner (i, j) of the grid; beyond a periodic end it is the point one turn further.
auto WettedWall::vertex(int i, int j, const std::array<int, 2>& turn) const -> Vertex {
  const int point = corner(i, j);
  const std::array<int, 2> index{i, j};
  Vertex v;
  for (int d : {0, 1}) {
    v.value[3 + d] = samples_.length[d] * (static_cast<double>(index[d]) / samples_.cells[d] + turn[d]);
    v.value[d] = v.value[3 + d] + samples_.displacement[d][point];
  }
  v.value[2] = samples_.displacement[2][point];
  v.value[5] = samples_.depth[point];
  return v;
}

void WettedWall::add_cell(int i, int j) {
  // Region and turns of the cell as one of its wet corners knows them.
  const auto known_by = [&](int c) {
    const int ci = i + around[c][0], cj = j + around[c][1], point = corner(ci, cj);
    std::array<int, 2> turn = turn_[point];
    if (ci == samples_.points(0)) --turn[0];
    if (cj == samples_.points(1)) --turn[1];
    return std::pair{region_[point], turn};
  };
  int any = -1;
  bool is_wet[4];
  for (int c = 0; c < 4; ++c)
    if ((is_wet[c] = wet(corner(i + around[c][0], j + around[c][1])))) any = c;
  if (any < 0) return;
  const bool middle_is_wet = wet_middle(i, j);
  std::array<Vertex, 4> corners;
  Vertex middle;
  std::optional<std::array<int, 2>> placed;  // the turns with which these were found
  for (int c = 0; c < 4; ++c) {
    const int next = (c + 1) % 4, owner = is_wet[c] ? c : is_wet[next] ? next : middle_is_wet ? any : -1;
    if (owner < 0) continue;
    const auto [region, turn] = known_by(owner);
    if (placed != turn) {
      middle = {};
      for (int k = 0; k < 4; ++k) {
        corners[k] = vertex(i + around[k][0], j + around[k][1], turn);
        for (int n = 0; n < 6; ++n) middle.value[n] += 0.25 * corners[k].value[n];
      }
      placed = turn;
    }
    add_triangle(corners[c], corners[next], middle, regions_[region]);
  }
}

/// Adds the part of a triangle that is wet: area, and area times places.
void WettedWall::add_triangle(const Vertex& first, const Vertex& second, const Vertex& third,
                              WettedRegion& region) const {
  const Vertex* const triangle[3] = {&first, &second, &third};
  std::array<Vertex, 4> above;
  int count = 0;
  for (int k = 0; k < 3; ++k) {
    const Vertex &a = *triangle[k], &b = *triangle[(k + 1) % 3];
    const double da = a.depth(), db = b.depth();
    if (da >= 0) above[count++] = a;
    if ((da >= 0) == (db >= 0)) continue;
    for (int n = 0; n < 6; ++n) above[count].value[n] = a.value[n] + (b.value[n] - a.value[n]) * da / (da - db);
    ++count;
  }
  for (int k = 1; k + 1 < count; ++k) {
    const auto &o = above[0].value, &a = above[k].value, &b = above[k + 1].value;
    const double u[3] = {a[0] - o[0], a[1] - o[1], a[2] - o[2]}, v[3] = {b[0] - o[0], b[1] - o[1], b[2] - o[2]};
    const double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
    const double area = 0.5 * std::sqrt(x * x + y * y + z * z);
    region.area += area;
    for (int d : {0, 1}) {
      region.centre[d] += area * (o[d] + a[d] + b[d]) / 3;
      region.reference_centre[d] += area * (o[3 + d] + a[3 + d] + b[3 + d]) / 3;
    }
  }
}

void WettedWall::finish() {
  for (WettedRegion& region : regions_)
    for (int d : {0, 1})
      for (double* sum : {&region.centre[d], &region.reference_centre[d]}) {
        if (region.area > 0) *sum /= region.area;
        if (samples_.periodic[d]) *sum = in_first_turn(*sum, samples_.length[d]);
      }
  for (int r = 0; r < static_cast<int>(regions_.size()); ++r)
    for (int d : {0, 1})
      if (!samples_.periodic[d])
        regions_[r].cut[d] = static_cast<int>(beside(r, d, samples_.cells[d])) - static_cast<int>(beside(r, d, 0));
}

/// Whether the point of a side next to the centre of a region belongs to it; `end` is the side's index along the axis.
bool WettedWall::beside(int region, int axis, int end) const {
  const int other = 1 - axis;
  const double share = regions_[region].reference_centre[other] / samples_.length[other];
  std::array<int, 2> index;
  index[axis] = end;
  index[other] = static_cast<int>(std::lround(share * samples_.cells[other]));
  return region_[corner(index[0], index[1])] == region;
}

int WettedWall::region_at(const Place& now) const {
  double nearest = 1e300;
  int found = -1;
  for (int p = 0; p < static_cast<int>(region_.size()); ++p) {
    const Vertex v = vertex(p % samples_.points(0), p / samples_.points(0), {0, 0});
    double square = 0;
    for (int d : {0, 1}) {
      const double away = v.value[d] - now[d];
      square += std::pow(samples_.periodic[d] ? std::remainder(away, samples_.length[d]) : away, 2);
    }
    if (square < nearest) nearest = square, found = region_[p];
  }
  return found;
}

}  // namespace softwet
