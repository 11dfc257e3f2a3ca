// The case `softwet init` writes for the pull, as a text and read.
#pragma once

#include "casefile/case_file.hpp"

namespace softwet::testing_tools {

inline const std::string& pull_text() {
  static const std::string text = initial_case("tensotaxis_pull_2d");
  return text;
}

inline const Case& pull() {
  static const Case c = parse_case(pull_text(), "case.toml");
  return c;
}

}  // namespace softwet::testing_tools
