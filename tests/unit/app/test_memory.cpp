// The memory a case needs at least, what can be had, and the refusal.
#include "app/host/memory.hpp"

#include <gtest/gtest.h>

#include "app/host/case_file.hpp"
#include "unit/observe/expect_error.hpp"

namespace softwet {
namespace {

Case pull(const std::string& elements) {
  return parse_case(initial_case("tensotaxis_pull_2d"), "case.toml", {"domain.elements=" + elements});
}

TEST(Memory, LeastGrowsWithTheMeshAndTheKrylovBasis) {
  Case c = pull("[128, 64]");
  const double coarse = least_bytes(c);
  EXPECT_NEAR(least_bytes(pull("[256, 128]")) / coarse, 4, 1e-12);
  // 128 x 64 elements, of which a quarter is solid: 2 velocities everywhere, 2 scalars in the fluid.
  const double unknowns = 128 * 64 * (2 + 2 * 0.75);
  c.solver.krylov_restart += 10;
  EXPECT_NEAR(least_bytes(c) - coarse, 8 * 20 * unknowns, 1e-6);
}

TEST(Memory, LeastStaysBelowWhatATableOfPartsCounts) {
  // The vectors of the pull (128 x 64) as `softwet check` counts them, control points of the edges included.
  const double counted = 1.2 + 0.7 + 1.2 + 14.4, least = least_bytes(pull("[128, 64]")) / 1048576;
  EXPECT_LT(least, counted);
  EXPECT_GT(least, 0.8 * counted);
}

TEST(Memory, MostUnknownsBoundsThoseOfTheMesh) { EXPECT_GE(most_unknowns(pull("[128, 64]")), 130 * 68 * 4); }

TEST(Memory, WhatCanBeHadIsPositiveAndMoreIsRefusedWithBothAmounts) {
  const double all = bytes_to_be_had();
  EXPECT_GT(all, 1e6);
  const Case c = pull("[128, 64]");
  require_bytes(c, 1024);
  expect_error(Exit::machine_failed, {"needs 9.313e+08 GiB", "can be had", "[128, 64]", "schwarz"},
               [&] { require_bytes(c, 1e18); });
}

}  // namespace
}  // namespace softwet
