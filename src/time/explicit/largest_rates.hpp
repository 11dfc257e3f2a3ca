// The largest rates at the points of a state, and the ranges of its values, in one pass.
#pragma once

#include <algorithm>
#include <limits>

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

  /// Values [first, last) of a processor: several beside each other where all are its own.
  void take(int first, int last, double* best) const {
    if (width != stored) {
      for (int k = first; k < last; ++k) (*this)(k, best);
      return;
    }
    const int begin_density = std::clamp(first_density, first, last),
              end_density = std::clamp(last_density, begin_density, last);
    const bool finite = all_finite(begin_density, end_density);
    take_density(begin_density, end_density, best);
    if (!finite) best[most_density] = Kokkos::Experimental::infinity_v<double>;
    if (!finite || !all_finite(first, begin_density) || !all_finite(end_density, last)) best[not_finite] = 1;
  }

 private:
  static constexpr int lanes = 8;
  static constexpr double largest = std::numeric_limits<double>::max();

  bool all_finite(int first, int last) const {
    double wrong[lanes] = {};
    for (; first + lanes <= last; first += lanes)
      for (int l = 0; l < lanes; ++l) wrong[l] = Kokkos::abs(unknown[first + l]) <= largest ? wrong[l] : 1.0;
    for (; first < last; ++first) wrong[0] = Kokkos::abs(unknown[first]) <= largest ? wrong[0] : 1.0;
    return std::all_of(wrong, wrong + lanes, [](double w) { return w == 0; });
  }
  void take_density(int first, int last, double* best) const {
    double most[lanes], least[lanes];
    for (int l = 0; l < lanes; ++l) most[l] = -Kokkos::Experimental::infinity_v<double>, least[l] = -most[l];
    const auto take = [&](int l, double v) {
      most[l] = v > most[l] ? v : most[l];
      least[l] = v < least[l] ? v : least[l];
    };
    for (; first + lanes <= last; first += lanes)
      for (int l = 0; l < lanes; ++l) take(l, unknown[first + l]);
    for (; first < last; ++first) take(0, unknown[first]);
    for (int l = 0; l < lanes; ++l) {
      best[most_density] = std::max(best[most_density], most[l]);
      best[least_density] = std::max(best[least_density], -least[l]);
    }
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

  static constexpr int piece = chunk(64);  ///< points of an item

  KOKKOS_FUNCTION static int pieces(int points) { return (points + piece - 1) / piece; }
  int items() const { return std::max(pieces(fluid_points), pieces(solid_points)); }
  KOKKOS_FUNCTION void init(double* best) const {
    for (int k = 0; k <= not_finite; ++k) best[k] = 0;
    for (int k = most_density; k < found_numbers; ++k) best[k] = -Kokkos::Experimental::infinity_v<double>;
  }
  KOKKOS_FUNCTION void join(double* best, const double* other) const {
    for (int k = 0; k < found_numbers; ++k) best[k] = best[k] < other[k] ? other[k] : best[k];
  }
  KOKKOS_FUNCTION void operator()(int i, double* best) const {
    const int of_fluid = pieces(fluid_points), of_solid = pieces(solid_points);
    const int all = of_fluid > of_solid ? of_fluid : of_solid;
    take(fluid, fluid_points, i, all, best);
    take(solid, solid_points, i, all, best);
    if constexpr (host_algorithms) {
      const int share = (values + all - 1) / all;
      value.take(std::min(i * share, values), std::min((i + 1) * share, values), best);
    } else {
      for (int k = i; k < values; k += all) value(k, best);
    }
  }

 private:
  /// Threads of the host have ranges of the items: the pieces of points are spread over all of these.
  template <class Point>
  KOKKOS_FORCEINLINE_FUNCTION static void take(const Point& point, int points, int i, int all, double* best) {
    const int apart = on_host && points > 0 ? all / pieces(points) : 1;
    if (i % apart != 0 || i / apart >= pieces(points)) return;
    const int first = i / apart * piece, last = first + piece < points ? first + piece : points;
    if constexpr (host_algorithms && requires { point.take_largest(first, last, best); }) {
      point.take_largest(first, last, best);
    } else {
      for (int k = first; k < last; ++k) {
        double found[mechanisms] = {};
        point(k, found);
        for (int m = 0; m < mechanisms; ++m) best[m] = best[m] < found[m] ? found[m] : best[m];
      }
    }
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
