// A term on a device, in tiles.
#pragma once

#include "operator/device/collect.hpp"

namespace softwet {

/// Adds the tiles of a term to the tiles of the evaluation.
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
    static_assert(sizeof(TileOf<Plan>) <= most_stored_bytes && std::is_trivially_copyable_v<TileOf<Plan>>);
    std::byte* room =
        sums.add_tiles(&Kernel::launch, List::template place<Entry>(), grid.count(), sizeof(TileOf<Plan>));
    auto* tile = new (room) TileOf<Plan>;
    tile->task.set(task, sums.direction());
    tile->set_spacing(spacing);
    tile->grid = grid;
    tile->partial = const_cast<Real*>(source.partial);
  }
}

/// Adds the tiles of a term to its list, whose tiles share a launch. With shared test functions it has its own launch.
template <class Tile, bool Tangent, class List, int D, class Term, class Motion, class Real>
void add_with_list(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  if constexpr (Term::where == Where::beside_wall) {
    using Shared = TermOnMesh<Term, Motion, true>;
    using Alone = TermList<Shared>;
    if (task.region.shared_test) return add_tiles<TileKernel<Tile, Tangent, Real, Alone>, Shared, Alone>(task, sums);
  }
  add_tiles<TileKernel<Tile, Tangent, Real, List>, TermOnMesh<Term, Motion>, List>(task, sums);
}

/// Whether slopes follow from values. Means of slopes over an element do not follow from means of values.
template <class Term, int P, int Q>
inline constexpr bool slopes_follow = Q == P + 1 && Term::where != Where::means;
template <int D, int P, int Q, bool Tangent, class Term, class Real>
using TileFor = std::conditional_t<slopes_follow<Term, P, Q>, ChosenTile<D, P, Tangent, Real>, SlopeTileShape<D, P, Q>>;

/// The term's residual, or (Tangent) its Jacobian-vector product, as partial sums.
template <int P, bool Tangent, class List, int D, class Term, class Motion, class Real>
void assemble_in_tiles(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    add_with_list<TileFor<D, P, Q, Tangent, Term, Real>, Tangent, List>(task, sums);
  });
}
template <int P, bool Tangent, int D, class Term, class Motion, class Real>
void assemble_in_tiles(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  assemble_in_tiles<P, Tangent, TermList<TermOnMesh<Term, Motion>>>(task, sums);
}

}  // namespace softwet
