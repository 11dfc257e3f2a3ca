#include "solver/gauss_jordan.hpp"

#include <algorithm>

namespace softwet {

namespace {

using Team = Kokkos::TeamPolicy<Exec>::member_type;
using Items = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;
using RowNumbers = Kokkos::View<int**, Kokkos::LayoutRight, Exec>;
using Factors = Kokkos::View<float**, Kokkos::LayoutRight, Exec>;
constexpr int depth_of_panel = GaussJordan::panel;

/// Each row over its largest entry. An item is a row.
struct ScaleGaussRows {
  DenseBlocks a;
  BlockSizes size;
  Factors scale;
  int rows;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int b = static_cast<int>(item / rows), i = static_cast<int>(item % rows), n = size(b);
    if (i >= n) return;
    float largest = 1e-30f;
    for (int j = 0; j < n; ++j) largest = Kokkos::fmax(largest, Kokkos::abs(a(b, i, j)));
    scale(b, i) = 1 / largest;
    for (int j = 0; j < n; ++j) a(b, i, j) *= 1 / largest;
  }
};

/// The elimination of a panel's columns, in the panel alone. What is left there: the inverse of the pivot block in the pivot
/// rows, and in each other row what its pivot rows are multiplied with.
struct EliminatePanel {
  DenseBlocks a, w;
  BlockSizes size;
  RowNumbers pivot;
  int first;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int b = team.league_rank(), n = size(b), count = n - first < depth_of_panel ? n - first : depth_of_panel;
    if (count <= 0) return;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int i) {
      for (int s = 0; s < count; ++s) w(b, s, i) = a(b, i, first + s);
    });
    team.team_barrier();
    for (int s = 0; s < count; ++s) {
      const int row = first + s, p = find_pivot(team, b, s, n);
      Kokkos::single(Kokkos::PerTeam(team), [&] { pivot(b, row) = p; });
      exchange(team, b, row, p, count);
      eliminate(team, b, s, n, count);
    }
  }
  KOKKOS_FUNCTION int find_pivot(const Team& team, int b, int s, int n) const {
    using Best = Kokkos::MaxLoc<float, int>;
    Best::value_type best;
    const int row = first + s;
    Kokkos::parallel_reduce(
        Kokkos::TeamVectorRange(team, n - row),
        [&](int i, Best::value_type& candidate) {
          const float v = Kokkos::abs(w(b, s, row + i));
          if (v > candidate.val || (v == candidate.val && row + i < candidate.loc)) {
            candidate.val = v;
            candidate.loc = row + i;
          }
        },
        Best(best));
    return best.loc >= row && best.loc < n ? best.loc : row;  // none: after a zero pivot the column is not finite
  }
  KOKKOS_FUNCTION void exchange(const Team& team, int b, int row, int p, int count) const {
    if (p != row)
      Kokkos::parallel_for(Kokkos::TeamVectorRange(team, count), [&](int t) {
        const float keep = w(b, t, row);
        w(b, t, row) = w(b, t, p);
        w(b, t, p) = keep;
      });
    team.team_barrier();
  }
  KOKKOS_FUNCTION void eliminate(const Team& team, int b, int s, int n, int count) const {
    const int row = first + s;
    const float scale = 1.0f / w(b, s, row);
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, count),
                         [&](int t) { w(b, t, row) = t == s ? scale : w(b, t, row) * scale; });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int i) {
      if (i == row) return;
      const float factor = w(b, s, i);
      for (int t = 0; t < count; ++t) w(b, t, i) = t == s ? -factor * scale : w(b, t, i) - factor * w(b, t, row);
    });
    team.team_barrier();
  }
};

/// Exchanges rows as the panel has, and takes the pivot rows out. An item is a column.
struct TakePivotRows {
  DenseBlocks a, taken;
  BlockSizes size;
  RowNumbers pivot;
  int first, rows;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int b = static_cast<int>(item / rows), j = static_cast<int>(item % rows), n = size(b);
    const int count = n - first < depth_of_panel ? n - first : depth_of_panel;
    if (j >= n) return;
    for (int s = 0; s < count; ++s) {
      const int p = pivot(b, first + s);
      const float lower = a(b, p, j);
      if (p != first + s) a(b, p, j) = a(b, first + s, j);
      a(b, first + s, j) = lower;
    }
    for (int s = 0; s < count; ++s) {
      taken(b, s, j) = a(b, first + s, j);
      a(b, first + s, j) = 0;
    }
  }
};

