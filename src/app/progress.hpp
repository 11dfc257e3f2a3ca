// The line on the terminal that tells how far a run is.
#pragma once

#include <chrono>
#include <deque>
#include <string>

#include "observe/scalars.hpp"

namespace softwet {

/// On a terminal one line that is rewritten a few times a second; elsewhere one line about every ten seconds.
class Progress {
 public:
  enum class Voice { silent, lines, terminal };

  /// The voice that fits stderr, silent when the user wants quiet.
  static Voice voice(bool quiet);

  /// @param start, end  on the clock of the output
  Progress(Voice voice, double start, double end);
  ~Progress() { finish_line(); }

  void step(double t, long step, const StepReport& report, const Headline& headline);
  /// A message on a line of its own, also before and after the run.
  void tell(const std::string& message);

 private:
  using Clock = std::chrono::steady_clock;
  std::string time_left(double t);
  void finish_line();

  Voice voice_;
  double start_, end_;
  Clock::time_point begin_, last_;
  std::deque<std::pair<Clock::time_point, double>> recent_;  ///< wall time and t of the last twenty seconds
  bool open_line_ = false;
};

}  // namespace softwet
