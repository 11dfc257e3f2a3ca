// The counter of kernels and copies against a stretch of known operations.
#include "cli/core/kernel_counts.hpp"

#include <gtest/gtest.h>

#include "field/vector.hpp"

namespace softwet::testing_tools {
namespace {

TEST(KernelCounter, CountsKernelsAndCopiesUntilItStops) {
  const Array x("x", 100), y("y", 100);
  combine(y, 1, x, 0);
  KernelCounter counter;
  for (int i = 0; i < 3; ++i) combine(y, 2, x, 1);
  dot(alone, x, y);  // a kernel, a copy from a device, and a wait
  to_host(y);
  Kokkos::fence();
  const Array another(Kokkos::view_alloc("another", Kokkos::WithoutInitializing), 100);
  const KernelCounts counts = counter.stop();
  combine(y, 1, x, 0);
  EXPECT_EQ(counts.kernels, 4);
  EXPECT_EQ(counts.copies, on_host ? 1 : 2);
  EXPECT_GE(counts.waits, 2);
  EXPECT_GE(counts.allocations, 1);
  EXPECT_EQ(counter.stop().kernels, 4) << "it has stopped";
}

TEST(KernelCounter, BeginsAnew) {
  const Array x("x", 100);
  KernelCounter().stop();
  KernelCounter counter;
  combine(x, 2, x, 0);
  const KernelCounts counts = counter.stop();
  EXPECT_EQ(counts.kernels, 1);
  EXPECT_EQ(counts.allocations, 0);
}

}  // namespace
}  // namespace softwet::testing_tools
