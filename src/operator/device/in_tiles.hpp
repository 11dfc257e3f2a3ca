// A term on a device: in tiles, or, with reduced quadrature or of means over elements, in rows of elements.
#pragma once

#include "operator/device/collect.hpp"
#include "operator/device/element_kernel.hpp"

namespace softwet {

/// Puts the tiles of a term among those of the evaluation.
template <class Kernel, class Entry, class List, int D, class Term, class Motion, class Real>
void add_tiles(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  static_assert(List::template has<Entry>, "the kernel of a list runs the terms of the list");
  using Plan = typename Kernel::template PlanOf<Entry>;
  using Shape = typename Plan::Shape;
  double spacing[D];
  for (int d = 0; d < D; ++d) spacing[d] = task.region.axis[d].spacing;
  const ElementColumns columns = task.region.first_axis();
  for (int r = 0; r < columns.runs; ++r) {
    const TileGrid<D> grid = TileGrid<D>::template of<Shape>(task.region, columns.run[r]);
    auto& source = sums.template add<typename Plan::Test>(std::size_t(grid.count()) * Plan::channels * Shape::controls);
    source.template shape<Shape>(grid);
    source.first_row = task.region.test.first;
    source.shared_test = Shape::Shared;
    std::byte* room = sums.add_tiles(&Kernel::launch, List::template place<Entry>(), grid.count());
    static_assert(sizeof(Tile<Plan>) <= TileSums<D, Real>::room_for_term && std::is_trivially_copyable_v<Tile<Plan>>);
    auto* tile = new (room) Tile<Plan>;
    tile->task.set(task, sums.direction());
    tile->slope = Collocation<D, Shape::Q, Real>::of(spacing);
    tile->grid = grid;
    tile->partial = const_cast<Real*>(source.partial);
  }
}

template <int P, int Q, bool Tangent, int D, class Term, class Motion, class Real>
void run_elements(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  using Kernel = ElementKernel<P, Q, Tangent, D, Term, Motion, Real>;
  using Tile = typename Kernel::Tile;
  using Test = typename Task<D, Term, Motion, Real>::Test;
  const ElementColumns columns = task.region.first_axis();
  for (int r = 0; r < columns.runs; ++r) {
    const TileGrid<D> grid = TileGrid<D>::template of<Tile>(task.region, columns.run[r]);
    auto& source = sums.template add<Test>(std::size_t(grid.count()) * Test::channel_count * Tile::controls);
    source.template shape<Tile>(grid);
    source.first_row = task.region.test.first;
    source.shared_test = task.region.shared_test;
    Kernel::launch(task, grid, const_cast<Real*>(source.partial));
  }
}

/// Puts the tiles of a term among those of its list, which share a launch. With shared test functions it has its own launch.
template <class Tile, bool Tangent, class List, int D, class Term, class Motion, class Real>
void add_with_list(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  if constexpr (Term::where == Where::beside_wall) {
    using Shared = TermOnMesh<Term, Motion, true>;
    using Alone = TermList<Shared>;
    if (task.region.shared_test) return add_tiles<TileKernel<Tile, Tangent, Real, Alone>, Shared, Alone>(task, sums);
  }
  add_tiles<TileKernel<Tile, Tangent, Real, List>, TermOnMesh<Term, Motion>, List>(task, sums);
}

/// Whether a term runs in tiles. These take slopes from the values at the points of full quadrature, from which the means of slopes over an
/// element do not follow.
template <class Term, int P, int Q>
inline constexpr bool runs_in_tiles = Q == P + 1 && Term::where != Where::means;

/// The term's residual, or (Tangent) its Jacobian-vector product, as partial sums.
template <int P, bool Tangent, class List, int D, class Term, class Motion, class Real>
void assemble_in_tiles(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    if constexpr (runs_in_tiles<Term, P, Q>) {
      add_with_list<ChosenTile<D, P, Tangent, Real>, Tangent, List>(task, sums);
    } else {
      run_elements<P, Q, Tangent>(task, sums);
    }
  });
}
template <int P, bool Tangent, int D, class Term, class Motion, class Real>
void assemble_in_tiles(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  assemble_in_tiles<P, Tangent, TermList<TermOnMesh<Term, Motion>>>(task, sums);
}

}  // namespace softwet
