#include "run/host/run_status.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <softwet_version.hpp>

namespace softwet {
namespace {

std::string state_of(const std::string& reason) {
  if (reason == "running") return "running";
  if (reason == "end reached" || reason == reason_of_rest) return "done";
  return reason.rfind("failed", 0) == 0 ? "failed" : "stopped";
}

RecordValue list_of(const std::vector<Event>& events) {
  RecordValue list(RecordValue::List{});
  for (const Event& event : events) {
    RecordValue entry;
    entry["t"] = event.time;
    entry["what"] = event.what;
    list.append(entry);
  }
  return list;
}

}  // namespace

std::string utc_text(double seconds_since_1970) {
  const auto time = static_cast<std::time_t>(seconds_since_1970);
  std::tm parts{};
  char text[32] = "";
  if (gmtime_r(&time, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

FieldOrigin origin_of(const Case& c) { return {c.name, version, commit}; }

void add_status(RunRecord& run, const RunStatus& status) {
  const std::string state = state_of(status.reason);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  run["started"] = utc_text(status.started);
  run["updated"] = utc_text(std::chrono::duration<double>(now).count());
  run["state"] = state;
  run["seconds_left"] = state == "running" ? status.seconds_left.value_or(NAN) : NAN;  // NAN is written as null
  run["events"] = list_of(status.events);
  run["stop"]["reason"] = status.reason;
  run["stop"]["t"] = status.time;
}

std::string sentence(const Event& event) { return fmt::format("at t = {:.6g} {}", event.time, event.what); }

std::string summary(const std::vector<Event>& events) {
  constexpr std::size_t shown = 3;
  std::string text;
  for (std::size_t i = 0; i < events.size() && i < shown; ++i) text += "; " + sentence(events[i]);
  if (events.size() > shown) text += fmt::format("; and {} more events, listed in run.json", events.size() - shown);
  return text;
}

std::string moves_text(const std::vector<std::string>& names, const std::vector<std::optional<double>>& moved) {
  constexpr std::size_t shown = 4;
  std::vector<std::size_t> there;
  for (std::size_t k = 0; k < moved.size(); ++k)
    if (moved[k]) there.push_back(k);
  if (there.empty()) return "";
  if (there.size() > shown) {
    const std::size_t k = *std::max_element(there.begin(), there.end(),
                                            [&](std::size_t a, std::size_t b) { return *moved[a] < *moved[b]; });
    return fmt::format("; on the way {} moved farthest, by {:.2g} (run.json has all: start.moved)", names[k],
                       *moved[k]);
  }
  std::string text;
  for (std::size_t k : there)
    text += fmt::format("{}{} moved by {:.2g}", text.empty() ? "" : ", ", names[k], *moved[k]);
  return "; on the way " + text;
}

}  // namespace softwet
