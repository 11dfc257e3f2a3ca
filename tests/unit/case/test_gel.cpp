// Branches and a viscosity in place of a power law.
#include "case/gel.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

double error_of(double exponent) {
  const PowerLaw law{exponent, 0.3, {-2, 2}};
  return GelFit::of(2.5, law).error(2.5, law);
}

// The numbers of an independent program (tests/oracle: 1.5 branches for a decade, one decade beyond either end).
TEST(GelFit, IsNearThePowerLaw) {
  EXPECT_NEAR(error_of(0.4), 0.031, 0.0006);
  EXPECT_NEAR(error_of(0.55), 0.008, 0.0006);
  EXPECT_NEAR(error_of(0.7), 0.006, 0.0006);
}

TEST(GelFit, HasBranchesForEachDecadeAndOneMoreOnBothSides) {
  const GelFit fit = GelFit::of(2.5, {0.5, 0.3, {-2, 2}});
  ASSERT_EQ(fit.branches.size(), 10);
  EXPECT_NEAR(fit.branches.front().time, 0.3e3, 1e-9);
  EXPECT_NEAR(fit.branches.back().time, 0.3e-3, 1e-15);
  EXPECT_EQ(GelFit::of(2.5, {0.5, 0.3, {-1, 0}}).branches.size(), 6);
  EXPECT_EQ(GelFit::of(2.5, {0.5, 0.3, {-4, 4}}).branches.size(), most_branches);
  EXPECT_TRUE(GelFit::of(2.5, {}).branches.empty());
  EXPECT_EQ(GelFit::of(2.5, {}).viscosity, 0);
}

// G belongs to the solid at rest; a gel combined with given branches has both.
TEST(GelFit, GoesBesideWhatIsGiven) {
  Substrate s;
  s.density = 2;
  s.young = 1.5;
  s.poisson = 0.25;
  s.viscosity = 0.1;
  s.branches = {{0.26, 1}};
  EXPECT_EQ(all_branches(s).size(), 1);
  EXPECT_EQ(shear_viscosity(s), 0.1);
  s.gel = {0.5, 0.3, {-2, 2}};
  const GelFit fit = GelFit::of(1.2, s.gel);
  const std::vector<Branch> all = all_branches(s);
  ASSERT_EQ(all.size(), 11);
  EXPECT_EQ(all[0].modulus, 0.26);
  EXPECT_DOUBLE_EQ(all[4].modulus, fit.branches[3].modulus);
  EXPECT_DOUBLE_EQ(shear_viscosity(s), 0.1 + fit.viscosity);
}

// At w time = 10 the modulus is |1 + sqrt(10 i)| = 3.9103 times the modulus at rest: without branches 1 - 1/.. of it is
// missing.
TEST(GelFit, KnowsWhatIsMissing) {
  const PowerLaw law{0.5, 1, {-1, 1}};
  const double real = 1 + std::sqrt(5.0), imaginary = std::sqrt(5.0);
  const double square = real * real + imaginary * imaginary;
  EXPECT_NEAR(GelFit{}.error(1, law), std::hypot(real / square - 1, imaginary / square), 1e-12);
}

}  // namespace
}  // namespace softwet
