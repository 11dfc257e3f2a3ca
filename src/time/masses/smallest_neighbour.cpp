#include "time/masses/smallest_neighbour.hpp"

namespace softwet {
namespace {

using Table = Kokkos::View<const int**, Kokkos::LayoutRight, Exec>;

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

/// Values cut to `ratio` times the smallest one around each. An item is a line of values along the first axis on the host,
/// and one value on a device.
template <int D, int P>
struct CutToNeighbours {
  static constexpr int width = 2 * P + 1;
  const double* in;
  double* out;
  double ratio;
  Table table[D];

  KOKKOS_FUNCTION int extent(int d) const { return static_cast<int>(table[d].extent(1)); }
  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (host_algorithms) {
      line(item * extent(0));
    } else {
      int place[D], rest = item;
      for (int d = 0; d < D; ++d) {
        place[d] = rest % extent(d);
        rest /= extent(d);
      }
      store(item, least<D - 1>(item, place));
    }
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void store(int i, double smallest) const {
    out[i] = Kokkos::min(in[i], ratio * smallest);
  }
  template <int d>
  KOKKOS_FORCEINLINE_FUNCTION double least(int i, const int (&place)[D]) const {
    if constexpr (d < 0) {
      return in[i];
    } else {
      int stride = 1;
      for (int e = 0; e < d; ++e) stride *= extent(e);
      double smallest = least<d - 1>(i, place);
      for (int k = 0; k < width; ++k)
        smallest = Kokkos::min(smallest, least<d - 1>(i + (table[d](k, place[d]) - place[d]) * stride, place));
      return smallest;
    }
  }

  /// The smallest of the lines around it first, then of the values around each of these.
  void line(int begin) const {
    const int row = extent(0), y = begin / row % extent(1), z = begin / row / extent(1);
    thread_local std::vector<double> room;
    room.assign(in + begin, in + begin + row);
    double* across = room.data();
    for (int l = 0; l < (D == 3 ? width : 1); ++l)
      for (int k = 0; k < width; ++k) {
        const double* beside =
            in + begin + ((D == 3 ? table[D - 1](l, z) - z : 0) * extent(1) + table[1](k, y) - y) * row;
        for (int i = 0; i < row; ++i) across[i] = Kokkos::min(across[i], beside[i]);
      }
    const int* at[width];
    for (int k = 0; k < width; ++k) at[k] = &table[0](k, 0);
    for (int i = 0; i < row; ++i) {
      double smallest = across[i];
      for (int k = 0; k < width; ++k) smallest = Kokkos::min(smallest, across[at[k][i]]);
      store(begin + i, smallest);
    }
  }
};

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
void SmallestNeighbour<D, P>::limit(const ConstArray& x, const Array& out, double ratio, bool velocities) const {
  CutToNeighbours<D, P> cut{x.data(), out.data(), ratio, {}};
  for (int d = 0; d < D; ++d) cut.table[d] = velocities ? velocity_[d] : scalar_[d];
  const int count = static_cast<int>(x.extent(0));
  Kokkos::parallel_for("softwet::smallest_neighbour", Items(0, host_algorithms ? count / layout_.extent(0) : count),
                       cut);
}

template class SmallestNeighbour<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
