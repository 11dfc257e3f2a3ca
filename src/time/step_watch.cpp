#include "time/step_watch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace softwet {

void StepWatch::begin(const StepSigns& first) {
  memory_ = {};
  memory_.begun = true;
  memory_.last = first;
}

bool StepWatch::grows(const StepSigns& next) const {
  constexpr double part = 0.1, part_of_kinetic = 1e-4, jump = 2, faster = 1.2;
  constexpr double part_of_change = 0.5;  // of the kinetic energy: that of consistent masses; steps have lumped ones
  const EnergyState &a = memory_.last.energy, &b = next.energy;
  const double dt = b.time - a.time;
  const double error = part * dt * (a.lost + std::abs(a.fed)) + part_of_kinetic * a.kinetic +
                       part_of_change * std::abs(b.kinetic - a.kinetic) + round_off_of(b);
  const bool rises = energy_law_ && unfed_rise(a, b) > error;
  const bool dissipates =
      a.lost > 0 && b.lost > a.lost * std::max(jump, faster * memory_.jump) && dt * b.lost > round_off_of(b);
  return rises || dissipates;
}

bool StepWatch::accept(const StepSigns& next) {
  constexpr double much = 1.7, unknown = 1e100;
  const double before = memory_.last.energy.lost, now = next.energy.lost;
  memory_.jump = now < unknown * before ? now / before : unknown;
  memory_.last = next;
  bool met = false;
  for (std::size_t place = 1; place < next.density.size(); ++place)
    met = met || next.density[place] > much * std::max(wet_, memory_.searched[place]);
  return met;
}

void StepWatch::visit_memory(StepMemory& memory) {
  EnergyState& e = memory_.last.energy;
  memory.flag("watch/begun", memory_.begun);
  memory.number("watch/jump", memory_.jump);
  memory.number("watch/time", e.time);
  memory.number("watch/energy", e.energy);
  memory.number("watch/size", e.size);
  memory.number("watch/kinetic", e.kinetic);
  memory.number("watch/fed", e.fed);
  memory.number("watch/lost", e.lost);
  for (std::size_t place = 0; place < memory_.searched.size(); ++place) {
    const std::string end = std::string("_") + char('0' + place);
    memory.number("watch/density" + end, memory_.last.density[place]);
    memory.number("watch/searched" + end, memory_.searched[place]);
  }
}

}  // namespace softwet
