// Lines of messages.
#include "machine/terminal.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace softwet {
namespace {

TEST(Terminal, MessagesAreBrokenBetweenWords) {
  EXPECT_EQ(wrapped("one two three four", 9), "one two\n  three\n  four");
  EXPECT_EQ(wrapped("one two", 80), "one two");
  EXPECT_EQ(wrapped("a/path/that/is/long is there", 10), "a/path/that/is/long\n  is there");
  EXPECT_EQ(wrapped("", 10), "");
}

TEST(Terminal, NoLineIsLongerThanTheTerminal) {
  std::string message;
  for (int i = 0; i < 200; ++i) message += std::string(1 + i * 7 % 11, 'a' + i % 26) + " ";
  for (const std::size_t width : {20, 40, 80}) {
    std::istringstream lines(wrapped(message, width));
    std::string words, again;
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), width);
      words += line + " ";
    }
    std::istringstream left(message), right(words);
    for (std::string a, b; left >> a;) {
      right >> b;
      EXPECT_EQ(a, b);
    }
  }
}

}  // namespace
}  // namespace softwet
