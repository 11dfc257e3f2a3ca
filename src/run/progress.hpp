// The line on the terminal that shows how far a run is.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "io/table_row.hpp"

namespace softwet {

/// On a terminal one line that is rewritten a few times a second; elsewhere one line about every ten seconds. Times are
/// t, on the clock of the output.
class Progress {
 public:
  enum class Voice { silent, lines, terminal };

  /// The voice that fits stderr.
  static Voice voice();

  Progress(Voice voice, double start, double end) : voice_(voice), start_(start), end_(end) {}
  ~Progress() { finish_line(); }

  /// @param row  the last one of history.csv, of which the line shows some cells
  void step(double t, long step, double dt, const TableRow& row, const std::optional<double>& seconds_left);
  /// Reports a step of a scene on its way to rest. @param change  of its fields, of their range in a unit of time
  void settle(long step, double change);
  /// A message on a line of its own, also before and after the run.
  void tell(const std::string& message);
  /// A line that belongs to the message before.
  void add(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_due();
  void show(const std::string& line);
  void finish_line();

  Voice voice_;
  double start_, end_;
  Clock::time_point last_ = Clock::now();
  bool open_line_ = false;
};

}  // namespace softwet
