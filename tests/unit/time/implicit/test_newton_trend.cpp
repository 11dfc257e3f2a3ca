// When Newton's method gives a step up, from the sizes of its residuals.
#include "time/implicit/newton.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

/// Newton's method where the residual has the given sizes, one after the other, whatever the linear solves do.
NewtonResult with_residuals(const std::vector<double>& sizes) {
  std::size_t next = 0;
  const NonlinearSystem system{[&](const Array&, const Array& r) { Kokkos::deep_copy(r, sizes.at(next++)); },
                               [](const Array& z, const Array& out) { Kokkos::deep_copy(out, z); },
                               [](const StencilValues&) {}, [](const Array&) { return Refusal{}; }};
  NewtonControl control;
  control.rtol = 1e-3;
  const int size = 2;
  return Newton(alone, size, size, std::make_unique<NoPreconditioner>())
      .solve(system, {{0, size, 0}}, control, Array("x", size));
}

// Along a soft direction a good step can be so long that the next residual is larger. Then it falls as before.
TEST(NewtonTrend, AResidualMayGrowOnceButNotTwice) {
  const NewtonResult once = with_residuals({1, 1e-1, 4e-3, 1.3e-2, 2e-3, 1e-4});
  EXPECT_TRUE(once.converged) << once.refusal.text();
  EXPECT_EQ(once.iterations, 5);
  const NewtonResult twice = with_residuals({1, 1e-1, 4e-3, 1.3e-2, 2e-3, 5e-3});
  EXPECT_EQ(twice.refusal.cause, Refusal::newton);
  EXPECT_EQ(twice.iterations, 5);
  const NewtonResult beyond = with_residuals({1, 1e-1, 4e-3, 1.1});
  EXPECT_EQ(beyond.refusal.cause, Refusal::newton);
  EXPECT_EQ(beyond.iterations, 3);
}

// Long before the last iteration that is allowed.
TEST(NewtonTrend, AResidualMayNotStayAboveThatOfTheStart) {
  EXPECT_TRUE(with_residuals({1, 0.8, 23, 2, 8e-3, 1e-4}).converged) << "it falls fast";
  const NewtonResult slow = with_residuals({1, 0.1, 6, 5.8, 3, 4.7});
  EXPECT_EQ(slow.refusal.cause, Refusal::newton);
  EXPECT_EQ(slow.iterations, 3);
}

}  // namespace
}  // namespace softwet
