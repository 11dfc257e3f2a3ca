// Dense inverses on a device: Gauss-Jordan elimination of many matrices at once, some columns at a time.
#pragma once

#include "field/array.hpp"

namespace softwet {

/// [block][row][column]
using DenseBlocks = Kokkos::View<float***, Kokkos::LayoutRight, Exec>;
using BlockSizes = Kokkos::View<const int*, Exec>;

/// Inverts the leading size(b) x size(b) part of each block in place. Rows are scaled to a largest entry of 1 and exchanged
/// so that pivots are largest in their column. `panel` columns are eliminated by one team; all others then change by one
/// product of that depth, so that a matrix is read n / panel times. A singular block gets values that are not finite; what
/// lies outside of the leading parts is not defined. Every number is the result of the same operations in the same order,
/// whichever threads there are.
/// Source: Higham, Accuracy and Stability of Numerical Algorithms, SIAM 2002, section 14.4.
class GaussJordan {
 public:
  static constexpr int panel = 16;

  /// Room for `count` blocks of `rows` rows.
  GaussJordan(int count, int rows);

  /// @param threads  of the team that eliminates a panel; 0: as many as suit the machine
  void invert(const DenseBlocks& blocks, const BlockSizes& size, int threads = 0) const;
  static double bytes(int count, int rows) { return 4.0 * count * rows * (2 * panel + 3); }

 private:
  DenseBlocks panels_;                                     ///< [block][column of the panel][row]
  DenseBlocks pivot_rows_;                                 ///< [block][row of the panel][column]
  Kokkos::View<int**, Kokkos::LayoutRight, Exec> pivot_;   ///< [block][step] the row that was exchanged with row `step`
  Kokkos::View<int**, Kokkos::LayoutRight, Exec> source_;  ///< [block][column] where it is before exchanges are undone
  Kokkos::View<float**, Kokkos::LayoutRight, Exec> scale_;  ///< [block][row]
};

}  // namespace softwet
