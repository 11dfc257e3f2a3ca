// Block LU and Schwarz against products, and the dense inverses under them.
#include "solver/block_lu.hpp"
#include "solver/dense_inverse.hpp"
#include "solver/dissection.hpp"
#include "solver/gmres.hpp"
#include "solver/schwarz.hpp"
#include "unit/model/scenes.hpp"

#include <random>

namespace softwet::testing_tools {
namespace {

Product frozen_product(RandomScene& s) {
  return [&s](const Array& z, const Array& out) { s.model.product(s.stage(), z, out, Geometry::frozen); };
}

/// Relative error with which the preconditioner undoes the product with frozen geometry.
double error_of(Preconditioner& p, RandomScene& s) {
  const Array z = s.direction();
  Array found("found", s.layout().size());
  p.build(frozen_product(s));
  p.apply(to_device<Array>(s.product(z, Geometry::frozen)), found);
  return distance(to_host(found), to_host(z));
}

Case longer(Case c, int nx, int ny) {
  c.domain.elements = {nx, ny};
  return c;
}

TEST(BlockLu, SolvesEverySceneToSinglePrecision) {
  for (const Case& c : {scene(Scene::coupled), longer(scene(Scene::coupled), 31, 18), scene(Scene::rigid),
                        scene(Scene::solid), longer(scene(Scene::rigid, WallLaw::energy, true), 23, 12)}) {
    RandomScene s(c);
    const auto lu = make_block_lu<2>(s.layout(), s.model.mask());
    EXPECT_LT(error_of(*lu, s), 1e-3);
    s.stage().rate_scale *= 3;  // a second build reuses the tree
    EXPECT_LT(error_of(*lu, s), 1e-3);
  }
}

TEST(BlockLu, GmresReachesFullPrecisionInFewIterations) {
  RandomScene s(longer(scene(Scene::coupled), 31, 18));
  const auto lu = make_block_lu<2>(s.layout(), s.model.mask());
  lu->build(frozen_product(s));
  const Array z = s.direction(), b = to_device<Array>(s.product(z, Geometry::frozen));
  Array x("x", s.layout().size());
  Gmres gmres(s.layout().size(), 20);
  const KrylovResult result = gmres.solve(
      frozen_product(s), [&](const Array& r, const Array& y) { lu->apply(r, y); }, b, x, 1e-12, 20);
  EXPECT_TRUE(result.converged);
  EXPECT_LE(result.iterations, 6);
}

TEST(Dissection, EveryUnknownIsEliminatedOnce) {
  RandomScene s(longer(scene(Scene::coupled), 31, 18));
  const std::vector<double> mask = to_host(s.model.mask());
  const StencilMatrix<2> matrix(s.layout(), s.model.mask());
  const Dissection tree = dissect(s.layout(), mask, matrix, 40);
  std::vector<int> times(mask.size(), 0);
  for (const DissectionNode& node : tree.nodes)
    for (int i : node.own) ++times[i];
  for (std::size_t i = 0; i < mask.size(); ++i) EXPECT_EQ(times[i], mask[i] != 0 ? 1 : 0) << i;
  EXPECT_GT(tree.levels.size(), 3u);
  EXPECT_TRUE(tree.nodes.back().border.empty());
}

TEST(Schwarz, OneBoxIsTheInverse) {
  RandomScene s(scene(Scene::coupled));
  EXPECT_LT(error_of(*make_schwarz<2>(s.layout(), s.model.mask(), {100, 0}), s), 1e-3);
}

TEST(Schwarz, OverlapHelps) {
  for (const Case& c :
       {longer(scene(Scene::coupled), 31, 18), longer(scene(Scene::rigid, WallLaw::energy, true), 31, 18)}) {
    RandomScene s(c);
    const Array b = to_device<Array>(s.product(s.direction(), Geometry::frozen));
    Array x("x", s.layout().size());
    Gmres gmres(s.layout().size(), 150);
    int before = 150;
    for (int overlap : {0, 2, 4}) {
      const auto p = make_schwarz<2>(s.layout(), s.model.mask(), {8, overlap});
      p->build(frozen_product(s));
      const KrylovResult r = gmres.solve(
          frozen_product(s), [&](const Array& a, const Array& z) { p->apply(a, z); }, b, x, 1e-6, 150);
      EXPECT_LT(r.iterations, before) << "overlap " << overlap;
      before = r.iterations;
    }
  }
}

TEST(DenseInverse, BothWaysAgreeWithTheProduct) {
  const int n = 37, m = 11;
  std::vector<int> size{n, n - 5}, core{m, m - 2};
  DenseBlocks a("a", 2, n, n), copy("copy", 2, n, n), x("x", 2, n, 16), y("y", 2, n, 16);
  auto host = Kokkos::create_mirror_view(a);
  std::mt19937 draw(7);
  std::uniform_real_distribution<float> number(-1, 1);
  for (int b = 0; b < 2; ++b)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) host(b, i, j) = i == j ? 0.0f : number(draw);  // zero diagonal: pivoting is needed
  Kokkos::deep_copy(a, host);
  Kokkos::deep_copy(copy, host);
  const auto sizes = to_device<Kokkos::View<int*, Exec>>(size), cores = to_device<Kokkos::View<int*, Exec>>(core);
  invert_core_rows(a, sizes, cores, x);
  invert_core_rows_by_teams(copy, sizes, cores, y);
  for (const DenseBlocks& inverse : {x, y}) {
    const auto found = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), inverse);
    for (int b = 0; b < 2; ++b)
      for (int row = 0; row < core[b]; ++row)
        for (int column = 0; column < size[b]; ++column) {
          double sum = 0;
          for (int k = 0; k < size[b]; ++k) sum += double(found(b, k, row)) * host(b, k, column);
          EXPECT_NEAR(sum, row == column ? 1.0 : 0.0, 1e-3);
        }
  }
}

}  // namespace
}  // namespace softwet::testing_tools
