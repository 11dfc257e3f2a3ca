// The tiles of a device, computed on the host: against the columns and colours of the host, and with several threads.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "compiled.hpp"
#include "patch.hpp"
#include "thread_team.hpp"

namespace softwet::testing_tools {

template <int D, int P = 2>
struct TileCases {
  Patch<D> patch;
  Terms terms;
  Array direction;
  double limit = 1e-12;  ///< of differences in double precision

  explicit TileCases(const std::array<int, D>& elements) : TileCases(Patch<D>(elements, 2, P)) {}
  explicit TileCases(const Patch<D>& p) : patch(p), direction(patch.draw(patch.layout.size(), -1, 1)) {}

  template <bool Tangent, class Motion, class Real, class Term>
  auto task(const Term& term, const Evaluation<D, Real>& at, const Region<D>& region) const {
    return task_of<D, Term, Motion>(term, rounded<Real>(region), at, patch.blend);
  }

  /// One evaluation in tiles and as the host does it. @param bound  of the difference, relative to the largest value
  template <bool Tangent, class Motion, class Real, class Term>
  void compare(const char* name, const Term& term, const Region<D>& region, Evaluation<D, Real> at,
               double bound) const {
    Patch<D> random = patch;
    const GivenField<double> field{random.draw(patch.layout.rows * patch.layout.row_size, 0.4, 1.2), 0};
    const GivenField<Real> given = rounded<Real>(field);
    const PieceOf<D, P, Term, Motion, Real> piece(name, region, region, term, patch.blend, Instant::stage, field);
    const ArrayOf<Real> want("want", patch.layout.size()), got("got", patch.layout.size());
    at.test = want;
    Tangent ? piece.product(at) : piece.residual(at);
    at.test = got;
    at.given = given.origin();
    TileSums<D, Real> sums(patch.layout, at.tangent);
    const auto whole = task<Tangent, Motion>(term, at, region);
    assemble_in_tiles<P, Tangent>(whole, sums);
    sums.add_to(got);
    const auto wide = [](const ArrayOf<Real>& a) {
      const Array copy("copy", a.extent(0));
      Kokkos::deep_copy(copy, a);
      return to_host(copy);
    };
    ASSERT_GT(largest(wide(want)), 1e-6) << name;
    EXPECT_LT(distance(wide(got), wide(want)), bound) << name << (Tangent ? ", product" : ", residual");
  }
  template <class Motion, class Term>
  void check(const char* name, const Term& term, const Region<D>& region) const {
    compare<false, Motion, double>(name, term, region, {patch.layout, patch.stage, {}, {}}, limit);
    compare<true, Motion, double>(name, term, region, {patch.layout, patch.stage, direction, {}}, limit);
  }
  /// A term that no implicit step has.
  template <class Term>
  void check_explicit(const char* name, const Term& term, const Region<D>& region) const {
    compare<false, NoMotion, double>(name, term, region, {patch.layout, patch.stage, {}, {}}, limit);
    compare<false, WallMotion<D>, double>(name, term, region, {patch.layout, patch.stage, {}, {}}, limit);
  }
  template <class Motion, class Term>
  void check_single(const char* name, const Term& term, const Region<D>& region) const {
    const StageOf<float> stage = single_stage(patch.stage);
    const ArrayOf<float> z("z", direction.extent(0));
    convert(z, direction);
    compare<true, Motion, float>(name, term, region, {patch.layout, stage, z, {}}, 2e-6);
  }
  template <class Term>
  void check_fluid(const char* name, const Term& term, const Region<D>& region) const {
    check<NoMotion>(name, term, region);
    check<WallMotion<D>>(name, term, region);
  }

  /// The partial sums of tiles by some threads, twice, against those by one.
  template <bool Tangent, class Motion, int Q = P + 1, int threads = ThreadTeam::size, class Term>
  void check_threads(const Term& term, const Region<D>& region) const {
    if (!on_host) GTEST_SKIP() << "the tiles of this program lie in the memory of a device";
    using Shape = ShapeOf<TermOnMesh<Term, Motion>, TileFor<D, P, Q, Tangent, Term, double>>;
    using Plan = TilePlan<Shape, Term, Motion, Tangent, double>;
    double spacing[D];
    for (int d = 0; d < D; ++d) spacing[d] = region.axis[d].spacing;
    const TileGrid<D> grid = TileGrid<D>::template of<Shape>(region, region.first_axis().run[0]);
    const int size = Plan::channels * Shape::controls;
    const Array one("one", std::size_t(grid.count()) * size), several("several", one.extent(0));
    const Evaluation<D> at{patch.layout, patch.stage, Tangent ? direction : Array(), {}};
    const auto whole = task<Tangent, Motion>(term, at, region);
    TileOf<Plan> tile;
    tile.task.set(whole, at.tangent.data());
    tile.set_spacing(spacing);
    tile.grid = grid;
    tile.partial = several.data();
    TileSums<D, double> sums(patch.layout, at.tangent);
    assemble_in_tiles<P, Tangent>(whole, sums);
    sums.add_to(Array("sum", patch.layout.size()));
    std::memcpy(one.data(), tile_room<double>(0, one.extent(0)), one.extent(0) * sizeof(double));
    using Team = ThreadTeamOf<threads>;
    const auto by_several = [&] {
      std::vector<double> scratch(TileOf<Plan>::Room::size, std::nan(""));
      run_thread_teams<Team>(grid.count(),
                             [&](const Team& team) { tile.run(team, at.tangent.data(), scratch.data()); });
      return to_host(several);
    };
    const std::vector<double> found = by_several();
    EXPECT_EQ(found, by_several());
    EXPECT_LT(distance(found, to_host(one)), 1e-13);
  }
};

}  // namespace softwet::testing_tools
