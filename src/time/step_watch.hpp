// What tells, at every step of an explicit scheme, that its largest stable step is no longer the one that was found.
#pragma once

#include <array>

#include "field/step_memory.hpp"
#include "time/energy_balance.hpp"

namespace softwet {

/// What is seen of a state after a step, for little cost.
struct StepSigns {
  EnergyState energy;
  /// Largest density where the domain ends along axes, a bit for each axis: on its sides, edges and corners. [0]: inside
  std::array<double, 8> density{};
};

/// The limit falls where liquid meets a side: the last functions of an axis are stiffer than those inside, and the stiffer
/// the denser the fluid is. And a step beyond the limit shows: a mode of short waves grows, which are what the dissipation
/// sees first; then the energy rises. Plain numbers.   Tested: tests/unit/time/test_step_watch.cpp
class StepWatch {
 public:
  /// What it remembers: numbers of a checkpoint.
  struct Memory {
    bool begun = false;
    StepSigns last;                    ///< of the state that was accepted last
    double jump = 1e100;               ///< its dissipation over that of the state before
    std::array<double, 8> searched{};  ///< densities at the last search
  };

  /// @param wet         density at a side from which on it may limit the step
  /// @param energy_law  nothing but what is fed in lets the energy rise
  StepWatch(double wet, bool energy_law) : wet_(wet), energy_law_(energy_law) {}

  bool begun() const { return memory_.begun; }
  /// Takes the state that a run begins with.
  void begin(const StepSigns&);
  /// Whether a step grows as steps beyond the limit do: the dissipation by more than 2 times (1.5 was seen in steps that
  /// are stable, and 2 to 140 in others) and faster than in the step before, as it is not where motion begins from rest; or the
  /// energy, where the equations have a law for it.
  bool grows(const StepSigns& next) const;
  /// Takes an accepted step. @return whether the density at the sides has risen so far since the search that the limit may
  /// have fallen below the step
  bool accept(const StepSigns& next);
  /// The limit was found at the last state.
  void searched() { memory_.searched = memory_.last.density; }

  /// What the judgement of the next steps goes on from.
  void visit_memory(StepMemory&);

 private:
  double wet_;
  bool energy_law_;
  Memory memory_;
};

}  // namespace softwet
