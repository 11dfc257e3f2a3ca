// Nested dissection against what the pattern of the matrix says.
#include "solver/direct/dissection.hpp"

#include <set>

#include "solver/direct/host/point_pairs.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

template <int D>
struct Dissected {
  Scene<D, 2> scene;
  Stencil<D> stencil;
  UnknownTable<D> table;
  Dissection tree;

  Dissected(const Case& c, int leaf)
      : scene(c),
        stencil(scene.layout()),
        table(scene.layout(), to_host(scene.mask())),
        tree(dissect(scene.layout(), table, leaf)) {}
};

Case with_elements(Case c, const std::vector<int>& elements) {
  c.domain.elements = elements;
  return c;
}
std::vector<Case> scenes_in_2d() {
  return {with_elements(small_case(SceneKind::coupled), {31, 18}), with_elements(small_case(SceneKind::solid), {14, 9}),
          with_elements(small_case(SceneKind::rigid, WallLaw::energy, true), {23, 12}),
          with_elements(small_case(SceneKind::rigid, WallLaw::gradient, true), {4, 4})};
}

TEST(Dissection, EveryUnknownIsEliminatedOnce) {
  const Dissected<2> s(with_elements(small_case(SceneKind::coupled), {31, 18}), 40);
  std::vector<int> times(s.scene.layout().size(), 0);
  for (const DissectionNode& node : s.tree.nodes)
    for (int i : node.own) ++times[i];
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], s.table.component(i) >= 0 ? 1 : 0) << i;
  EXPECT_GT(s.tree.levels.size(), 3u);
  EXPECT_TRUE(s.tree.nodes.back().border.empty());
}

/// The border of a node is what the matrix couples to its subtree, in the order of elimination.
template <int D>
void expect_borders(const Dissected<D>& s) {
  std::vector<int> position(s.scene.layout().size(), -1);
  int next = 0;
  for (const DissectionNode& node : s.tree.nodes)
    for (int i : node.own) position[i] = next++;
  for (std::size_t n = 0; n < s.tree.nodes.size(); ++n) {
    const DissectionNode& node = s.tree.nodes[n];
    std::set<int> subtree;
    for (std::size_t m = node.first; m <= n; ++m)
      subtree.insert(s.tree.nodes[m].own.begin(), s.tree.nodes[m].own.end());
    std::set<std::pair<int, int>> coupled;  // by position
    for (int i : subtree)
      for_column_point(s.stencil, s.table.point(i), [&](int from, std::int64_t) {
        for (int c = 0; c < s.stencil.components; ++c)
          if (const int row = s.table.unknown(c, from); row >= 0 && subtree.count(row) == 0)
            coupled.insert({position[row], row});
      });
    std::vector<int> expected;
    for (const auto& [at, unknown] : coupled) expected.push_back(unknown);
    EXPECT_EQ(node.border, expected) << n;
    for (int child : node.children)
      for (std::size_t i = 0; i < s.tree.nodes[child].border.size(); ++i) {
        const int in_parent = s.tree.nodes[child].border_in_parent[i], own = static_cast<int>(node.own.size());
        EXPECT_EQ(in_parent < own ? node.own[in_parent] : node.border[in_parent - own], s.tree.nodes[child].border[i]);
      }
  }
}

TEST(Dissection, BordersAreWhatTheMatrixCouplesToASubtree) {
  for (const Case& c : scenes_in_2d()) expect_borders(Dissected<2>(c, 12));
  expect_borders(Dissected<3>(with_elements(small_case_in_3d(SceneKind::coupled), {4, 5, 6}), 20));
}

/// Each block of the matrix between two points belongs to one node, which eliminates one of them and has the other.
template <int D>
void expect_pairs(const Dissected<D>& s) {
  std::set<std::int64_t> found;
  const auto pairs = find_point_pairs(s.tree, s.scene.layout(), s.table);
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const DissectionNode& node = s.tree.nodes[n];
    const int own = static_cast<int>(node.own.size());
    const auto unknown = [&](int local) { return local < own ? node.own[local] : node.border[local - own]; };
    for (const PointPair& pair : pairs[n]) {
      EXPECT_TRUE(found.insert(pair.place).second) << "twice";
      EXPECT_LT(std::min(pair.row, pair.column), own);
      const int row = s.table.point(unknown(pair.row)), column = s.table.point(unknown(pair.column));
      bool there = false;
      for_column_point(s.stencil, column,
                       [&](int from, std::int64_t place) { there = there || (from == row && place == pair.place); });
      EXPECT_TRUE(there);
      for (const auto& [point, fields, first] :
           {std::tuple{row, pair.row_fields, pair.row}, std::tuple{column, pair.column_fields, pair.column}})
        for (int c = 0, local = first; c < s.stencil.components; ++c) {
          EXPECT_EQ(fields >> c & 1, s.table.unknown(c, point) >= 0 ? 1 : 0);
          if (fields >> c & 1) {
            EXPECT_EQ(unknown(local++), s.table.unknown(c, point));
          }
        }
    }
  }
  const auto free = [&](int point) {
    for (int c = 0; c < s.stencil.components; ++c)
      if (s.table.unknown(c, point) >= 0) return true;
    return false;
  };
  std::size_t blocks = 0;
  for (int column = 0; column < s.stencil.points; ++column)
    for_column_point(s.stencil, column, [&](int row, std::int64_t) { blocks += free(row) && free(column) ? 1 : 0; });
  EXPECT_EQ(found.size(), blocks);
}

TEST(PointPairs, HoldEveryBlockOfTheMatrixOnce) {
  for (const Case& c : scenes_in_2d()) expect_pairs(Dissected<2>(c, 12));
  expect_pairs(Dissected<3>(with_elements(small_case_in_3d(SceneKind::coupled), {4, 5, 6}), 20));
}

}  // namespace
}  // namespace softwet::testing_tools
