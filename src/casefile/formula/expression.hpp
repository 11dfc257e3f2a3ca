// A formula in a case file, "0.5 + 0.1*tanh((x - 0.5)/g)". The only file that sees the library muParser is
// expression.cpp.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "case/profile.hpp"

namespace softwet {

/// What is wrong with an expression or a table, and what to do about it.
struct FormulaError : std::runtime_error {
  FormulaError(const std::string& problem, const std::string& advice) : std::runtime_error(problem), remedy(advice) {}
  std::string remedy;
};

/// The names that an expression may use beside the functions.
struct Vocabulary {
  std::vector<std::string> variables;  ///< out of x, y, z and t
  std::vector<std::pair<std::string, double>> constants;

  std::string text() const;  ///< "x, y; the constants pi, Lx; the functions sin, ..."
};

/// The functions of expressions, for `explain`.
extern const char* const functions_of_expressions;

class Expression final : public Formula {
 public:
  /// Throws FormulaError, which names the column of the text.
  Expression(const std::string& text, const Vocabulary&);
  ~Expression() override;

  double at(const std::array<double, 3>& x, double t) const override;
  bool constant() const;  ///< no variable occurs

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace softwet
