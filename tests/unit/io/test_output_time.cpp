// Times of the results are free of what subtractions and sums have rounded.
#include "io/output_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

TEST(OutputTime, IsTheDecimalThatWasMeant) {
  EXPECT_NE(0.1 + 0.1 + 0.1, 0.3);
  EXPECT_EQ(output_time(0.1 + 0.1 + 0.1, 0), 0.3);
  EXPECT_NE((30 + 0.3) - 30, 0.3);
  EXPECT_EQ(output_time(30 + 0.3, 30), 0.3);
  EXPECT_EQ(output_time(0, 30), -30);
  EXPECT_EQ(output_time(std::nextafter(30.0, 31.0), 30), 0);
  EXPECT_FALSE(std::signbit(output_time(std::nextafter(30.0, 0.0), 30)));
}

TEST(OutputTime, KeepsWhatIsNoRounding) {
  for (double time : {1.0 / 3, 0.1234567890123456, 123456.78901234567, 1e-12 / 7})
    EXPECT_EQ(output_time(time, 0), time);
  EXPECT_EQ(short_decimal(2.0 / 3), 2.0 / 3);
  EXPECT_EQ(short_decimal(0.3 + 1e-13), 0.3 + 1e-13);
  EXPECT_EQ(short_decimal(0), 0);
}

}  // namespace
}  // namespace softwet
