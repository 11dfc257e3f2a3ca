// The times of the field files are the decimals that a user would write.
#include "casefile/checks/field_times.hpp"

#include <gtest/gtest.h>

#include "casefile/schema/value.hpp"
#include "unit/casefile/pull.hpp"

namespace softwet {
namespace {

Case every(double interval, double end) {
  Case c = testing_tools::pull();
  c.output.field_times = {};
  c.output.field_every = interval;
  c.time.end = end;
  return c;
}

TEST(FieldTimes, MultiplesOfADecimalAreDecimals) {
  const std::vector<double> times = field_times(every(0.1, 1.2));
  EXPECT_EQ(times, (std::vector<double>{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2}));
  const std::vector<double> fine = field_times(every(0.007, 70));
  ASSERT_EQ(fine.size(), 10001u);
  for (int k = 0; k < 10001; ++k) ASSERT_EQ(fine[k], number_from_text(std::to_string(7 * k) + "e-3")) << k;
}

TEST(FieldTimes, MultiplesOfARatioAreThoseOfTheRatio) {
  const double third = 1.0 / 3;
  EXPECT_EQ(field_times(every(third, 1)), (std::vector<double>{0, third, 2 * third, 1}));
}

TEST(FieldTimes, ARangeHasTheDecimalsToo) {
  for (int count : {8, 11, 71, 101}) {
    const auto times = range_from_text("0:" + text_of_number((count - 1) / 10.0) + ":" + std::to_string(count));
    ASSERT_TRUE(times);
    for (int k = 0; k < count; ++k) EXPECT_EQ((*times)[k], number_from_text(std::to_string(k) + "e-1")) << count;
  }
}

}  // namespace
}  // namespace softwet
