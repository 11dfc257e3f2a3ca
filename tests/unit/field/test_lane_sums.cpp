// Sums as a device adds them up, with a thread for each of the sums of an item and a team for each sum of blocks,
// against the host.
#include "field/lane_sums.hpp"

#include <gtest/gtest.h>

#include "field/vector.hpp"

namespace softwet {
namespace {

/// Numbers of 18 bits and very different sizes. Products of two of them and a weight of few bits are exact, so that a
/// compiler may contract or not; sums are rounded, so that their order shows.
double number(int i, int kind) {
  std::uint64_t h = (std::uint64_t(i) * 3 + kind + 1) * 0x9E3779B97F4A7C15u;
  h ^= h >> 29;
  h *= 0xBF58476D1CE4E5B9u;
  h ^= h >> 32;
  return std::ldexp(static_cast<double>(h % (1 << 18)) - (1 << 17), static_cast<int>((h >> 20) % 30));
}

template <class Real>
ArrayOf<Real> numbers(int count, int kind) {
  std::vector<Real> x(count);
  for (int i = 0; i < count; ++i) x[i] = static_cast<Real>(number(i, kind));
  return to_device<ArrayOf<Real>>(x);
}

template <class Real>
struct Vectors {
  VectorSpace space;
  int size, stride, count = 3;
  ArrayOf<Real> x, y, z;

  Vectors(const VectorSpace& space_, int size_)
      : space(space_),
        size(size_),
        stride(size_ + 5),
        x(numbers<Real>(stride * count, 0)),
        y(numbers<Real>(size, 1)),
        z(numbers<Real>(size, 2)) {}

  /// All kinds of sums: of squares, of products with one and with two vectors, without and with weights, and of
  /// entries.
  std::vector<StripSums<Real>> kernels() const {
    RangeFactors whole_lines, any;
    const int line = size / 3 / space.stored * space.stored;
    whole_lines.add(line, 2 * line, 0.75);
    any.add(size / 7, size / 2, 0.75);
    any.add(size / 2, size, 3);
    std::vector<StripSums<Real>> all;
    for (const RangeFactors& w : {RangeFactors(), whole_lines, any}) {
      all.push_back({space, x.data(), stride, count, {y.data()}, SquareOfFirst::left_out, size, w});
      all.push_back({space, x.data(), stride, count, {y.data(), z.data()}, SquareOfFirst::added, size, w});
    }
    all.push_back({space, x.data(), 0, 1, {nullptr}, SquareOfFirst::left_out, size});
    return all;
  }

  void check() const {
    for (const StripSums<Real>& k : kernels()) {
      const int items = k.items();
      if (items == 0) continue;
      const Array host("host", items), lanes("lanes", items), sums("sums", k.strips() * k.sums());
      Kokkos::parallel_for("items", Items(0, items), ItemSums<StripSums<Real>>{k, host});
      LaneSums<StripSums<Real>>{k, items, lanes}.start("lanes");
      ASSERT_EQ(to_host(lanes), to_host(host)) << size << " entries in lines of " << space.stored;
      AddBlocks{lanes, k.blocks(), sums}.start();
      check_totals(k, to_host(host), to_host(sums));
    }
  }

