#include "time/smallest_neighbour.hpp"

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

/// The smallest of the values around each along one axis. An item is a row of values along the first axis on the host, and one
/// value on a device.
template <int P>
struct SmallestAlong {
  static constexpr int width = 2 * P + 1;
  const double* in;
  double* out;
  double ratio;  ///< above 0: values of `out` are cut to so many times the smallest ones
  Table table;
  int row, stride;

  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (host_algorithms) {
      const int begin = item * row;
      stride == 1 ? first_axis(begin) : other_axis(begin, place_of(begin));
    } else {
      const int place = place_of(item);
      double least = in[item];
      for (int k = 0; k < width; ++k) least = Kokkos::min(least, in[item + (table(k, place) - place) * stride]);
      store(item, least);
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION int place_of(int i) const { return i / stride % static_cast<int>(table.extent(1)); }
  KOKKOS_FORCEINLINE_FUNCTION void store(int i, double least) const {
    out[i] = ratio > 0 ? Kokkos::min(out[i], ratio * least) : least;
  }
  void first_axis(int begin) const {
    const int* at[width];
    for (int k = 0; k < width; ++k) at[k] = &table(k, 0);
    for (int i = 0; i < row; ++i) {
      double least = in[begin + i];
      for (int k = 0; k < width; ++k) least = Kokkos::min(least, in[begin + at[k][i]]);
      store(begin + i, least);
    }
  }
  void other_axis(int begin, int place) const {
    int from[width];
    for (int k = 0; k < width; ++k) from[k] = begin + (table(k, place) - place) * stride;
    for (int i = 0; i < row; ++i) {
      double least = in[begin + i];
      for (int k = 0; k < width; ++k) least = Kokkos::min(least, in[from[k] + i]);
      store(begin + i, least);
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
  for (Array& a : scratch_) a = Array("smallest_neighbour", l.rows * l.row_size);
}

template <int D, int P>
void SmallestNeighbour<D, P>::limit(const Array& x, double ratio, bool velocities) const {
  const std::array<Table, D>& tables = velocities ? velocity_ : scalar_;
  const int row = layout_.extent(0), count = static_cast<int>(x.extent(0)),
            items = host_algorithms ? count / row : count;
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const bool last = d == D - 1;
    const double* from = d == 0 ? x.data() : scratch_[(d - 1) % 2].data();
    double* to = last ? x.data() : scratch_[d % 2].data();
    Kokkos::parallel_for("softwet::smallest_neighbour", Items(0, items),
                         SmallestAlong<P>{from, to, last ? ratio : 0, tables[d], row, stride});
    stride *= static_cast<int>(tables[d].extent(1));
  }
}

template class SmallestNeighbour<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
