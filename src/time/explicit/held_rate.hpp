// The rate that the steps of kick_drift follow in a solid: the rate of their bound, without its swings.
#pragma once

#include <algorithm>

#include "field/step_memory.hpp"

namespace softwet {

/// Steps of one length keep an energy that is near the true one, and so do steps whose length changes much more slowly
/// than waves swing. A length that swings with the waves feeds them without end (parametric resonance), however little
/// it swings. So the rate rises at once, as stability asks, and falls late and slowly: to the largest one of the last
/// `window` steps, where this is less than `enough` of it, by `fall` of it in a step.
/// All members are numbers of a checkpoint.   Tested: tests/unit/time/explicit/test_held_rate.cpp
class HeldRate {
 public:
  static constexpr int window = 100;
  static constexpr double enough = 0.8, fall = 0.01;

  double value() const { return value_; }

  /// Goes on by a step to a state whose bound has this rate.
  void follow(double rate) {
    recent_ = std::max(recent_, rate);
    if (rate >= aim_) {
      set_aim(rate);
    } else if (++steps_ >= window) {
      set_aim(recent_ < enough * aim_ ? recent_ : aim_);
    }
    value_ = std::max(aim_, (1 - fall) * value_);
  }

  void visit_memory(StepMemory& memory) {
    memory.number("bound/held", value_);
    memory.number("bound/held_aim", aim_);
    memory.number("bound/held_recent", recent_);
    memory.count("bound/held_steps", steps_);
  }

 private:
  void set_aim(double rate) {
    aim_ = rate;
    recent_ = 0;
    steps_ = 0;
  }

  double value_ = 0;
  double aim_ = 0;     ///< what it falls to
  double recent_ = 0;  ///< largest rate since it was set
  int steps_ = 0;      ///< since then
};

}  // namespace softwet
