// The one exception of softwet: a sentence for the user and the exit code the program ends with.
#pragma once

#include <stdexcept>
#include <string>

namespace softwet {

/// Exit codes of the program (docs/quick_start.md: contract with the user).
enum class Exit { done = 0, invalid_input = 1, computation_failed = 2, machine_failed = 3 };

/// Thrown wherever softwet cannot go on. `what()` is the whole message shown to the user: place, value, range, remedy.
class Error : public std::runtime_error {
 public:
  Error(Exit code, const std::string& message) : std::runtime_error(message), code_(code) {}
  Exit code() const { return code_; }

 private:
  Exit code_;
};

}  // namespace softwet
