#include "solver/stencil.hpp"

namespace softwet {

template <int D>
UnknownTable<D>::UnknownTable(const Layout<D>& layout, const std::vector<double>& mask)
    : points_(layout.rows * layout.row_size), component_(mask.size(), -1), point_(mask.size(), -1) {
  unknown_.assign(static_cast<std::size_t>(layout.components()) * points_, -1);
  for (int c = 0; c < layout.components(); ++c)
    for (int p = layout.component_first(c); p < points_; ++p) {
      const int i = layout.component_shift(c) + p;
      if (mask[i] == 0) continue;
      unknown_[c * points_ + p] = i;
      component_[i] = c;
      point_[i] = p;
    }
}

namespace {

/// Free values of a vector, in single precision, by component and line of control points along the first axis. Lines
/// carry `degree` values in front and a rest behind, so that a product reads whole chunks: zeros, or what a periodic
/// axis repeats. Values that do not exist are zero.
template <int D>
struct SpreadValues {
  Stencil<D> stencil;
  ConstArray x, mask;
  StencilValues out;
  ComponentPlaces<D> places;
  int line_length;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = stencil.extent[0], lines = stencil.points / n;
    const int at = static_cast<int>(item % line_length), line = static_cast<int>(item / line_length % lines);
    const int c = static_cast<int>(item / line_length / lines);
    const int i = at < n + 2 * stencil.degree ? stencil.moved(at, -stencil.degree, 0) : -1;
    const int point = line * n + i, unknown = places.shift[c] + point;
    out(item) = i < 0 || point < places.first[c] ? 0.0f : static_cast<float>(x(unknown) * mask(unknown));
  }
};

/// y of one component on a chunk of a line of control points, offset by offset.
template <int D>
struct MultiplyChunk {
  Stencil<D> stencil;
  StencilValues values, x;
  ConstArray mask;
  Array y;
  ComponentPlaces<D> places;
  int line_length;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    constexpr int chunk = StencilMatrix<D>::chunk;
    const int n = stencil.extent[0], chunks = (n + chunk - 1) / chunk, lines = stencil.points / n;
    const int begin = static_cast<int>(item % chunks) * chunk, line = static_cast<int>(item / chunks % lines);
    const int a = static_cast<int>(item / chunks / lines), point = line * n + begin;
    if (point < places.first[a]) return;
    const int width = 2 * stencil.degree + 1;
    float sum[chunk] = {};
    for (int across = 0; across < stencil.offsets / width; ++across) {  // shifts along the other axes
      int to = 0, stride = 1;                                           // the neighbouring line
      bool inside = true;
      for (int d = 1; d < D; ++d) {
        const int i = stencil.moved(stencil.coordinate(point, d), stencil.shift(across * width, d), d);
        inside = inside && i >= 0;
        to += stride * i;
        stride *= stencil.extent[d];
      }
      if (!inside) continue;
      for (int u = 0; u < stencil.components; ++u) {
        if (to * n < places.first[u]) continue;
        const float* from = x.data() + (u * lines + to) * line_length + begin;
        const float* entry = values.data() + stencil.index(a, u, across * width, point);
        for (int o = 0; o < width; ++o, ++from, entry += stencil.points)
          for (int i = 0; i < chunk; ++i) sum[i] += entry[i] * from[i];
      }
    }
    const int unknown = places.shift[a] + point;
    for (int i = 0; i < chunk && begin + i < n; ++i) y(unknown + i) = sum[i] * mask(unknown + i);
  }
};

}  // namespace

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask)
    : layout_(layout), stencil_(layout), mask_(mask) {
  const int n = stencil_.extent[0];
  line_length_ = (n + chunk - 1) / chunk * chunk + 2 * stencil_.degree;
  spread_ = StencilValues("stencil.x", stencil_.components * (stencil_.points / n) * line_length_);
}

template <int D>
void StencilMatrix<D>::fill(const Jacobian& jacobian) {
  const auto all = Kokkos::make_pair(std::int64_t(0), stencil_.size());
  if (values_.extent(0) == 0) values_ = StencilValues("stencil", stencil_.size() + chunk);  // a product reads beyond
  jacobian(Kokkos::subview(values_, all));
}

template <int D>
void StencilMatrix<D>::multiply(const ConstArray& x, const Array& y) const {
  using Policy = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;
  const ComponentPlaces<D> places(layout_);
  const SpreadValues<D> spread{stencil_, x, mask_, spread_, places, line_length_};
  const MultiplyChunk<D> product{stencil_, values_, spread_, mask_, y, places, line_length_};
  Kokkos::parallel_for("softwet::spread", Policy(0, spread_.extent(0)), spread);
  const int chunks = (stencil_.extent[0] + chunk - 1) / chunk;
  const std::int64_t items = std::int64_t(stencil_.components) * (stencil_.points / stencil_.extent[0]) * chunks;
  Kokkos::parallel_for("softwet::stencil_multiply", Policy(0, items), product);
}

template class UnknownTable<2>;
template class UnknownTable<3>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
