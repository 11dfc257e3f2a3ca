// A term on a device: in tiles, or, where its points are not those of a tile, with one thread for each element.
#pragma once

#include "operator/batch.hpp"
#include "operator/collect.hpp"
#include "operator/tile.hpp"

namespace softwet {

/// Terms with degree + 1 points along every axis, whose test functions are those of the element.
template <class Term, int P, int Q>
inline constexpr bool fits_tiles = Q == P + 1 && Term::where != Where::wall;

/// @param threads  of a team: the points of a pass, or a divisor of their number
template <int threads, class Plan>
struct TileKernel {
  Tile<Plan> tile;

  template <class Member>
  KOKKOS_FUNCTION void operator()(const Member& member) const {
    using Real = typename Plan::Real;
    auto* scratch = static_cast<Real*>(member.team_shmem().get_shmem(TileScratch<Plan>::size * sizeof(Real)));
    tile.run(TileTeam<threads, Member>{member}, scratch);
  }
};

/// One thread takes one element; what it adds to control values is kept for the element alone.
template <int P, int Q, bool Tangent, int D, class Term, class Motion, class Real>
struct ElementKernel {
  static constexpr int controls = power(P + 1, D);
  Task<D, Term, Motion, Real> task;
  TileGrid<D> grid;
  Real* partial;  ///< [element][channel][control]

  KOKKOS_FUNCTION void operator()(int item) const {
    using S = OneNumber<Real>;
    Batch<D> b{};
    b.count = 1;
    int rest = item;
    for (int d = 0; d < D; ++d) {
      b.element[d] = rest % grid.tiles[d] + grid.first[d];
      rest /= grid.tiles[d];
    }
    constexpr int channels = Term::template Test<Real, D>::channel_count;
    compute_batch<S, std::conditional_t<Tangent, Dual<S>, S>, D, P, Q, Term, Motion>(
        task, b, [&](int c, const S(&nodal)[controls]) {
          Real* out = partial + (std::int64_t(item) * channels + c) * controls;
          for (int a = 0; a < controls; ++a) out[a] = plain(nodal[a]);
        });
  }
};

template <class Shape, bool Tangent, int D, class Term, class Motion, class Real>
void run_tiles(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  using Plan = TilePlan<Shape, Term, Motion, Tangent, Real>;
  constexpr int threads = on_host ? 1 : Shape::points, bytes = TileScratch<Plan>::size * sizeof(Real);
  static_assert(bytes + (Shape::points + 4) * sizeof(double) <= 48 * 1024,
                "a device may give a team 48 kB and no more");
  double spacing[D];
  for (int d = 0; d < D; ++d) spacing[d] = task.region.axis[d].spacing;
  const ElementColumns columns = task.region.first_axis();
  for (int r = 0; r < columns.runs; ++r) {
    const TileGrid<D> grid = TileGrid<D>::template of<Shape>(task.region, columns.run[r]);
    auto& source = sums.template add<typename Plan::Test>(std::size_t(grid.count()) * Plan::channels * Shape::controls);
    source.template shape<Shape>(grid);
    source.first_row = task.region.test.first;
    const Tile<Plan> tile{task, Collocation<D, Shape::Q, Real>::of(spacing), grid, const_cast<Real*>(source.partial)};
    Kokkos::TeamPolicy<Exec, Kokkos::LaunchBounds<Shape::points, Shape::teams>> policy(grid.count(), threads);
    Kokkos::parallel_for("softwet::tiles", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)),
                         TileKernel<threads, Plan>{tile});
  }
}

template <int P, int Q, bool Tangent, int D, class Term, class Motion, class Real>
void run_elements(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  using Shape = TileShape<D, P, 1, 1, 1, 1>;
  using Kernel = ElementKernel<P, Q, Tangent, D, Term, Motion, Real>;
  using Test = typename Task<D, Term, Motion, Real>::Test;
  const ElementColumns columns = task.region.first_axis();
  for (int r = 0; r < columns.runs; ++r) {
    const TileGrid<D> grid = TileGrid<D>::template of<Shape>(task.region, columns.run[r]);
    auto& source = sums.template add<Test>(std::size_t(grid.count()) * Test::channel_count * Kernel::controls);
    source.template shape<Shape>(grid);
    source.first_row = task.region.test.first;
    source.shared_test = task.region.shared_test;
    Kokkos::parallel_for("softwet::elements", Kokkos::RangePolicy<Exec>(0, grid.count()),
                         Kernel{task, grid, const_cast<Real*>(source.partial)});
  }
}

/// The term's residual, or (Tangent) its Jacobian-vector product, as partial sums.
template <int P, bool Tangent, int D, class Term, class Motion, class Real>
void assemble_in_tiles(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  using Shape = ChosenTile<D, P, Tangent, Real>;
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    if constexpr (fits_tiles<Term, P, Q>) {
      constexpr bool layer = Term::where == Where::beside_wall;
      if constexpr (layer)
        if (task.region.shared_test) return run_elements<P, Q, Tangent>(task, sums);
      run_tiles<std::conditional_t<layer, LayerOf<Shape>, Shape>, Tangent>(task, sums);
    } else {
      run_elements<P, Q, Tangent>(task, sums);
    }
  });
}

}  // namespace softwet
