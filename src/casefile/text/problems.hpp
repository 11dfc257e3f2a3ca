// The mistakes of a case, collected so that all of them are reported at once.
#pragma once

#include <string>
#include <vector>

#include "case/error.hpp"

namespace softwet {

/// Bad input that concerns one key or table of a case.
struct CaseError : Error {
  CaseError(const std::string& about, const std::string& message) : Error(Exit::invalid_input, message), key(about) {}
  std::string key;  ///< indexed name, "load[0].box"
};

class Problems {
 public:
  static constexpr std::size_t most = 20;  ///< reading ends with this many

  /// Does the work; a CaseError that comes out of it is kept. Throws all that is kept where they are too many.
  template <class Work>
  void keep(const Work& work) {
    try {
      work();
    } catch (const CaseError& error) {
      add(error);
    }
  }

  /// True when a problem with this key, or with a table it is in, is kept: a check that needs it would mislead.
  bool about(const std::string& name) const;

  /// Throws one Error with all that is kept, a line each. Nothing happens where nothing is kept.
  void throw_if_any() const;

 private:
  void add(const CaseError& error);

  std::vector<CaseError> kept_;
};

/// Ends with CaseError: "place: key = text: problem; remedy". `about` is the key the problem concerns where it is not
/// the one that is shown.
[[noreturn]] void reject(const std::string& place, const std::string& key, const std::string& text,
                         const std::string& problem, const std::string& remedy, const std::string& about = {});

}  // namespace softwet
