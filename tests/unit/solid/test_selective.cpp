// The two parts of a nearly incompressible solid.
#include <gtest/gtest.h>

#include "kernels/solid/isotropic.hpp"

namespace softwet {
namespace {

TEST(SelectiveParts, AddUpToTheSolid) {
  for (const double poisson : {-0.3, 0.0, 0.4, 0.45, 0.49, 0.4999}) {
    const LameParameters whole = LameParameters::from(2.7, poisson);
    const SelectiveParts parts = SelectiveParts::of(whole);
    EXPECT_NEAR(parts.everywhere.lambda + parts.of_means.lambda, whole.lambda, 1e-15 * std::abs(whole.lambda));
    EXPECT_EQ(parts.everywhere.shear_modulus, whole.shear_modulus);
    EXPECT_EQ(parts.of_means.shear_modulus, 0);
    EXPECT_GE(parts.of_means.lambda, 0);
  }
}

TEST(SelectiveParts, HaveAtAllPointsWhatTheirPoissonRatioHas) {
  const LameParameters bound = LameParameters::from(3 * (1 + SelectiveParts::poisson), SelectiveParts::poisson);
  const LameParameters stiff = LameParameters::from(3 * (1 + 0.4999), 0.4999);  // of the same shear modulus
  EXPECT_NEAR(SelectiveParts::of(stiff).everywhere.lambda, bound.lambda, 1e-12 * bound.lambda);
  const LameParameters below = LameParameters::from(1, 0.399);
  EXPECT_EQ(SelectiveParts::of(below).everywhere.lambda, below.lambda);
  EXPECT_EQ(SelectiveParts::of(below).of_means.lambda, 0);
}

}  // namespace
}  // namespace softwet
