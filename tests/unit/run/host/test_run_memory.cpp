// What a run remembers comes back from its checkpoint as it was, or is refused with the name of what no run writes.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>

#include "casefile/case_file.hpp"
#include "run/host/checkpoint_entries.hpp"
#include "run/host/fingerprint.hpp"
#include "unit/casefile/pull.hpp"
#include "unit/io/expect_error.hpp"
#include "unit/io/scratch_folder.hpp"

namespace softwet {
namespace {

using testing_tools::pull;
using testing_tools::pull_text;

/// Values that are written in place of those that are visited.
struct Changes {
  std::map<std::string, double> numbers;
  std::map<std::string, std::int64_t> counts;
  std::map<std::string, std::vector<double>> arrays;
};

/// Writes the visited entries, with changes, and keeps the names.
class ChangedEntries final : public RunEntries {
 public:
  ChangedEntries(CheckpointWriter& file, const Changes& changes) : file_(file), changes_(changes) {}

  std::vector<std::string> numbers_visited, counts_visited, arrays_visited;

  bool restores() const override { return false; }
  void number(const std::string& name, double& value) override {
    numbers_visited.push_back(name);
    change(changes_.numbers, name, [&](double bad) { value = bad; });
    file_.number(name, value);
  }
  using RunEntries::count;
  void count(const std::string& name, std::int64_t& value) override {
    counts_visited.push_back(name);
    std::int64_t written = value;
    change(changes_.counts, name, [&](std::int64_t bad) { written = bad; });
    file_.count(name, written);
  }
  void text(const std::string& name, std::string& value) override { file_.text(name, value); }
  void numbers(const std::string& name, std::vector<double>& values) override {
    arrays_visited.push_back(name);
    std::vector<double> written = values;
    change(changes_.arrays, name, [&](const std::vector<double>& bad) { written = bad; });
    file_.numbers(name, written);
  }
  void list(const std::string& name, std::vector<double>& values) override { file_.list(name, values); }
  [[noreturn]] void refuse(const std::string& name, const std::string& found,
                           const std::string& needed) const override {
    file_.refuse(name, found, needed);
  }

 private:
  template <class Value, class Use>
  static void change(const std::map<std::string, Value>& changes, const std::string& name, Use use) {
    if (const auto found = changes.find(name); found != changes.end()) use(found->second);
  }

  EntriesToFile file_;
  const Changes& changes_;
};

/// No two values are equal.
RunMemory some_run() {
  RunMemory run{2.5, 0.5, 0.25, 7, 1, 2, -0.03125, {}, {}};
  run.history.step = 6;
  run.history.time = 2;
  run.history.mass_start = 0.1;
  run.history.droplets = {{{0.5, 0.375}, true, false}};
  run.history.bodies = {{{0.5, 0.25, 0.125}, 6, true, true, false, true}};
  run.history.events = {{-2, "the droplet reached the left side"}, {3.5, "the droplet vanished"}};
  run.history.energy = {true, false, {11, 12, 13, 14, 15, 16}, -17, 18, 19, 20};
  run.files = {{1234, 56, 0xfedcba98u}, {20, 0, 1}, {-2, 0.5}};
  return run;
}

ChangedEntries write(const std::string& path, const Changes& changes, RunMemory run = some_run()) {
  CheckpointWriter file(path);
  ChangedEntries entries(file, changes);
  visit(entries, run);
  file.value("case", fingerprint(pull()));
  file.commit();
  return entries;
}

RunMemory read(const std::string& path, std::size_t bodies = 1) {
  RunMemory run;
  run.history.droplets.resize(bodies);
  run.history.bodies.resize(bodies);
  EntriesFromFile file(path);
  file.require_case(pull());
  visit(file, run);
  return run;
}

TEST(RunMemory, ComesBackAsItWas) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write(path, {});
  const RunMemory run = read(path), was = some_run();
  EXPECT_EQ(run.time, was.time);
  EXPECT_EQ(run.previous_dt, was.previous_dt);
  EXPECT_EQ(run.proposed_dt, was.proposed_dt);
  EXPECT_EQ(run.steps, was.steps);
  EXPECT_EQ(run.memory_shift, was.memory_shift);
  EXPECT_EQ(run.rejected_newton, was.rejected_newton);
  EXPECT_EQ(run.rejected_error, was.rejected_error);
  EXPECT_EQ(run.history.step, was.history.step);
  EXPECT_EQ(run.history.time, was.history.time);
  EXPECT_EQ(run.history.mass_start, was.history.mass_start);
  EXPECT_EQ(run.files.history, was.files.history);
  EXPECT_EQ(run.files.interface, was.files.interface);
  EXPECT_EQ(run.files.field_times, was.files.field_times);
}

TEST(RunMemory, KnowsWhatBecameOfTheDroplets) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write(path, {});
  const HistoryMemory history = read(path).history;
  EXPECT_EQ(history.droplets[0].centre, (Place{0.5, 0.375}));
  EXPECT_TRUE(history.droplets[0].on_wall && !history.droplets[0].merged);
  const Body& body = history.bodies[0];
  EXPECT_EQ(body.place, (std::array<double, 3>{0.5, 0.25, 0.125}));
  EXPECT_EQ(body.touched, 6U);
  EXPECT_TRUE(body.seen && body.on_wall && !body.left_wall && body.gone);
  ASSERT_EQ(history.events.size(), 2U);
  EXPECT_EQ(history.events[0].time, -2);
  EXPECT_EQ(history.events[1].what, "the droplet vanished");
  const EnergyBalance& e = history.energy;
  EXPECT_TRUE(e.begun && !e.told);
  EXPECT_EQ((std::vector{e.last.time, e.last.energy, e.last.size, e.last.kinetic, e.last.fed, e.last.lost}),
            (std::vector<double>{11, 12, 13, 14, 15, 16}));
  EXPECT_EQ((std::vector{e.rise, e.lost, e.fed, e.moving}), (std::vector<double>{-17, 18, 19, 20}));
}

