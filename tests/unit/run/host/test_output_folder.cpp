// The output folder: an old result stays until the new run begins; what came to nothing leaves no folder behind.
#include "run/host/output_folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "casefile/case_file.hpp"
#include "unit/casefile/pull.hpp"
#include "unit/io/expect_error.hpp"
#include "unit/io/scratch_folder.hpp"

namespace softwet {
namespace {

using testing_tools::pull;

namespace fs = std::filesystem;

/// A folder with the result of an earlier run and a file of the user.
void write_old_result(const ScratchFolder& folder) {
  fs::create_directory(folder / "fields");
  for (const char* name : {"case.toml", "run.json", "history.csv", "checkpoint.h5", "fields/fluid_0000.hdf", "mine"})
    overwrite(folder / name, std::string("old ") + name);
}

TEST(OutputFolder, AnOldResultStaysWhenTheNewRunIsRefused) {
  const ScratchFolder folder;
  write_old_result(folder);
  OutputFolder(folder / "", pull(), OldResult::overwrite).discard();
  for (const char* name : {"case.toml", "run.json", "history.csv", "checkpoint.h5", "fields/fluid_0000.hdf", "mine"})
    EXPECT_EQ(content_of(folder / name), std::string("old ") + name);
}

TEST(OutputFolder, TheNewRunReplacesTheOldResultAndNothingElse) {
  const ScratchFolder folder;
  write_old_result(folder);
  OutputFolder output(folder / "", pull(), OldResult::overwrite);
  output.begin();
  for (const char* name : {"run.json", "history.csv", "checkpoint.h5", "fields"})
    EXPECT_FALSE(fs::exists(folder / name));
  EXPECT_EQ(content_of(folder / "mine"), "old mine");
  EXPECT_NE(content_of(folder / "case.toml").find("tensotaxis_pull_2d"), std::string::npos);
}

TEST(OutputFolder, ARunThatIsRefusedLeavesNoFolder) {
  const ScratchFolder folder;
  OutputFolder output(folder / "a/b/c", pull(), OldResult::refuse);
  EXPECT_TRUE(fs::is_directory(folder / "a/b/c"));
  output.discard();
  EXPECT_FALSE(fs::exists(folder / "a"));
}

TEST(OutputFolder, ARunWithoutARowLeavesNoFolder) {
  const ScratchFolder folder;
  OutputFolder output(folder / "a/b", pull(), OldResult::refuse);
  output.begin();
  EXPECT_TRUE(fs::exists(folder / "a/b/case.toml"));
  output.discard();
  EXPECT_FALSE(fs::exists(folder / "a"));
}

TEST(OutputFolder, ARunWithARowStays) {
  const ScratchFolder folder;
  OutputFolder output(folder / "a", pull(), OldResult::refuse);
  output.begin();
  overwrite(folder / "a/history.csv", "step\n");
  output.discard();
  EXPECT_TRUE(fs::exists(folder / "a/case.toml"));
}

TEST(OutputFolder, RefusesAnOldResultUnlessAskedToUseIt) {
  const ScratchFolder folder;
  write_old_result(folder);
  expect_error(Exit::invalid_input, {"--resume", "--overwrite", "--out"},
               [&] { OutputFolder(folder / "", pull(), OldResult::refuse); });
}

TEST(OutputFolder, ARunThatEndedBeforeItsFirstCheckpointIsStartedAgain) {
  const ScratchFolder folder;
  write_old_result(folder);
  fs::remove(folder / "checkpoint.h5");
  for (OldResult old : {OldResult::refuse, OldResult::resume})
    expect_error(Exit::invalid_input, {folder / "", "before its first checkpoint", "--overwrite"},
                 [&] { OutputFolder(folder / "", pull(), old); });
  OutputFolder(folder / "", pull(), OldResult::overwrite).begin();
  EXPECT_FALSE(fs::exists(folder / "history.csv"));
}

TEST(OutputFolder, ThereIsNothingToResumeWhereNoRunIs) {
  const ScratchFolder folder;
  for (const char* name : {"", "none"})
    expect_error(Exit::invalid_input, {folder / name, "there is no run", "leave out --resume", "--out"},
                 [&] { OutputFolder(folder / name, pull(), OldResult::resume); });
  EXPECT_FALSE(fs::exists(folder / "none"));
}

TEST(OutputFolder, ARunThatIsUnderWayIsTheFirstThingSaid) {
  const ScratchFolder folder;
  const OutputFolder running(folder / "", pull(), OldResult::refuse);
  for (OldResult old : {OldResult::refuse, OldResult::resume, OldResult::overwrite})
    expect_error(Exit::invalid_input, {"another run", folder / "", "is writing", "--out"},
                 [&] { OutputFolder(folder / "", pull(), old); });
  write_old_result(folder);
  for (OldResult old : {OldResult::refuse, OldResult::resume, OldResult::overwrite})
    expect_error(Exit::invalid_input, {"another run", folder / "", "is writing", "--out"},
                 [&] { OutputFolder(folder / "", pull(), old); });
}

TEST(OutputFolder, AGlanceAtTheLockIsNoRun) {
  const ScratchFolder folder;
  const int glance = ::open((folder / "").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(glance, LOCK_SH), 0);
  std::thread end([glance] {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::close(glance);
  });
  EXPECT_NO_THROW(OutputFolder(folder / "", pull(), OldResult::refuse));
  end.join();
}

TEST(OutputFolder, ARefusalGivesTheFolderBack) {
  const ScratchFolder folder;
  write_old_result(folder);
  EXPECT_THROW(OutputFolder(folder / "", pull(), OldResult::refuse), Error);
  OutputFolder(folder / "", pull(), OldResult::resume);
}

TEST(OutputFolder, KnowsWhereItIsWhenItIsMoved) {
  const ScratchFolder folder;
  const OutputFolder output(folder / "a", pull(), OldResult::refuse);
  EXPECT_EQ(output.place(), folder / "a");
  fs::rename(folder / "a", folder / "b");
  EXPECT_EQ(output.place(), fs::canonical(folder / "b").string());
  fs::create_directory(folder / "a");  // a folder of somebody else
  EXPECT_EQ(output.place(), fs::canonical(folder / "b").string());
}

TEST(OutputFolder, KnowsThatItIsRemoved) {
  const ScratchFolder folder;
  const OutputFolder output(folder / "a", pull(), OldResult::refuse);
  fs::remove_all(folder / "a");
  EXPECT_EQ(output.place(), "");
  fs::create_directory(folder / "a");
  EXPECT_EQ(output.place(), "");
}

TEST(OutputFolder, TakesNothingBackFromAFolderOfSomebodyElse) {
  const ScratchFolder folder;
  OutputFolder output(folder / "a", pull(), OldResult::refuse);
  output.begin();
  fs::rename(folder / "a", folder / "b");
  fs::create_directory(folder / "a");
  overwrite(folder / "a/case.toml", "another\n");
  output.discard();
  EXPECT_EQ(content_of(folder / "a/case.toml"), "another\n");
  EXPECT_TRUE(fs::exists(folder / "b/case.toml"));
}

TEST(OutputFolder, APipeInThePlaceOfTheCaseIsNotWaitedFor) {
  const ScratchFolder folder;
  ASSERT_EQ(::mkfifo((folder / "case.toml").c_str(), 0600), 0);
  OutputFolder output(folder / "", pull(), OldResult::refuse);
  output.begin();
  EXPECT_TRUE(fs::is_regular_file(folder / "case.toml"));
}

}  // namespace
}  // namespace softwet
