// Entry of softwet_unit: Kokkos lives around all tests. A listing of the tests needs no device.
#include <gtest/gtest.h>

#include "memory/team_scratch.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  const Kokkos::ScopeGuard kokkos(argc, argv);
  softwet::reserve_team_scratch();
  return RUN_ALL_TESTS();
}
