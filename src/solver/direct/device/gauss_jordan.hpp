// Dense inverses and eliminations on a device: Gauss-Jordan elimination of many matrices at once, some columns at a
// time.
#pragma once

#include <cstdint>

#include "memory/array.hpp"

namespace softwet {

/// [block][row][column]
using DenseBlocks = Kokkos::View<float***, Kokkos::LayoutRight, Exec>;
using BlockSizes = Kokkos::View<const int*, Exec>;

/// Blocks of different sizes: the entry (row, column) of block b lies at begin(b) + row stride(b) + column.
struct ScatteredBlocks {
  float* data;
  Kokkos::View<const std::int64_t*, Exec> begin;
  BlockSizes stride;

  KOKKOS_FORCEINLINE_FUNCTION float& operator()(int block, int row, int column) const {
    return data[begin(block) + std::int64_t(row) * stride(block) + column];
  }
  int count() const { return static_cast<int>(begin.extent(0)); }
};

/// How blocks are shared out to teams. The results are the same bits.
enum class BlockTeams {
  chosen,    ///< whichever is faster
  one_each,  ///< a block is the work of one team, in one kernel for all of it
  many_each  ///< many teams share a block, in three kernels a panel and three more
};

/// Inverts the leading size(b) x size(b) part of each block in place. Rows are scaled to a largest entry of 1 and
/// exchanged so that pivots are largest in their column. `panel` columns are eliminated by one team; all others then
/// change by one product of that depth, so that a matrix is read n / panel times. A singular block gets values that are
/// not finite; what lies outside of the leading parts is not defined. Every number is the result of the same operations
/// in the same order, whichever threads there are.
/// Source: Higham, Accuracy and Stability of Numerical Algorithms, SIAM 2002, section 14.4.
class GaussJordan {
 public:
  static constexpr int panel = 16;

  /// Room for `count` blocks of `rows` rows, or for others that have no more rows all together.
  explicit GaussJordan(std::int64_t count, int rows = 1, BlockTeams teams = BlockTeams::chosen);

  /// @param threads  of the team that eliminates a panel; 0: as many as suit the machine
  void invert(const DenseBlocks& blocks, const BlockSizes& size, int threads = 0) const;
  /// Eliminates the first pivots(b) unknowns of each block ((A, B), (C, S)) alone, with pivots in the rows of A. Its
  /// leading size(b) x size(b) part becomes ((A^-1, A^-1 B), (-C A^-1, S - C A^-1 B)).
  /// @param rows, most  no block has more rows, and more pivots
  void eliminate(const ScatteredBlocks& blocks, const BlockSizes& pivots, const BlockSizes& size, int rows, int most,
                 int threads = 0) const;
  static double bytes(std::int64_t count, int rows = 1) { return 4.0 * count * rows * (2 * panel + 3); }

 private:
  template <class Blocks>
  void run(const Blocks& blocks, const BlockSizes& pivots, const BlockSizes& size, int count, int rows, int most,
           int threads) const;

  BlockTeams teams_;
  Kokkos::View<float*, Exec> panels_,
      pivot_rows_;                    ///< [block][column of the panel][row]; [block][row of the panel][column]
  Kokkos::View<int*, Exec> pivot_;    ///< [block][step] the row that was exchanged with row `step`
  Kokkos::View<int*, Exec> source_;   ///< [block][column] where it is before exchanges are undone
  Kokkos::View<float*, Exec> scale_;  ///< [block][row]
};

}  // namespace softwet
