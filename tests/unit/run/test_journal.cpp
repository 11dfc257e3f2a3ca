// A run that writes rows and field files during its steps leaves the same files as a run that waits for them, and ends
// in the same way where one fails.
#include "run/journal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "case/error.hpp"
#include "run/motion.hpp"
#include "unit/io/scratch_folder.hpp"
#include "unit/time/explicit_run.hpp"

namespace softwet::testing_tools {
namespace {

namespace fs = std::filesystem;

Case with_fields() {
  Case c = moving_droplet(SceneKind::coupled);
  c.name = "files";
  c.time.scheme = TimeScheme::kick_drift;
  c.time.dt_initial = 1e-3;
  c.time.dt_max = 5e-3;
  c.time.end = 0.04;
  c.output.field_times = {0, 0.01, 0.02, 0.03, 0.04};
  c.output.history_every = 3;
  return c;
}

/// A run in a folder of its own, or what has ended it.
struct Finished {
  ScratchFolder folder;
  Exit code = Exit::done;
  std::string problem;

  /// @param spoil  what happens to the folder before
  Finished(const Case& c, Writes writes, const std::function<void(const ScratchFolder&)>& spoil = {}) {
    if (spoil) spoil(folder);
    go(c, writes);
  }
  void go(const Case& c, Writes writes, bool resume = false) {
    RunOptions options;
    options.out = folder / "out";
    options.quiet = true;
    options.resume = resume;
    options.writes = writes;
    fs::create_directories(options.out);
    try {
      Motion<2, 2>(c, options).run();
    } catch (const Error& error) {
      code = error.code();
      problem = without_place(error.what());
    }
  }
  std::string without_place(std::string text) const {
    const std::string place = folder / "out";
    for (std::size_t at; (at = text.find(place)) != std::string::npos;) text.replace(at, place.size(), "OUT");
    return text;
  }
  /// All files but the checkpoint; of run.json the end alone, without the time of day: events, why it stopped, and the
  /// last row.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
      if (entry.is_regular_file() && entry.path().filename() != "run.json" &&
          entry.path().filename() != "checkpoint.h5")
        all[fs::relative(entry.path(), folder / "out").string()] = content_of(entry.path().string());
    if (fs::exists(folder / "out/run.json")) {
      const std::string record = content_of(folder / "out/run.json");
      all["run.json"] = without_place(record.substr(std::min(record.size(), record.find("\"events\""))));
    }
    return all;
  }
};

void expect_alike(const Finished& beside, const Finished& in_turn) {
  EXPECT_EQ(beside.code, in_turn.code);
  EXPECT_EQ(beside.problem, in_turn.problem);
  const auto found = beside.files(), expected = in_turn.files();
  std::vector<std::string> names, expected_names;
  for (const auto& [name, content] : found) names.push_back(name);
  for (const auto& [name, content] : expected) expected_names.push_back(name);
  EXPECT_EQ(names, expected_names);
  for (const auto& [name, content] : expected) EXPECT_TRUE(found.count(name) && found.at(name) == content) << name;
}

TEST(FilesBesideSteps, AreThoseOfARunThatWaits) {
  const Finished beside(with_fields(), Writes::beside_steps), in_turn(with_fields(), Writes::in_turn);
  EXPECT_EQ(in_turn.problem, "");
  EXPECT_EQ(in_turn.files().size(), 2 * 5 + 2 + 2 + 1U);  // fields and their lists, tables, run.json
  expect_alike(beside, in_turn);
}

TEST(FilesBesideSteps, GoOnAfterAResume) {
  Case half = with_fields();
  half.time.end = 0.02;
  half.output.field_times = {0, 0.01, 0.02};
  Finished beside(half, Writes::beside_steps), in_turn(half, Writes::in_turn);
  expect_alike(beside, in_turn);
  beside.go(with_fields(), Writes::beside_steps, true);
  in_turn.go(with_fields(), Writes::in_turn, true);
  EXPECT_EQ(in_turn.problem, "");
  expect_alike(beside, in_turn);
  expect_alike(beside, Finished(with_fields(), Writes::in_turn));
}

/// The times of the field files that a checkpoint knows, and the time of its state.
std::vector<double> times_of(const std::string& checkpoint, const Case& c) {
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  WrittenFiles files;
  RunSeconds seconds;
  read_checkpoint<2, 2>(checkpoint, c, stepper, Scalars<2, 2>(c, scene).memory(), files, seconds);
  std::vector<double> times = files.field_times;
  times.push_back(stepper.state().time);
  return times;
}

// A folder stands where the second file has to go. In both runs the checkpoint holds the first state.
TEST(FilesBesideSteps, AFileThatFailsEndsTheRun) {
  const auto spoil = [](const ScratchFolder& folder) {
    fs::create_directories(folder / "out/fields/solid_0001.hdf/taken");
  };
  const Finished beside(with_fields(), Writes::beside_steps, spoil), in_turn(with_fields(), Writes::in_turn, spoil);
  EXPECT_EQ(beside.code, Exit::machine_failed);
  EXPECT_NE(beside.problem.find("solid_0001.hdf"), std::string::npos) << beside.problem;
  EXPECT_EQ(beside.code, in_turn.code);
  EXPECT_EQ(beside.problem, in_turn.problem);
  const std::vector<double> expected{0, with_fields().run_start()};
  EXPECT_EQ(times_of(beside.folder / "out/checkpoint.h5", with_fields()), expected);
  EXPECT_EQ(times_of(in_turn.folder / "out/checkpoint.h5", with_fields()), expected);
  EXPECT_FALSE(fs::exists(beside.folder / "out/fields/fluid_0002.hdf"));
}

// Not even the first file can be written: there is no checkpoint that lists it.
TEST(FilesBesideSteps, NoCheckpointWithoutItsFiles) {
  const auto spoil = [](const ScratchFolder& folder) {
    fs::create_directories(folder / "out");
    overwrite(folder / "out/fields", "a file");
  };
  const Finished beside(with_fields(), Writes::beside_steps, spoil), in_turn(with_fields(), Writes::in_turn, spoil);
  EXPECT_EQ(beside.code, Exit::machine_failed);
  expect_alike(beside, in_turn);
  EXPECT_FALSE(fs::exists(beside.folder / "out/checkpoint.h5"));
}

// The setup of scene and solver is a part of the run.
TEST(RunSeconds, CountFromTheStart) {
  ScratchFolder folder;
  RunOptions options;
  options.out = folder / "";
  options.quiet = true;
  options.begun -= std::chrono::seconds(100);
  Case c = with_fields();
  c.time.max_steps = 1;
  Motion<2, 2>(c, options).run();
  const std::string record = content_of(folder / "run.json");
  for (const std::string name : {"\"setup\":", "\"total\":"}) {
    const std::size_t at = record.find(name);
    ASSERT_NE(at, std::string::npos) << name;
    const double seconds = std::stod(record.substr(at + name.size()));
    EXPECT_GE(seconds, 100) << name;
    EXPECT_LT(seconds, 200) << name;
  }
}

// A step fails while a file is being written: the last good state is kept, and it knows the file.
TEST(FilesBesideSteps, AStepThatFailsLosesNoFile) {
  const Case c = with_fields();
  for (const Writes writes : {Writes::beside_steps, Writes::in_turn}) {
    ScratchFolder folder;
    RunOptions options;
    options.out = folder / "";
    options.quiet = true;
    options.writes = writes;
    const Scene<2, 2> scene(c);
    Stepper<2, 2> stepper(scene, c, {});
    State state = initial_state<2, 2>(c, scene);
    state.time = c.run_start();
    stepper.scheme().initialise(state);
    stepper.start(state);
    Journal<2, 2> journal(c, options, scene, stepper, {0});
    journal.begin();
    EXPECT_THROW(journal.keep_state_of(c,
                                       [&] {
                                         journal.observe({});
                                         throw Error(Exit::computation_failed, "no step");
                                       }),
                 Error);
    EXPECT_TRUE(fs::exists(folder / "fields/solid_0000.hdf"));
    EXPECT_EQ(times_of(folder / "checkpoint.h5", c), (std::vector<double>{0, c.run_start()}));
  }
}

}  // namespace
}  // namespace softwet::testing_tools
