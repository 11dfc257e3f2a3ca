// The smallest value among the functions that overlap with each function.
#pragma once

#include <vector>

#include "field/fused.hpp"
#include "solver/krylov/line_blocks.hpp"

namespace softwet {

/// Entry (k, i) is the place of function i + k - degree; at an end or where a process does not store it, i itself.
using NeighbourTable = Kokkos::View<const int**, Kokkos::LayoutRight, Exec>;

/// Values cut to `ratio` times the smallest one around each. An item is a line of values along the first axis on the
/// host, and one value on a device.
template <int D, int P>
struct CutToNeighbours {
  static constexpr int width = 2 * P + 1;
  const double* in;
  double* out;
  double ratio;
  NeighbourTable table[D];

  KOKKOS_FUNCTION int extent(int d) const { return static_cast<int>(table[d].extent(1)); }
  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (host_algorithms) {
      line(item * extent(0));
    } else {
      int place[D], rest = item;
      for (int d = 0; d < D; ++d) {
        place[d] = rest % extent(d);
        rest /= extent(d);
      }
      store(item, least<D - 1>(item, place));
    }
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void store(int i, double smallest) const {
    out[i] = Kokkos::min(in[i], ratio * smallest);
  }
  template <int d>
  KOKKOS_FORCEINLINE_FUNCTION double least(int i, const int (&place)[D]) const {
    if constexpr (d < 0) {
      return in[i];
    } else {
      int stride = 1;
      for (int e = 0; e < d; ++e) stride *= extent(e);
      double smallest = least<d - 1>(i, place);
      for (int k = 0; k < width; ++k)
        smallest = Kokkos::min(smallest, least<d - 1>(i + (table[d](k, place[d]) - place[d]) * stride, place));
      return smallest;
    }
  }

  /// The smallest of the lines around it first, then of the values around each of these.
  void line(int begin) const {
    const int row = extent(0), y = begin / row % extent(1), z = begin / row / extent(1);
    thread_local std::vector<double> room;
    room.assign(in + begin, in + begin + row);
    double* across = room.data();
    for (int l = 0; l < (D == 3 ? width : 1); ++l)
      for (int k = 0; k < width; ++k) {
        const double* beside =
            in + begin + ((D == 3 ? table[D - 1](l, z) - z : 0) * extent(1) + table[1](k, y) - y) * row;
        for (int i = 0; i < row; ++i) across[i] = Kokkos::min(across[i], beside[i]);
      }
    const int* at[width];
    for (int k = 0; k < width; ++k) at[k] = &table[0](k, 0);
    for (int i = 0; i < row; ++i) {
      double smallest = across[i];
      for (int k = 0; k < width; ++k) smallest = Kokkos::min(smallest, across[at[k][i]]);
      store(begin + i, smallest);
    }
  }
};

/// Works on one component by control point. Axes follow each other, for functions overlap where they do on every axis.
/// Tested: tests/unit/time/masses/test_mass_inverse.cpp
template <int D, int P>
class SmallestNeighbour {
 public:
  explicit SmallestNeighbour(const Layout<D>&);

  /// The kernel of out_i = min(x_i, ratio min_j x_j) in another array.
  Counted<CutToNeighbours<D, P>> limit(const ConstArray& x, const Array& out, double ratio, Unknowns) const;

 private:
  Layout<D> layout_;
  std::array<NeighbourTable, D> velocity_, scalar_;
};

}  // namespace softwet
