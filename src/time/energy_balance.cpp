#include "time/energy_balance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softwet {

double EnergyBalance::follow(const EnergyState& next, double share) {
  constexpr double share_of_fed = 0.25;
  const EnergyState before = std::exchange(last, next);
  moving = std::max({moving, before.kinetic, next.kinetic});
  if (!std::exchange(begun, true)) return 0;
  const double step = unfed_rise(before, next), half = 0.5 * (next.time - before.time);
  lost += half * (before.lost + next.lost);
  fed += half * (std::abs(before.fed) + std::abs(next.fed));
  if (step <= 0) told = false;
  rise = told ? 0 : std::max(0.0, rise + step);  // what was told is not told again
  if (rise <= share * (moving + lost) + share_of_fed * fed + round_off_of(next)) return 0;
  told = true;
  return std::exchange(rise, 0.0);
}

}  // namespace softwet
