// The extremes of the symbols of masses against formulas of quadratic splines, and how much stiffer ends, an axis and a
// joint are.
#include "time/masses/mass_symbols.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace softwet {
namespace {

// With the symbols m = (33 + 26 cos x + cos 2x) / 60, k = 1 - (2 cos x + cos 2x) / 3 and b = (10 sin x + sin 2x) / 12
// of quadratic splines.
TEST(MassSymbols, AreTheExtremesOfTheSymbolsOfQuadraticSplines) {
  MassSymbols lumped, corrected;
  for (int n = 1; n <= 10000; ++n) {
    const double x = M_PI * n / 10000, m = (33 + 26 * std::cos(x) + std::cos(2 * x)) / 60;
    const double k = 1 - (2 * std::cos(x) + std::cos(2 * x)) / 3, b = (10 * std::sin(x) + std::sin(2 * x)) / 12;
    const double e = 1 - m, s = 1 + e + e * e - 2 * e * e * e;
    lumped.acoustic = std::max(lumped.acoustic, std::sqrt(m) * b);
    lumped.capillary = std::max(lumped.capillary, std::sqrt(k) * b);
    lumped.viscous = std::max(lumped.viscous, k);
    corrected.acoustic = std::max(corrected.acoustic, std::sqrt(s * s * s * m) * b);
    corrected.capillary = std::max(corrected.capillary, std::sqrt(s * s * s * k) * b);
    corrected.elastic = std::max(corrected.elastic, std::sqrt(s * k));
  }
  const MassSymbols a = inside_symbols(2, MassKind::lumped), b = inside_symbols(2, MassKind::corrected);
  EXPECT_NEAR(a.acoustic, lumped.acoustic, 1e-4);
  EXPECT_NEAR(a.capillary, lumped.capillary, 1e-4);
  EXPECT_NEAR(a.viscous, lumped.viscous, 1e-4);
  EXPECT_NEAR(b.acoustic, corrected.acoustic, 1e-4);
  EXPECT_NEAR(b.capillary, corrected.capillary, 1e-4);
  EXPECT_NEAR(b.elastic, corrected.elastic, 1e-4);
}

TEST(MassSymbols, SpringsAtControlValuesMeetLumpedMasses) {
  EXPECT_NEAR(inside_symbols(2, MassKind::consistent).held, 7.5, 1e-9);  // 1 / m at x = pi
  EXPECT_EQ(end_symbols(2, MassKind::lumped).held, 1);
  double most = 0;
  for (int n = 0; n <= 10000; ++n) {
    const double e = n / 10000.0;
    most = std::max(most, 1 + e + e * e - 2 * e * e * e);
  }
  EXPECT_NEAR(end_symbols(3, MassKind::corrected).held, most, 1e-7);
  // One element of degree 2: row sums 1/3 over the smallest eigenvalue 1/30 of its mass.
  EXPECT_NEAR(end_symbols(2, MassKind::consistent, 1).held, 10, 1e-9);
}

TEST(MassSymbols, AnAxisOfSymmetryIsUpToAFifthStifferThanAnEnd) {
  for (const int degree : {2, 3})
    for (const MassKind kind : {MassKind::lumped, MassKind::corrected}) {
      const MassSymbols end = end_symbols(degree, kind),
                        axis = end_symbols(degree, kind, 10, Coordinates::axisymmetric);
      for (const auto symbol : {&MassSymbols::acoustic, &MassSymbols::capillary, &MassSymbols::viscous,
                                &MassSymbols::diffusive, &MassSymbols::elastic}) {
        EXPECT_GT(axis.*symbol, 0.99 * end.*symbol);
        EXPECT_LT(axis.*symbol, 1.25 * end.*symbol);
      }
    }
}

TEST(MassSymbols, EndsAreNotStifferThanTiesAllow) {
  for (const int degree : {2, 3})
    for (const MassKind kind : {MassKind::lumped, MassKind::corrected}) {
      const MassSymbols inside = inside_symbols(degree, kind), end = end_symbols(degree, kind);
      EXPECT_GE(end.acoustic, inside.acoustic);
      EXPECT_LT(end.acoustic, (degree == 2 ? 1.2 : 1.5) * inside.acoustic);
      EXPECT_LT(end.capillary, (degree == 2 ? 1.5 : 3.2) * inside.capillary);
      EXPECT_LT(end.elastic, (degree == 2 ? 1.25 : 2) * inside.elastic);
    }
}

TEST(MassSymbols, AJointIsLittleStifferThanAnEnd) {
  for (const int degree : {2, 3})
    for (const MassKind kind : {MassKind::lumped, MassKind::corrected}) {
      const MassSymbols end = end_symbols(degree, kind);
      for (const JoinedElements elements : {JoinedElements{10, 10}, {1, 10}, {10, 1}, {1, 1}, {2, 3}}) {
        const MassSymbols joint = with_joint(end, degree, kind, elements);
        EXPECT_GE(joint.elastic, end.elastic);
        const double most =
            std::min(elements.below, elements.above) > 1 ? 1.3 : 1.5;  // a row that has an end, too, is stiffer
        EXPECT_LT(joint.elastic, most * end.elastic) << degree << ": " << elements.below << ", " << elements.above;
        EXPECT_EQ(joint.acoustic, end.acoustic);
      }
      EXPECT_EQ(with_joint(end, degree, kind, {}).elastic, end.elastic);
    }
}

}  // namespace
}  // namespace softwet