/// a += panel x pivot rows; the panel itself takes the place of its columns. An item is a column of some rows.
struct AddPanel {
  static constexpr int rows_at_once = 8;
  DenseBlocks a, w, taken;
  BlockSizes size;
  int first, rows;

  KOKKOS_FUNCTION int pieces() const { return (rows + rows_at_once - 1) / rows_at_once; }
  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int j = static_cast<int>(item % rows), begin = static_cast<int>(item / rows % pieces()) * rows_at_once;
    const int b = static_cast<int>(item / rows / pieces()), n = size(b);
    const int count = n - first < depth_of_panel ? n - first : depth_of_panel;
    if (j >= n || count <= 0) return;
    const int end = begin + rows_at_once < n ? begin + rows_at_once : n;
    if (j >= first && j < first + count) {
      for (int i = begin; i < end; ++i) a(b, i, j) = w(b, j - first, i);
      return;
    }
    float upper[depth_of_panel];
    for (int s = 0; s < depth_of_panel; ++s) upper[s] = s < count ? taken(b, s, j) : 0.0f;
    for (int i = begin; i < end; ++i) {
      float sum = a(b, i, j);
      for (int s = 0; s < depth_of_panel; ++s)
        if (s < count) sum += w(b, s, i) * upper[s];
      a(b, i, j) = sum;
    }
  }
};

/// The order of the columns once all exchanges of rows are undone. An item is a block.
struct UndoExchanges {
  BlockSizes size;
  RowNumbers pivot, source;

  KOKKOS_FUNCTION void operator()(int b) const {
    const int n = size(b);
    for (int j = 0; j < n; ++j) source(b, j) = j;
    for (int k = n - 1; k >= 0; --k) {
      const int p = pivot(b, k), keep = source(b, k);
      source(b, k) = source(b, p);
      source(b, p) = keep;
    }
  }
};

/// Puts columns in that order and undoes the scaling of rows. A team is a row.
struct OrderColumns {
  DenseBlocks a;
  BlockSizes size;
  RowNumbers source;
  Factors scale;
  int rows;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int b = team.league_rank() / rows, i = team.league_rank() % rows, n = size(b);
    const Scratch row(team.team_scratch(0), rows);
    if (i >= n) return;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int j) { row(j) = a(b, i, j); });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n),
                         [&](int j) { a(b, i, j) = row(source(b, j)) * scale(b, j); });
  }
};

}  // namespace

GaussJordan::GaussJordan(int count, int rows)
    : panels_(Kokkos::view_alloc("gauss_jordan.panels", Kokkos::WithoutInitializing), count, panel, rows),
      pivot_rows_(Kokkos::view_alloc("gauss_jordan.rows", Kokkos::WithoutInitializing), count, panel, rows),
      pivot_("gauss_jordan.pivot", count, rows),
      source_("gauss_jordan.source", count, rows),
      scale_("gauss_jordan.scale", count, rows) {}

void GaussJordan::invert(const DenseBlocks& a, const BlockSizes& size, int threads) const {
  const int count = static_cast<int>(a.extent(0)), rows = static_cast<int>(scale_.extent(1));
  const int lanes = on_host ? 1 : 32;
  if (threads == 0) threads = on_host ? 1 : std::min(16, (rows + lanes - 1) / lanes);
  Kokkos::parallel_for("softwet::scale_rows", Items(0, std::int64_t(count) * rows),
                       ScaleGaussRows{a, size, scale_, rows});
  for (int first = 0; first < rows; first += depth_of_panel) {
    Kokkos::parallel_for("softwet::panel", Kokkos::TeamPolicy<Exec>(count, threads, lanes),
                         EliminatePanel{a, panels_, size, pivot_, first});
    Kokkos::parallel_for("softwet::pivot_rows", Items(0, std::int64_t(count) * rows),
                         TakePivotRows{a, pivot_rows_, size, pivot_, first, rows});
    const AddPanel add{a, panels_, pivot_rows_, size, first, rows};
    Kokkos::parallel_for("softwet::add_panel", Items(0, std::int64_t(count) * add.pieces() * rows), add);
  }
  Kokkos::parallel_for("softwet::exchanges", Kokkos::RangePolicy<Exec>(0, count), UndoExchanges{size, pivot_, source_});
  Kokkos::parallel_for("softwet::order",
                       Kokkos::TeamPolicy<Exec>(count * rows, 1, lanes)
                           .set_scratch_size(0, Kokkos::PerTeam(OrderColumns::Scratch::shmem_size(rows))),
                       OrderColumns{a, size, source_, scale_, rows});
}

}  // namespace softwet
