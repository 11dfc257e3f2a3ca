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

void smallest_along(const ConstArray& in, const Array& out, const Table& table, int stride) {
  const int extent = static_cast<int>(table.extent(1)), width = static_cast<int>(table.extent(0));
  Kokkos::parallel_for(
      "softwet::smallest_neighbour", Items(0, in.extent(0)), KOKKOS_LAMBDA(int i) {
        const int place = i / stride % extent;
        double least = in(i);
        for (int k = 0; k < width; ++k) least = Kokkos::min(least, in(i + (table(k, place) - place) * stride));
        out(i) = least;
      });
}

void limit_by(const Array& x, double ratio, const ConstArray& least) {
  Kokkos::parallel_for(
      "softwet::limit_by", Items(0, x.extent(0)), KOKKOS_LAMBDA(int i) { x(i) = Kokkos::min(x(i), ratio * least(i)); });
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
  for (Array& a : scratch_) a = Array("smallest_neighbour", l.rows * l.row_size);
}

template <int D, int P>
void SmallestNeighbour<D, P>::limit(const Array& x, double ratio, bool velocities) const {
  const std::array<Table, D>& tables = velocities ? velocity_ : scalar_;
  const auto cut = [&x](const Array& a) { return Kokkos::subview(a, Kokkos::make_pair(std::size_t(0), x.extent(0))); };
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const ConstArray from = d == 0 ? ConstArray(x) : ConstArray(cut(scratch_[(d - 1) % 2]));
    smallest_along(from, cut(scratch_[d % 2]), tables[d], stride);
    stride *= static_cast<int>(tables[d].extent(1));
  }
  limit_by(x, ratio, cut(scratch_[(D - 1) % 2]));
}

template class SmallestNeighbour<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
