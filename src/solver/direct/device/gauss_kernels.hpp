// The kernels of Gauss-Jordan elimination: one for each piece of the work, shared by many teams, or all of it in one
// team a block.
#pragma once

#include "solver/direct/device/gauss_block.hpp"

namespace softwet {

using GaussScratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
using GaussOrder = Kokkos::View<int*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

/// Where a panel is eliminated: in the memory of a team, or in the room of its block.
enum class PanelPlace { team, room };

/// Blocks that are eliminated together, and their room.
template <class Blocks>
struct GaussBlocks {
  static constexpr int depth = GaussBlock<Blocks>::depth;
  Blocks a;
  BlockSizes pivots, size;
  int rows, most;         ///< no block has more rows, and more pivots
  float *panels, *taken;  ///< [block][column of the panel][row]; [block][row of the panel][column]
  int *pivot, *source;    ///< [block][step]; [block][column] where it is before exchanges are undone
  float* scale;           ///< [block][row]

  KOKKOS_FUNCTION GaussBlock<Blocks> block(int b) const {
    const std::int64_t first = std::int64_t(b) * rows;
    return {
        a, b, pivots(b), size(b), rows, panels + depth * first, taken + depth * first, pivot + first, scale + first};
  }
  static std::size_t panel_bytes(int rows) { return GaussScratch::shmem_size(std::size_t(depth) * rows); }
};

/// A team is a row, and has one thread.
template <class Blocks>
struct ScaleGaussRows {
  GaussBlocks<Blocks> all;

  KOKKOS_FUNCTION void operator()(const GaussTeam& team) const {
    const auto block = all.block(team.league_rank() / all.rows);
    const int i = team.league_rank() % all.rows;
    if (i < block.pivots) block.scale_row(team, i);
  }
};

/// A team is a block.
template <class Blocks>
struct EliminatePanel {
  GaussBlocks<Blocks> all;
  int first;
  PanelPlace place;

  KOKKOS_FUNCTION void operator()(const GaussTeam& team) const {
    auto block = all.block(team.league_rank());
    const int count = block.columns(first);
    if (count <= 0) return;
    if (place == PanelPlace::room) return block.eliminate_panel(team, first);
    const GaussScratch near(team.team_scratch(0), all.depth * all.rows);
    float* const result = block.panel;
    block.panel = near.data();
    block.eliminate_panel(team, first);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, block.size), [&](int i) {
      for (int s = 0; s < count; ++s) result[std::int64_t(s) * all.rows + i] = block.w(s, i);
    });
  }
};

/// An item is a column.
template <class Blocks>
struct TakePivotRows {
  GaussBlocks<Blocks> all;
  int first;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const auto block = all.block(static_cast<int>(item / all.rows));
    const int j = static_cast<int>(item % all.rows);
    if (j < block.size) block.take_pivot_rows(first, j);
  }
};

/// An item is some columns of some rows.
template <class Blocks>
struct AddPanel {
  using Block = GaussBlock<Blocks>;
  static constexpr int together = chunk(16);
  GaussBlocks<Blocks> all;
  int first;

  KOKKOS_FUNCTION int pieces() const { return chunks_in(all.rows, Block::rows_together); }
  KOKKOS_FUNCTION int groups() const { return chunks_in(all.rows, together); }
  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int j = static_cast<int>(item % groups()) * together;
    const int begin = static_cast<int>(item / groups() % pieces()) * Block::rows_together;
    const auto block = all.block(static_cast<int>(item / groups() / pieces()));
    if (j < block.size && block.columns(first) > 0) block.template add_panel<together, 1>(first, begin, j);
  }
};

/// A team is a block.
template <class Blocks>
struct UndoExchanges {
  GaussBlocks<Blocks> all;

  KOKKOS_FUNCTION void operator()(const GaussTeam& team) const {
    const auto block = all.block(team.league_rank());
    const GaussOrder order(team.team_scratch(0), all.most);
    block.undo_exchanges(team, order.data());
    int* const source = all.source + std::int64_t(team.league_rank()) * all.rows;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, block.pivots), [&](int j) { source[j] = order(j); });
  }
};

/// A team is a row, and has one thread.
template <class Blocks>
struct OrderColumns {
  GaussBlocks<Blocks> all;

  KOKKOS_FUNCTION void operator()(const GaussTeam& team) const {
    const int b = team.league_rank() / all.rows, i = team.league_rank() % all.rows;
    const auto block = all.block(b);
    const GaussScratch row(team.team_scratch(0), all.most);
    if (i < block.size) block.order_columns(team, i, all.source + std::int64_t(b) * all.rows, row.data());
  }
};

/// The whole elimination. A team is a block, whose panel is in the memory of the team.
template <class Blocks>
struct EliminateBlock {
  using Block = GaussBlock<Blocks>;
  static constexpr int most_threads = Block::depth;  ///< for each of them the panel has a row
  /// Columns that a lane adds to at once: on a device so many that reading the panel does not take longer than the
  /// products.
  static constexpr int together = chunk(16, 4), apart = team_size(32), columns_of_lanes = together * apart;
  GaussBlocks<Blocks> all;

  static std::size_t bytes(int rows, int most) {
    return GaussBlocks<Blocks>::panel_bytes(rows) + GaussOrder::shmem_size(most);
  }
  KOKKOS_FUNCTION void operator()(const GaussTeam& team) const {
    auto block = all.block(team.league_rank());
    const GaussScratch panel(team.team_scratch(0), all.depth * all.rows);
    const GaussOrder order(team.team_scratch(0), all.most);
    block.panel = panel.data();
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, block.pivots), [&](int i) { block.scale_row(team, i); });
    team.team_barrier();
    for (int first = 0; first < block.pivots; first += all.depth) {
      block.eliminate_panel(team, first);
      Kokkos::parallel_for(Kokkos::TeamVectorRange(team, block.size), [&](int j) { block.take_pivot_rows(first, j); });
      team.team_barrier();
      add_panel(team, block, first);
      team.team_barrier();
    }
    block.undo_exchanges(team, order.data());
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, block.size),
                         [&](int i) { block.order_columns(team, i, order.data(), &block.w(team.team_rank(), 0)); });
  }
  /// Lanes have neighbouring columns.
  KOKKOS_FUNCTION void add_panel(const GaussTeam& team, const Block& block, int first) const {
    const int lanes = chunks_in(block.size, columns_of_lanes) * apart;
    const int pieces = chunks_in(block.size, Block::rows_together);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, lanes * pieces), [&](int item) {
      const int lane = item % lanes, j = lane / apart * columns_of_lanes + lane % apart;
      if (j < block.size) block.template add_panel<together, apart>(first, item / lanes * Block::rows_together, j);
    });
  }
};

}  // namespace softwet
