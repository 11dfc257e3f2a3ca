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

/// Free values of a vector by component and control point of the patch, in single precision; others are zero.
struct SpreadValues {
  ConstArray x, mask;
  StencilValues out;
  int shift[5], first[5], points;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int c = item / points, point = item % points, unknown = shift[c] + point;
    out(item) = point < first[c] ? 0.0f : static_cast<float>(x(unknown) * mask(unknown));
  }
};

/// y of one component along a piece of a line of control points, offset by offset.
template <int D>
struct MultiplyLine {
  Stencil<D> stencil;
  StencilValues values, x;
  ConstArray mask;
  Array y;
  int shift[5], first[5];
  static constexpr int chunk = on_host ? 64 : 1;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = stencil.extent[0], chunks = (n + chunk - 1) / chunk, lines = stencil.points / n;
    const int begin = static_cast<int>(item % chunks) * chunk, count = n - begin < chunk ? n - begin : chunk;
    const int line = static_cast<int>(item / chunks % lines), a = static_cast<int>(item / chunks / lines);
    const int point = line * n + begin;
    if (point < first[a]) return;
    float sum[chunk] = {};
    for (int o = 0; o < stencil.offsets; ++o) {
      int to = 0, stride = n;  // first control point of the neighbouring line
      bool inside = true;
      for (int d = 1; d < D; ++d) {
        const int i = stencil.moved(stencil.coordinate(point, d), stencil.shift(o, d), d);
        inside = inside && i >= 0;
        to += stride * i;
        stride *= stencil.extent[d];
      }
      if (!inside) continue;
      for (int u = 0; u < stencil.components; ++u)
        if (to >= first[u])
          add_offset(values.data() + stencil.index(a, u, o, point), x.data() + u * stencil.points + to, begin, count,
                     stencil.shift(o, 0), sum);
    }
    for (int i = 0; i < count; ++i) y(shift[a] + point + i) = sum[i] * mask(shift[a] + point + i);
  }
  KOKKOS_FORCEINLINE_FUNCTION void add_offset(const float* entry, const float* from, int begin, int count, int move,
                                              float* sum) const {
    if (stencil.period[0] > 0) {
      for (int i = 0; i < count; ++i) sum[i] += entry[i] * from[stencil.moved(begin + i, move, 0)];
      return;
    }
    const int low = begin + move < 0 ? -(begin + move) : 0;
    const int high = begin + count + move > stencil.extent[0] ? stencil.extent[0] - begin - move : count;
    from += begin + move;
    for (int i = low; i < high; ++i) sum[i] += entry[i] * from[i];
  }
};

}  // namespace

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask)
    : layout_(layout), stencil_(layout), mask_(mask), spread_("stencil.x", stencil_.components * stencil_.points) {}

template <int D>
void StencilMatrix<D>::fill(const Jacobian& jacobian) {
  if (values_.extent(0) == 0)
    values_ = StencilValues(Kokkos::view_alloc("stencil", Kokkos::WithoutInitializing), stencil_.size());
  jacobian(values_);
}

template <int D>
void StencilMatrix<D>::multiply(const ConstArray& x, const Array& y) const {
  MultiplyLine<D> line{stencil_, values_, spread_, mask_, y, {}, {}};
  SpreadValues spread{x, mask_, spread_, {}, {}, stencil_.points};
  for (int c = 0; c < stencil_.components; ++c) {
    line.shift[c] = spread.shift[c] = component_shift(layout_, c);
    line.first[c] = spread.first[c] = c < D ? 0 : layout_.fluid_shift();
  }
  Kokkos::parallel_for("softwet::spread", Kokkos::RangePolicy<Exec>(0, spread_.extent(0)), spread);
  const int chunks = (stencil_.extent[0] + line.chunk - 1) / line.chunk;
  const std::int64_t items = std::int64_t(stencil_.components) * (stencil_.points / stencil_.extent[0]) * chunks;
  Kokkos::parallel_for("softwet::stencil_multiply",
                       Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>(0, items), line);
}

template class UnknownTable<2>;
template class UnknownTable<3>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
