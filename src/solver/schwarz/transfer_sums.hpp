// Entries of a vector on its way between two levels, each summed along all axes at once.
#pragma once

#include "field/stencil.hpp"
#include "solver/schwarz/axis_transfer.hpp"

namespace softwet {

/// Where the components of a vector lie on its way from one space to the other.
template <int D>
struct Places {
  int extent[D];                   ///< control points along each axis
  int points;                      ///< of all axes
  int shift[D + 2], first[D + 2];  ///< as in ComponentPlaces
};

/// The places of a vector of unknowns.
template <int D>
Places<D> places_of(const Layout<D>& layout) {
  const ComponentPlaces<D> components(layout);
  Places<D> p;
  p.points = 1;
  for (int d = 0; d < D; ++d) p.points *= p.extent[d] = layout.extent(d);
  for (int c = 0; c < D + 2; ++c) {
    p.shift[c] = components.shift[c];
    p.first[c] = components.first[c];
  }
  return p;
}

/// What a vector is on the other level. An entry is computed where a kernel asks for it, so that one that needs the
/// result or makes its source takes no kernel beside it. The source is of the precision Real.
template <int D, class Real>
struct SumAllAxes {
  AxisSums sums[D];
  Places<D> from_place, to_place;
  ConstArrayOf<Real> from;
  ConstArray mask;  ///< of the result
  int components;

  KOKKOS_FUNCTION double operator()(int entry) const {
    if (mask(entry) == 0) return 0;
    int c = components - 1;
    while (c > 0 && entry < to_place.shift[c] + to_place.first[c]) --c;
    int at[D], rest = entry - to_place.shift[c];
    for (int d = 0; d < D; ++d) {
      at[d] = rest % to_place.extent[d];
      rest /= to_place.extent[d];
    }
    return along<D - 1>(c, at, 0);
  }

 private:
  /// @param above  number of the line (plane) of source points along the axes behind d
  template <int d>
  KOKKOS_FUNCTION double along(int c, const int (&at)[D], int above) const {
    double sum = 0;
    for (int k = 0; k < static_cast<int>(sums[d].weight.extent(1)); ++k) {
      const double weight = sums[d].weight(at[d], k);
      const int next = above * from_place.extent[d] + sums[d].source(at[d], k);
      if (weight == 0) continue;
      if constexpr (d > 0) {
        sum += weight * along<d - 1>(c, at, next);
      } else if (next >= from_place.first[c]) {
        sum += weight * static_cast<double>(from(from_place.shift[c] + next));
      }
    }
    return sum;
  }
};

/// Entries of a vector, as a kernel or as part of one.
template <class Values>
struct WriteEntries {
  Values values;
  Array to;

  int items() const { return static_cast<int>(to.extent(0)); }
  KOKKOS_FUNCTION void operator()(int i) const { to(i) = values(i); }
};

}  // namespace softwet
