// The matrices of boxes, out of the matrix of a level.
#pragma once

#include "solver/direct/device/gauss_jordan.hpp"
#include "solver/schwarz/patches.hpp"

namespace softwet {

/// Rows of the boxes' matrices out of the stencil: those of one component on one line of control points of a box. On the
/// host an item does so for all boxes that follow each other along the first axis, for their values lie side by side.
template <int D>
struct FillRows {
  Stencil<D> stencil;
  StencilValues values;
  Kokkos::View<const int*, Exec> size, local, start, column_of;  ///< as in PatchTables
  Kokkos::View<const int*, Exec> box;                            ///< of each block
  DenseBlocks blocks;
  int sites, width, together;
  int round;  ///< control points once around the first axis; 0: it is not periodic

  KOKKOS_FUNCTION int lines() const { return sites / stencil.components / width; }
  int items(int count) const { return count / together * lines() * stencil.components; }

  KOKKOS_FUNCTION void operator()(int item) const {
    const int a = item % stencil.components, line = item / stencil.components % lines();
    const int begin = item / stencil.components / lines() * together;
    int at[D], point = 0, stride = stencil.extent[0];
    for (int d = 1, rest = line; d < D; ++d) {
      at[d] = rest % width;
      rest /= width;
      point += stride * stencil.moved(start(box(begin) * D + d), at[d], d);
      stride *= stencil.extent[d];
    }
    for (int block = begin; block < begin + together; ++block) clear(block, line, a);
    const int shifts = 2 * stencil.degree + 1;
    for (int across = 0; across < stencil.offsets; across += shifts) {
      const int to = neighbour_line(at, across);
      if (to < 0) continue;
      for (int u = 0; u < stencil.components; ++u)
        for (int o = 0; o < shifts && stencil.couples(a, u); ++o) {
          const float* entry = values.data() + stencil.index(a, u, across + o, point);
          for (int block = begin; block < begin + together; ++block)
            add(block, line * width, a, to * width, u, o - stencil.degree, entry);
        }
    }
  }
  KOKKOS_FUNCTION int unknown(int block, int point, int component) const {
    return local(box(block) * sites + point * stencil.components + component);
  }
  KOKKOS_FUNCTION void clear(int block, int line, int a) const {
    const int n = size(box(block));
    for (int x = 0; x < width; ++x) {
      const int row = unknown(block, line * width + x, a);
      for (int j = 0; j < n && row >= 0; ++j) blocks(block, row, j) = 0;
    }
  }
  /// The line of a box at an offset from another; a box that goes all around a periodic axis closes on itself.
  KOKKOS_FUNCTION int neighbour_line(const int* at, int offset) const {
    int to = 0, step = 1;
    for (int d = 1; d < D; ++d) {
      const int i = wrapped(at[d] + stencil.shift(offset, d), width, stencil.period[d]);
      if (i < 0) return -1;
      to += step * i;
      step *= width;
    }
    return to;
  }
  KOKKOS_FUNCTION void add(int block, int line, int a, int to, int u, int shift, const float* entry) const {
    const int begin = start(box(block) * D);
    for (int x = 0; x < width; ++x) {
      const int there = wrapped(x + shift, width, round);
      const int row = unknown(block, line + x, a), column = there < 0 ? -1 : unknown(block, to + there, u);
      if (row >= 0 && column >= 0) blocks(block, row, column) += entry[column_of(begin + x)];
    }
  }
};

}  // namespace softwet
