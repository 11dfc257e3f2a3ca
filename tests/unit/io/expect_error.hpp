// Checks that a call throws softwet::Error with a given exit code and words in its message.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "case/error.hpp"

namespace softwet {

template <class Call>
void expect_error(Exit code, std::initializer_list<std::string> words, Call call) {
  try {
    call();
    ADD_FAILURE() << "no error was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << "'" << word << "' not in: " << error.what();
    }
  }
}

}  // namespace softwet
