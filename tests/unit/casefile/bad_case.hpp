// What a case that is wrong is answered.
#pragma once

#include <gtest/gtest.h>

#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "unit/casefile/pull.hpp"

namespace softwet::testing_tools {

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  return position == std::string::npos ? text : text.replace(position, from.size(), to);
}

inline std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_case(text, "case.toml", overrides);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::invalid_input);
    return error.what();
  }
  return "(accepted)";
}

inline void expect_parts(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

}  // namespace softwet::testing_tools
