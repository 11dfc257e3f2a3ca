// The spring of a needle: force against the derivative of the energy, and the power of the place against both.
#include "kernels/solid/spring.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

constexpr Spring spring{7.5};
constexpr double place = 0.3, displacement = -0.45;

TEST(Spring, ForceIsMinusTheDerivativeOfTheEnergy) {
  const Dual<double> gap = place - Dual<double>(displacement, 1.0);
  EXPECT_DOUBLE_EQ(spring.force(place - displacement), -spring.energy(gap).tangent);
  EXPECT_DOUBLE_EQ(spring.force(gap).tangent, -7.5);
  EXPECT_DOUBLE_EQ(spring.energy(place - displacement), 0.5 * 7.5 * 0.75 * 0.75);
}

TEST(Spring, GainsWhatThePlaceGivesAndTheSolidDoesNotTake) {
  constexpr double of_place = 0.7, of_solid = -1.1;
  const Dual<double> gap = Dual<double>(place, of_place) - Dual<double>(displacement, of_solid);
  const double force = spring.force(gap.value);
  EXPECT_DOUBLE_EQ(spring.energy(gap).tangent, force * of_place - force * of_solid);
}

}  // namespace
}  // namespace softwet
