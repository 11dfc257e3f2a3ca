// How a run stands: the part of run.json that somebody watches, and the sentences about what happened on the way.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/field_file.hpp"
#include "io/run_record.hpp"
#include "observe/host/bodies.hpp"

namespace softwet {

/// Why a search for a state of rest ended that has found it.
inline constexpr const char* reason_of_rest = "at rest";

struct RunStatus {
  std::string reason;                  ///< "running", or why it ended
  double time = 0;                     ///< t, on the clock of the output
  double started = 0;                  ///< when the first process of the run began, seconds since 1970
  std::optional<double> seconds_left;  ///< an estimate, while it runs
  std::vector<Event> events;
};

/// Sets started, updated (now), state, seconds_left, events and stop. The state is running, done (the end is reached),
/// stopped (before the end, and to be resumed) or failed.
void add_status(RunRecord&, const RunStatus&);

/// Whose a field file is: the case, and the program that wrote it.
FieldOrigin origin_of(const Case&);

/// "2026-01-31T23:59:59Z"
std::string utc_text(double seconds_since_1970);

/// "at t = 3.2 the droplet vanished"
std::string sentence(const Event&);

/// The events for the closing line, "; at t = ..." each, the first three of many; empty without events.
std::string summary(const std::vector<Event>&);

/// How far a start at rest has moved what is there: "; on the way the droplet moved by 0.012", of many the farthest
/// alone. Empty where nothing is left.
std::string moves_text(const std::vector<std::string>& names, const std::vector<std::optional<double>>& moved);

}  // namespace softwet
