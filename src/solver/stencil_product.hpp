// Kernels of the product with a stencil matrix.
#pragma once

#include <utility>

#include "solver/bfloat16.hpp"
#include "solver/stencil.hpp"

namespace softwet {

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
inline constexpr int stencil_piece = host_algorithms ? 128 : 1, long_piece = host_algorithms ? 1024 : 1,
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

}  // namespace softwet
