#include "run/host/run_memory.hpp"

#include <fmt/core.h>

#include <sstream>

namespace softwet {

void RunEntries::not_negative(const std::string& name, double& value) {
  number(name, value);
  if (restores() && value < 0) refuse(name, fmt::format("is {}", value), "a number in [0, inf)");
}

void RunEntries::positive(const std::string& name, double& value) {
  number(name, value);
  if (restores() && value <= 0) refuse(name, fmt::format("is {}", value), "a number in (0, inf)");
}

void RunEntries::flag(const std::string& name, bool& value) {
  std::int64_t number = value ? 1 : 0;
  count(name, number);
  if (number > 1) refuse(name, fmt::format("is {}", number), "0 or 1");
  value = number == 1;
}

namespace {

void visit_droplets(RunEntries& run, std::vector<DropletTrack>& droplets) {
  const std::string list = "history/droplets/";
  run.column(list + "x", droplets, [](DropletTrack& d) -> double& { return d.centre[0]; });
  run.column(list + "y", droplets, [](DropletTrack& d) -> double& { return d.centre[1]; });
  run.column(list + "on_wall", droplets, [](DropletTrack& d) -> bool& { return d.on_wall; });
  run.column(list + "merged", droplets, [](DropletTrack& d) -> bool& { return d.merged; });
}

void visit_bodies(RunEntries& run, std::vector<Body>& bodies) {
  const std::string list = "history/bodies/";
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t d = 0; d < 3; ++d)
    run.column(list + axes[d], bodies, [d](Body& b) -> double& { return b.place[d]; });
  std::vector<double> touched;
  for (const Body& b : bodies) touched.push_back(b.touched);
  run.numbers(list + "touched", touched);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!(touched[k] >= 0 && touched[k] <= all_touched) || (static_cast<unsigned>(touched[k]) & ~all_touched) != 0)
      run.refuse(list + "touched", fmt::format("has {} at entry {}", touched[k], k),
                 fmt::format("sums of bits of {} for the sides and ends that a body has reached", all_touched));
    bodies[k].touched = static_cast<unsigned>(touched[k]);
  }
  run.column(list + "seen", bodies, [](Body& b) -> bool& { return b.seen; });
  run.column(list + "on_wall", bodies, [](Body& b) -> bool& { return b.on_wall; });
  run.column(list + "left_wall", bodies, [](Body& b) -> bool& { return b.left_wall; });
  run.column(list + "gone", bodies, [](Body& b) -> bool& { return b.gone; });
}

/// A line of text each, and an array of their times.
void visit_events(RunEntries& run, std::vector<Event>& events) {
  std::string lines;
  for (const Event& event : events) lines += event.what + "\n";
  run.text("history/events/what", lines);
  if (run.restores()) {
    events.clear();
    std::istringstream stream(lines);
    for (std::string what; std::getline(stream, what);) events.push_back({0, what});
  }
  run.column("history/events/time", events, [](Event& e) -> double& { return e.time; });
}

void visit_energy(RunEntries& run, EnergyBalance& e) {
  const std::string part = "history/energy/";
  run.flag(part + "begun", e.begun);
  run.flag(part + "told", e.told);
  run.number(part + "rise", e.rise);
  run.number(part + "lost", e.lost);
  run.number(part + "fed", e.fed);
  run.not_negative(part + "moving", e.moving);
  run.number(part + "last/time", e.last.time);
  run.number(part + "last/energy", e.last.energy);
  run.number(part + "last/size", e.last.size);
  run.number(part + "last/kinetic", e.last.kinetic);
  run.number(part + "last/fed", e.last.fed);
  run.number(part + "last/lost", e.last.lost);
}

void visit_mark(RunEntries& run, const std::string& table, TableMark& mark) {
  run.count(table + "/bytes", mark.bytes);
  run.count(table + "/rows", mark.rows);
  run.count(table + "/checksum", mark.checksum);
}

}  // namespace

void visit(RunEntries& run, RunMemory& m) {
  run.not_negative("time", m.time);
  run.not_negative("previous/dt", m.previous_dt);
  run.number("state/memory_shift", m.memory_shift);
  run.positive("step_control/proposed", m.proposed_dt);
  run.count("steps/accepted", m.steps);
  run.count("steps/rejected_newton", m.rejected_newton);
  run.count("steps/rejected_error", m.rejected_error);
  run.count("history/step", m.history.step);
  run.not_negative("history/time", m.history.time);
  run.number("history/mass_start", m.history.mass_start);
  visit_droplets(run, m.history.droplets);
  visit_bodies(run, m.history.bodies);
  visit_events(run, m.history.events);
  visit_energy(run, m.history.energy);
  visit_mark(run, "files/history", m.files.history);
  visit_mark(run, "files/interface", m.files.interface);
  run.list("files/field_times", m.files.field_times);
}

}  // namespace softwet
