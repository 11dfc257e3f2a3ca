#include "solver/stencil.hpp"

#include <algorithm>
#include <utility>

#include "solver/bfloat16.hpp"
#include "solver/large_pages.hpp"

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

/// Free values of a vector, in single precision, by component and line. Lines carry `margin` values in front and more
/// behind, so that a product reads whole chunks: zeros, or what a periodic axis repeats. Values that do not exist are
/// zero.
template <int D, class Vector>
struct SpreadValues {
  Stencil<D> stencil;
  Vector x;
  ConstArray mask;
  StencilValues out;
  ComponentPlaces<D> places;
  StencilLines lines;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = lines.length, count = stencil.points / n;
    const int at = static_cast<int>(item % lines.stored), line = static_cast<int>(item / lines.stored % count);
    const int c = static_cast<int>(item / lines.stored / count);
    const int i =
        at < n + 2 * lines.margin ? wrapped(at - lines.margin, n, n < stencil.points ? stencil.period[0] : 0) : -1;
    const int point = line * n + i, unknown = places.shift[c] + point;
    out(item) = i < 0 || point < places.first[c] ? 0.0f : static_cast<float>(x(unknown) * mask(unknown));
  }
};

/// Rows of a product at once: on the host pieces of neighbouring lines, so that each of the matrix' many streams is
/// read some hundred entries at a time; on a device one row per thread.
constexpr int stencil_piece = host_algorithms ? 128 : 1, long_piece = host_algorithms ? 1024 : 1,
              lines_at_once = host_algorithms ? 8 : 1, pack = host_algorithms ? 16 : 1;

KOKKOS_FORCEINLINE_FUNCTION void store_product(const Array& y, const ConstArray& r, const ConstArray& mask, int i,
                                               double sum) {
  y(i) = (r.data() ? r(i) - sum : sum) * mask(i);
}

/// y of one component on pieces of some lines of control points, offset by offset.
template <int D, class Value>
struct MultiplyPieces {
  Stencil<D> stencil;
  Kokkos::View<const Value*, Exec> values;
  StencilValues x;
  ConstArray mask;
  ConstArray r;  ///< empty: y = A x, else y = r - A x
  Array y;
  ComponentPlaces<D> places;
  StencilLines stored_lines;

  KOKKOS_FUNCTION int pieces() const { return (stencil.extent[0] + stencil_piece - 1) / stencil_piece; }
  KOKKOS_FUNCTION int groups() const { return (stencil.extent[1] + lines_at_once - 1) / lines_at_once; }
  std::int64_t items() const {
    const int planes = stencil.points / (stencil.extent[0] * stencil.extent[1]);
    return std::int64_t(stencil.components) * planes * groups() * pieces();
  }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = stencil.extent[0], planes = stencil.points / (n * stencil.extent[1]);
    const int begin = static_cast<int>(item % pieces()) * stencil_piece;
    const int group = static_cast<int>(item / pieces() % groups()) * lines_at_once;
    const int plane = static_cast<int>(item / pieces() / groups() % planes);
    const int a = static_cast<int>(item / pieces() / groups() / planes);
    const int line = plane * stencil.extent[1] + group, first = line * n + begin;
    const int lines = group + lines_at_once < stencil.extent[1] ? lines_at_once : stencil.extent[1] - group;
    const int count = begin + stencil_piece < n ? stencil_piece : n - begin;
    if (first + (lines - 1) * n < places.first[a]) return;
    float sum[lines_at_once][stencil_piece] = {};
    const int width = 2 * stencil.degree + 1;
    for (int across = 0; across < stencil.offsets / width; ++across) {  // shifts along the other axes
      int to[lines_at_once];                                            // the neighbouring lines
      for (int l = 0; l < lines; ++l) to[l] = neighbour_line(first + l * n, across * width);
      for (int u = 0; u < stencil.components; ++u)
        for (int o = 0; o < width && stencil.couples(a, u); ++o)
          for (int l = 0; l < lines; ++l) {
            if (to[l] * n < places.first[u]) continue;  // also -1, none
            const Value* entry = values.data() + stencil.index(a, u, across * width + o, first + l * n);
            add(entry, x.data() + (u * (stencil.points / n) + to[l]) * stored_lines.stored + begin + o, count, sum[l]);
          }
    }
    for (int l = 0; l < lines; ++l) {
      const int point = first + l * n, unknown = places.shift[a] + point;
      if (point < places.first[a]) continue;
      for (int i = 0; i < count; ++i) store_product(y, r, mask, unknown + i, sum[l][i]);
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
  KOKKOS_FUNCTION static void add(const Value* entry, const float* from, int count, float* sum) {
    for (int k = 0; k < count; k += pack)  // whole packs: what lies beyond the line is not used
      for (int i = k; i < k + pack; ++i) sum[i] += widen(entry[i]) * from[i];
  }
};

/// y of one component on a piece of all control points. Where no axis is periodic, each neighbour is everywhere the same
/// distance away in storage: a neighbour beyond an end does not exist, and its entry is zero.
template <int D, class Value>
struct MultiplyLongPieces {
  Stencil<D> stencil;
  Kokkos::View<const Value*, Exec> values;
  StencilValues x;
  ConstArray mask;
  ConstArray r;  ///< empty: y = A x, else y = r - A x
  Array y;
  ComponentPlaces<D> places;
  StencilLines line;

