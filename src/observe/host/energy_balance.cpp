#include "observe/host/energy_balance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softwet {

double EnergyBalance::follow(const EnergyState& next, const EnergyRule& rule) {
  constexpr double share_of_fed = 0.25;
  const EnergyState before = std::exchange(last, next);
  moving = std::max({moving, before.kinetic, next.kinetic});
  if (!std::exchange(begun, true)) return 0;
  const double step = unfed_rise(before, next), half = 0.5 * (next.time - before.time);
  const double lost_now = half * (before.lost + next.lost);
  lost += lost_now;
  fed += half * (std::abs(before.fed) + std::abs(next.fed));
  const bool from_first = rule.floor == EnergyFloor::first;
  if (from_first) {
    rise += step + lost_now;
    if (rise <= 0) told = false;
    if (told) return 0;
  } else {
    if (step <= 0) told = false;
    rise = told ? 0 : std::max(0.0, rise + step);  // a reported rise is not reported again
  }
  if (rise <= rule.share * (moving + lost) + share_of_fed * fed + round_off_of(next)) return 0;
  told = true;
  return from_first ? rise : std::exchange(rise, 0.0);
}

}  // namespace softwet
