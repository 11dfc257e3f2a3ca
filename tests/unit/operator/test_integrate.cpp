// Numbers that kernels leave for the host, in one list.
#include <gtest/gtest.h>

#include <cmath>

#include "operator/integrate.hpp"

namespace softwet::testing_tools {
namespace {

Array sine_array(int count, double step) {
  std::vector<double> values(count);
  for (int i = 0; i < count; ++i) values[i] = std::sin(step * i);
  return to_device<Array>(values);
}

TEST(PendingIntegrals, SumsAreThoseThatWait) {
  const Array x = sine_array(1300, 0.7), y = sine_array(1300, 1.1);
  for (const bool has_room : {false, true}) {
    double product = 0, all = 0;
    PendingIntegrals pending;
    pending.start_sum(alone, x, y, [&](double sum) { product = sum; });
    pending.start_sum(alone, x, {}, [&](double sum) { all = sum; });
    if (has_room) {
      EXPECT_EQ(product, 0);  // not before the end
    }
    pending.finish();
    EXPECT_EQ(product, dot(alone, x, y));
    EXPECT_EQ(all, total(alone, x));
  }
}

// The vectors of a sum stay until it is there, whoever else has let them go.
TEST(PendingIntegrals, SumsKeepWhatTheyRead) {
  double sum = 0;
  PendingIntegrals pending;
  Array x = sine_array(100, 0.3);
  const double expected = dot(alone, x, x);
  pending.start_sum(alone, x, x, [&](double s) { sum = s; });
  const long kept = x.use_count();
  EXPECT_GT(kept, 1);
  pending.finish();
  EXPECT_EQ(sum, expected);
  EXPECT_EQ(x.use_count(), 1);
}

/// Leaves k, k + 1, ...
struct CountUp {
  Array out;
  int from;
  KOKKOS_FUNCTION void operator()(int i) const { out(i) = from + i; }
};

// Some are handed out early, where the room has to grow, but each once and in their order.
TEST(PendingIntegrals, NumbersComeInTheOrderInWhichTheyWereStarted) {
  for (int round = 0; round < 2; ++round) {
    std::vector<int> order;
    PendingIntegrals pending;
    for (int k = 0; k < 5; ++k) {
      const std::size_t count = 40000 * (k + 1);
      pending.start_numbers(
          count,
          [&](const Array& out) {
            Kokkos::parallel_for("count", Items(0, count), CountUp{out, k});
          },
          [&order, k, count](const auto& values) {
            ASSERT_EQ(values.extent(0), count);
            EXPECT_EQ(values(0), k);
            EXPECT_EQ(values(count - 1), k + static_cast<double>(count - 1));
            order.push_back(2 * k);
          });
      pending.then([&order, k] { order.push_back(2 * k + 1); });
    }
    pending.finish();
    EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
    pending.finish();
    EXPECT_EQ(order.size(), 10U);
  }
}

TEST(PendingIntegrals, OneListAtATime) {
  PendingIntegrals one;
  const Array x = sine_array(10, 1);
  one.start_sum(alone, x, x, [](double) {});
  PendingIntegrals other;
  EXPECT_THROW(other.start_sum(alone, x, x, [](double) {}), std::logic_error);
  one.finish();
  EXPECT_NO_THROW(other.start_sum(alone, x, x, [](double) {}));
  other.finish();
}

}  // namespace
}  // namespace softwet::testing_tools
