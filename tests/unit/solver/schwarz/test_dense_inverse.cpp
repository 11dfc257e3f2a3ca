// Batched dense inverses, as the host and as a device computes them.
#include "solver/schwarz/dense_inverse.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace softwet::testing_tools {
namespace {

using HostBlocks = DenseBlocks::host_mirror_type;

DenseBlocks copy_of(const HostBlocks& given) {
  const DenseBlocks copy("copy", given.extent(0), given.extent(1), given.extent(2));
  Kokkos::deep_copy(copy, given);
  return copy;
}
BlockSizes to_sizes(const std::vector<int>& size) { return to_device<Kokkos::View<int*, Exec>>(size); }

HostBlocks random_blocks(int count, int rows, int seed) {
  const HostBlocks given("given", count, rows, rows);
  std::mt19937 draw(seed);
  std::uniform_real_distribution<float> number(-1, 1);
  for (std::size_t i = 0; i < given.size(); ++i) given.data()[i] = number(draw);
  return given;
}

constexpr BlockTeams all_teams[] = {BlockTeams::many_each, BlockTeams::one_each, BlockTeams::chosen};

/// What both ways leave: [by factors, by elimination], as block(b, row, column).
std::vector<HostBlocks> both_inverses(const HostBlocks& given, const std::vector<int>& size) {
  std::vector<HostBlocks> found;
  if (on_host) {
    const DenseBlocks a = copy_of(given);
    invert_by_factors(a, to_sizes(size));
    const HostBlocks turned("turned", a.extent(0), a.extent(1), a.extent(2));
    for (std::size_t b = 0; b < a.extent(0); ++b)
      for (int i = 0; i < size[b]; ++i)
        for (int j = 0; j < size[b]; ++j) turned(b, i, j) = a(b, j, i);
    found.push_back(turned);
  }
  const DenseBlocks a = copy_of(given);
  GaussJordan(a.extent(0), a.extent(1)).invert(a, to_sizes(size));
  found.push_back(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), a));
  return found;
}

/// Sizes end within a panel of the elimination, at its end and behind it. Rows differ in scale by 10^8, and diagonals
/// are zero, so that pivots have to be found.
TEST(DenseInverse, BothWaysAgreeWithTheProduct) {
  const int n = 3 * GaussJordan::panel + 5;
  const std::vector<int> size{n, 1, 2, GaussJordan::panel, GaussJordan::panel + 1, 0, 2 * GaussJordan::panel - 1};
  const HostBlocks given = random_blocks(size.size(), n, 7);
  for (std::size_t b = 0; b < size.size(); ++b)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        given(b, i, j) *= i == j && size[b] > 1 ? 0.0f : std::pow(10.0f, static_cast<float>(i % 9 - 4));
  for (const HostBlocks& found : both_inverses(given, size))
    for (std::size_t b = 0; b < size.size(); ++b)
      for (int row = 0; row < size[b]; ++row)
        for (int column = 0; column < size[b]; ++column) {
          double sum = 0;
          for (int k = 0; k < size[b]; ++k) sum += double(found(b, row, k)) * given(b, k, column);
          ASSERT_NEAR(sum, row == column ? 1.0 : 0.0, 1e-3) << size[b] << " rows";
        }
}

/// Blocks of different sizes, with gaps between their rows, of which none, some or all unknowns are eliminated.
TEST(DenseInverse, SomeUnknownsAreEliminatedAlone) {
  const std::vector<int> size{40, 37, 5, 16, 21}, pivots{17, 37, 0, 16, 3}, stride{43, 40, 5, 24, 21};
  std::vector<std::int64_t> begin;
  std::vector<float> given;
  std::mt19937 draw(9);
  std::uniform_real_distribution<float> number(-1, 1);
  for (std::size_t b = 0; b < size.size(); ++b) {
    begin.push_back(static_cast<std::int64_t>(given.size()));
    for (int i = 0; i < size[b] * stride[b]; ++i) given.push_back(number(draw));
  }
  const auto eliminated = [&](BlockTeams teams) {
    const auto data = to_device<Kokkos::View<float*, Exec>>(given);
    const ScatteredBlocks blocks{data.data(), to_device<Kokkos::View<std::int64_t*, Exec>>(begin), to_sizes(stride)};
    GaussJordan(size.size(), 40, teams).eliminate(blocks, to_sizes(pivots), to_sizes(size), 40, 37);
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), data);
  };
  const auto found = eliminated(BlockTeams::many_each);
  for (const BlockTeams teams : all_teams) {
    const auto other = eliminated(teams);
    for (std::size_t i = 0; i < given.size(); ++i) ASSERT_EQ(other(i), found(i)) << i;
  }
  using Strided = Eigen::Map<const Eigen::Matrix<float, -1, -1, Eigen::RowMajor>, 0, Eigen::OuterStride<>>;
  for (std::size_t b = 0; b < size.size(); ++b) {
    const int m = pivots[b], n = size[b] - m;
    const Eigen::OuterStride<> step(stride[b]);
    const Eigen::MatrixXd a = Strided(given.data() + begin[b], size[b], size[b], step).cast<double>();
    const Eigen::MatrixXd inverse = a.topLeftCorner(m, m).inverse(), upper = inverse * a.topRightCorner(m, n);
    Eigen::MatrixXd expected(size[b], size[b]);
    expected << inverse, upper, -a.bottomLeftCorner(n, m) * inverse,
        a.bottomRightCorner(n, n) - a.bottomLeftCorner(n, m) * upper;
    const Eigen::MatrixXd result = Strided(found.data() + begin[b], size[b], size[b], step).cast<double>();
    EXPECT_LT((result - expected).norm(), 1e-4 * expected.norm()) << "block " << b;
  }
}

