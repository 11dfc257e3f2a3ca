#include "solver/stencil.hpp"

namespace softwet {

template <int D>
UnknownTable<D>::UnknownTable(const Layout<D>& layout, const std::vector<double>& mask)
    : points_(layout.rows * layout.row_size), component_(mask.size(), -1), point_(mask.size(), -1) {
  const int components = layout.has_fluid ? D + 2 : D;
  unknown_.assign(static_cast<std::size_t>(components) * points_, -1);
  for (int c = 0; c < components; ++c)
    for (int p = c < D ? 0 : layout.fluid_shift(); p < points_; ++p) {
      const int i = component_shift(layout, c) + p;
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
  int shift[D + 2], first[D + 2], line_length;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = stencil.extent[0], lines = stencil.points / n;
    const int at = static_cast<int>(item % line_length), line = static_cast<int>(item / line_length % lines);
    const int c = static_cast<int>(item / line_length / lines);
    const int i = at < n + 2 * stencil.degree ? stencil.moved(at, -stencil.degree, 0) : -1;
    const int point = line * n + i, unknown = shift[c] + point;
    out(item) = i < 0 || point < first[c] ? 0.0f : static_cast<float>(x(unknown) * mask(unknown));
  }
};

/// y of one component on a chunk of a line of control points, offset by offset.
template <int D>
struct MultiplyChunk {
  Stencil<D> stencil;
  StencilValues values, x;
  ConstArray mask;
  Array y;
  int shift[D + 2], first[D + 2], line_length;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    constexpr int chunk = StencilMatrix<D>::chunk;
    const int n = stencil.extent[0], chunks = (n + chunk - 1) / chunk, lines = stencil.points / n;
    const int begin = static_cast<int>(item % chunks) * chunk, line = static_cast<int>(item / chunks % lines);
    const int a = static_cast<int>(item / chunks / lines), point = line * n + begin;
    if (point < first[a]) return;
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
        if (to * n < first[u]) continue;
        const float* from = x.data() + (u * lines + to) * line_length + begin;
        const float* entry = values.data() + stencil.index(a, u, across * width, point);
        for (int o = 0; o < width; ++o, ++from, entry += stencil.points)
          for (int i = 0; i < chunk; ++i) sum[i] += entry[i] * from[i];
      }
    }
    for (int i = 0; i < chunk && begin + i < n; ++i)
      y(shift[a] + point + i) = sum[i] * mask(shift[a] + point + i);
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
  SpreadValues<D> spread{stencil_, x, mask_, spread_, {}, {}, line_length_};
  MultiplyChunk<D> product{stencil_, values_, spread_, mask_, y, {}, {}, line_length_};
  for (int c = 0; c < stencil_.components; ++c) {
    product.shift[c] = spread.shift[c] = component_shift(layout_, c);
    product.first[c] = spread.first[c] = c < D ? 0 : layout_.fluid_shift();
  }
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
