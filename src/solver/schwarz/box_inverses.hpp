// Inverses of boxes in 16 bits, as they lie in memory, and products with them.
#pragma once

#include "memory/chunk.hpp"
#include "solver/schwarz/bfloat16.hpp"

namespace softwet {

/// Rows of an inverse that one thread multiplies at once. On a device two: it reads their entries as one number.
inline constexpr int rows_at_once = chunk(32, 2);

/// Several boxes may use the same inverse.
struct BoxInverses {
  /// [inverse][strip of rows][column][row in the strip]: what one thread of the host reads lies in one piece.
  Kokkos::View<std::uint16_t*, Exec> entry;
  Kokkos::View<std::int64_t*, Exec> begin;  ///< [box] first entry of its inverse
  int strip = rows_at_once;                 ///< rows of a strip, a multiple of this

  /// Entries of an inverse of n unknowns.
  std::int64_t room(int n) const { return std::int64_t(chunks_in(n, strip)) * strip * n; }

  /// Where an entry of an inverse of n unknowns lies in it.
  KOKKOS_FORCEINLINE_FUNCTION int place(int n, int row, int column) const {
    return (row / strip * n + column) * strip + row % strip;
  }
  KOKKOS_FORCEINLINE_FUNCTION std::uint16_t* place(int box, int n, int row, int column) const {
    return entry.data() + begin(box) + place(n, row, column);
  }

  /// sum[k] = rows first, first + 1, ... of the inverse of a box of n unknowns, times x[k]. Each row that is read
  /// serves all vectors.
  template <int vectors>
  KOKKOS_FORCEINLINE_FUNCTION void multiply(int box, int n, int first, const float* const (&x)[vectors],
                                            float (&sum)[vectors][rows_at_once]) const {
    for (int k = 0; k < vectors; ++k)
      for (int i = 0; i < rows_at_once; ++i) sum[k][i] = 0;
    const std::uint16_t* column = place(box, n, first, 0);
    if constexpr (rows_at_once == 2) {
      constexpr int ahead = 8;  // columns whose entries are read before the first is used
      int j = 0;
      for (; j + ahead <= n; j += ahead) add_columns<ahead>(column + j * strip, x, j, sum);
      for (; j < n; ++j) add_columns<1>(column + j * strip, x, j, sum);
    } else {
      constexpr int ahead = 48;  // columns
      for (int j = 0; j < n; ++j, column += strip) {
        prefetch(column + ahead * strip);
        for (int k = 0; k < vectors; ++k)
          for (int i = 0; i < rows_at_once; ++i) sum[k][i] += widen(column[i]) * x[k][j];
      }
    }
  }

 private:
  /// Adds columns j, j + 1, ... of two rows.
  template <int columns, int vectors>
  KOKKOS_FORCEINLINE_FUNCTION void add_columns(const std::uint16_t* from, const float* const (&x)[vectors], int j,
                                               float (&sum)[vectors][rows_at_once]) const {
    TwoHalves rows[columns];
    for (int c = 0; c < columns; ++c) rows[c] = TwoHalves(from + c * strip);
    for (int c = 0; c < columns; ++c)
      for (int k = 0; k < vectors; ++k) {
        sum[k][0] += rows[c].first() * x[k][j + c];
        sum[k][1] += rows[c].second() * x[k][j + c];
      }
  }
  static KOKKOS_FORCEINLINE_FUNCTION void prefetch([[maybe_unused]] const void* p) {
    KOKKOS_IF_ON_HOST((__builtin_prefetch(p);))
  }
};

}  // namespace softwet