// Every number is the result of the same operations, whichever thread does them: a missing barrier shows.
TEST(DenseInverse, TheThreadsOfATeamDoNotMatter) {
  const int threads = on_host ? std::min(4, Exec().concurrency()) : 8, n = 61, count = 20;
  if (threads < 2) GTEST_SKIP() << "one thread alone";
  const HostBlocks given = random_blocks(count, n, 8);
  const DenseBlocks one = copy_of(given), several = copy_of(given);
  std::vector<int> size;
  for (int b = 0; b < count; ++b) size.push_back(n - b);
  const GaussJordan inverse(count, n);
  inverse.invert(one, to_sizes(size), 1);
  inverse.invert(several, to_sizes(size), threads);
  const auto expected = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), one);
  const auto found = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), several);
  for (int b = 0; b < count; ++b)
    for (int i = 0; i < size[b]; ++i)
      for (int j = 0; j < size[b]; ++j) ASSERT_EQ(found(b, i, j), expected(b, i, j)) << b << " " << i << " " << j;
}

/// However blocks are shared out, for sizes that end within a panel of the elimination, at its end and behind it.
TEST(DenseInverse, OneTeamAndManyGiveTheSameBits) {
  const int n = 2 * GaussJordan::panel + 9;
  const std::vector<int> size{n, 1, GaussJordan::panel, 0, GaussJordan::panel + 1, 2 * GaussJordan::panel};
  const HostBlocks given = random_blocks(size.size(), n, 11);
  std::vector<HostBlocks> found;
  for (const BlockTeams teams : all_teams)
    for (const int threads : {0, on_host ? std::min(3, Exec().concurrency()) : 8}) {
      const DenseBlocks a = copy_of(given);
      GaussJordan(size.size(), n, teams).invert(a, to_sizes(size), threads);
      found.push_back(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), a));
    }
  for (const HostBlocks& other : found)
    for (std::size_t b = 0; b < size.size(); ++b)
      for (int i = 0; i < size[b]; ++i)
        for (int j = 0; j < size[b]; ++j) ASSERT_EQ(other(b, i, j), found[0](b, i, j)) << b << " " << i << " " << j;
}

/// Launches of a Gauss-Jordan elimination.
long launches_of(BlockTeams teams, int count, int rows) {
  static long launches;
  const DenseBlocks a = copy_of(random_blocks(count, rows, 3));
  const BlockSizes size = to_sizes(std::vector<int>(count, rows));
  const GaussJordan elimination(count, rows, teams);
  const auto before = Kokkos::Tools::Experimental::get_callbacks();
  launches = 0;
  Kokkos::Tools::Experimental::set_begin_parallel_for_callback([](const char*, std::uint32_t, std::uint64_t* id) {
    *id = 0;
    ++launches;
  });
  elimination.invert(a, size);
  Kokkos::Tools::Experimental::set_callbacks(before);
  return launches;
}

TEST(DenseInverse, ABlockOfItsOwnTeamIsOneLaunch) {
  const int panels = 3, rows = panels * GaussJordan::panel;
  EXPECT_EQ(launches_of(BlockTeams::many_each, 2, rows), 3 * panels + 3);
  EXPECT_EQ(launches_of(BlockTeams::one_each, 2, rows), 1);
  EXPECT_EQ(launches_of(BlockTeams::chosen, on_host ? 4 * Exec().concurrency() : 2, rows), 1) << "small, or many";
}

TEST(DenseInverse, ASingularBlockIsNotFiniteAndItsNeighbourIsRight) {
  const int n = 6;
  const HostBlocks given("given", 3, n, n);
  // Two zero pivots in a row in the first block, nothing but zeros in the second one, 2 I in the third one.
  for (int i = 0; i < n; ++i) {
    given(0, i, i) = i == 2 || i == 3 ? 0.0f : 1.0f;
    given(2, i, i) = 2;
  }
  for (const HostBlocks& found : both_inverses(given, {n, n, n})) {
    double sum[3] = {0, 0, 0};
    for (int b = 0; b < 3; ++b)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum[b] += std::abs(found(b, i, j));
    EXPECT_FALSE(std::isfinite(sum[0]));
    EXPECT_FALSE(std::isfinite(sum[1]));
    EXPECT_DOUBLE_EQ(sum[2], 0.5 * n);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
