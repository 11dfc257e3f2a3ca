// Eigenvalues from the columns of Arnoldi's method, against matrices whose eigenvalues are known.
#include "solver/krylov/ritz.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

// A rotation by 30 degrees that also halves lengths, and a mode of its own: the space is complete after three columns.
TEST(Ritz, FindsAllEigenvaluesOfACompleteSpace) {
  const double c = 0.5 * std::cos(M_PI / 6), s = 0.5 * std::sin(M_PI / 6);
  std::vector<RitzValue> found = ritz_values({{c, s}, {-s, c, 0}, {0.3, 0.2, -0.7, 0}});
  ASSERT_EQ(found.size(), 3u);
  std::sort(found.begin(), found.end(), [](const RitzValue& a, const RitzValue& b) {
    return std::pair(a.value.real(), a.value.imag()) < std::pair(b.value.real(), b.value.imag());
  });
  EXPECT_NEAR(std::abs(found[0].value - std::complex<double>(-0.7, 0)), 0, 1e-14);
  EXPECT_NEAR(std::abs(found[1].value - std::complex<double>(c, -s)), 0, 1e-14);
  EXPECT_NEAR(std::abs(found[2].value - std::complex<double>(c, s)), 0, 1e-14);
  for (const RitzValue& r : found) EXPECT_EQ(r.error, 0.0);
}

// With one direction the value is Rayleigh's quotient, and the error is the rest A v - value v.
TEST(Ritz, EstimatesTheErrorOfAnIncompleteSpace) {
  const std::vector<RitzValue> found = ritz_values({{2.0, 0.25}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].value, std::complex<double>(2.0));
  EXPECT_EQ(found[0].error, 0.25);
}

}  // namespace
}  // namespace softwet
