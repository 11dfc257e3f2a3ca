// When something that is repeated has to be done again.
#pragma once

namespace softwet {

/// All times are in seconds since the start of the process.
class Rhythm {
 public:
  /// @param first  from the start to the first time  @param pause  from then on, from one time to the next
  Rhythm(double first, double pause) : next_(first), pause_(pause) {}

  /// Whether its time has come; once it has, the next pause begins.
  bool due(double now) {
    if (now < next_) return false;
    next_ = now + pause_;
    return true;
  }

 private:
  double next_, pause_;
};

}  // namespace softwet