TEST(RunMemory, OfNoDropletsAndNoEventsComesBackToo) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  RunMemory empty;
  empty.proposed_dt = 1;
  write(path, {}, empty);
  const RunMemory run = read(path, 0);
  EXPECT_TRUE(run.history.bodies.empty() && run.history.events.empty() && run.files.field_times.empty());
}

void expect_refused(const std::string& name, const Changes& changes) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write(path, changes);
  expect_error(Exit::invalid_input, {path, "'" + name + "'", "--resume"}, [&] { read(path); });
}

TEST(RunMemory, RefusesNumbersThatAreNone) {
  const ScratchFolder folder;
  const ChangedEntries usual = write(folder / "checkpoint.h5", {});
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(usual.numbers_visited.size(), 16U);
  EXPECT_EQ(usual.arrays_visited.size(), 13U);
  for (const std::string& name : usual.numbers_visited)
    for (const double bad : {nan, inf, -inf}) expect_refused(name, {{{name, bad}}, {}, {}});
  for (const std::string& name : usual.arrays_visited) {
    const std::size_t entries = name == "history/events/time" ? 2 : 1;
    for (const double bad : {nan, -inf}) expect_refused(name, {{}, {}, {{name, std::vector<double>(entries, bad)}}});
  }
}

TEST(RunMemory, RefusesTimesStepsAndCountsBelowZero) {
  for (const std::string name :
       {"time", "previous/dt", "step_control/proposed", "history/time", "history/energy/moving"})
    expect_refused(name, {{{name, -1e-3}}, {}, {}});
  expect_refused("step_control/proposed", {{{"step_control/proposed", 0.0}}, {}, {}});
  const ScratchFolder folder;
  const ChangedEntries usual = write(folder / "checkpoint.h5", {});
  EXPECT_EQ(usual.counts_visited.size(), 12U);
  for (const std::string& name : usual.counts_visited) expect_refused(name, {{}, {{name, -1}}, {}});
  expect_refused("files/history/checksum", {{}, {{"files/history/checksum", std::int64_t{1} << 40}}, {}});
  expect_refused("history/energy/begun", {{}, {{"history/energy/begun", 2}}, {}});
}

