// One value, or one block of lines, of a product with the mass of the fixed mesh: for kernels that go on with it.
#pragma once

#include <algorithm>
#include <vector>

#include "solver/krylov/line_blocks.hpp"

namespace softwet {

/// The product M in of components behind each other, axis by axis: first the sums along the first axis, of these those
/// along the next one. A periodic axis is closed: sums at its ghosts count for what the ghosts are copies of. Reads
/// ghosts, which have to be filled; the results there mean nothing.
template <int D, int P>
struct BandProduct {
  using Band = Kokkos::View<const double**, Kokkos::LayoutRight, Exec>;
  static constexpr int width = 2 * P + 1;

  Band band[D];              ///< entry (k, i) is M(i, i + k - degree)
  int extent[D], stride[D];  ///< values along each axis, and the distance between neighbours
  int owned[D];              ///< values before the ghosts of an axis that closes; else all
  int nodes;                 ///< of a component
  LineBlocks<D> blocks;
  const double* in;

  /// Calls store(value, node, product) for all values of an item.
  template <class Store>
  KOKKOS_FORCEINLINE_FUNCTION void for_values(OneValue value, const Store& store) const {
    store(value.number, value.number % nodes, at(value.number));
  }
  template <class Store>
  void for_values(BlockOfLines block, const Store& store) const;

 private:
  /// Value i of the product.
  KOKKOS_FUNCTION double at(int i) const {
    int place[D], rest = i % nodes;
    for (int d = 0; d < D; ++d) {
      place[d] = rest % extent[d];
      rest /= extent[d];
    }
    return closed<D - 1>(i, place);
  }

  /// The sum of the axes up to d.
  template <int d>
  KOKKOS_FORCEINLINE_FUNCTION double closed(int i, const int (&place)[D]) const {
    if constexpr (d < 0) {
      return in[i];
    } else {
      double sum = along<d>(i, place[d], place);
      if (owned[d] < extent[d] && place[d] < P) sum += along<d>(i + owned[d] * stride[d], place[d] + owned[d], place);
      return sum;
    }
  }
  template <int d>
  KOKKOS_FORCEINLINE_FUNCTION double along(int i, int at, const int (&place)[D]) const {
    double sum = 0;
    for (int k = 0; k < width; ++k)
      if (at + k >= P && at + k < extent[d] + P) sum += band[d](k, at) * closed<d - 1>(i + (k - P) * stride[d], place);
    return sum;
  }

  /// The places along an axis that the sums of a block read: a range, and behind it what a closing axis adds.
  struct Reach {
    int begin, end, more, last;
    int count() const { return end - begin + last - more; }
    int place(int k) const { return k < end - begin ? begin + k : more + k - (end - begin); }
    int index(int place) const { return place >= begin && place < end ? place - begin : end - begin + place - more; }
  };
  Reach reach(int d, int first, int last) const {
    Reach r{std::max(0, first - P), std::min(extent[d], last + P), extent[d], extent[d]};
    if (owned[d] < extent[d] && first < P) r.more = std::max(r.end, owned[d] + first - P);
    return r;
  }

