// Teams of the kernels of a device, against the limits of a chip as its maker's tables have them.
#include "operator/device/team_bounds.hpp"

#include <gtest/gtest.h>

#include "kernels/fluid/explicit_terms.hpp"
#include "scene/scene_terms.hpp"

namespace softwet {
namespace {

TEST(TeamBounds, MemoryLimitsTeams) {
  constexpr int chip = multiprocessor.bytes;
  EXPECT_EQ(teams_that_fit(32, 10000),
            std::min(chip / (10000 + 36 * 8 + 1024), multiprocessor.threads / multiprocessor.warp));
  EXPECT_GT(teams_that_fit(32, 48 * 1024 - 36 * 8), 0);
  EXPECT_EQ(teams_that_fit(32, 48 * 1024 - 36 * 8 + 1), 0);
}

TEST(TeamBounds, ThreadsLimitTeams) {
  EXPECT_EQ(teams_that_fit(1024, 0), multiprocessor.threads / 1024);
  const int next = multiprocessor.warp + 1;
  EXPECT_EQ(teams_that_fit(next, 0), std::min(multiprocessor.bytes / ((next + 4) * 8 + 1024),
                                              multiprocessor.threads / (2 * multiprocessor.warp)));
}

TEST(TeamBounds, NoMoreThanWanted) {
  EXPECT_EQ((BoundsOfTeams<32, 100, 12>::teams), 12);
  EXPECT_EQ((BoundsOfTeams<32, 100, 3>::teams), 3);
}

/// Teams on a multiprocessor; for AMD warps on one of its four units, as many as such teams have.
TEST(TeamBounds, SecondNumber) {
  const bool units = multiprocessor.warp == 64;
  EXPECT_EQ(second_bound(32, 12), units ? 3 : 12);
  EXPECT_EQ(second_bound(162, 4), units ? 3 : 4);
  EXPECT_EQ(second_bound(252, 3), 3);
  EXPECT_EQ(second_bound(64, 1), 1);
  using Bounds = TeamBounds<162, 100, 4>;
  EXPECT_EQ(Bounds::maxTperB, 162u);
  EXPECT_EQ(Bounds::minBperSM, static_cast<unsigned>(second_bound(162, 4)));
}

/// Teams of the terms of most scenes with reduced quadrature: whole warps, and residuals have 512 points on a
/// multiprocessor of 228 kB. Kokkos counts the scratch, two numbers and one for each thread.
template <int D, bool Tangent, class Real, class List>
void check_reduced() {
  using Shape = SlopeTileShape<D, 2, 2>;
  using Kernel = TileKernel<Shape, Tangent, Real, List>;
  constexpr int threads = Kernel::threads;
  constexpr int teams = BoundsOfTeams<threads, Kernel::bytes, Shape::teams * Shape::points / threads>::teams;
  EXPECT_EQ(threads % multiprocessor.warp, 0);
  EXPECT_GE(teams, 2);
  EXPECT_LE(teams * (Kernel::bytes + (threads + 2) * 8), multiprocessor.bytes);
  if (!Tangent && multiprocessor.bytes >= 228 * 1024) {
    EXPECT_GE(teams * Shape::points, 512) << Kernel::bytes;
  }
}

TEST(TeamBounds, ReducedQuadratureFits) {
  check_reduced<2, false, double, SoftTerms<2, double>>();
  check_reduced<2, true, double, SoftTerms<2, double>>();
  check_reduced<2, true, float, SoftTerms<2, float>>();
  check_reduced<3, false, double, SoftTerms<3, double>>();
  check_reduced<3, true, double, SoftTerms<3, double>>();
  check_reduced<3, true, float, SoftTerms<3, float>>();
  check_reduced<3, false, double, RigidTerms>();
}

/// Terms of explicit steps need less scratch, and half as many threads, where these are whole warps.
TEST(TeamBounds, PointsOfAThread) {
  const bool halves = multiprocessor.warp == 32 && multiprocessor.bytes >= 228 * 1024;
  EXPECT_EQ((TileKernel<SlopeTileShape<3, 2, 2>, false, double, TermList<TermOnMesh<MassFlux, NoMotion>>>::threads),
            halves ? 32 : 64);
  EXPECT_EQ((TileKernel<SlopeTileShape<2, 2, 2>, false, double, TermList<TermOnMesh<MassFlux, NoMotion>>>::threads),
            halves ? 64 : 128);
  EXPECT_EQ((SlopeTileShape<3, 2, 2>::team(40 * 1024)), 64);
  EXPECT_EQ((SlopeTileShape<3, 3, 3>::team(1024)), 27 * 3);
}

}  // namespace
}  // namespace softwet
