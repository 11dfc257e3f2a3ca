// How long a run will still take, from the steps it has made.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace softwet {

/// What bounds the steps. error: steps grow as the state settles, up to time.dt_max. stability: the steps of explicit schemes,
/// which hardly change.
enum class StepsFollow { error, stability };

/// Steps that stay as long as the last few were need the most seconds, and steps that are as long as time.dt_max from now on
/// the fewest. Between the two lies the geometric mean of two estimates: that each doubling of the time takes as long as each
/// took so far, and that steps grow from now on with the power 3/2 of the time. A step costs as much as the second half of the
/// steps so far did. What will shorten the steps later, such as a second load, is not known.
class TimeLeft {
 public:
  /// @param end, dt_max  as in the case; all times are on the clock of the computation, which begins at 0
  TimeLeft(double end, double dt_max, long max_steps, StepsFollow follow = StepsFollow::error)
      : end_(end), dt_max_(dt_max), max_steps_(max_steps), follow_(follow) {}

  /// After an accepted step. @param step  of the whole run  @param seconds  on any clock that goes on
  void step(long step, double time, double seconds);

  /// Empty while there are too few steps to judge from.
  std::optional<double> seconds() const;

 private:
  struct Sample {
    long step;
    double time, seconds;
  };
  void remember(const Sample& sample);
  double seconds_of_a_step() const;
  /// Where each doubling of the time takes as long as each took so far.
  double as_so_far() const;

  double end_, dt_max_;
  long max_steps_;
  StepsFollow follow_;
  std::deque<Sample> recent_;
  std::vector<Sample> all_;  ///< every stride-th step, at least half of `most` of them once there are as many
  long stride_ = 1, seen_ = 0;
};

/// "a few seconds", "about 40 s", "about 3 min", "about 2 h", "about 4 days": no more figures than an estimate has.
std::string rough_duration(double seconds);

}  // namespace softwet
