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

/// Rows of a product at once: on the host pieces of neighbouring lines, so that each of the matrix' many streams is
/// read some hundred entries at a time; on a device one row per thread.
constexpr int piece = on_host ? 128 : 1, lines_at_once = on_host ? 8 : 1, pack = on_host ? 16 : 1;

/// y of one component on pieces of some lines of control points, offset by offset.
template <int D>
struct MultiplyPieces {
  Stencil<D> stencil;
  StencilValues values, x;
  ConstArray mask;
  Array y;
  ComponentPlaces<D> places;
  int line_length;

  KOKKOS_FUNCTION int pieces() const { return (stencil.extent[0] + piece - 1) / piece; }
  KOKKOS_FUNCTION int groups() const { return (stencil.extent[1] + lines_at_once - 1) / lines_at_once; }
  std::int64_t items() const {
    const int planes = stencil.points / (stencil.extent[0] * stencil.extent[1]);
    return std::int64_t(stencil.components) * planes * groups() * pieces();
  }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = stencil.extent[0], planes = stencil.points / (n * stencil.extent[1]);
    const int begin = static_cast<int>(item % pieces()) * piece;
    const int group = static_cast<int>(item / pieces() % groups()) * lines_at_once;
    const int plane = static_cast<int>(item / pieces() / groups() % planes);
    const int a = static_cast<int>(item / pieces() / groups() / planes);
    const int line = plane * stencil.extent[1] + group, first = line * n + begin;
    const int lines = group + lines_at_once < stencil.extent[1] ? lines_at_once : stencil.extent[1] - group;
    const int count = begin + piece < n ? piece : n - begin;
    if (first + (lines - 1) * n < places.first[a]) return;
    float sum[lines_at_once][piece] = {};
    const int width = 2 * stencil.degree + 1;
    for (int across = 0; across < stencil.offsets / width; ++across) {  // shifts along the other axes
      int to[lines_at_once];                                            // the neighbouring lines
      for (int l = 0; l < lines; ++l) to[l] = neighbour_line(first + l * n, across * width);
      for (int u = 0; u < stencil.components; ++u)
        for (int o = 0; o < width; ++o)
          for (int l = 0; l < lines; ++l) {
            if (to[l] * n < places.first[u]) continue;  // also -1, none
            const float* entry = values.data() + stencil.index(a, u, across * width + o, first + l * n);
            add(entry, x.data() + (u * (stencil.points / n) + to[l]) * line_length + begin + o, count, sum[l]);
          }
    }
    for (int l = 0; l < lines; ++l) {
      const int point = first + l * n, unknown = places.shift[a] + point;
      if (point < places.first[a]) continue;
      for (int i = 0; i < count; ++i) y(unknown + i) = sum[l][i] * mask(unknown + i);
    }
  }
  KOKKOS_FUNCTION int neighbour_line(int point, int offset) const {
    int to = 0, stride = 1;
    for (int d = 1; d < D; ++d) {
      const int i = stencil.moved(stencil.coordinate(point, d), stencil.shift(offset, d), d);
      if (i < 0) return -1;
      to += stride * i;
      stride *= stencil.extent[d];
    }
    return to;
  }
  KOKKOS_FUNCTION static void add(const float* entry, const float* from, int count, float* sum) {
    for (int k = 0; k < count; k += pack)  // whole packs: what lies beyond the line is not used
      for (int i = k; i < k + pack; ++i) sum[i] += entry[i] * from[i];
  }
};

}  // namespace

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask)
    : layout_(layout), stencil_(layout), mask_(mask) {
  const int n = stencil_.extent[0];
  line_length_ = (n + pack - 1) / pack * pack + 2 * stencil_.degree;
  spread_ = StencilValues("stencil.x", stencil_.components * (stencil_.points / n) * line_length_);
}

template <int D>
void StencilMatrix<D>::fill(const Jacobian& jacobian) {
  const auto all = Kokkos::make_pair(std::int64_t(0), stencil_.size());
  if (values_.extent(0) == 0) values_ = StencilValues("stencil", stencil_.size() + pack);  // a product reads beyond
  jacobian(Kokkos::subview(values_, all));
}

template <int D>
void StencilMatrix<D>::multiply(const ConstArray& x, const Array& y) const {
  using Policy = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;
  const ComponentPlaces<D> places(layout_);
  const SpreadValues<D> spread{stencil_, x, mask_, spread_, places, line_length_};
  const MultiplyPieces<D> product{stencil_, values_, spread_, mask_, y, places, line_length_};
  Kokkos::parallel_for("softwet::spread", Policy(0, spread_.extent(0)), spread);
  Kokkos::parallel_for("softwet::stencil_multiply", Policy(0, product.items()), product);
}

template class UnknownTable<2>;
template class UnknownTable<3>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
