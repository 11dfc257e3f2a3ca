// Numbers, ranges and texts of a case file.
#include <gtest/gtest.h>

#include "casefile/case_file.hpp"
#include "casefile/checks/field_times.hpp"
#include "casefile/schema/schema.hpp"
#include "casefile/text/document.hpp"

namespace softwet {
namespace {

TEST(Value, ReadsNumbersAndRatios) {
  EXPECT_EQ(number_from_text("1/256"), 1.0 / 256);
  EXPECT_EQ(number_from_text(" -3 / 8 "), -0.375);
  EXPECT_EQ(number_from_text("+2e-3"), 2e-3);
  for (const char* wrong :
       {"", "/", "1/", "/2", "1/0", "1/2/3", "abc", "1 2", "+-1", "1__0", "_1", "1_", "1_.5", "_"}) {
    EXPECT_FALSE(number_from_text(wrong)) << wrong;
  }
}

TEST(Value, ReadsWholeNumbersInAnyWayThatTomlWritesThem) {
  for (const char* text : {"1000", "1_000", "1000.0", "1e3", "+1_0e0_2", "1_000.0", " 2_000/2 "})
    EXPECT_EQ(number_from_text(text), 1000) << text;
}

TEST(Value, WritesTextThatReadsBackToTheSameBits) {
  for (double number : {0.1, 1.0 / 3, 1e-300, 123456789.125, 5e-324, 1e22}) {
    EXPECT_EQ(number_from_text(text_of_number(number)), number);
  }
  EXPECT_EQ(text_of_number(-0.0), "0");
  EXPECT_EQ(text_of_value(std::string("a\"b\\c\n")), "\"a\\\"b\\\\c\\u000A\"");
}

TEST(Value, ReadsRanges) {
  EXPECT_EQ(range_from_text("0:5:11"), (Numbers{0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5}));
  EXPECT_EQ(range_from_text(" -1/2 : 0.1 : 2 "), (Numbers{-0.5, 0.1}));
  for (const char* wrong : {"", ":", "::", "0:5", "0:5:1", "0:5:2.5", "0:5:10001", "0:5:nan", "0:x:3", "0:5:3:4"})
    EXPECT_FALSE(range_from_text(wrong)) << wrong;
}

}  // namespace
}  // namespace softwet
