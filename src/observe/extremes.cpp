#include "observe/extremes.hpp"

#include <algorithm>
#include <cmath>

#include "field/ranks.hpp"
#include "field/vector.hpp"

namespace softwet {
namespace {

/// The control points of some rows in a process's own columns, numbered from 0.
struct OwnPoints {
  int stored, begin, width, count;

  /// @param entries  of a vector of these rows
  OwnPoints(const VectorSpace& space, int entries)
      : stored(space.shared ? space.stored : entries),
        begin(space.shared ? space.begin : 0),
        width(space.shared ? space.end - space.begin : entries),
        count(entries > 0 ? entries / stored * width : 0) {}
  /// Place of a point in a vector of these rows.
  KOKKOS_FORCEINLINE_FUNCTION int place(int point) const { return point / width * stored + begin + point % width; }
};

/// Largest square of the velocity at points where the density is above a level; without a density: anywhere. 0: nowhere
template <int D>
struct LargestSquare {
  OwnPoints points;
  const double* velocity;  ///< of the first of these points, first component
  int stride;              ///< of components
  const double* density;
  double level;

  KOKKOS_FUNCTION void operator()(int point, double& largest) const {
    const int i = points.place(point);
    if (density && !(density[i] > level)) return;
    double square = 0;
    for (int d = 0; d < D; ++d) square += velocity[d * stride + i] * velocity[d * stride + i];
    if (square > largest) largest = square;
  }
  double find() const {
    double largest = 0;
    Kokkos::parallel_reduce("softwet::largest_square", Items(0, points.count), *this, Kokkos::Max<double>(largest));
    return std::max(0.0, largest);  // no point may count
  }
};

/// Smallest and largest value.
Kokkos::MinMaxScalar<double> range(const OwnPoints& points, const double* value) {
  Kokkos::MinMaxScalar<double> range;
  Kokkos::parallel_reduce(
      "softwet::extremes", Items(0, points.count),
      KOKKOS_LAMBDA(int point, Kokkos::MinMaxScalar<double>& best) {
        const double v = value[points.place(point)];
        if (v < best.min_val) best.min_val = v;
        if (v > best.max_val) best.max_val = v;
      },
      Kokkos::MinMax<double>(range));
  return range;
}

}  // namespace

template <int D>
Extremes find_extremes(const Layout<D>& l, const State& state, double level) {
  const VectorSpace space = l.space();
  const auto points = [&](int rows) { return OwnPoints(space, rows * l.row_size); };
  const double *velocity = state.unknown.data(), *density = velocity + l.density_offset();
  const double* at_wall = velocity + l.fluid_shift();
  const int stride = l.rows * l.row_size;
  double found[5] = {};
  if (l.has_fluid) {
    const auto values = range(points(l.fluid_rows()), density);
    found[0] = -values.min_val;
    found[1] = values.max_val;
    found[2] = LargestSquare<D>{points(l.fluid_rows()), at_wall, stride, nullptr, 0}.find();
    found[3] = LargestSquare<D>{points(l.fluid_rows()), at_wall, stride, density, level}.find();
  }
  if (l.has_solid) found[4] = LargestSquare<D>{points(l.solid_rows()), velocity, stride, nullptr, 0}.find();
  ranks::largest(found, 5);
  if (!l.has_fluid) found[0] = found[1] = 0;
  return {-found[0], found[1], std::sqrt(found[2]), std::sqrt(found[4]), std::sqrt(found[3])};
}

template Extremes find_extremes(const Layout<2>&, const State&, double);
template Extremes find_extremes(const Layout<3>&, const State&, double);

}  // namespace softwet
