#include "solver/direct/device/gauss_jordan.hpp"

#include <algorithm>

#include "memory/start_teams.hpp"
#include "solver/direct/device/gauss_kernels.hpp"

namespace softwet {

namespace {

constexpr int gauss_lanes = team_size(32);

/// With so few registers that enough threads share a multiprocessor to hide the latency of memory.
using ManyItems = Kokkos::RangePolicy<Exec, WithLaunch, Kokkos::IndexType<std::int64_t>, Kokkos::LaunchBounds<256, 4>>;

template <class Policy = Teams<>>
Policy with_scratch(Policy policy, std::size_t bytes) {
  return policy.set_scratch_size(0, Kokkos::PerTeam(bytes));
}

/// A device gives a team 48 kB, of which Kokkos keeps some for reductions (operator/device/team_bounds.hpp).
bool fits_a_team(std::size_t bytes) { return bytes <= 48 * 1024 - 512; }

/// One team is as fast as many where its block is small, or where there are blocks for the whole machine. By a model one team takes 16 us
/// for 16 pivots of 320 rows and a launch 3.7 us, so that both are equal near 45 blocks of that size. On the host the threads need several
/// blocks each, because these differ in size.
BlockTeams faster_teams(int count, int rows) {
  const bool small = !on_host && rows <= 192;
  return small || count >= (on_host ? 4 * Exec().concurrency() : 64) ? BlockTeams::one_each : BlockTeams::many_each;
}

/// Kernels for the pieces of the work.
template <class Blocks>
void start_piece_by_piece(const GaussBlocks<Blocks>& all, int count, int threads) {
  if (threads == 0) threads = team_size(std::min(16, chunks_in(all.rows, gauss_lanes)));
  const LongItems each_column(0, std::int64_t(count) * all.rows);
  const Teams<> team_for_row(count * all.rows, 1, gauss_lanes);
  const std::size_t near = GaussBlocks<Blocks>::panel_bytes(all.rows);
  const PanelPlace place = !host_algorithms && fits_a_team(near) ? PanelPlace::team : PanelPlace::room;
  const Teams<> team_for_panel = with_scratch({count, threads, gauss_lanes}, place == PanelPlace::team ? near : 0);
  start_teams("softwet::scale_rows", team_for_row, ScaleGaussRows<Blocks>{all});
  for (int first = 0; first < all.most; first += all.depth) {
    start_teams("softwet::panel", team_for_panel, EliminatePanel<Blocks>{all, first, place});
    Kokkos::parallel_for("softwet::pivot_rows", each_column, TakePivotRows<Blocks>{all, first});
    const AddPanel<Blocks> add{all, first};
    Kokkos::parallel_for("softwet::add_panel", ManyItems(0, std::int64_t(count) * add.pieces() * add.groups()), add);
  }
  start_teams("softwet::exchanges", with_scratch({count, 1, gauss_lanes}, GaussOrder::shmem_size(all.most)),
              UndoExchanges<Blocks>{all});
  start_teams("softwet::order", with_scratch(team_for_row, GaussScratch::shmem_size(all.most)),
              OrderColumns<Blocks>{all});
}

/// One kernel for all of it. Where there are more blocks than multiprocessors, two teams share one of these.
template <class Blocks>
void start_block_by_block(const GaussBlocks<Blocks>& all, int count, int threads) {
  using Kernel = EliminateBlock<Blocks>;
  using Policy = Teams<Kokkos::LaunchBounds<32 * Kernel::most_threads, 1>>;
  if (threads == 0) threads = team_size(std::min(count > 132 ? 8 : 16, chunks_in(all.rows, 16)));
  threads = std::min(threads, Kernel::most_threads);
  start_teams("softwet::eliminate_blocks",
              with_scratch(Policy(count, threads, gauss_lanes), Kernel::bytes(all.rows, all.most)), Kernel{all});
}

}  // namespace

GaussJordan::GaussJordan(std::int64_t count, int rows, BlockTeams teams)
    : teams_(teams),
      panels_(Kokkos::view_alloc("gauss_jordan.panels", Kokkos::WithoutInitializing), count * panel * rows),
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
  const GaussBlocks<Blocks> all{
      a, pivots, size, rows, most, panels_.data(), pivot_rows_.data(), pivot_.data(), source_.data(), scale_.data()};
  BlockTeams teams = teams_ == BlockTeams::chosen ? faster_teams(count, rows) : teams_;
  if (!fits_a_team(EliminateBlock<Blocks>::bytes(rows, most))) teams = BlockTeams::many_each;
  teams == BlockTeams::one_each ? start_block_by_block(all, count, threads) : start_piece_by_piece(all, count, threads);
}

}  // namespace softwet
