#include "solver/direct/device/gauss_jordan.hpp"

#include <algorithm>

#include "memory/start_teams.hpp"

namespace softwet {

namespace {

using Team = Kokkos::TeamPolicy<Exec>::member_type;
using RowNumbers = Kokkos::View<int**, Kokkos::LayoutRight, Exec>;
using Factors = Kokkos::View<float**, Kokkos::LayoutRight, Exec>;
constexpr int depth_of_panel = GaussJordan::panel;

/// Columns of the panel that begins at `first`, of so many that are eliminated; less than one: there is none.
KOKKOS_FORCEINLINE_FUNCTION int columns_of_panel(int all, int first) {
  return all - first < depth_of_panel ? all - first : depth_of_panel;
}

/// Each row with a pivot over its largest entry among the columns with pivots. A team is a row.
template <class Blocks>
struct ScaleGaussRows {
  Blocks a;
  BlockSizes pivots, size;
  Factors scale;
  int rows;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int b = team.league_rank() / rows, i = team.league_rank() % rows, m = pivots(b);
    if (i >= m) return;
    float largest = 0;
    Kokkos::parallel_reduce(
        Kokkos::TeamVectorRange(team, m),
        [&](int j, float& most) { most = Kokkos::fmax(most, Kokkos::abs(a(b, i, j))); }, Kokkos::Max<float>(largest));
    const float factor = 1 / Kokkos::fmax(largest, 1e-30f);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, size(b)), [&](int j) { a(b, i, j) *= factor; });
    Kokkos::single(Kokkos::PerTeam(team), [&] { scale(b, i) = factor; });
  }
};

/// The elimination of a panel's columns, in the panel alone. What is left there: the inverse of the pivot block in the pivot
/// rows, and in each other row what its pivot rows are multiplied with.
template <class Blocks>
struct EliminatePanel {
  Blocks a;
  DenseBlocks w;
  BlockSizes pivots, size;
  RowNumbers pivot;
  int first;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int b = team.league_rank(), n = size(b), count = columns_of_panel(pivots(b), first);
    if (count <= 0) return;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int i) {
      for (int s = 0; s < count; ++s) w(b, s, i) = a(b, i, first + s);
    });
    team.team_barrier();
    for (int s = 0; s < count; ++s) {
      const int row = first + s, p = find_pivot(team, b, s, pivots(b));
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
template <class Blocks>
struct TakePivotRows {
  Blocks a;
  DenseBlocks taken;
  BlockSizes pivots, size;
  RowNumbers pivot;
  int first, rows;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int b = static_cast<int>(item / rows), j = static_cast<int>(item % rows), n = size(b);
    const int count = columns_of_panel(pivots(b), first);
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

/// a += panel x pivot rows; the panel itself takes the place of its columns. An item is some columns of some rows.
template <class Blocks>
struct AddPanel {
  static constexpr int rows_at_once = 8, columns_at_once = on_host ? 16 : 1;
  Blocks a;
  DenseBlocks w, taken;
  BlockSizes pivots, size;
  int first, rows;

  KOKKOS_FUNCTION int pieces() const { return (rows + rows_at_once - 1) / rows_at_once; }
  KOKKOS_FUNCTION int groups() const { return (rows + columns_at_once - 1) / columns_at_once; }
  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int j = static_cast<int>(item % groups()) * columns_at_once;
    const int begin = static_cast<int>(item / groups() % pieces()) * rows_at_once;
    const int b = static_cast<int>(item / groups() / pieces()), n = size(b);
    const int count = columns_of_panel(pivots(b), first);
    if (j >= n || count <= 0) return;
    const int end = begin + rows_at_once < n ? begin + rows_at_once : n;
    const int columns = j + columns_at_once < n ? columns_at_once : n - j;
    float upper[depth_of_panel][columns_at_once];
    for (int s = 0; s < depth_of_panel; ++s)
      for (int c = 0; c < columns_at_once; ++c) upper[s][c] = s < count && c < columns ? taken(b, s, j + c) : 0.0f;
    for (int i = begin; i < end; ++i) {
      float sum[columns_at_once];
      for (int c = 0; c < columns_at_once; ++c) sum[c] = c < columns ? a(b, i, j + c) : 0.0f;
      for (int s = 0; s < depth_of_panel; ++s) {
        if (s >= count) continue;
        const float factor = w(b, s, i);
        for (int c = 0; c < columns_at_once; ++c) sum[c] += factor * upper[s][c];
      }
      for (int c = 0; c < columns; ++c) {
        const int s = j + c - first;
        a(b, i, j + c) = s >= 0 && s < count ? w(b, s, i) : sum[c];
      }
    }
  }
};

/// The order of the columns once all exchanges of rows are undone, one after the other. A team is a block.
struct UndoExchanges {
  BlockSizes pivots;
  RowNumbers pivot, source;
  int most;
  using Scratch = Kokkos::View<int*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int b = team.league_rank(), n = pivots(b);
    const Scratch order(team.team_scratch(0), most);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int j) { order(j) = j; });
    team.team_barrier();
    Kokkos::single(Kokkos::PerTeam(team), [&] {
      for (int k = n - 1; k >= 0; --k) {
        const int p = pivot(b, k), keep = order(k);
        order(k) = order(p);
        order(p) = keep;
      }
    });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int j) { source(b, j) = order(j); });
  }
};

