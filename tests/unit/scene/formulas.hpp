// Formulas of a place and a time for tests, without a parser.
#pragma once

#include <functional>
#include <utility>

#include "case/profile.hpp"

namespace softwet::testing_tools {

class TestFormula final : public Formula {
 public:
  using Function = std::function<double(const std::array<double, 3>&, double)>;
  explicit TestFormula(Function function) : function_(std::move(function)) {}
  double at(const std::array<double, 3>& x, double t) const override { return function_(x, t); }

 private:
  Function function_;
};

inline Profile varying(TestFormula::Function function) {
  Profile profile;
  profile.text = "a test";
  profile.formula = std::make_shared<TestFormula>(std::move(function));
  return profile;
}

}  // namespace softwet::testing_tools
