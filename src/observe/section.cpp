#include "observe/section.hpp"

#include <algorithm>
#include <cmath>

#include "observe/host/places.hpp"

namespace softwet {

namespace {

/// Largest depth above each place of the wall.
std::vector<double> largest_of_columns(const Snapshot<2>& snapshot, const Surface& surface,
                                       const std::vector<double>& x) {
  const Axis& vertical = snapshot.layout().axis[1];
  const std::vector<double> height = equidistant(snapshot.wall_height(), vertical.length(), vertical.equal_parts());
  const std::vector<double> depth = surface.depth(snapshot.density({x, height}));
  std::vector<double> largest(depth.begin(), depth.begin() + x.size());
  for (std::size_t i = 0; i < depth.size(); ++i) largest[i % x.size()] = std::max(largest[i % x.size()], depth[i]);
  return largest;
}

}  // namespace

std::vector<double> equidistant(double low, double high, int count) {
  std::vector<double> x(count + 1);
  for (int i = 0; i <= count; ++i) x[i] = low + (high - low) * i / count;
  return x;
}

template <int D>
std::vector<double> Section<D>::abscissas(int per_element) const {
  const std::vector<Axis>& axis = snapshot_.layout().axis;
  if constexpr (D == 2) return equidistant(reach_.low, reach_.high, per_element * axis[0].equal_parts());
  // Through a corner of the domain a section may have no length.
  return equidistant(reach_.low, reach_.high,
                     per_element * std::max(1, parts_no_longer(reach_.high - reach_.low, spacing())));
}

template <int D>
double Section<D>::spacing() const {
  const std::vector<Axis>& axis = snapshot_.layout().axis;
  double shortest = axis[0].spacing();
  for (int d = 1; d < D - 1; ++d) shortest = std::min(shortest, axis[d].spacing());
  return shortest;
}

template <int D>
bool Section<D>::at_low_side(double s) const {
  return reach_.low_is_side && at_end(s, reach_.low, spacing());
}

template <int D>
bool Section<D>::at_high_side(double s) const {
  return reach_.high_is_side && at_end(s, reach_.high, spacing());
}

template <int D>
double Section<D>::coordinate(double s, int d) const {
  const Axis& axis = snapshot_.layout().axis[d];
  const double x = origin_[d] + s * direction_[d];
  return axis.periodic() ? x - axis.length() * std::floor(x / axis.length()) : x;
}

template <int D>
typename Snapshot<D>::Grid Section<D>::point(double s) const {
  typename Snapshot<D>::Grid at;
  for (int d = 0; d < D - 1; ++d) at[d] = {coordinate(s, d)};
  return at;
}

template <int D>
std::vector<double> Section<D>::density(const std::vector<double>& s, const std::vector<double>& height) const {
  if constexpr (D == 2) {
    std::vector<double> x(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) x[i] = coordinate(s[i], 0);
    return snapshot_.density({x, height});
  }
  std::vector<double> values(s.size() * height.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    auto at = point(s[i]);
    at[D - 1] = height;
    const std::vector<double> column = snapshot_.density(at);
    for (std::size_t j = 0; j < height.size(); ++j) values[j * s.size() + i] = column[j];
  }
  return values;
}

template <int D>
std::array<double, 2> Section<D>::current(double s, double height) const {
  auto at = point(s);
  at[D - 1] = {height};
  double along = 0;
  for (int d = 0; d < D - 1; ++d) along += direction_[d] * snapshot_.displacement(at, d, Medium::fluid)[0];
  return {s + along, height + snapshot_.displacement(at, D - 1, Medium::fluid)[0]};
}

template <int D>
std::vector<double> Section<D>::rise(const std::vector<double>& s) const {
  std::vector<double> values;
  if constexpr (D == 2) {
    for (double along : s) values.push_back(coordinate(along, 0));
    return snapshot_.displacement({values, {snapshot_.wall_height()}}, 1, Medium::solid);
  }
  for (double along : s) {
    auto at = point(along);
    at[D - 1] = {snapshot_.wall_height()};
    values.push_back(snapshot_.displacement(at, D - 1, Medium::solid)[0]);
  }
  return values;
}

template <int D>
std::array<double, 2> Section<D>::tangent(double s) const {
  auto at = point(s);
  at[D - 1] = {snapshot_.wall_height()};
  std::array<double, 2> t{1, 0};
  for (int axis = 0; axis < D - 1; ++axis) {
    for (int d = 0; d < D - 1; ++d)
      t[0] +=
          direction_[d] * direction_[axis] * snapshot_.displacement_gradient(at, d, axis, snapshot_.solid_rows())[0];
    t[1] += direction_[axis] * snapshot_.displacement_gradient(at, D - 1, axis, snapshot_.solid_rows())[0];
  }
  return t;
}

Section<2> side_view(const Snapshot<2>& snapshot, const Surface& surface) {
  const Axis& axis = snapshot.layout().axis[0];
  if (!axis.periodic())
    return {snapshot, {0, 0}, {1, 0}, {.low = 0, .high = axis.length(), .low_is_side = true, .high_is_side = true}};
  double low = 0;
  if (largest_of_columns(snapshot, surface, {0})[0] >= 0) {
    const std::vector<double> x = equidistant(0, axis.length(), 4 * axis.equal_parts());
    const std::vector<double> largest = largest_of_columns(snapshot, surface, x);
    low = x[std::min_element(largest.begin(), largest.end()) - largest.begin()] - axis.length();
  }
  return {
      snapshot, {0, 0}, {1, 0}, {.low = low, .high = low + axis.length(), .low_is_side = false, .high_is_side = false}};
}

double along_track(const Layout<3>& layout, const Place& point, const Place& direction) {
  double s = 0;
  for (int d : {0, 1}) s += (point[d] - 0.5 * layout.axis[d].length()) * direction[d];
  return s;
}

Section<3> side_view(const Snapshot<3>& snapshot, const Place& point, const Place& direction) {
  const Layout<3>& layout = snapshot.layout();
  const double s = along_track(layout, point, direction);
  const Place origin{point[0] - s * direction[0], point[1] - s * direction[1]};
  Reach reach{.low = -1e300, .high = 1e300, .low_is_side = true, .high_is_side = true};
  for (int d : {0, 1}) {
    const double slope = direction[d], length = layout.axis[d].length();
    if (std::abs(slope) < 1e-12) continue;
    const bool side = !layout.axis[d].periodic();
    const double half = 0.5 * length / std::abs(slope), middle = side ? (0.5 * length - origin[d]) / slope : s;
    if (middle - half > reach.low) reach.low = middle - half, reach.low_is_side = side;
    if (middle + half < reach.high) reach.high = middle + half, reach.high_is_side = side;
  }
  return {snapshot, origin, direction, reach};
}

template class Section<2>;
template class Section<3>;

}  // namespace softwet
