// A checkpoint is taken as a whole or refused with the name of what no run writes.
#include "run/host/saved_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <sstream>

#include "casefile/case_file.hpp"
#include "io/checkpoint_file.hpp"
#include "io/hdf5_file.hpp"
#include "run/host/fingerprint.hpp"
#include "unit/casefile/pull.hpp"
#include "unit/io/expect_error.hpp"
#include "unit/io/scratch_folder.hpp"

namespace softwet {
namespace {

using testing_tools::pull;
using testing_tools::pull_text;

const std::vector<ArraySize> sizes{{"state/unknown", 4}, {"previous/unknown", 4}};

/// What a run would write, with one value changed.
struct Content {
  std::map<std::string, double> numbers{{"time", 2.5},
                                        {"previous/dt", 0.5},
                                        {"step_control/proposed", 0.25},
                                        {"history/time", 2.0},
                                        {"history/mass_start", 0.1}};
  std::map<std::string, std::int64_t> counts{
      {"steps/accepted", 7}, {"steps/rejected_newton", 1}, {"steps/rejected_error", 2}, {"history/step", 6}};
  std::map<std::string, std::vector<double>> arrays{
      {"state/unknown", {1, 2, 3, 4}}, {"previous/unknown", {5, 6, 7, 8}}, {"history/droplets", {0.5, 1, 0}}};

  void write(
      const std::string& path, const Case& c = pull(),
      const std::function<void(CheckpointWriter&)>& more = [](CheckpointWriter&) {}) const {
    CheckpointWriter file(path);
    file.value("case", fingerprint(c));
    for (const auto& [name, value] : numbers) file.value(name, value);
    for (const auto& [name, value] : counts) file.value(name, value);
    for (const auto& [name, values] : arrays) file.array(name, values);
    more(file);
    file.commit();
  }
};

TEST(SavedRun, ReadsWhatARunWrites) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  Content().write(path);
  const SavedRun run = read_saved_run(path, pull(), sizes);
  EXPECT_EQ(run.time, 2.5);
  EXPECT_EQ(run.arrays, (std::vector<std::vector<double>>{{1, 2, 3, 4}, {5, 6, 7, 8}}));
  EXPECT_EQ(run.previous_dt, 0.5);
  EXPECT_EQ(run.proposed_dt, 0.25);
  EXPECT_EQ(run.steps + run.rejected_newton + run.rejected_error + run.history_step, 7 + 1 + 2 + 6);
  EXPECT_EQ(run.droplets[0], (std::vector<double>{0.5, 1, 0}));
}

TEST(SavedRun, ReadsWhatBecameOfTheDroplets) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  const Body body{{0.5, 0.25, 0}, 6, true, true, false, true};
  Content().write(path, pull(), [&](CheckpointWriter& file) {
    write_watch({body}, {{-2, "the droplet reached the left side"}, {3.5, "the droplet vanished"}}, file);
    file.value("run/started", 1e9);
  });
  const SavedRun run = read_saved_run(path, pull(), sizes);
  ASSERT_EQ(run.bodies.size(), 1U);
  EXPECT_EQ(run.bodies[0].place, body.place);
  EXPECT_EQ(run.bodies[0].touched, 6U);
  EXPECT_TRUE(run.bodies[0].seen && run.bodies[0].on_wall && !run.bodies[0].left_wall && run.bodies[0].gone);
  ASSERT_EQ(run.events.size(), 2U);
  EXPECT_EQ(run.events[0].time, -2);
  EXPECT_EQ(run.events[1].what, "the droplet vanished");
  EXPECT_EQ(run.started, 1e9);
}

TEST(SavedRun, ACheckpointOfAnOlderProgramHasNoEvents) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  Content().write(path);
  const SavedRun run = read_saved_run(path, pull(), sizes);
  EXPECT_TRUE(run.bodies.empty() && run.events.empty());
  EXPECT_FALSE(run.started);
}

TEST(SavedRun, RefusesDropletsAndEventsThatNoRunWrites) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  const auto refuses = [&](const std::string& name, const std::function<void(CheckpointWriter&)>& more) {
    Content().write(path, pull(), more);
    expect_error(Exit::invalid_input, {path, "'" + name + "'", "--resume"},
                 [&] { read_saved_run(path, pull(), sizes); });
  };
  refuses("history/bodies", [](CheckpointWriter& file) { write_watch({{}, {}}, {}, file); });
  refuses("history/bodies", [](CheckpointWriter& file) { write_watch({{{}, 64}}, {}, file); });
  refuses("history/bodies", [](CheckpointWriter& file) { write_watch({{{NAN, 0, 0}}}, {}, file); });
  refuses("history/event_times", [](CheckpointWriter& file) {
    write_watch({{}}, {{NAN, "the droplet vanished"}}, file);
  });
  refuses("history/event_times", [](CheckpointWriter& file) {
    file.array("history/event_times", {1, 2});
    file.value("history/events", std::string("the droplet vanished\n"));
  });
  refuses("run/started", [](CheckpointWriter& file) { file.value("run/started", NAN); });
}