TEST(RunMemory, RefusesOtherDropletsThanThoseOfTheCase) {
  expect_refused("history/droplets/x", {{}, {}, {{"history/droplets/x", {0.5, 0.6}}}});
  expect_refused("history/bodies/z", {{}, {}, {{"history/bodies/z", {}}}});
  expect_refused("history/bodies/touched", {{}, {}, {{"history/bodies/touched", {64}}}});
  expect_refused("history/bodies/touched", {{}, {}, {{"history/bodies/touched", {-1}}}});
  expect_refused("history/events/time", {{}, {}, {{"history/events/time", {1}}}});
}

TEST(EntriesFromFile, ReadsArraysAndTextsByName) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  CheckpointWriter file(path);
  file.value("memory/settings", std::string("these"));
  file.value("memory/many", std::int64_t{1} << 40);
  file.single_array("memory/mode", {0.1f, 2});
  file.array("memory/bad", {1, NAN});
  file.commit();
  EntriesFromFile entries(path);
  EXPECT_TRUE(entries.says("memory/settings", "these"));
  EXPECT_FALSE(entries.says("memory/settings", "others"));
  EXPECT_FALSE(entries.says("memory/others", "these"));
  EXPECT_EQ(entries.array("memory/mode", 2), (std::vector<double>{0.1f, 2}));
  int count = 0;
  double number = 0;
  expect_error(Exit::invalid_input, {path, "memory/many"}, [&] { entries.count("memory/many", count); });
  expect_error(Exit::invalid_input, {path, "memory/bad"}, [&] { entries.array("memory/bad", 2); });
  expect_error(Exit::invalid_input, {path, "memory/mode"}, [&] { entries.array("memory/mode", 3); });
  expect_error(Exit::invalid_input, {path, "memory/missing"}, [&] { entries.number("memory/missing", number); });
}

TEST(Fingerprint, NamesWhatAResumedRunMayNotChange) {
  const auto with = [](const std::string& setting) { return parse_case(pull_text(), "case.toml", {setting}); };
  const std::string stored = fingerprint(pull());
  for (const char* may : {"name=other", "time.end=5", "time.max_steps=7", "time.dt_initial=1e-3", "time.dt_min=1e-9",
                          "time.dt_max=3", "time.tolerance=1e-3", "solver.newton.rtol=1e-5", "output.history.every=3"})
    EXPECT_NO_THROW(check_fingerprint("checkpoint.h5", stored, with(may))) << may;
  for (const std::string key : {"time.mass=lumped", "time.safety=0.5", "time.start=equilibrium", "time.rho_inf=0.8",
                                "fluid.viscosity=1", "domain.degree=3"})
    expect_error(Exit::invalid_input, {"checkpoint.h5", key.substr(0, key.find('=')) + " was", "may change"},
                 [&] { check_fingerprint("checkpoint.h5", stored, with(key)); });
  const std::vector<std::string> scheme{"time.scheme=kick_drift", "domain.quadrature=full"};
  expect_error(Exit::invalid_input, {"checkpoint.h5", "time.scheme was", "may change"},
               [&] { check_fingerprint("checkpoint.h5", stored, parse_case(pull_text(), "case.toml", scheme)); });
  EXPECT_EQ(solver_settings(pull()), solver_settings(with("time.end=5")));
  EXPECT_NE(solver_settings(pull()), solver_settings(with("solver.newton.rtol=1e-5")));
}

TEST(Fingerprint, ThatOfAnOlderProgramLacksSomeKeys) {
  std::string stored;
  std::istringstream lines(fingerprint(pull()));
  for (std::string line; std::getline(lines, line);) {
    bool later = false;
    for (const char* key : {"time.mass", "time.safety", "time.start", "domain.grading", "domain.coordinates",
                            "substrate.surface_tension", "load[0].path"})
      later = later || line.rfind(key, 0) == 0;
    if (!later) stored += line + "\n";
  }
  ASSERT_NE(stored, fingerprint(pull()));
  EXPECT_NO_THROW(check_fingerprint("checkpoint.h5", stored, pull()));
  const std::string graded = "domain.grading.box=[[0.2,0.05],[0.9,0.3]]", tense = "substrate.surface_tension=0.1";
  for (const std::string& setting : {graded, tense})
    expect_error(Exit::invalid_input, {"checkpoint.h5", setting.substr(0, 10), "another case"},
                 [&] { check_fingerprint("checkpoint.h5", stored, parse_case(pull_text(), "case.toml", {setting})); });
}

}  // namespace
}  // namespace softwet
