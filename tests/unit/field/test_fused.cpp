// Several operations in one launch against the same one after another.
#include "field/fused.hpp"

#include <gtest/gtest.h>

#include "field/vector.hpp"

namespace softwet::testing_tools {
namespace {

struct Square {
  Array x;
  KOKKOS_FUNCTION void operator()(int i) const { x(i) = x(i) * x(i); }
};
struct AddTo {
  Array sum;
  ConstArray x;
  KOKKOS_FUNCTION void operator()(int i) const { sum(i) += x(i); }
};

std::vector<double> numbers(int count) {
  std::vector<double> x(count);
  for (int i = 0; i < count; ++i) x[i] = 1 + i % 7;
  return x;
}

// Vectors of different lengths, none a multiple of a piece of the host.
TEST(Fused, EachOperationRunsOnItsOwnLengthAndInItsPlace) {
  const Array x = to_device<Array>(numbers(1300)), sum = to_device<Array>(numbers(700)), copy("copy", 5);
  run_fused("test", ForEach{1300, Square{x}}, ForEach{700, AddTo{sum, x}}, copied(copy, x), ForEach{0, Square{sum}});
  const std::vector<double> squares = to_host(x), sums = to_host(sum), copies = to_host(copy), before = numbers(1300);
  for (int i = 0; i < 1300; ++i) ASSERT_EQ(squares[i], before[i] * before[i]) << i;
  for (int i = 0; i < 700; ++i) ASSERT_EQ(sums[i], before[i] + squares[i]) << "after the squares, " << i;
  for (int i = 0; i < 5; ++i) ASSERT_EQ(copies[i], squares[i]);
}

TEST(Fused, NothingIsStartedForNothing) { run_fused("test", ForEach{0, Square{}}, copied({}, {})); }

}  // namespace
}  // namespace softwet::testing_tools
