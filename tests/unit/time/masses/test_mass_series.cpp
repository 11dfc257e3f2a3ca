// The series that inverts a mass: in blocks of lines and value by value; and the blocks, which keep ties together.
#include "time/masses/mass_series.hpp"

#include <functional>
#include <set>

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

using namespace mass_kernels;

std::vector<Case> scenes_of_ties() {
  Case closed = small_case(SceneKind::rigid, WallLaw::gradient, true);
  closed.boundary.side[1] = {Side::periodic, Side::periodic};
  Case tall = small_case(SceneKind::coupled);  // several blocks, and a last line that would be a block of its own
  tall.domain.elements = {9, 45};
  Case flat = small_case(SceneKind::rigid);  // so short an axis that both of its ends share a function
  flat.domain.elements = {9, 1};
  return {small_case(SceneKind::rigid),
          small_case(SceneKind::coupled),
          small_case(SceneKind::coupled, WallLaw::gradient, true),
          closed,
          tall,
          flat};
}

template <int D>
void expect_whole_clusters(const Layout<D>& l, const TieClusters& ties, Unknowns of) {
  const bool velocities = of == Unknowns::velocities;
  const LineBlocks<D> blocks(l, of);
  std::set<int> seen;
  for (int block = 0; block < (velocities ? D : 1) * blocks.count(); ++block) {
    std::set<int> values;
    blocks.for_lines(block, [&](int begin, int) {
      for (int i = 0; i < blocks.extent[0]; ++i) values.insert(begin + i);
    });
    for (const int i : values) EXPECT_TRUE(seen.insert(i).second) << "a value in two blocks";
    for (int c = ties.count() > 0 ? ties.of_block(block) : 0; ties.count() > 0 && c < ties.of_block(block + 1); ++c)
      for (int m = ties.first_member(c); m < ties.first_member(c + 1); ++m)
        EXPECT_TRUE(values.count(ties.member(m))) << "block " << block << ", value " << ties.member(m);
  }
  EXPECT_EQ(static_cast<int>(seen.size()), (velocities ? D : 1) * blocks.nodes);
  if (ties.count() > 0) {
    EXPECT_EQ(ties.of_block(ties.of_block.extent(0) - 1), ties.count());
  }
}

TEST(MassSeries, BlocksHaveEveryValueOnceAndWholeClustersOfTies) {
  if (!host_algorithms) GTEST_SKIP() << "this program has the algorithms of a device, whose ties are in no blocks";
  for (const Case& c : scenes_of_ties()) {
    const Scene<2, 2> scene(c);
    const EndTies<2> ties(scene.layout(), scene.mask());
    expect_whole_clusters(scene.layout(), ties.velocities(), Unknowns::velocities);
    expect_whole_clusters(scene.layout(), ties.scalars(), Unknowns::scalars);
  }
  for (const SceneKind kind : {SceneKind::rigid, SceneKind::coupled}) {
    Case c = small_case_in_3d(kind);
    c.domain.elements = {5, 8, 24};
    const Scene<3, 2> scene(c);
    const EndTies<3> ties(scene.layout(), scene.mask());
    expect_whole_clusters(scene.layout(), ties.velocities(), Unknowns::velocities);
    expect_whole_clusters(scene.layout(), ties.scalars(), Unknowns::scalars);
  }
}

/// Runs the items of a stage with its ties: blocks of lines as on the host, or clusters and values as on a device.
template <class Values, class Stage>
void run_items(const Stage& stage, const TieClusters& ties, int components) {
  const WithTies<Stage, Values> kernel{stage, ties};
  for (int item = 0; item < kernel.items(components); ++item) kernel(item);
}

template <int D>
struct Series {
  RandomSceneIn<D> random;
  MassProduct<D, 2> product;
  EndTies<D> ties;
  WeightedMass mass;
  int first, count, nodes;
  bool velocities;

  Series(const Case& c, bool of_velocities)
      : random(c),
        product(l(), random.scene.regions().points()),
        ties(l(), random.scene.mask()),
        first(of_velocities ? 0 : l().density_offset()),
        count(of_velocities ? l().velocity_size() : l().scalar_size()),
        nodes(of_velocities ? count / D : count),
        velocities(of_velocities) {
    for (Array* a : {&mass.sums, &mass.unit, &mass.root, &mass.left, &mass.right})
      *a = random.terms.patch.draw(nodes, 1, 2);
  }
  const Layout<D>& l() const { return random.layout(); }
  Unknowns kind() const { return velocities ? Unknowns::velocities : Unknowns::scalars; }
  Array draw() { return random.terms.patch.draw(count, -1, 1); }
  const TieClusters& clusters() const { return velocities ? ties.velocities() : ties.scalars(); }

