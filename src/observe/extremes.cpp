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
  KOKKOS_FORCEINLINE_FUNCTION int place(int point) const {
    return begin + (width == stored ? point : point / width * stored + point % width);
  }
};

/// The extremes, each as a largest number.
enum Extreme { minus_least_density, most_density, square_in_fluid, square_in_liquid, square_in_solid, extremes };

/// Finds all extremes in one pass: squares are squares of velocities, 0 where no point counts.
template <int D>
struct FindExtremes {
  using value_type = double[];
  unsigned value_count = extremes;
  OwnPoints fluid, solid;
  const double *in_fluid, *in_solid;  ///< velocity of the first point of each, first component
  int stride;                         ///< of components
  const double* density;
  double level;

  KOKKOS_FUNCTION void init(double* best) const {
    for (int k = 0; k < extremes; ++k) best[k] = k <= most_density ? -Kokkos::Experimental::finite_max_v<double> : 0;
  }
  KOKKOS_FUNCTION void join(double* best, const double* other) const {
    for (int k = 0; k < extremes; ++k) raise(best[k], other[k]);
  }
  KOKKOS_FUNCTION void operator()(int point, double* best) const {
    if (point < fluid.count) {
      const int i = fluid.place(point);
      const double square = square_at(in_fluid, i);
      raise(best[minus_least_density], -density[i]);
      raise(best[most_density], density[i]);
      raise(best[square_in_fluid], square);
      if (density[i] > level) raise(best[square_in_liquid], square);
    }
    if (point < solid.count) raise(best[square_in_solid], square_at(in_solid, solid.place(point)));
  }

 private:
  /// A value that is not a number does not count.
  KOKKOS_FORCEINLINE_FUNCTION static void raise(double& best, double value) {
    if (value > best) best = value;
  }
  KOKKOS_FORCEINLINE_FUNCTION double square_at(const double* velocity, int i) const {
    double square = 0;
    for (int d = 0; d < D; ++d) square += velocity[d * stride + i] * velocity[d * stride + i];
    return square;
  }
};

template <int D, class Take>
void start(const FindExtremes<D>& all, PendingIntegrals& pending, const Take& take) {
  pending.start_numbers(
      extremes,
      [&all](const Array& best) {
        Kokkos::parallel_reduce("softwet::extremes", Items(0, std::max(all.fluid.count, all.solid.count)), all, best);
      },
      take);
}

}  // namespace

template <int D>
void start_extremes(const Layout<D>& l, const State& state, double level, PendingIntegrals& pending, Extremes& found) {
  const auto points = [&](int rows) { return OwnPoints(l.space(), rows * l.row_size); };
  const double* velocity = state.unknown.data();
  const FindExtremes<D> all{.fluid = points(l.fluid_rows()),
                            .solid = points(l.solid_rows()),
                            .in_fluid = velocity + l.fluid_shift(),
                            .in_solid = velocity,
                            .stride = l.rows * l.row_size,
                            .density = velocity + l.density_offset(),
                            .level = level};
  start(all, pending, [&found, has_fluid = l.has_fluid](const auto& of_process) {
    double best[extremes];
    std::copy_n(of_process.data(), int(extremes), best);
    ranks::largest(best, extremes);
    if (!has_fluid) best[minus_least_density] = best[most_density] = 0;
    found = {-best[minus_least_density], best[most_density], std::sqrt(best[square_in_fluid]),
             std::sqrt(best[square_in_solid]), std::sqrt(best[square_in_liquid])};
  });
}

template <int D>
Extremes find_extremes(const Layout<D>& layout, const State& state, double level) {
  Extremes found;
  PendingIntegrals pending;
  start_extremes(layout, state, level, pending, found);
  pending.finish();
  return found;
}

template void start_extremes(const Layout<2>&, const State&, double, PendingIntegrals&, Extremes&);
template void start_extremes(const Layout<3>&, const State&, double, PendingIntegrals&, Extremes&);
template Extremes find_extremes(const Layout<2>&, const State&, double);
template Extremes find_extremes(const Layout<3>&, const State&, double);

}  // namespace softwet