  /// to = the sums along the first axis, of a line.
  void first_line(const double* from, double* to) const;
  /// to = the sums along axis d at a place, where line(p) are the sums of the axes before at place p. With room for a
  /// line.
  template <class LineAt>
  void next_line(int d, int place, const LineAt& line, double* to, double* beyond) const;
  template <class LineAt>
  void line_sum(int d, int place, const LineAt& line, double* to) const;
};

/// Memory of a thread, kept for later.
inline double* thread_room(std::size_t size) {
  thread_local std::vector<double> room;
  if (room.size() < size) room.resize(size);
  return room.data();
}

template <int D, int P>
void BandProduct<D, P>::first_line(const double* from, double* to) const {
  const int row = extent[0], end = std::max(P, row - P);
  const double* b[width];
  for (int k = 0; k < width; ++k) b[k] = &band[0](k, 0);
  const auto guarded = [&](int i) {
    double sum = 0;
    for (int k = 0; k < width; ++k)
      if (i + k >= P && i + k < row + P) sum += b[k][i] * from[i + k - P];
    return sum;
  };
  for (int i = 0; i < std::min(P, row); ++i) to[i] = guarded(i);
  SOFTWET_INDEPENDENT
  for (int i = P; i < end; ++i) {
    double sum = b[0][i] * from[i - P];
    for (int k = 1; k < width; ++k) sum += b[k][i] * from[i + k - P];
    to[i] = sum;
  }
  for (int i = end; i < row; ++i) to[i] = guarded(i);
  if (owned[0] < row)
    for (int i = 0; i < P; ++i) to[i] += to[owned[0] + i];
}

template <int D, int P>
template <class LineAt>
void BandProduct<D, P>::line_sum(int d, int place, const LineAt& line, double* to) const {
  const double* from[width];
  double b[width];
  for (int k = 0; k < width; ++k) {
    const bool inside = place + k >= P && place + k < extent[d] + P;
    from[k] = line(inside ? place + k - P : place);
    b[k] = inside ? band[d](k, place) : 0.0;
  }
  SOFTWET_INDEPENDENT
  for (int i = 0; i < extent[0]; ++i) {
    double sum = b[0] * from[0][i];
    for (int k = 1; k < width; ++k) sum += b[k] * from[k][i];
    to[i] = sum;
  }
}

template <int D, int P>
template <class LineAt>
void BandProduct<D, P>::next_line(int d, int place, const LineAt& line, double* to, double* beyond) const {
  line_sum(d, place, line, to);
  if (owned[d] == extent[d] || place >= P) return;
  line_sum(d, place + owned[d], line, beyond);
  for (int i = 0; i < extent[0]; ++i) to[i] += beyond[i];
}

template <int D, int P>
template <class Store>
void BandProduct<D, P>::for_values(BlockOfLines item, const Store& store) const {
  const int block = item.number, row = extent[0], component = block / blocks.count() * nodes;
  int first[3] = {}, last[3] = {1, 1, 1};
  Reach r[3] = {{}, {}, {0, 1, 1, 1}};
  for (int d = 1; d < D; ++d) {
    blocks.range(block, d, first[d], last[d]);
    r[d] = reach(d, first[d], last[d]);
  }
  const int high = last[1] - first[1], planes = r[2].count(), lines = r[1].count();
  double* room = thread_room(std::size_t(row) * (planes * (lines + high) + 2));
  double *sums = room, *beyond = sums + row, *of_first = beyond + row,
         *of_second = of_first + std::size_t(row) * planes * lines;
  for (int z = 0; z < planes; ++z)
    for (int y = 0; y < lines; ++y)
      first_line(in + component + (r[2].place(z) * extent[1] + r[1].place(y)) * row, of_first + (z * lines + y) * row);
  const auto finish = [&](int y, int z) {
    const int node = (z * extent[1] + y) * row, begin = component + node;
    SOFTWET_INDEPENDENT
    for (int i = 0; i < row; ++i) store(begin + i, node + i, sums[i]);
  };
  if constexpr (D == 2) {
    for (int y = first[1]; y < last[1]; ++y) {
      next_line(
          1, y, [&](int p) { return of_first + r[1].index(p) * row; }, sums, beyond);
      finish(y, 0);
    }
  } else {
    for (int z = 0; z < planes; ++z)
      for (int y = first[1]; y < last[1]; ++y) {
        next_line(
            1, y, [&](int p) { return of_first + (z * lines + r[1].index(p)) * row; },
            of_second + (z * high + y - first[1]) * row, beyond);
      }
    for (int z = first[2]; z < last[2]; ++z)
      for (int y = first[1]; y < last[1]; ++y) {
        next_line(
            2, z, [&](int p) { return of_second + (r[2].index(p) * high + y - first[1]) * row; }, sums, beyond);
        finish(y, z);
      }
  }
}

}  // namespace softwet