TEST(SavedRun, ARunMayHaveBegunBefore1970) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  Content().write(path, pull(), [](CheckpointWriter& file) { file.value("run/started", -86400.0); });
  EXPECT_EQ(read_saved_run(path, pull(), sizes).started, -86400);
}

TEST(SavedRun, KnowsTheFilesBesideTheCheckpoint) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  const TableMark history{1234, 56, 0xfedcba98u}, interface { 20, 0, 1 };
  Content().write(path, pull(), [&](CheckpointWriter& file) {
    write_files({history, interface, std::vector<double>{-2, 0.5}}, file);
  });
  const WrittenFiles files = read_saved_run(path, pull(), sizes).files;
  EXPECT_EQ(files.history, history);
  EXPECT_EQ(files.interface, interface);
  EXPECT_EQ(files.field_times, (std::vector<double>{-2, 0.5}));
  Content().write(path);
  const WrittenFiles none = read_saved_run(path, pull(), sizes).files;
  EXPECT_FALSE(none.history || none.interface || none.field_times);
}

TEST(SavedRun, HandsBackWhatASchemeRemembers) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  Content().write(path, pull(), [](CheckpointWriter& file) {
    file.value(SavedMemory::settings, std::string("these"));
    file.value(SavedMemory::name("limit"), 0.25);
    file.value(SavedMemory::name("age"), 3);
    file.value(SavedMemory::name("many"), std::int64_t{1} << 40);
    file.single_array(SavedMemory::name("mode"), {0.1f, 2});
    file.array(SavedMemory::name("bad"), {1, NAN});
  });
  const SavedMemory memory(path);
  EXPECT_TRUE(memory.fits("these"));
  EXPECT_FALSE(memory.fits("others"));
  EXPECT_EQ(memory.number("limit"), 0.25);
  EXPECT_EQ(memory.count("age"), 3);
  EXPECT_EQ(memory.array("mode", 2), (std::vector<double>{0.1f, 2}));
  expect_error(Exit::invalid_input, {path, "memory/many"}, [&] { memory.count("many"); });
  expect_error(Exit::invalid_input, {path, "memory/bad"}, [&] { memory.array("bad", 2); });
  expect_error(Exit::invalid_input, {path, "memory/mode"}, [&] { memory.array("mode", 3); });
  expect_error(Exit::invalid_input, {path, "memory/missing"}, [&] { memory.number("missing"); });
  Content().write(path);
  EXPECT_FALSE(SavedMemory(path).fits("these"));
}

TEST(Fingerprint, TellsWhatAResumedRunMayNotChange) {
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

TEST(SavedRun, ADropletOn3DHasTwoCoordinates) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  const Case box = parse_case(
      "name='b'\ntime.end=1\ndomain={size=[1,1,1],elements=[8,8,8]}\nfluid={viscosity=1,capillarity=1,temperature=0.5}"
      "\n"
      "[[droplet]]\ncentre=[0.4,0.4,0]\nradius=0.2\n[[droplet]]\ncentre=[0.6,0.6,0]\nradius=0.2\n",
      "box.toml");
  Content content;
  content.arrays["history/droplets"] = {0.4, 0.5, 1, 0, 0.6, 0.7, 0, 1};
  content.write(path, box);
  EXPECT_EQ(read_saved_run(path, box, sizes).droplets,
            (std::vector<std::vector<double>>{{0.4, 0.5, 1, 0}, {0.6, 0.7, 0, 1}}));
}

void expect_refused(const std::string& name, const std::function<void(Content&)>& change) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  Content content;
  change(content);
  content.write(path);
  expect_error(Exit::invalid_input, {path, "'" + name + "'", "--resume"}, [&] { read_saved_run(path, pull(), sizes); });
}

TEST(SavedRun, RefusesNumbersThatAreNone) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [name, value] : Content().numbers)
    for (double bad : {nan, inf, -inf}) expect_refused(name, [&, n = name](Content& c) { c.numbers[n] = bad; });
  for (const auto& [name, values] : Content().arrays)
    for (double bad : {nan, -inf}) expect_refused(name, [&, n = name](Content& c) { c.arrays[n][2] = bad; });
}

TEST(SavedRun, RefusesTimesStepsAndCountsBelowZero) {
  for (const char* name : {"time", "previous/dt", "step_control/proposed", "history/time"})
    expect_refused(name, [&](Content& c) { c.numbers[name] = -1e-3; });
  expect_refused("step_control/proposed", [](Content& c) { c.numbers["step_control/proposed"] = 0; });
  for (const auto& [name, value] : Content().counts) expect_refused(name, [n = name](Content& c) { c.counts[n] = -1; });
}

TEST(SavedRun, RefusesArraysOfAnotherLength) {
  expect_refused("state/unknown", [](Content& c) { c.arrays["state/unknown"].push_back(0); });
  expect_refused("history/droplets", [](Content& c) { c.arrays["history/droplets"].clear(); });
}

}  // namespace
}  // namespace softwet
