// Expressions by muParser.
#include "casefile/formula/expression.hpp"

#include <fmt/core.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "casefile/schema/value.hpp"

namespace softwet {
namespace {

constexpr std::size_t longest_expression = 4000;  ///< letters of an expression

/// From 0 to 1, with the width 1.
double smooth_step(double s) { return 0.5 + 0.5 * std::tanh(s); }

/// Versions of the library differ in the base of log.
double natural_logarithm(double s) { return std::log(s); }

double* address_of(const std::string& variable, std::array<double, 4>& values) {
  return &values[std::string("xyzt").find(variable)];
}

[[noreturn]] void reject_at(std::size_t column, const std::string& problem, const std::string& remedy) {
  throw FormulaError(fmt::format("column {} of the text: {}", column, problem), remedy);
}

/// The library would set a variable there.
void refuse_assignments(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool compares = i > 0 && std::string("<>!=").find(text[i - 1]) != std::string::npos;
    if (!compares && (i + 1 >= text.size() || text[i + 1] != '='))
      reject_at(i + 1, "'=' sets nothing", "to compare write ==, <, >, <= or >=");
  }
}

/// Reports what the library found, in words. Its positions count from 0; some mistakes have a position behind the
/// mistake, or none.
[[noreturn]] void reject_syntax(const mu::ParserError& error, const std::string& text, const Vocabulary& known) {
  std::string token = error.GetToken();
  while (!token.empty() && token.back() == ' ') token.pop_back();
  const std::size_t end = text.size() + 1;
  const std::size_t column = error.GetPos() < 0 ? end : std::min<std::size_t>(error.GetPos() + 1, end);
  const std::string remedy = "known are " + known.text();
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      reject_at(column, fmt::format("'{}' is not known", token), remedy);
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
      reject_at(column, fmt::format("'{}' is where an operator has to be", token),
                "a product needs a sign, 2*x; an expression has no units");
    case mu::ecUNEXPECTED_OPERATOR:
      reject_at(column, fmt::format("the operator '{}' has nothing to act on", token),
                "the operators are + - * / ^, < <= > >= == !=, && || and condition ? one : other");
    case mu::ecUNEXPECTED_EOF:
      reject_at(column, "the expression ends too early", "complete or remove the last part");
    case mu::ecMISSING_PARENS:
    case mu::ecUNEXPECTED_PARENS:
      reject_at(column, "the parentheses do not match", "each ( needs its )");
    case mu::ecTOO_MANY_PARAMS:
    case mu::ecTOO_FEW_PARAMS:
      reject_at(column,
                fmt::format("the function {} has too {} arguments", token,
                            error.GetCode() == mu::ecTOO_MANY_PARAMS ? "many" : "few"),
                remedy);
    case mu::ecUNEXPECTED_ARG_SEP:
    case mu::ecUNEXPECTED_ARG:
      reject_at(column, "a comma is outside of the arguments of a function", "decimal numbers have a point: 0.5");
    case mu::ecMISSING_ELSE_CLAUSE:
    case mu::ecMISPLACED_COLON:
    case mu::ecUNEXPECTED_CONDITIONAL:
      reject_at(column, "a condition is not complete", "write condition ? one : other");
    case mu::ecEMPTY_EXPRESSION:
      reject_at(1, "it is empty", remedy);
    default:
      reject_at(column, error.GetMsg(), remedy);
  }
}

std::string comma_separated(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

const char* const functions_of_expressions =
    "sin, cos, tan, asin, acos, atan, atan2, sinh, cosh, tanh, asinh, acosh, atanh, exp, ln and log (both of base e), "
    "log2, log10, sqrt, abs, sign, rint, min, max, sum and avg (of any number of arguments), and step(s) = (1 + "
    "tanh(s))/2";

std::string Vocabulary::text() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : constants) names.push_back(name);
  return fmt::format("{}; the constants {}; the functions {}", comma_separated(variables), comma_separated(names),
                     functions_of_expressions);
}

struct Expression::Parser {
  mu::Parser library;
  std::array<double, 4> values{};  ///< of x, y, z, t
  std::mutex turn;                 ///< of the thread that uses them
};

Expression::Expression(const std::string& text, const Vocabulary& known) : parser_(std::make_unique<Parser>()) {
  if (text.size() > longest_expression)
    reject_at(longest_expression, fmt::format("an expression has at most {} letters", longest_expression),
              "shorten it");
  refuse_assignments(text);
  mu::Parser& library = parser_->library;
  try {
    library.ClearConst();
    for (const std::string& name : known.variables) library.DefineVar(name, address_of(name, parser_->values));
    for (const auto& [name, value] : known.constants) library.DefineConst(name, value);
    library.DefineFun("step", smooth_step);
    library.DefineFun("log", natural_logarithm);
    library.SetExpr(text);
    library.Eval();
  } catch (const mu::ParserError& error) {
    reject_syntax(error, text, known);
  }
  if (library.GetNumResults() != 1)
    reject_at(text.find(',') + 1, "a comma is outside of the arguments of a function",
              "decimal numbers have a point: 0.5");
}

Expression::~Expression() = default;

double Expression::at(const std::array<double, 3>& x, double t) const {
  const std::lock_guard turn(parser_->turn);
  parser_->values = {x[0], x[1], x[2], t};
  return parser_->library.Eval();
}

bool Expression::constant() const { return parser_->library.GetUsedVar().empty(); }

}  // namespace softwet
