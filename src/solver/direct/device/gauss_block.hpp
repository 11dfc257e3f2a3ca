// What Gauss-Jordan elimination does with one block, piece by piece. A piece is the work of a kernel, or of a team
// among others.
#pragma once

#include "solver/direct/device/gauss_jordan.hpp"

namespace softwet {

using GaussTeam = Kokkos::TeamPolicy<Exec>::member_type;

/// A block of which the first `pivots` unknowns are eliminated, and the room that this takes.
template <class Blocks>
struct GaussBlock {
  static constexpr int depth = GaussJordan::panel;
  static constexpr int rows_together = 8;  ///< of add_panel
  Blocks a;
  int b, pivots, size;
  int stride;            ///< between columns of the panel, and between pivot rows
  float *panel, *taken;  ///< [column of the panel][row]; [row of the panel][column]
  int* pivot;            ///< [step] the row that was exchanged with row `step`
  float* scale;          ///< [row]

  KOKKOS_FORCEINLINE_FUNCTION float& at(int row, int column) const { return a(b, row, column); }
  KOKKOS_FORCEINLINE_FUNCTION float& w(int s, int row) const { return panel[s * stride + row]; }
  KOKKOS_FORCEINLINE_FUNCTION float& upper_row(int s, int column) const { return taken[s * stride + column]; }
  /// Columns of the panel that begins at `first`, of those that are eliminated; less than one: there is none.
  KOKKOS_FORCEINLINE_FUNCTION int columns(int first) const { return pivots - first < depth ? pivots - first : depth; }

  /// A row with a pivot over its largest entry among the columns with pivots. For the lanes of a thread.
  KOKKOS_FUNCTION void scale_row(const GaussTeam& team, int i) const {
    float largest = 0;
    Kokkos::parallel_reduce(
        Kokkos::ThreadVectorRange(team, pivots),
        [&](int j, float& most) { most = Kokkos::fmax(most, Kokkos::abs(at(i, j))); }, Kokkos::Max<float>(largest));
    const float factor = 1 / Kokkos::fmax(largest, 1e-30f);
    Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, size), [&](int j) { at(i, j) *= factor; });
    Kokkos::single(Kokkos::PerThread(team), [&] { scale[i] = factor; });
  }

  /// The elimination of a panel's columns, in the panel alone. What is left there: the inverse of the pivot block in
  /// the pivot rows, and in each other row what its pivot rows are multiplied with. For a team, all threads of which
  /// may read it then.
  KOKKOS_FUNCTION void eliminate_panel(const GaussTeam& team, int first) const {
    const int count = columns(first);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, size), [&](int i) {
      for (int s = 0; s < count; ++s) w(s, i) = at(i, first + s);
    });
    team.team_barrier();
    for (int s = 0; s < count; ++s) {
      const int row = first + s, p = find_pivot(team, s, row);
      Kokkos::single(Kokkos::PerTeam(team), [&] { pivot[row] = p; });
      exchange(team, row, p, count);
      eliminate(team, s, row, count);
    }
  }

  /// Exchanges rows as the panel has, and takes the pivot rows out, in one column.
  KOKKOS_FUNCTION void take_pivot_rows(int first, int j) const {
    const int count = columns(first);
    for (int s = 0; s < count; ++s) {
      const int p = pivot[first + s];
      const float lower = at(p, j);
      if (p != first + s) at(p, j) = at(first + s, j);
      at(first + s, j) = lower;
    }
    for (int s = 0; s < count; ++s) {
      upper_row(s, j) = at(first + s, j);
      at(first + s, j) = 0;
    }
  }

  /// a += panel x pivot rows, in some rows of the columns j, j + apart, ..., as many as `together` or as there are; the
  /// panel itself takes the place of its columns.
  template <int together, int apart>
  KOKKOS_FUNCTION void add_panel(int first, int begin, int j) const {
    const int count = columns(first), end = begin + rows_together < size ? begin + rows_together : size;
    const int there = (size - j + apart - 1) / apart, wide = there < together ? there : together;
    float upper[depth][together];
    for (int s = 0; s < depth; ++s)
      for (int c = 0; c < together; ++c) upper[s][c] = s < count && c < wide ? upper_row(s, j + c * apart) : 0.0f;
    for (int i = begin; i < end; ++i) {
      float sum[together];
      for (int c = 0; c < together; ++c) sum[c] = c < wide ? at(i, j + c * apart) : 0.0f;
      for (int s = 0; s < depth; ++s) {
        if (s >= count) continue;
        const float factor = w(s, i);
        for (int c = 0; c < together; ++c) sum[c] += factor * upper[s][c];
      }
      for (int c = 0; c < wide; ++c) {
        const int s = j + c * apart - first;
        at(i, j + c * apart) = s >= 0 && s < count ? w(s, i) : sum[c];
      }
    }
  }

  /// The order of the columns once all exchanges of rows are undone, one after the other. For a team.
  KOKKOS_FUNCTION void undo_exchanges(const GaussTeam& team, int* order) const {
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, pivots), [&](int j) { order[j] = j; });
    team.team_barrier();
    Kokkos::single(Kokkos::PerTeam(team), [&] {
      for (int k = pivots - 1; k >= 0; --k) {
        const int p = pivot[k], keep = order[k];
        order[k] = order[p];
        order[p] = keep;
      }
    });
    team.team_barrier();
  }

  /// Puts columns with pivots in that order and undoes the scaling, in one row. For the lanes of a thread.
  /// @param row  room for so many numbers as there are pivots
  KOKKOS_FUNCTION void order_columns(const GaussTeam& team, int i, const int* order, float* row) const {
    Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, pivots), [&](int j) { row[j] = at(i, j); });
    Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, pivots), [&](int j) { at(i, j) = row[order[j]] * scale[j]; });
  }

 private:
  KOKKOS_FUNCTION int find_pivot(const GaussTeam& team, int s, int row) const {
    using Best = Kokkos::MaxLoc<float, int>;
    typename Best::value_type best;
    Kokkos::parallel_reduce(
        Kokkos::TeamVectorRange(team, pivots - row),
        [&](int i, typename Best::value_type& candidate) {
          const float v = Kokkos::abs(w(s, row + i));
          if (v > candidate.val || (v == candidate.val && row + i < candidate.loc)) {
            candidate.val = v;
            candidate.loc = row + i;
          }
        },
        Best(best));
    return best.loc >= row && best.loc < pivots ? best.loc : row;  // none: after a zero pivot the column is not finite
  }
  KOKKOS_FUNCTION void exchange(const GaussTeam& team, int row, int p, int count) const {
    if (p != row)
      Kokkos::parallel_for(Kokkos::TeamVectorRange(team, count), [&](int t) {
        const float keep = w(t, row);
        w(t, row) = w(t, p);
        w(t, p) = keep;
      });
    team.team_barrier();
  }
  KOKKOS_FUNCTION void eliminate(const GaussTeam& team, int s, int row, int count) const {
    const float factor_of_row = 1.0f / w(s, row);
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, count),
                         [&](int t) { w(t, row) = t == s ? factor_of_row : w(t, row) * factor_of_row; });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, size), [&](int i) {
      if (i == row) return;
      const float factor = w(s, i);
      for (int t = 0; t < count; ++t) w(t, i) = t == s ? -factor * factor_of_row : w(t, i) - factor * w(t, row);
    });
    team.team_barrier();
  }
};

}  // namespace softwet
