// The fronts of a nested dissection, level by level, as kernels of a device find them.
#pragma once

#include <cstdint>

#include "memory/array.hpp"
#include "solver/direct/dissection.hpp"

namespace softwet {

/// A front ((A, B), (C, S)) of `size` unknowns, of which the first `own` ones are eliminated in it. What lists and
/// vectors have for its unknowns begins at the place `first`.
struct LevelFront {
  int own, size, first;
  int child[2];         ///< numbers of fronts; -1: none
  std::int64_t matrix;  ///< place of its first entry in the memory of its level
  std::int64_t lower;   ///< place of (A^-1, C A^-1), size x own, among the factors
  std::int64_t upper;   ///< place of -A^-1 B, own x border

  /// Columns begin with a sector of memory.
  static KOKKOS_FORCEINLINE_FUNCTION int padded(int rows) { return (rows + 7) / 8 * 8; }
  KOKKOS_FORCEINLINE_FUNCTION int border() const { return size - own; }
  KOKKOS_FORCEINLINE_FUNCTION int stride() const {
    return padded(size);
  }  ///< between columns of the front, and of `lower`
  KOKKOS_FORCEINLINE_FUNCTION int upper_stride() const { return padded(own); }  ///< between columns of `upper`
};

/// Some rows of a front, which a team multiplies with a vector.
struct LevelStrip {
  static constexpr int rows = 32;
  int front, row;
};

/// Fronts and strips of one depth.
struct TreeLevel {
  int first = 0, last = 0;                    ///< fronts
  int first_forward = 0, last_forward = 0;    ///< strips of all rows
  int first_backward = 0, last_backward = 0;  ///< strips of own rows, in fronts with a border
  int rows = 0, pivots = 0, border = 0;       ///< the most that a front has
  std::int64_t entries = 0;                   ///< of its fronts
};

/// Everything that the dissection says, in lists. Fronts without unknowns are left out.
struct LevelTree {
  std::vector<TreeLevel> levels;  ///< root first
  std::vector<LevelFront> fronts;
  std::vector<LevelStrip> forward, backward;
  std::vector<int> unknown;         ///< [first + i] own ones, then the border
  std::vector<int> inherited;       ///< [2 first + child size + i] place of the same unknown in the child; -1: none
  std::int64_t factor_entries = 0;  ///< numbers of the factors
};

LevelTree make_level_tree(const Dissection&);

}  // namespace softwet
