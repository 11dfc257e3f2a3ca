// Block LU: scaling, what builds allocate, and how the work is shared.
#include "solver/direct/host/block_lu.hpp"

#include <cmath>
#include <random>

#include "allocations.hpp"
#include "solver/direct/host/work_split.hpp"
#include "solver/matrix/equilibration.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

void count_array(Kokkos::Tools::SpaceHandle, const char*, const void*, std::uint64_t) { ++large_allocations; }

Case larger(Case c, int nx, int ny) {
  c.domain.elements = {nx, ny};
  return c;
}

TEST(BlockLu, ASecondBuildAllocatesNothing) {
  RandomScene s(larger(small_case(SceneKind::coupled), 31, 18));
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  matrix.fill(s.jacobian());
  const auto lu = make_block_lu<2>(s.layout(), s.scene.mask());
  const Array r("r", s.layout().size()), z("z", s.layout().size());
  large_allocations = 0;
  Kokkos::Tools::Experimental::set_allocate_data_callback(count_array);
  lu->build(matrix);
  EXPECT_GT(large_allocations, 0);
  large_allocations = 0;
  for (int i = 0; i < 3; ++i) {
    lu->build(matrix);
    lu->apply(r, z);
  }
  EXPECT_EQ(large_allocations, 0);
  Kokkos::Tools::Experimental::set_allocate_data_callback(nullptr);
}

/// Rows and columns of the Jacobian, each with a factor of its own.
void scale(const StencilMatrix<2>& matrix, const std::vector<double>& row, const std::vector<double>& column) {
  const UnknownTable<2> table(matrix.layout(), to_host(matrix.mask()));
  const auto values = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), matrix.values());
  for (int c = 0; c < matrix.layout().size(); ++c)
    if (table.component(c) >= 0)
      for_column(matrix.stencil(), table, c,
                 [&](int r, std::int64_t at) { values(at) = static_cast<float>(values(at) * row[r] * column[c]); });
  Kokkos::deep_copy(matrix.values(), values);
}

TEST(BlockLu, TinyAndHugeRowsAndColumnsDoNotMatter) {
  for (const Case& c :
       {small_case(SceneKind::coupled), larger(small_case(SceneKind::rigid, WallLaw::energy, true), 23, 12)}) {
    RandomScene s(c);
    const int n = s.layout().size();
    StencilMatrix<2> matrix(s.layout(), s.scene.mask());
    matrix.fill(s.jacobian());
    std::mt19937 draw(23);
    std::uniform_int_distribution<int> power(-40, 40);  // powers of two: the matrix itself is not rounded
    std::vector<double> row(n), column(n);
    for (double& f : row) f = std::exp2(power(draw));
    for (double& f : column) f = std::exp2(power(draw));
    const std::vector<double> direction = to_host(s.direction());
    Array right("right", n), found("found", n);
    matrix.multiply(to_device<Array>(direction), right);
    std::vector<double> scaled = to_host(right);
    for (int i = 0; i < n; ++i) scaled[i] *= row[i];
    scale(matrix, row, column);
    const auto lu = make_block_lu<2>(s.layout(), s.scene.mask());
    lu->build(matrix);
    lu->apply(to_device<Array>(scaled), found);
    std::vector<double> back = to_host(found);
    for (int i = 0; i < n; ++i) back[i] *= column[i];
    EXPECT_LT(distance(back, direction), 0.02);
  }
}

TEST(Equilibration, LargestEntriesBecomeOne) {
  std::vector<Case> cases{small_case(SceneKind::coupled), small_case(SceneKind::solid),
                          small_case(SceneKind::coupled, WallLaw::gradient, true)};
  for (int n : {3, 4, 6}) cases.push_back(larger(small_case(SceneKind::rigid, WallLaw::gradient, true), n, 4));
  for (const Case& c : cases) {
    RandomScene s(c);
    StencilMatrix<2> matrix(s.layout(), s.scene.mask());
    matrix.fill(s.jacobian());
    const UnknownTable<2> table(s.layout(), to_host(s.scene.mask()));
    const auto values = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), matrix.values());
    Equilibration found;
    Equilibrator<2>(s.layout(), table).compute(values, found);
    const int n = s.layout().size();
    std::vector<double> rows(n, 0.0), columns(n, 0.0);
    const auto visit = [&](const auto& body) {
      for (int c = 0; c < n; ++c)
        if (table.component(c) >= 0)
          for_column(matrix.stencil(), table, c,
                     [&](int r, std::int64_t at) { body(r, c, std::abs(double(values(at)))); });
    };
    visit([&](int r, int, double size) { rows[r] = std::max(rows[r], size); });
    visit([&](int r, int c, double size) { columns[c] = std::max(columns[c], size / rows[r]); });
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(found.row[i] * (table.component(i) < 0 ? 1 : rows[i]), 1, 1e-6) << i;
      EXPECT_NEAR(found.column[i] * (table.component(i) < 0 ? 1 : columns[i]), 1, 1e-6) << i;
    }
  }
}

TEST(BlockLu, AZeroMatrixGivesNoNumbers) {
  RandomScene s(small_case(SceneKind::rigid));
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  const auto lu = make_block_lu<2>(s.layout(), s.scene.mask());
  Array right("right", s.layout().size()), found("found", s.layout().size());
  Kokkos::deep_copy(right, 1.0);
  for (const float entry : {0.0f, std::nanf("")}) {
    matrix.fill([&](const StencilValues& values) { Kokkos::deep_copy(values, entry); });
    lu->build(matrix);
    lu->apply(right, found);
    double sum = 0;
    for (double v : to_host(found)) sum += std::abs(v);
    EXPECT_FALSE(std::isfinite(sum));
  }
}

/// Every node belongs to one subtree or lies above them, its children before it.
TEST(WorkSplit, HoldsEveryNodeOnce) {
  RandomScene s(larger(small_case(SceneKind::coupled), 31, 18));
  const Dissection tree = dissect(s.layout(), UnknownTable<2>(s.layout(), to_host(s.scene.mask())), 16);
  std::size_t before = 0;
  for (int threads : {1, 2, 3, 8, 64}) {
    const WorkSplit split = split_work(tree, threads);
    std::vector<int> times(tree.nodes.size(), 0);
    for (int root : split.subtrees)
      for (int n = tree.nodes[root].first; n <= root; ++n) ++times[n];
    for (const std::vector<int>& level : split.top)
      for (int n : level) ++times[n];
    EXPECT_EQ(times, std::vector<int>(tree.nodes.size(), 1)) << threads;
    EXPECT_GE(split.subtrees.size(), before);
    before = split.subtrees.size();
  }
  EXPECT_EQ(split_work(tree, 1).subtrees.size(), 1u);
}

}  // namespace
}  // namespace softwet::testing_tools
