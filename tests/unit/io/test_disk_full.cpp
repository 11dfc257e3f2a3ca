// A disk that takes no more: every writer reports it with exit code 3, keeps the old file and leaves no partial file.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "case/error.hpp"
#include "io/checkpoint_file.hpp"
#include "io/field_file.hpp"
#include "io/run_record.hpp"
#include "io/table_file.hpp"
#include "scratch_folder.hpp"

/// Leak checkers: after a failed write HDF5 keeps its memory to the end of the process.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

namespace softwet {
namespace {

/// Runs `write` in a process whose files may have 8 KiB and ends it with the exit code of its Error.
template <class Write>
void exit_with_code_on_small_disk(Write write) {
  ::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit = {8192, 8192};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  try {
    write();
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::exit(int(error.code()));
  }
  std::exit(0);
}

const std::vector<double> many_values(40000, 0.5);

TEST(DiskFull, CheckpointKeepsTheOldOne) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  overwrite(path, "old");
  const auto write = [&] {
    CheckpointWriter writer(path);
    writer.array("density", many_values);
    writer.commit();
  };
  EXPECT_EXIT(exit_with_code_on_small_disk(write), testing::ExitedWithCode(3), "checkpoint.h5.*File too large");
  EXPECT_EQ(content_of(path), "old");
  EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
}

TEST(DiskFull, FieldsAreNotLeftHalfWritten) {
  const ScratchFolder folder;
  const std::string path = folder / "fluid_000001.hdf";
  const TensorGrid grid = {2, {50, 50, 1}};
  const std::vector<double> points(2 * 101 * 101, 1.0);
  const auto write = [&] { write_fields(path, {}, grid, points, {}, 0.0); };
  EXPECT_EXIT(exit_with_code_on_small_disk(write), testing::ExitedWithCode(3), "fluid_000001.hdf.*File too large");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
}

TEST(DiskFull, TablesAndRecordsReportIt) {
  const ScratchFolder folder;
  const auto write_table = [&] {
    TableFile table = TableFile::create(folder / "history.csv", {"step", "t"});
    for (int step = 0; step < 5000; ++step) table.row({{"step", step}, {"t", 0.1 * step}});
    table.flush();
  };
  EXPECT_EXIT(exit_with_code_on_small_disk(write_table), testing::ExitedWithCode(3), "history.csv.*File too large");
  const auto write_table_and_go_on = [&] {
    TableFile table = TableFile::create(folder / "history.csv", {"step", "t"});
    try {
      for (int step = 0; step < 5000; ++step) table.row({{"step", step}, {"t", 0.1 * step}});
      table.flush();
    } catch (const Error&) {
    }
    table.bring_to_disk();  // before a checkpoint, which must not count rows that are lost
  };
  EXPECT_EXIT(exit_with_code_on_small_disk(write_table_and_go_on), testing::ExitedWithCode(3),
              "history.csv.*File too large");
  const auto write_record = [&] {
    RunRecord record;
    record["text"] = std::string(20000, 'x');
    record.write(folder / "run.json");
  };
  EXPECT_EXIT(exit_with_code_on_small_disk(write_record), testing::ExitedWithCode(3), "run.json.*File too large");
  EXPECT_FALSE(std::filesystem::exists(folder / "run.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run.json.partial"));
}

TEST(DiskFull, AFolderThatCannotBeMadeIsReported) {
  const ScratchFolder folder;
  overwrite(folder / "file", "");
  for (const auto& write :
       std::vector<void (*)(const std::string&)>{[](const std::string& path) { CheckpointWriter writer(path); },
                                                 [](const std::string& path) { TableFile::create(path, {"step"}); },
                                                 [](const std::string& path) { RunRecord().write(path); }}) {
    try {
      write(folder / "file/output");
      ADD_FAILURE() << "no error was thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Exit::machine_failed);
      EXPECT_NE(std::string(error.what()).find("--out"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace softwet
