// Kernels of the product with a stencil matrix.
#pragma once

#include "memory/chunk.hpp"
#include "solver/matrix/stencil_matrix.hpp"

namespace softwet {

/// Free values of a vector, in single precision, by component and line. Lines carry `degree` values in front and more
/// behind, so that a product reads whole packs: zeros, or what a periodic axis repeats. Values that do not exist are
/// zero.
template <int D>
struct SpreadValues {
  Stencil<D> stencil;
  ConstArray x, mask;
  StencilValues out;
  ComponentPlaces<D> places;
  int stored;  ///< of a line

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = stencil.extent[0], count = stencil.points / n;
    const int at = static_cast<int>(item % stored), line = static_cast<int>(item / stored % count);
    const int c = static_cast<int>(item / stored / count);
    const int i = at < n + 2 * stencil.degree ? wrapped(at - stencil.degree, n, stencil.period[0]) : -1;
    const int point = line * n + i, unknown = places.shift[c] + point;
    out(item) = i < 0 || point < places.first[c] ? 0.0f : static_cast<float>(x(unknown) * mask(unknown));
  }
};

/// Rows of a product at once: on the host pieces of neighbouring lines, so that each of the matrix' many streams is
/// read some hundred entries at a time; on a device one row per thread.
inline constexpr int stencil_piece = chunk(128), lines_at_once = chunk(8), stencil_pack = chunk(16);

/// y of one component on pieces of some lines of control points, offset by offset.
template <int D>
struct MultiplyPieces {
  Stencil<D> stencil;
  StencilValues values, x;
  ConstArray mask;
  Array y;
  ComponentPlaces<D> places;
  int stored;  ///< of a line of x

  KOKKOS_FUNCTION int pieces() const { return chunks_in(stencil.extent[0], stencil_piece); }
  KOKKOS_FUNCTION int groups() const { return chunks_in(stencil.extent[1], lines_at_once); }
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
            const float* entry = values.data() + stencil.index(a, u, across * width + o, first + l * n);
            add(entry, x.data() + (u * (stencil.points / n) + to[l]) * stored + begin + o, count, sum[l]);
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
    for (int k = 0; k < count; k += stencil_pack)  // whole packs: what lies beyond the line is not used
      for (int i = k; i < k + stencil_pack; ++i) sum[i] += entry[i] * from[i];
  }
};

}  // namespace softwet
