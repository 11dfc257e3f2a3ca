// Teams of the kernels of a device, against the limits of a chip as its maker's tables have them.
#include "operator/device/team_bounds.hpp"

#include <gtest/gtest.h>

#include "scene/scene_terms.hpp"

namespace softwet {
namespace {

template <class Bounds>
constexpr int teams_of = static_cast<int>(Bounds::minBperSM);

TEST(TeamBounds, MemoryLimitsTeams) {
  constexpr int chip = multiprocessor.bytes;
  EXPECT_EQ(teams_that_fit(32, 10000), std::min(chip / (10000 + 36 * 8 + 1024), multiprocessor.threads / 32));
  EXPECT_GT(teams_that_fit(32, 48 * 1024 - 36 * 8), 0);
  EXPECT_EQ(teams_that_fit(32, 48 * 1024 - 36 * 8 + 1), 0);
}

TEST(TeamBounds, ThreadsLimitTeams) {
  EXPECT_EQ(teams_that_fit(1024, 0), multiprocessor.threads / 1024);
  EXPECT_EQ(teams_that_fit(33, 0), std::min(multiprocessor.bytes / (37 * 8 + 1024), multiprocessor.threads / 64));
}

TEST(TeamBounds, NoMoreThanWanted) {
  EXPECT_EQ((teams_of<TeamBounds<32, 100, 12>>), 12);
  EXPECT_EQ((teams_of<TeamBounds<32, 100, 3>>), 3);
}

/// Teams of the terms of most scenes with reduced quadrature: whole warps, and residuals have 512 threads on a multiprocessor of
/// 228 kB. Kokkos counts the scratch, two numbers and one for each thread.
template <int D, bool Tangent, class Real, class List>
void check_reduced() {
  using Shape = SlopeTileShape<D, 2, 2>;
  using Kernel = TileKernel<Shape, Tangent, Real, List>;
  constexpr int teams = teams_of<TeamBounds<Shape::points, Kernel::bytes, Shape::teams>>;
  EXPECT_EQ(Shape::points % 32, 0);
  EXPECT_GE(teams, 2);
  EXPECT_LE(teams * (Kernel::bytes + (Shape::points + 2) * 8), multiprocessor.bytes);
  if (!Tangent && multiprocessor.bytes >= 228 * 1024) EXPECT_GE(teams * Shape::points, 512) << Kernel::bytes;
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

}  // namespace
}  // namespace softwet