 private:
  /// Sums of strips that were added up on a device, and what `strip_sums` finds.
  static void check_totals(const StripSums<Real>& k, const std::vector<double>& items,
                           const std::vector<double>& of_strips) {
    StripTotals of_items(k.space.strips, k.sums(), StripsHere::all);
    StripTotals in_two(k.space.strips, k.sums(), StripsHere::all);
    add_partial_sums(of_items, k, items.data(), k.items(), 0);
    add_partial_sums(in_two, k, of_strips.data(), k.strips() * k.sums(), 0);
    const std::vector<double> found = strip_sums<Real>({k});
    for (int s = 0; s < k.sums(); ++s) {
      const double total = of_items.total(s);
      EXPECT_EQ(in_two.total(s), total);
      EXPECT_EQ(found[s], total);
    }
  }
};

template <class Real>
void check(const VectorSpace& space, const std::vector<int>& sizes) {
  for (const int size : sizes) Vectors<Real>(space, size).check();
}

TEST(LaneSums, OfNumbersThatAreInNoLines) {
  const std::vector<int> sizes{1, 2, 3, 4, 5, 7, 8, 9, 11, 250, 252, 255, 256, 257, 259, 260, 1023, 1024, 1029, 5003};
  check<double>(alone, sizes);
  check<float>(alone, sizes);
  check<double>(alone, {200003});  // so many blocks that a device adds them up
}

/// Strips of four columns, of which the last one is wider or all there is: odd numbers of lines, and of blocks of 64.
TEST(LaneSums, OfLinesOfColumns) {
  for (const int elements : {1, 2, 3, 4, 9, 11, 30}) {
    const VectorSpace space(cut_columns(Axis(1.0, elements, 2), 0, 1));
    std::vector<int> sizes;
    for (const int lines : {1, 2, 3, 63, 64, 65, 127, 150, 193}) sizes.push_back(lines * space.stored);
    check<double>(space, sizes);
    check<float>(space, sizes);
  }
}

/// What processes have of them begins behind copies of their neighbours' columns.
TEST(LaneSums, OfPartsOfColumns) {
  for (int rank = 0; rank < 3; ++rank) {
    const VectorSpace space(cut_columns(Axis(1.0, 31, 2), rank, 3));
    for (const int lines : {3, 130}) {
      const Vectors<double> vectors(space, lines * space.stored);
      const StripSums<double> k = vectors.kernels()[1];
      const Array host("host", k.items()), lanes("lanes", k.items());
      Kokkos::parallel_for("items", Items(0, k.items()), ItemSums<StripSums<double>>{k, host});
      LaneSums<StripSums<double>>{k, k.items(), lanes}.start("lanes");
      EXPECT_EQ(to_host(lanes), to_host(host)) << "process " << rank;
    }
  }
}

TEST(LaneSums, BlocksAreAddedInTheirOrder) {
  bool order_shows = false;
  for (const int blocks : {0, 1, 2, AddBlocks::at_once - 1, AddBlocks::at_once, AddBlocks::at_once + 1, 1300})
    for (const int totals : {1, 7}) {
      const Array partial = numbers<double>(blocks * totals, 0), sum("sum", totals);
      multiply(partial, numbers<double>(blocks * totals, 1));
      Kokkos::deep_copy(sum, std::nan(""));
      AddBlocks{partial, blocks, sum}.start();
      const std::vector<double> part = to_host(partial), found = to_host(sum);
      for (int r = 0; r < totals; ++r) {
        double expected = 0, backwards = 0;
        for (int b = 0; b < blocks; ++b) expected += part[b * totals + r];
        for (int b = blocks - 1; b >= 0; --b) backwards += part[b * totals + r];
        EXPECT_EQ(found[r], expected) << blocks << " blocks, sum " << r;
        order_shows = order_shows || backwards != expected;
      }
    }
  EXPECT_TRUE(order_shows) << "these numbers have the same sum in any order";
}

TEST(LaneSums, TheThreadsOfATeamDoNotMatter) {
  const int threads = on_host ? std::min(3, Exec().concurrency()) : 4;
  if (threads < 2) GTEST_SKIP() << "one thread alone";
  const Vectors<double> vectors(VectorSpace(cut_columns(Axis(1.0, 11, 2), 0, 1)), 13 * 150);
  for (const StripSums<double>& k : vectors.kernels()) {
    const auto sums = [&k](int count) {
      const Array lanes("lanes", k.items()), sum("sum", k.strips() * k.sums());
      LaneSums<StripSums<double>>{k, k.items(), lanes}.start("lanes", count);
      AddBlocks{lanes, k.blocks(), sum}.start(count);
      return to_host(sum);
    };
    EXPECT_EQ(sums(threads), sums(1));
  }
}

}  // namespace
}  // namespace softwet