  KOKKOS_FUNCTION int pieces() const { return (stencil.points + long_piece - 1) / long_piece; }
  std::int64_t items() const { return std::int64_t(stencil.components) * pieces(); }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int a = static_cast<int>(item / pieces()), begin = static_cast<int>(item % pieces()) * long_piece;
    const int end = begin + long_piece < stencil.points ? begin + long_piece : stencil.points, count = end - begin;
    if (end <= places.first[a]) return;
    float sum[long_piece] = {};
    const int whole = (count + pack - 1) / pack * pack;
    const int width = 2 * stencil.degree + 1;
    for (int u = 0; u < stencil.components; ++u)
      for (int across = 0; across < stencil.offsets; across += width) {
        const int to = begin + distance(across);
        if (to + width + count <= places.first[u] || !stencil.couples(a, u)) continue;
        const Value* entry = values.data() + stencil.index(a, u, across, begin);
        const float* from = x.data() + std::int64_t(u) * line.stored + line.margin + to;
        if (width == 5) {
          add(entry, from, whole, sum, std::make_integer_sequence<int, 5>());
        } else {
          for (int o = 0; o < width; ++o)
            add(entry + std::int64_t(o) * stencil.points, from + o, whole, sum, std::make_integer_sequence<int, 1>());
        }
      }
    for (int i = 0; i < count; ++i) {
      const int unknown = places.shift[a] + begin + i;
      if (begin + i >= places.first[a]) store_product(y, r, mask, unknown, sum[i]);
    }
  }
  KOKKOS_FUNCTION int distance(int offset) const {
    int result = 0, stride = 1;
    for (int d = 0; d < D; ++d) {
      result += stride * stencil.shift(offset, d);
      stride *= stencil.extent[d];
    }
    return result;
  }
  /// Offsets that follow each other along the first axis. Counts are whole packs: what lies beyond the end is not used.
  template <int... O>
  KOKKOS_FUNCTION void add(const Value* entry, const float* from, int count, float* sum,
                           std::integer_sequence<int, O...>) const {
    const std::int64_t next = stencil.points;
    for (int i = 0; i < count; ++i) sum[i] += ((widen(entry[O * next + i]) * from[O + i]) + ...);
  }
};

