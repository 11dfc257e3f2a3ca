// Which threads of a team have a point, and in which banks of the memory that the team shares their numbers lie: a
// device reads 16 numbers in double precision at once where they lie in different banks.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "operator/device/tile.hpp"

namespace softwet {
namespace {

using Plan = TilePlan<ChosenTile<3, 2, false, double>, NavierStokesKorteweg, WallMotion<3>, false, double>;
using Shape = Plan::Shape;
using Room = TileScratch<Plan>;

template <int threads>
struct OneOf {
  static constexpr int size = threads;
  int rank_;
  int rank() const { return rank_; }
};

/// The points of all threads one after the other; each is preceded by the number of its thread.
template <int threads>
std::vector<std::vector<int>> points_of_threads() {
  std::vector<std::vector<int>> points(threads);
  for (int rank = 0; rank < threads; ++rank)
    share_points<Shape::points, Shape::lanes>(OneOf<threads>{rank}, [&](int p, int l) {
      EXPECT_LT(l, (slots_of(Shape::points, Shape::lanes) + threads - 1) / threads);
      points[rank].push_back(p);
    });
  return points;
}

template <int threads>
void check_points() {
  std::vector<int> times(Shape::points, 0);
  for (const auto& of_thread : points_of_threads<threads>())
    for (int p : of_thread) ++times[p];
  EXPECT_EQ(times, std::vector<int>(Shape::points, 1)) << threads;
}

TEST(TileBanks, EachPointHasOneThread) {
  check_points<1>();
  check_points<3>();
  check_points<40>();
  check_points<Shape::points>();
  check_points<Shape::threads>();
}

/// The most of these numbers in one bank.
int most_in_a_bank(const std::vector<int>& places) {
  std::vector<int> in_bank(16, 0);
  int most = 0;
  for (int place : places) most = std::max(most, ++in_bank[place % 16]);
  return most;
}

TEST(TileBanks, NeighboursAlongX) {
  static_assert(Shape::threads % 32 == 0 && Shape::lanes == 15);
  const auto points = points_of_threads<Shape::threads>();
  for (int r = 0; r < Shape::Q; ++r)
    for (int begin = 0; begin < Shape::threads; begin += 16) {
      std::vector<int> places;
      for (int rank = begin; rank < begin + 16; ++rank)
        for (int p : points[rank]) places.push_back(p - p % Shape::Q + (p + r) % Shape::Q);
      EXPECT_LE(most_in_a_bank(places), 1) << begin << ", " << r;
    }
}

/// Threads that go along x from line to line of different fields, as sweeps along y and z and folds do.
TEST(TileBanks, LinesOfFields) {
  for (int apart : {Room::field, Room::point_field})
    for (int begin = 0; begin + 16 <= Shape::qx * Plan::fields; begin += 16) {
      std::vector<int> places;
      for (int item = begin; item < begin + 16; ++item) places.push_back(item / Shape::qx * apart + item % Shape::qx);
      EXPECT_EQ(most_in_a_bank(places), 1) << apart << ", " << begin;
    }
}

}  // namespace
}  // namespace softwet
