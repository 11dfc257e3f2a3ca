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

/// y of one component along one row of control points: all columns of one offset after another.
template <int D>
struct MultiplyRow {
  Stencil<D> stencil;
  StencilValues values;
  ConstArray x, mask;
  Array y;
  int shift[D + 2], first[D + 2];  ///< of each component: unknown - point, and its first point
  static constexpr int chunk = on_host ? 64 : 1;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = stencil.extent[0], chunks = (n + chunk - 1) / chunk, rows = stencil.points / n;
    const int begin = static_cast<int>(item % chunks) * chunk, count = n - begin < chunk ? n - begin : chunk;
    const int line = static_cast<int>(item / chunks % rows), a = static_cast<int>(item / chunks / rows);
    const int point = line * n + begin;
    if (point + count <= first[a]) return;
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
      if (inside) add_offset(o, point, begin, count, to, a, sum);
    }
    for (int i = 0; i < count; ++i) y(shift[a] + point + i) = sum[i] * mask(shift[a] + point + i);
  }
  KOKKOS_FUNCTION void add_offset(int o, int point, int begin, int count, int to, int a, float* sum) const {
    const int move = stencil.shift(o, 0);
    for (int u = 0; u < stencil.components; ++u) {
      if (to < first[u]) continue;
      const float* entry = values.data() + stencil.index(a, u, o, point);
      const double* from = x.data() + shift[u] + to;
      const double* free = mask.data() + shift[u] + to;
      if (begin + move >= 0 && begin + count + move <= stencil.extent[0] && stencil.period[0] == 0) {
        for (int i = 0; i < count; ++i)
          sum[i] += entry[i] * static_cast<float>(from[begin + i + move] * free[begin + i + move]);
        continue;
      }
      for (int i = 0; i < count; ++i) {
        const int j = stencil.moved(begin + i, move, 0);
        if (j >= 0) sum[i] += entry[i] * static_cast<float>(from[j] * free[j]);
      }
    }
  }
};

}  // namespace

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask)
    : layout_(layout), stencil_(layout), mask_(mask) {}

template <int D>
void StencilMatrix<D>::fill(const Jacobian& jacobian) {
  if (values_.extent(0) == 0)
    values_ = StencilValues(Kokkos::view_alloc("stencil", Kokkos::WithoutInitializing), stencil_.size());
  jacobian(values_);
}

template <int D>
void StencilMatrix<D>::multiply(const ConstArray& x, const Array& y) const {
  MultiplyRow<D> row{stencil_, values_, x, mask_, y, {}, {}};
  for (int c = 0; c < stencil_.components; ++c) {
    row.shift[c] = component_shift(layout_, c);
    row.first[c] = c < D ? 0 : layout_.fluid_shift();
  }
  const int chunks = (stencil_.extent[0] + row.chunk - 1) / row.chunk;
  const std::int64_t items = std::int64_t(stencil_.components) * (stencil_.points / stencil_.extent[0]) * chunks;
  Kokkos::parallel_for("softwet::stencil_multiply",
                       Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>(0, items), row);
}

template class UnknownTable<2>;
template class UnknownTable<3>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
