#include "time/masses/smallest_neighbour.hpp"

namespace softwet {
namespace {

using Table = NeighbourTable;

/// @param functions, places  the function of each place, and the place of each function, -1: nowhere
/// @param period             functions of a periodic axis; 0: it ends
Table neighbours(const std::vector<int>& functions, const std::vector<int>& places, int degree, int period) {
  const int count = static_cast<int>(functions.size()), last = static_cast<int>(places.size()) - 1;
  Kokkos::View<int**, Kokkos::LayoutRight, Kokkos::HostSpace> table("neighbours", 2 * degree + 1, count);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k <= 2 * degree; ++k) {
      int f = functions[i] + k - degree;
      if (period > 0) f = (f + period) % period;
      const int place = f < 0 || f > last ? -1 : places[f];
      table(k, i) = place < 0 ? i : place;
    }
  Kokkos::View<int**, Kokkos::LayoutRight, Exec> device("neighbours", 2 * degree + 1, count);
  Kokkos::deep_copy(device, table);
  return device;
}

std::vector<int> numbers(int count) {
  std::vector<int> all(count);
  for (int i = 0; i < count; ++i) all[i] = i;
  return all;
}

}  // namespace

template <int D, int P>
SmallestNeighbour<D, P>::SmallestNeighbour(const Layout<D>& l) : layout_(l) {
  for (int d = 0; d < D; ++d) {
    const Axis& axis = l.axis[d];
    std::vector<int> functions = numbers(l.extent(d)), places = numbers(axis.functions());
    if (d == 0 && l.columns.stored() > 0) {
      functions = l.columns.function;
      places = places_of_functions(axis, l.columns);
    }
    const int period = axis.periodic() ? axis.owned() : 0;
    for (int& f : functions) f = period > 0 ? f % period : f;
    velocity_[d] = neighbours(functions, places, P, period);
    scalar_[d] = d < D - 1 ? velocity_[d] : neighbours(numbers(l.fluid_rows()), numbers(l.fluid_rows()), P, period);
  }
}

template <int D, int P>
Counted<CutToNeighbours<D, P>> SmallestNeighbour<D, P>::limit(const ConstArray& x, const Array& out, double ratio,
                                                              Unknowns of) const {
  CutToNeighbours<D, P> cut{x.data(), out.data(), ratio, {}};
  for (int d = 0; d < D; ++d) cut.table[d] = of == Unknowns::velocities ? velocity_[d] : scalar_[d];
  const int count = static_cast<int>(x.extent(0));
  return {host_algorithms ? count / layout_.extent(0) : count, cut};
}

template class SmallestNeighbour<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
