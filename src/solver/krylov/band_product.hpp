// One value, or one block of lines, of a product with the mass of the fixed mesh: for kernels that go on with it.
#pragma once

#include <algorithm>
#include <utility>
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
    bool plain = true;
    for (int d = 0; d < D; ++d) {
      place[d] = rest % extent[d];
      rest /= extent[d];
      plain = plain && extent[d] >= width && (owned[d] == extent[d] || place[d] >= P);
    }
    if (!plain) return closed<D - 1>(i, place);
    Window window[D];
    const double* first = in + i;
    for (int d = 0; d < D; ++d) first += take_window(d, place[d], window[d]) * stride[d];
    return inside<D - 1>(first, window);
  }

  /// As many values as a row of a band has, all of them inside of the axis, and their factors: some are zero at an end.
  struct Window {
    double factor[width];
  };
  /// Where the window of a place begins, as a distance from the place.
  KOKKOS_FORCEINLINE_FUNCTION int take_window(int d, int place, Window& window) const {
    const int wanted = place - P, last = extent[d] - width;
    const int shift = (wanted < 0 ? 0 : wanted > last ? last : wanted) - wanted;
    for (int k = 0; k < width; ++k) {
      const int entry = k + shift;
      window.factor[k] = entry >= 0 && entry < width ? band[d](entry, place) : 0.0;
    }
    return shift - P;
  }
  /// The sum of the axes up to d over windows, without tests of bounds.
  template <int d>
  KOKKOS_FORCEINLINE_FUNCTION double inside(const double* from, const Window (&window)[D]) const {
    if constexpr (d < 0) {
      return *from;
    } else {
      const int step = d == 0 ? 1 : stride[d];
      return [&]<int... k>(std::integer_sequence<int, k...>) {
        return (... + (window[d].factor[k] * inside<d - 1>(from + k * step, window)));
      }
      (std::make_integer_sequence<int, width>());
    }
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
  /// The lines and factors that the sums along axis d at a place are made of, where line(p) are the sums of the axes
  /// before at place p.
  struct LineSum {
    const double* from[width];
    double factor[width];
    double operator()(int i) const {
      double sum = factor[0] * from[0][i];
      for (int k = 1; k < width; ++k) sum += factor[k] * from[k][i];
      return sum;
    }
  };
  template <class LineAt>
  LineSum line_sum(int d, int place, const LineAt& line) const;
  /// Calls store(i, sum) for the sums along axis d at a place.
  template <class LineAt, class Store>
  void next_line(int d, int place, const LineAt& line, const Store& store) const;
  /// Whether sums along axis d at a place also count at the other end.
  bool closes(int d, int place) const { return owned[d] < extent[d] && place < P; }
  /// How many of the places in reach the sums along the last axis have to read before the one at `place` is known.
  int needed(const Reach& r, int place) const {
    return closes(D - 1, place) ? r.count() : r.index(std::min(extent[D - 1] - 1, place + P)) + 1;
  }
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
typename BandProduct<D, P>::LineSum BandProduct<D, P>::line_sum(int d, int place, const LineAt& line) const {
  LineSum sum;
  for (int k = 0; k < width; ++k) {
    const bool inside = place + k >= P && place + k < extent[d] + P;
    sum.from[k] = line(inside ? place + k - P : place);
    sum.factor[k] = inside ? band[d](k, place) : 0.0;
  }
  return sum;
}

template <int D, int P>
template <class LineAt, class Store>
void BandProduct<D, P>::next_line(int d, int place, const LineAt& line, const Store& store) const {
  const LineSum sum = line_sum(d, place, line);
  const int row = extent[0];
  if (!closes(d, place)) {
    SOFTWET_INDEPENDENT
    for (int i = 0; i < row; ++i) store(i, sum(i));
    return;
  }
  const LineSum beyond = line_sum(d, place + owned[d], line);
  SOFTWET_INDEPENDENT
  for (int i = 0; i < row; ++i) store(i, sum(i) + beyond(i));
}

// Sums of the axes before the last one lie in a ring of as many lines or planes as a sum along the last axis reads, so
// that they stay in the fastest memory. Where the last axis closes, all of them are kept.
template <int D, int P>
template <class Store>
void BandProduct<D, P>::for_values(BlockOfLines item, const Store& store) const {
  const int block = item.number, row = extent[0], component = block / blocks.count() * nodes;
  int first[3] = {}, last[3] = {1, 1, 1};
  Reach r[3] = {};
  for (int d = 1; d < D; ++d) {
    blocks.range(block, d, first[d], last[d]);
    r[d] = reach(d, first[d], last[d]);
  }
  constexpr int e = D - 1;
  const int kept = closes(e, first[e]) ? r[e].count() : std::min(width, r[e].count());
  const int lines = D == 3 ? r[1].count() : 0, high = D == 3 ? last[1] - first[1] : 1;
  double* of_first = thread_room(std::size_t(row) * (lines + kept * high));
  double* of_second = of_first + std::size_t(row) * lines;
  int made = 0;
  const auto make = [&](int k) {
    double* to = of_second + std::size_t(row) * (k % kept * high);
    if constexpr (D == 2) return first_line(in + component + r[1].place(k) * row, to);
    for (int y = 0; y < lines; ++y)
      first_line(in + component + (r[2].place(k) * extent[1] + r[1].place(y)) * row, of_first + y * row);
    for (int y = first[1]; y < last[1]; ++y, to += row)
      next_line(
          1, y, [&](int p) { return of_first + r[1].index(p) * row; }, [to](int i, double sum) { to[i] = sum; });
  };
  for (int z = first[e]; z < last[e]; ++z) {
    for (const int all = needed(r[e], z); made < all; ++made) make(made);
    for (int y = 0; y < high; ++y) {
      const int node = (D == 3 ? z * extent[1] + first[1] + y : z) * row, begin = component + node;
      next_line(
          e, z, [&](int p) { return of_second + std::size_t(row) * (r[e].index(p) % kept * high + y); },
          [&](int i, double sum) { store(begin + i, node + i, sum); });
    }
  }
}

}  // namespace softwet
