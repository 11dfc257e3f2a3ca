// How long a run will still take, from the steps it has made.
#pragma once

#include <deque>
#include <optional>
#include <string>

namespace softwet {

/// Steps are short after the start and grow as the state settles, roughly in proportion to the time computed so far, up
/// to time.dt_max. With dt = (dt now) time / (time now), the steps that are left are those up to dt_max,
/// (time now / dt now) ln(time at dt_max / time now), and those of the size dt_max behind it. Each takes as long as the
/// last few did. What will shorten the steps later, such as a second load, is not known.
class TimeLeft {
 public:
  /// @param end, dt_max  as in the case; all times are on the clock of the computation, which begins at 0
  TimeLeft(double end, double dt_max, long max_steps) : end_(end), dt_max_(dt_max), max_steps_(max_steps) {}

  /// After an accepted step. @param step  of the whole run  @param seconds  on any clock that goes on
  void step(long step, double time, double seconds);

  /// Empty while there are too few steps to judge from.
  std::optional<double> seconds() const;

 private:
  struct Sample {
    long step;
    double time, seconds;
  };
  double end_, dt_max_;
  long max_steps_;
  std::deque<Sample> recent_;
};

/// "a few seconds", "about 40 s", "about 3 min", "about 2 h", "about 4 days": no more figures than an estimate has.
std::string rough_duration(double seconds);

}  // namespace softwet
