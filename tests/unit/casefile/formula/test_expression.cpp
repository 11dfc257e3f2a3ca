// Expressions: their values, and messages about wrong ones.
#include "casefile/formula/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <future>

namespace softwet {
namespace {

const Vocabulary two_axes{{"x", "y"}, {{"pi", std::acos(-1.0)}, {"H", 0.125}}};

double value(const std::string& text, double x = 0.25, double y = -2) {
  return Expression(text, two_axes).at({x, y, 0}, 0);
}

/// The problem and the remedy of a wrong expression.
std::string told(const std::string& text) {
  try {
    const Expression expression(text, two_axes);
  } catch (const FormulaError& error) {
    return error.what() + ("; " + error.remedy);
  }
  return "(accepted)";
}

TEST(Expression, HasVariablesConstantsAndFunctions) {
  EXPECT_DOUBLE_EQ(value("1 + 2*x - y^2"), -2.5);
  EXPECT_DOUBLE_EQ(value("-x^2"), -0.0625);
  EXPECT_DOUBLE_EQ(value("cos(2*pi*x) + H"), 0.125);
  EXPECT_DOUBLE_EQ(value("x > 0.2 ? exp(y) : 7"), std::exp(-2.0));
  EXPECT_DOUBLE_EQ(value("min(x, y) + max(x, 1) + abs(y) + sqrt(4) + tanh(0)"), 3);
  EXPECT_DOUBLE_EQ(value("step((x - 0.25)/0.01)"), 0.5);
  EXPECT_DOUBLE_EQ(value("step(x/0.1)"), 0.5 + 0.5 * std::tanh(2.5));
  EXPECT_DOUBLE_EQ(value("ln(exp(3)) + log10(100)"), 5);
  EXPECT_DOUBLE_EQ(value("log(exp(3)) + 10*log2(8)"), 33);
  EXPECT_DOUBLE_EQ(value("sum(x, 1, 2) + 10*avg(1, 2, 6)"), 33.25);
  EXPECT_DOUBLE_EQ(value("asinh(sinh(2)) + acosh(cosh(2)) + atanh(tanh(0.5))"), 4.5);
}

TEST(Expression, KnowsWhetherItVaries) {
  EXPECT_TRUE(Expression("3*H + pi", two_axes).constant());
  EXPECT_FALSE(Expression("3*H + 0*x", two_axes).constant());
}

TEST(Expression, OfTime) {
  const Expression wave("sin(2*pi*t/5)", {{"t"}, two_axes.constants});
  EXPECT_DOUBLE_EQ(wave.at({7, 7, 7}, 1.25), 1);
}

TEST(Expression, NamesTheColumnOfAMistake) {
  struct Wrong {
    std::string text, column, words;
  };
  for (const Wrong& wrong : std::vector<Wrong>{{"1 + 2*foo", "column 7", "'foo' is not known; known are x, y"},
                                               {"1 + z", "column 5", "'z' is not known"},
                                               {"x*t", "column 3", "'t' is not known"},
                                               {"2x", "column 2", "a product needs a sign"},
                                               {"75 degrees", "column 4", "'degrees' is not known"},
                                               {"1 + * 2", "column 5", "the operator '*'"},
                                               {"1 +", "column 4", "ends too early"},
                                               {"(1 + x", "column", "parentheses"},
                                               {"1 + x)", "column 6", "parentheses"},
                                               {"sin(1, 2)", "column", "the function sin has too many arguments"},
                                               {"0,5*x", "column 2", "decimal numbers have a point"},
                                               {"max(x, 0,5), 1", "column", "decimal numbers have a point"},
                                               {"x = 3", "column 3", "'=' sets nothing"},
                                               {"x > 0 ? 1", "column", "condition ? one : other"},
                                               {"", "column 1", "it is empty"},
                                               {"\"x\"", "column", "known are x, y"}}) {
    const std::string message = told(wrong.text);
    EXPECT_NE(message.find(wrong.column), std::string::npos) << wrong.text << "\n" << message;
    EXPECT_NE(message.find(wrong.words), std::string::npos) << wrong.text << "\n" << message;
  }
  EXPECT_EQ(told("x >= 0 && x <= 1 || x == 2 || x != 3"), "(accepted)");
  EXPECT_NE(told(std::string(5000, '1')).find("at most"), std::string::npos);
}

TEST(Expression, TwoOfThemDoNotShareVariables) {
  const Expression one("x", two_axes), other("2*x", two_axes);
  EXPECT_EQ(one.at({3, 0, 0}, 0), 3);
  EXPECT_EQ(other.at({5, 0, 0}, 0), 10);
  EXPECT_EQ(one.at({4, 0, 0}, 0), 4);
}

// The computation and a thread that writes fields evaluate the same stiffness.
TEST(Expression, ThreadsTakeTurns) {
  const Expression formula("x*x + y", two_axes);
  const auto wrong = [&formula](double x, double y) {
    int found = 0;
    for (int i = 0; i < 3000000; ++i) found += formula.at({x, y, 0}, 0) != x * x + y;
    return found;
  };
  std::future<int> beside = std::async(std::launch::async, wrong, 2.0, 1.0);
  EXPECT_EQ(wrong(5.0, -3.0), 0);
  EXPECT_EQ(beside.get(), 0);
}

}  // namespace
}  // namespace softwet