/// Rounds the values to 16 bits.
struct NarrowValues {
  StencilValues values;
  Kokkos::View<std::uint16_t*, Exec> out;
  KOKKOS_FUNCTION void operator()(std::int64_t i) const { out(i) = narrow(values(i)); }
};

}  // namespace

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask, Products products)
    : layout_(layout), stencil_(layout), mask_(mask), products_(products) {
  bool periodic = false;
  int stride = 1, farthest = 0;
  for (int d = 0; d < D; ++d) {
    periodic = periodic || layout.axis[d].periodic();
    farthest += stride * stencil_.degree;
    stride *= stencil_.extent[d];
  }
  lines_.length = periodic ? stencil_.extent[0] : stencil_.points;
  lines_.margin = periodic ? stencil_.degree : farthest;
  lines_.stored = (lines_.length + pack - 1) / pack * pack + 2 * lines_.margin;
  spread_ =
      StencilValues("stencil.x", std::int64_t(stencil_.components) * (stencil_.points / lines_.length) * lines_.stored);
}

template <int D>
void StencilMatrix<D>::fill(const Jacobian& jacobian) {
  using Policy = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;
  const auto all = Kokkos::make_pair(std::int64_t(0), stencil_.size());
  if (values_.extent(0) == 0) {
    values_ = large_array<StencilValues>("stencil", stencil_.size() + pack);  // a product reads beyond
    Kokkos::deep_copy(values_, 0.0f);
  }
  jacobian(Kokkos::subview(values_, all));
  if (products_ == Products::single) return;
  if (narrow_.extent(0) == 0) {
    narrow_ = large_array<Kokkos::View<std::uint16_t*, Exec>>("stencil.narrow", values_.extent(0));
    Kokkos::deep_copy(narrow_, std::uint16_t(0));
  }
  Kokkos::parallel_for("softwet::narrow", Policy(0, stencil_.size()), NarrowValues{values_, narrow_});
}

/// Some lines after the other, so that the memory for messages stays small.
template <int D>
void StencilMatrix<D>::update_copies() const {
  if (layout_.whole()) return;
  const std::int64_t lines = (std::int64_t(1) << 22) / layout_.axis[0].functions();  // the same for all processes
  const std::int64_t at_once = lines * layout_.columns.stored();
  for (std::int64_t first = 0; first < stencil_.size(); first += at_once) {
    const std::int64_t last = std::min(stencil_.size(), first + at_once);
    update_columns<float>(layout_.columns, *layout_.exchange, Kokkos::subview(values_, Kokkos::make_pair(first, last)));
  }
}

template <int D>
template <class Vector>
void StencilMatrix<D>::multiply_into(const ConstArray& r, const Vector& x, const Array& y) const {
  using Policy = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;
  const ComponentPlaces<D> places(layout_);
  const SpreadValues<D, Vector> spread{stencil_, x, mask_, spread_, places, lines_};
  Kokkos::parallel_for("softwet::spread", Policy(0, spread_.extent(0)), spread);
  const auto run = [&](const auto& product) {
    Kokkos::parallel_for("softwet::stencil_multiply", Policy(0, product.items()), product);
  };
  const auto with = [&](const auto& values) {
    using Value = typename std::decay_t<decltype(values)>::non_const_value_type;
    if (lines_.length == stencil_.points) {
      run(MultiplyLongPieces<D, Value>{stencil_, values, spread_, mask_, r, y, places, lines_});
    } else {
      run(MultiplyPieces<D, Value>{stencil_, values, spread_, mask_, r, y, places, lines_});
    }
  };
  products_ == Products::single ? with(values_) : with(narrow_);
}

template <int D>
void StencilMatrix<D>::multiply(const ConstArray& x, const Array& y) const {
  multiply_into({}, x, y);
}
template <int D>
void StencilMatrix<D>::residual(const ConstArray& r, const ConstArray& x, const Array& y) const {
  multiply_into(r, x, y);
}
template <int D>
void StencilMatrix<D>::residual(const ConstArray& r, const SumAllAxes<D, double>& x, const Array& y) const {
  multiply_into(r, x, y);
}

template class UnknownTable<2>;
template class UnknownTable<3>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
