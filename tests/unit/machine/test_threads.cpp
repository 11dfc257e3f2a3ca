// The number of threads: the request, the environment, the control groups, and the limit of Kokkos.
#include "machine/threads.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "unit/io/expect_error.hpp"
#include "unit/io/scratch_folder.hpp"
#include "unit/machine/environment_variable.hpp"

namespace softwet {
namespace {

using testing_tools::Environment;
using testing_tools::Variables;

const Variables nothing_said{{"KOKKOS_NUM_THREADS", {}}, {"OMP_NUM_THREADS", {}}, {"OMP_THREAD_LIMIT", {}}};

/// A made-up /proc and /sys.
class RootOfCores {
 public:
  explicit RootOfCores(const std::string& groups_of_process) { write("proc/self", "cgroup", groups_of_process); }
  void version_1(const std::string& group, const std::string& quota) const {
    write("sys/fs/cgroup/cpu" + group, "cpu.cfs_quota_us", quota);
    write("sys/fs/cgroup/cpu" + group, "cpu.cfs_period_us", "100000");
  }
  void version_2(const std::string& group, const std::string& text) const {
    write("sys/fs/cgroup" + group, "cpu.max", text);
  }
  std::string path() const { return root_ / ""; }
  double cores() const { return cores_by_control_groups(path()); }

 private:
  void write(const std::string& folder, const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(root_ / folder);
    overwrite(root_ / (folder + "/" + name), content + "\n");
  }
  ScratchFolder root_;
};

constexpr double no_quota = std::numeric_limits<double>::infinity();

TEST(Threads, ControlGroupsOfVersion2GrantTheLeastOfTheirPath) {
  const RootOfCores root("0::/pod/box");
  EXPECT_EQ(root.cores(), no_quota);
  root.version_2("/pod/box", "max 100000");
  EXPECT_EQ(root.cores(), no_quota);
  root.version_2("/pod", "250000 100000");
  EXPECT_EQ(root.cores(), 2.5);
  root.version_2("/pod/box", "50000 100000");
  EXPECT_EQ(root.cores(), 0.5);
  root.version_2("/other", "1000 100000");
  EXPECT_EQ(root.cores(), 0.5);
}

TEST(Threads, ControlGroupsOfVersion1GrantTheLeastOfTheirPath) {
  const RootOfCores root("4:cpu,cpuacct:/docker/abc\n1:memory:/x");
  EXPECT_EQ(root.cores(), no_quota);
  root.version_1("", "-1");
  EXPECT_EQ(root.cores(), no_quota);
  root.version_1("/docker/abc", "300000");
  EXPECT_EQ(root.cores(), 3);
  root.version_1("", "150000");  // a container sees its own group at the top
  EXPECT_EQ(root.cores(), 1.5);
}

TEST(Threads, ByDefaultOneForEachCoreThatIsGranted) {
  const Environment environment(nothing_said);
  const RootOfCores root("0::/");
  EXPECT_EQ(number_of_threads(0, 8, root.path()), 8);
  root.version_2("", "250000 100000");
  EXPECT_EQ(number_of_threads(0, 8, root.path()), 3);
  EXPECT_EQ(number_of_threads(0, 2, root.path()), 2);
  EXPECT_EQ(number_of_threads(5, 2, root.path()), 5);  // who asks gets them
}

TEST(Threads, AMachineWithMoreCoresThanKokkosHasRoomForGetsAsManyAsThereIsRoomFor) {
  const Environment environment(nothing_said);
  EXPECT_EQ(number_of_threads(0, 640, "/nowhere"), most_threads);
  EXPECT_EQ(number_of_threads(most_threads, 640, "/nowhere"), most_threads);
  expect_error(Exit::invalid_input, {"--threads = 513", "512"}, [] { number_of_threads(513, 640, "/nowhere"); });
}

TEST(Threads, VariablesOfTheEnvironmentCountInTheirOrder) {
  const Environment cleared(nothing_said);
  const Environment openmp(Variables{{"OMP_NUM_THREADS", "3,2"}});
  EXPECT_EQ(number_of_threads(0, 8, "/nowhere"), 3);
  const Environment kokkos(Variables{{"KOKKOS_NUM_THREADS", "4"}});
  EXPECT_EQ(number_of_threads(0, 8, "/nowhere"), 4);
  EXPECT_EQ(number_of_threads(6, 8, "/nowhere"), 6);
  const Environment limit(Variables{{"OMP_THREAD_LIMIT", "5"}});
  expect_error(Exit::invalid_input, {"--threads = 6", "OMP_THREAD_LIMIT"}, [] { number_of_threads(6, 8, "/nowhere"); });
}

TEST(Threads, ALimitOfOpenMpHoldsByDefault) {
  const Environment environment(nothing_said), limit(Variables{{"OMP_THREAD_LIMIT", "2"}});
  EXPECT_EQ(number_of_threads(0, 8, "/nowhere"), 2);
}

TEST(Threads, NonsenseInTheEnvironmentIsRefusedByName) {
  const Environment environment(nothing_said);
  for (const char* name : {"KOKKOS_NUM_THREADS", "OMP_NUM_THREADS"})
    for (const char* wrong : {"abc", "0", "-3", "1e3", "100000", "2x"}) {
      const Environment one(Variables{{name, wrong}});
      expect_error(Exit::invalid_input, {name, wrong, "[1, 512]"}, [] { number_of_threads(0, 8, "/nowhere"); });
    }
  const Environment empty(Variables{{"OMP_NUM_THREADS", ""}});
  EXPECT_EQ(number_of_threads(0, 8, "/nowhere"), 8);
}

TEST(Threads, WhatKokkosWouldEndTheProgramForIsRefusedByName) {
  const Environment cleared(Variables{{"KOKKOS_NUM_THREADS", {}}, {"KOKKOS_TOOLS_LIBS", {}}});
  EXPECT_NO_THROW(check_environment_of_kokkos());
  const std::pair<const char*, const char*> wrong[] = {
      {"KOKKOS_NUM_THREADS", "abc"},       {"KOKKOS_NUM_THREADS", ""},    {"KOKKOS_NUM_THREADS", "0"},
      {"KOKKOS_DEVICE_ID", "first"},       {"KOKKOS_DEVICE_ID", "-1"},    {"KOKKOS_DISABLE_WARNINGS", "maybe"},
      {"KOKKOS_PRINT_CONFIGURATION", "2"}, {"KOKKOS_TUNE_INTERNALS", ""}, {"KOKKOS_MAP_DEVICE_ID_BY", "luck"},
  };
  for (const auto& [name, value] : wrong) {
    const Environment one(Variables{{name, value}});
    expect_error(Exit::invalid_input, {name, "'" + std::string(value) + "'", "must be"},
                 [] { check_environment_of_kokkos(); });
  }
  const Environment two(Variables{{"KOKKOS_TOOLS_LIBS", "a.so"}, {"KOKKOS_PROFILE_LIBRARY", "b.so"}});
  expect_error(Exit::invalid_input, {"KOKKOS_PROFILE_LIBRARY", "a.so"}, [] { check_environment_of_kokkos(); });
  const Environment right(Variables{{"KOKKOS_PROFILE_LIBRARY", {}}, {"KOKKOS_DISABLE_WARNINGS", "True"}});
  EXPECT_NO_THROW(check_environment_of_kokkos());
}

}  // namespace
}  // namespace softwet
