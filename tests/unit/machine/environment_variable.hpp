// Variables of the environment for the length of a test.
#pragma once

#include <stdlib.h>

#include <map>
#include <optional>
#include <string>

namespace softwet::testing_tools {

/// Values of variables; nothing: it is not set.
using Variables = std::map<std::string, std::optional<std::string>>;

/// Sets variables, or removes them, and restores their old values.
class Environment {
 public:
  explicit Environment(const Variables& values) {
    for (const auto& [name, value] : values) {
      const char* before = ::getenv(name.c_str());
      before_[name] = before == nullptr ? std::optional<std::string>() : before;
      set(name, value);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() {
    for (const auto& [name, value] : before_) set(name, value);
  }

 private:
  static void set(const std::string& name, const std::optional<std::string>& value) {
    value ? ::setenv(name.c_str(), value->c_str(), 1) : ::unsetenv(name.c_str());
  }
  Variables before_;
};

}  // namespace softwet::testing_tools