/// Puts columns with pivots in that order and undoes the scaling of rows. A team is a row.
template <class Blocks>
struct OrderColumns {
  Blocks a;
  BlockSizes pivots, size;
  RowNumbers source;
  Factors scale;
  int rows, most;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int b = team.league_rank() / rows, i = team.league_rank() % rows, n = pivots(b);
    const Scratch row(team.team_scratch(0), most);
    if (i >= size(b)) return;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int j) { row(j) = a(b, i, j); });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n),
                         [&](int j) { a(b, i, j) = row(source(b, j)) * scale(b, j); });
  }
};

}  // namespace

GaussJordan::GaussJordan(std::int64_t count, int rows)
    : panels_(Kokkos::view_alloc("gauss_jordan.panels", Kokkos::WithoutInitializing), count * panel * rows),
      pivot_rows_(Kokkos::view_alloc("gauss_jordan.rows", Kokkos::WithoutInitializing), count * panel * rows),
      pivot_("gauss_jordan.pivot", count * rows),
      source_("gauss_jordan.source", count * rows),
      scale_("gauss_jordan.scale", count * rows) {}

void GaussJordan::invert(const DenseBlocks& blocks, const BlockSizes& size, int threads) const {
  const int rows = static_cast<int>(blocks.extent(1));
  run(blocks, size, size, static_cast<int>(blocks.extent(0)), rows, rows, threads);
}

void GaussJordan::eliminate(const ScatteredBlocks& blocks, const BlockSizes& pivots, const BlockSizes& size, int rows,
                            int most, int threads) const {
  run(blocks, pivots, size, blocks.count(), rows, most, threads);
}

template <class Blocks>
void GaussJordan::run(const Blocks& a, const BlockSizes& pivots, const BlockSizes& size, int count, int rows, int most,
                      int threads) const {
  const DenseBlocks panels(panels_.data(), count, panel, rows), pivot_rows(pivot_rows_.data(), count, panel, rows);
  const RowNumbers pivot(pivot_.data(), count, rows), source(source_.data(), count, rows);
  const Factors scale(scale_.data(), count, rows);
  const int lanes = on_host ? 1 : 32;
  if (threads == 0) threads = on_host ? 1 : std::min(16, (rows + lanes - 1) / lanes);
  const LongItems each_row(0, std::int64_t(count) * rows);
  const Teams<> team_for_row(count * rows, 1, lanes);
  const auto with_scratch = [](Teams<> policy, std::size_t bytes) {
    return policy.set_scratch_size(0, Kokkos::PerTeam(bytes));
  };
  start_teams("softwet::scale_rows", team_for_row, ScaleGaussRows<Blocks>{a, pivots, size, scale, rows});
  for (int first = 0; first < most; first += depth_of_panel) {
    start_teams("softwet::panel", Teams<>(count, threads, lanes),
                EliminatePanel<Blocks>{a, panels, pivots, size, pivot, first});
    Kokkos::parallel_for("softwet::pivot_rows", each_row,
                         TakePivotRows<Blocks>{a, pivot_rows, pivots, size, pivot, first, rows});
    const AddPanel<Blocks> add{a, panels, pivot_rows, pivots, size, first, rows};
    Kokkos::parallel_for("softwet::add_panel", LongItems(0, std::int64_t(count) * add.pieces() * add.groups()), add);
  }
  start_teams("softwet::exchanges", with_scratch({count, 1, lanes}, UndoExchanges::Scratch::shmem_size(most)),
              UndoExchanges{pivots, pivot, source, most});
  start_teams("softwet::order", with_scratch(team_for_row, OrderColumns<Blocks>::Scratch::shmem_size(most)),
              OrderColumns<Blocks>{a, pivots, size, source, scale, rows, most});
}

}  // namespace softwet
