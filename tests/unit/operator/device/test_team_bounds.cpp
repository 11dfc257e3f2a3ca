// Teams of the kernels of a device, against the limits of a chip as its maker's tables have them.
#include "operator/device/team_bounds.hpp"

#include <gtest/gtest.h>

#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "operator/device/element_kernel.hpp"

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

/// A product of the fluid in space on a moving mesh with reduced quadrature: twelve teams of its scratch need more than a
/// multiprocessor of any chip has. Kokkos counts the scratch, two numbers and one for each thread.
TEST(TeamBounds, ReducedQuadratureInSpaceFits) {
  using Kernel = ElementKernel<2, 2, true, 3, NavierStokesKorteweg, WallMotion<3>, double>;
  constexpr int counted = Kernel::bytes + (32 + 2) * 8, teams = teams_of<TeamBounds<32, Kernel::bytes, 12>>;
  EXPECT_GT(12 * counted, 228 * 1024);
  EXPECT_GT(teams, 0);
  EXPECT_LE(teams * counted, multiprocessor.bytes);
}

}  // namespace
}  // namespace softwet
