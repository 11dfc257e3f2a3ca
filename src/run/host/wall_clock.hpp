// When a run has to stop so that it ends within the time that it has on the clock on the wall.
#pragma once

#include <algorithm>

namespace softwet {

/// All times are in seconds since the start of the process.
class WallClock {
 public:
  /// @param hours  that the run has; 0: no limit
  explicit WallClock(double hours) : limit_(3600 * hours) {}

  /// A step, with the rows and files that followed it, has taken so long.
  void step(double seconds) { longest_step_ = std::max(longest_step_, seconds); }
  /// A checkpoint has taken so long to write.
  void save(double seconds) { longest_save_ = std::max(longest_save_, seconds); }
  /// A file that was written beside the steps has taken so long. The last checkpoint waits for such a file.
  void file(double seconds) { longest_file_ = std::max(longest_file_, seconds); }

  /// Whether another step, a file and the last checkpoint may no longer fit: each is given twice its longest time so
  /// far, and a hundredth of the whole time is left for what a launcher does before and after.
  bool over(double now) const {
    return limit_ > 0 && now + 2 * (longest_step_ + longest_file_ + longest_save_) >= 0.99 * limit_;
  }

 private:
  double limit_, longest_step_ = 0, longest_file_ = 0, longest_save_ = 0;
};

}  // namespace softwet
