#include "solver/dense_inverse.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <new>

namespace softwet {

namespace {

using Sizes = Kokkos::View<const int*, Exec>;
using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Host: with rows scaled to 1, A = D^-1 B; the transpose of A^-1 is D B^-T.
struct InvertOnHost {
  DenseBlocks blocks;
  Sizes size;
  std::atomic<bool>* out_of_memory;  ///< no exception may leave a parallel region

  void operator()(int b) const {
    try {
      invert(b);
    } catch (const std::bad_alloc&) {
      *out_of_memory = true;
    }
  }
  void invert(int b) const {
    const int n = size(b);
    if (n == 0) return;
    // The rows of A are the columns of this map, so that B^T is factorised in place.
    using Strided = Eigen::Map<Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
    Strided a(&blocks(b, 0, 0), n, n, Eigen::OuterStride<>(blocks.extent(2)));
    const Eigen::VectorXf scale = a.colwise().lpNorm<Eigen::Infinity>().cwiseMax(1e-30f).cwiseInverse();
    a = a * scale.asDiagonal();
    const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXf, 0, Eigen::OuterStride<>>> lu(a);
    thread_local Eigen::MatrixXf x;  // kept, so that a second build allocates nothing
    x.setIdentity(n, n);
    constexpr int columns = 64;
    for (int j = 0; j < n; j += columns) {  // above its diagonal the inverse of L is zero
      auto part = x.block(j, j, n - j, std::min(columns, n - j));
      a.bottomRightCorner(n - j, n - j).triangularView<Eigen::UnitLower>().solveInPlace(part);
    }
    a.triangularView<Eigen::Upper>().solveInPlace(x);
    Eigen::Map<RowMajor, 0, Eigen::OuterStride<>>(a.data(), n, n, a.outerStride()) =
        scale.asDiagonal() * (x * lu.permutationP());
  }
};

/// Device: Gauss-Jordan elimination in place with row pivoting, one team per block.
struct InvertOnDevice {
  DenseBlocks blocks;
  Sizes size;
  Kokkos::View<int**, Exec> pivots;
  using Team = Kokkos::TeamPolicy<Exec>::member_type;

  KOKKOS_FUNCTION void swap_rows(const Team& team, int b, int n, int k, int p) const {
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int j) {
      const float keep = blocks(b, k, j);
      blocks(b, k, j) = blocks(b, p, j);
      blocks(b, p, j) = keep;
    });
  }
  KOKKOS_FUNCTION int find_pivot(const Team& team, int b, int n, int k) const {
    using Best = Kokkos::MaxLoc<float, int>;
    Best::value_type best;
    Kokkos::parallel_reduce(
        Kokkos::TeamVectorRange(team, n - k),
        [&](int i, Best::value_type& candidate) {
          const float v = Kokkos::abs(blocks(b, k + i, k));
          if (v > candidate.val) {
            candidate.val = v;
            candidate.loc = k + i;
          }
        },
        Best(best));
    return best.loc < n ? best.loc : k;  // none was found: after a zero pivot the column is not finite
  }
  KOKKOS_FUNCTION void eliminate(const Team& team, int b, int n, int k) const {
    const float scale = 1.0f / blocks(b, k, k);
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n),
                         [&](int j) { blocks(b, k, j) = j == k ? scale : blocks(b, k, j) * scale; });
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), [&](int i) {
      if (i == k) return;
      const float factor = blocks(b, i, k);
      Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, n), [&](int j) {
        blocks(b, i, j) = j == k ? -factor * scale : blocks(b, i, j) - factor * blocks(b, k, j);
      });
    });
    team.team_barrier();
  }
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int b = team.league_rank(), n = size(b);
    for (int k = 0; k < n; ++k) {
      const int p = find_pivot(team, b, n, k);
      Kokkos::single(Kokkos::PerTeam(team), [&] { pivots(b, k) = p; });
      if (p != k) swap_rows(team, b, n, k, p);
      team.team_barrier();
      eliminate(team, b, n, k);
    }
    for (int k = n - 1; k >= 0; --k) {  // undo the row exchanges as column exchanges
      const int p = pivots(b, k);
      if (p != k)
        Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int i) {
          const float keep = blocks(b, i, k);
          blocks(b, i, k) = blocks(b, i, p);
          blocks(b, i, p) = keep;
        });
      team.team_barrier();
    }
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), [&](int i) {
      Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, i), [&](int j) {
        const float keep = blocks(b, i, j);
        blocks(b, i, j) = blocks(b, j, i);
        blocks(b, j, i) = keep;
      });
    });
  }
};

}  // namespace

void invert_by_teams(const DenseBlocks& blocks, const Sizes& size, int threads) {
  const int count = static_cast<int>(blocks.extent(0));
  const Kokkos::View<int**, Exec> pivots("pivots", count, blocks.extent(1));
  Kokkos::parallel_for("softwet::invert", Kokkos::TeamPolicy<Exec>(count, threads, on_host ? 1 : 32),
                       InvertOnDevice{blocks, size, pivots});
}

void invert(const DenseBlocks& blocks, const Sizes& size) {
  if (!on_host) return invert_by_teams(blocks, size);
  using Host = Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
  std::atomic<bool> out_of_memory = false;
  Kokkos::parallel_for("softwet::invert", Host(0, blocks.extent(0)).set_chunk_size(1),
                       InvertOnHost{blocks, size, &out_of_memory});
  if (out_of_memory) throw std::bad_alloc();
}

}  // namespace softwet
