// The largest rates at the points of a state, and the ranges of its values, in one pass.
#pragma once

#include <algorithm>

#include "time/explicit/solid_points.hpp"

namespace softwet::step_points {

/// What a pass finds of the values, stored behind the rates: whether one is not finite, the largest density, and minus
/// the smallest density.
enum ValueRange { not_finite = mechanisms, most_density, least_density, found_numbers };

/// Values of unknowns, each process's own. One that is not finite counts as an infinite density.
struct ValuePoint {
  const double* unknown;
  int stored, begin, width;         ///< columns of a line, and the own ones
  int first_density, last_density;  ///< in a vector of unknowns

  KOKKOS_FUNCTION void operator()(int i, double* best) const {
    const int at = width == stored ? i : i / width * stored + begin + i % width;
    const double v = unknown[at];
    const bool finite = Kokkos::isfinite(v);
    if (!finite) best[not_finite] = 1;
    if (at < first_density || at >= last_density) return;
    const double high = finite ? v : Kokkos::Experimental::infinity_v<double>;
    if (high > best[most_density]) best[most_density] = high;
    if (-v > best[least_density]) best[least_density] = -v;
  }
};

/// The point of a region that does not exist: no rates.
struct NoPoint {
  KOKKOS_FUNCTION void operator()(int, double*) const {}
};

/// The largest rates and the ranges of values, in one pass over all of them.
template <class Fluid, class Solid>
struct LargestRates {
  using value_type = double[];
  unsigned value_count = found_numbers;
  Fluid fluid;
  Solid solid;
  ValuePoint value;
  int fluid_points, solid_points, values;

  int items() const { return std::max(fluid_points, solid_points); }
  KOKKOS_FUNCTION void init(double* best) const {
    for (int k = 0; k <= not_finite; ++k) best[k] = 0;
    for (int k = most_density; k < found_numbers; ++k) best[k] = -Kokkos::Experimental::infinity_v<double>;
  }
  KOKKOS_FUNCTION void join(double* best, const double* other) const {
    for (int k = 0; k < found_numbers; ++k) best[k] = best[k] < other[k] ? other[k] : best[k];
  }
  KOKKOS_FUNCTION void operator()(int i, double* best) const {
    const int all = fluid_points > solid_points ? fluid_points : solid_points;
    take(fluid, fluid_points, i, all, best);
    take(solid, solid_points, i, all, best);
    for (int k = i; k < values; k += all) value(k, best);
  }

 private:
  /// Threads of the host have pieces of the items: the points are spread over all of these.
  template <class Point>
  KOKKOS_FORCEINLINE_FUNCTION static void take(const Point& point, int points, int i, int all, double* best) {
    const int apart = on_host && points > 0 ? all / points : 1;
    if (i % apart != 0 || i / apart >= points) return;
    double found[mechanisms] = {};
    point(i / apart, found);
    for (int k = 0; k < mechanisms; ++k) best[k] = best[k] < found[k] ? found[k] : best[k];
  }
};

/// The largest combined rate and its item.
template <class Point>
struct LargestPlace {
  Point point;

  KOKKOS_FUNCTION void operator()(int i, Kokkos::MaxLoc<double, int>::value_type& best) const {
    double found[mechanisms] = {};
    point(i, found);
    if (found[combined] > best.val) best = {found[combined], i};
  }
};

}  // namespace softwet::step_points
