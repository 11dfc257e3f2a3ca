// A part of the columns, as one of several processes stores it, gives its own rows the same bits as the whole patch.
#include <gtest/gtest.h>

#include "patch.hpp"

namespace softwet {
namespace {

using testing_tools::Patch;
using testing_tools::single_stage;

Patch<2> make_whole(int elements, bool periodic) {
  Layout<2> l;
  l.solid_elements = 3;
  l.axis = {Axis(0.9, elements, 2, periodic ? AxisKind::periodic : AxisKind::bounded),
            Axis(0.8, 8, 2, AxisKind::bounded, 3)};
  l.row_size = l.axis[0].functions();
  l.rows = l.axis[1].functions();
  l.wall_row = l.axis[1].span(3);
  return Patch<2>(l, {l.axis[1].lower(3), 0.8 - l.axis[1].lower(3)});
}

Array part_of(const Columns& c, const Array& all) {
  const int lines = static_cast<int>(all.extent(0)) / c.first_function.back();
  const std::vector<double> from = to_host(all);
  std::vector<double> own(static_cast<std::size_t>(lines) * c.stored());
  take_lines(c, lines, from.data(), own.data());
  return to_device<Array>(own);
}

Patch<2> part_of(const Patch<2>& whole, int rank, int ranks) {
  Layout<2> l = whole.layout;
  l.columns = cut_columns(l.axis[0], rank, ranks);
  l.row_size = l.columns.stored();
  Patch<2> part(l, whole.blend);
  part.stage = whole.stage;
  for (Array Stage::*field :
       {&Stage::unknown, &Stage::acceleration, &Stage::displacement, &Stage::displacement_end, &Stage::density_end})
    part.stage.*field = part_of(l.columns, whole.stage.*field);
  return part;
}

/// Residual, product with a direction, and matrix of the terms of a scene, with the sums of ghosts.
struct Results {
  std::vector<double> residual, product;
  std::vector<float> matrix;
};
Results evaluate(const Patch<2>& p, const Array& z) {
  const testing_tools::Terms t;
  const PieceOf<2, 2, NavierStokesKorteweg, WallMotion<2>> fluid("fluid", p.fluid(), p.fluid(), t.fluid, p.blend);
  const PieceOf<2, 2, CapillaryTraction, WallMotion<2>> traction("traction", p.layer(), p.layer(), t.traction, p.blend);
  const PieceOf<2, 2, EnergyWall, WallMotion<2>> wall("wall", p.face(), p.face(), t.energy_wall, p.blend);
  const PieceOf<2, 2, Elastodynamics<SaintVenantKirchhoff>, NoMotion> solid("solid", p.solid(), p.solid(), t.solid);
  const Array residual("residual", p.layout.size()), product("product", p.layout.size());
  for (const Piece<2>* piece : {static_cast<const Piece<2>*>(&fluid), static_cast<const Piece<2>*>(&traction),
                                static_cast<const Piece<2>*>(&wall), static_cast<const Piece<2>*>(&solid)}) {
    piece->residual({p.layout, p.stage, {}, residual});
    piece->product({p.layout, p.stage, z, product});
  }
  move_ghosts(p.layout, residual, GhostAction::add);
  move_ghosts(p.layout, product, GhostAction::add);
  const PieceOf<2, 2, NavierStokesKorteweg, WallMotion<2, float>, float> single("fluid", p.fluid(), p.fluid(), t.fluid,
                                                                                p.blend);
  const StageOf<float> rounded = single_stage(p.stage);
  const Stencil<2> stencil(p.layout);
  const StencilValues values("matrix", stencil.size());
  single.jacobian({p.layout, rounded, {}, rounded.unknown, Geometry::frozen}, stencil, values);
  fold_ghosts(p.layout, stencil, values);
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), values);
  return {to_host(residual), to_host(product), {host.data(), host.data() + host.extent(0)}};
}

template <class Real>
void expect_same_rows(const Layout<2>& part, const std::vector<Real>& found, const std::vector<Real>& expected) {
  const Columns& c = part.columns;
  const int all = part.axis[0].functions(), lines = static_cast<int>(expected.size()) / all;
  int different = 0, nonzero = 0;
  for (int line = 0; line < lines; ++line)
    for (int i = c.begin; i < c.end && c.function[i] < part.axis[0].owned(); ++i) {
      different += found[line * c.stored() + i] != expected[line * all + c.function[i]];
      nonzero += expected[line * all + c.function[i]] != 0;
    }
  EXPECT_EQ(different, 0) << "rank " << c.rank << " of " << c.ranks;
  EXPECT_GT(nonzero, c.end - c.begin);
}

void check_parts(int elements, bool periodic, int ranks) {
  Patch<2> whole = make_whole(elements, periodic);
  const Array z = whole.draw(whole.layout.size(), -1, 1);
  const Results expected = evaluate(whole, z);
  for (int rank = 0; rank < ranks; ++rank) {
    const Patch<2> part = part_of(whole, rank, ranks);
    const Results found = evaluate(part, part_of(part.layout.columns, z));
    expect_same_rows(part.layout, found.residual, expected.residual);
    expect_same_rows(part.layout, found.product, expected.product);
    expect_same_rows(part.layout, found.matrix, expected.matrix);
  }
}

TEST(Parts, HaveTheBitsOfTheWhole) {
  check_parts(37, false, 1);
  check_parts(37, false, 2);
  check_parts(37, false, 4);
}

TEST(Parts, HaveThemAroundAPeriodicAxis) {
  check_parts(37, true, 1);
  check_parts(37, true, 2);
  check_parts(37, true, 3);
}

}  // namespace
}  // namespace softwet