  /// A vector over its row sums with ties, the next one of the series, and that without the roots.
  template <class Values>
  std::vector<double> run(const Array& b, const Array& y) {
    const Array x("x", count), image("image", count), next("next", count), result("result", count);
    const int components = velocities ? D : 1;
    const ConstArray mask = part(random.scene.mask(), first, first + count);
    const WeightedPointers pointers(mass);
    run_items<Values>(DivideBySums<D>{LineBlocks<D>(l(), kind()), mass_kernels::RightSide<D>::of(b), -1.5, mask,
                                      pointers.sums, pointers.root, x.data()},
                      clusters(), components);
    product.fill_ghosts(y, velocities ? 0 : D, velocities ? D : D + 1);
    run_items<Values>(SeriesStep<D, 2>{product.of(y, kind()), pointers, mask.data(), -2, x.data(), image.data(),
                                       next.data(), result.data()},
                      clusters(), components);
    std::vector<double> all;
    const std::vector<double> free = to_host(mask);
    for (const Array& a : {x, next, result}) {
      const std::vector<double> v = to_host(a);
      for (int i = 0; i < count; ++i) all.push_back(free[i] * v[i]);  // at ghosts nothing counts
    }
    return all;
  }
};

template <int D>
void expect_same(const Case& c, bool velocities) {
  Series<D> series(c, velocities);
  const Array b = series.draw(), y = series.draw();
  const std::vector<double> lines = series.template run<BlockOfLines>(b, y),
                            values = series.template run<OneValue>(b, y);
  double largest = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_NEAR(lines[i], values[i], 1e-14) << i;
    largest = std::max(largest, std::abs(lines[i]));
  }
  EXPECT_GT(largest, 0.1);
}

TEST(MassSeries, IsTheSameInBlocksOfLinesAndValueByValue) {
  if (!host_algorithms) GTEST_SKIP() << "this program has the algorithms of a device, whose ties are in no blocks";
  for (const Case& c : scenes_of_ties())
    for (const bool velocities : {true, false}) expect_same<2>(c, velocities);
  for (const SceneKind kind : {SceneKind::rigid, SceneKind::coupled})
    for (const bool velocities : {true, false}) {
      Case c = small_case_in_3d(kind);
      c.domain.elements = {5, 8, 24};
      expect_same<3>(c, velocities);
      c.boundary.side[0] = c.boundary.side[1] = {Side::periodic, Side::periodic};
      expect_same<3>(c, velocities);
    }
}

// With roots, vectors are scaled with them: W D^{-1} b is the same, and so are its ties.
TEST(MassSeries, SmoothsScaledVectorsAsItSmoothsTheVectorsThemselves) {
  for (const bool velocities : {true, false}) {
    Series<2> series(small_case(SceneKind::coupled), velocities);
    const TieClusters& ties = series.clusters();
    ASSERT_GT(ties.count(), 0);
    const std::vector<double> plain = to_host(series.draw()), sums = to_host(series.mass.sums),
                              root = to_host(series.mass.root);
    std::vector<double> x = plain, lost(plain.size(), 0.0), scaled = plain, scaled_lost = lost;
    for (std::size_t i = 0; i < x.size(); ++i) scaled[i] *= root[i % series.nodes];
    if (!host_algorithms) GTEST_SKIP() << "the ties of a device lie in its memory";
    for (int c = 0; c < ties.count(); ++c) {
      ties.smooth(c, {x.data(), sums.data(), nullptr, lost.data()});
      ties.smooth(c, {scaled.data(), sums.data(), root.data(), scaled_lost.data()});
    }
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_NEAR(scaled[i], root[i % series.nodes] * x[i], 1e-14);
      ASSERT_NEAR(scaled_lost[i], root[i % series.nodes] * lost[i], 1e-14);
      ASSERT_NEAR(x[i] + lost[i], plain[i], 1e-14);
      largest = std::max(largest, std::abs(lost[i]));
    }
    EXPECT_GT(largest, 0.1);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
