#include "solver/matrix/equilibration.hpp"

#include <algorithm>
#include <cmath>

namespace softwet {

namespace {

/// Largest entry of each row (or column) of one component on one line of control points along the first axis. An entry
/// counts with the weight of its column (or row).
template <int D, bool Columns>
struct LargestOnLine {
  Stencil<D> stencil;
  ComponentPlaces<D> places;
  const float *values, *weight;
  float* largest;

  int lines() const { return stencil.points / stencil.extent[0]; }

  void operator()(int item) const {
    const int component = item / lines(), first = item % lines() * stencil.extent[0];
    if (first < places.first[component]) return;
    const int width = 2 * stencil.degree + 1;
    for (int across = 0; across < stencil.offsets / width; ++across) {  // shifts along the other axes
      const int other = other_line(first, across * width);
      if (other < 0) continue;
      for (int c = 0; c < stencil.components; ++c)
        if (other >= places.first[c] && couples(component, c))
          for (int o = 0; o < width; ++o) add(component, c, across * width + o, first, other);
    }
  }
  bool couples(int component, int c) const {
    return Columns ? stencil.couples(c, component) : stencil.couples(component, c);
  }
  /// First point of the line of columns (or rows) at an offset; -1 outside.
  int other_line(int point, int offset) const {
    int to = 0, stride = stencil.extent[0];
    for (int d = 1; d < D; ++d) {
      const int shift = Columns ? -stencil.shift(offset, d) : stencil.shift(offset, d);
      const int i = stencil.moved(stencil.coordinate(point, d), shift, d);
      if (i < 0) return -1;
      to += stride * i;
      stride *= stencil.extent[d];
    }
    return to;
  }
  void add(int component, int c, int offset, int line, int other) const {
    const int shift = stencil.shift(offset, 0);
    const int a = Columns ? c : component, u = Columns ? component : c;
    const float* entry = values + stencil.index(a, u, offset, Columns ? other : line);
    const float* other_weight = weight + places.shift[c] + other;
    float* most = largest + places.shift[component] + line;
    const int n = stencil.period[0] > 0 ? stencil.period[0] : stencil.extent[0];
    const int begin = std::max(0, -shift), end = std::min(n, n - shift);
    const auto one = [&](int row, int column) {
      const int to = Columns ? column : row, from = Columns ? row : column;
      const float size = std::abs(entry[row]) * other_weight[from];
      most[to] = size > most[to] ? size : most[to];
    };
    for (int row = begin; row < end; ++row) one(row, row + shift);
    if (stencil.period[0] == 0) return;
    for (int row = 0; row < std::min(begin, n); ++row) one(row, wrapped(row + shift, n, n));
    for (int row = std::max(end, 0); row < n; ++row) one(row, wrapped(row + shift, n, n));
  }
};

template <class Body>
void for_lines(int count, const Body& body) {
  Kokkos::parallel_for("softwet::scale", Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace>(0, count), body);
}

}  // namespace

template <int D>
Equilibrator<D>::Equilibrator(const Layout<D>& layout, const UnknownTable<D>& table)
    : stencil_(layout), places_(layout), free_(layout.size()), weight_(layout.size()) {
  for (int i = 0; i < layout.size(); ++i) free_[i] = table.component(i) < 0 ? 0.0f : 1.0f;
}

template <int D>
void Equilibrator<D>::compute(const Kokkos::View<const float*, Kokkos::HostSpace>& values, Equilibration& result) {
  const int items = stencil_.points / stencil_.extent[0] * stencil_.components;
  const auto invert = [&](std::vector<float>& largest) {
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = free_[i] > 0 && largest[i] > 0 ? 1 / largest[i] : 1;
  };
  result.row.assign(free_.size(), 0.0f);
  result.column.assign(free_.size(), 0.0f);
  for_lines(items, LargestOnLine<D, false>{stencil_, places_, values.data(), free_.data(), result.row.data()});
  invert(result.row);
  for (std::size_t i = 0; i < free_.size(); ++i) weight_[i] = free_[i] * result.row[i];
  for_lines(items, LargestOnLine<D, true>{stencil_, places_, values.data(), weight_.data(), result.column.data()});
  invert(result.column);
}

template class Equilibrator<2>;
template class Equilibrator<3>;

}  // namespace softwet
