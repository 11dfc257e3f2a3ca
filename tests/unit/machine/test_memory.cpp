// The memory a case needs at least, what can be had, and the refusal.
#include "machine/memory.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "casefile/case_file.hpp"
#include "unit/io/expect_error.hpp"
#include "unit/io/scratch_folder.hpp"

namespace softwet {
namespace {

Case pull_on(const std::string& elements) {
  return parse_case(initial_case("tensotaxis_pull_2d"), "case.toml",
                    {"domain.elements=" + elements, "solver.precision=double"});
}

TEST(Memory, LeastGrowsWithTheMeshAndTheKrylovBasis) {
  Case c = pull_on("[128, 64]");
  const double coarse = least_bytes(c);
  EXPECT_NEAR(least_bytes(pull_on("[256, 128]")) / coarse, 4, 1e-12);
  // 128 x 64 elements, of which a quarter is solid: 2 velocities everywhere, 2 scalars in the fluid.
  const double unknowns = 128 * 64 * (2 + 2 * 0.75);
  c.solver.krylov_restart += 10;
  EXPECT_NEAR(least_bytes(c) - coarse, 8 * 20 * unknowns, 1e-6);
  const double full = least_bytes(c);
  c.solver.precision = PrecisionChoice::mixed;
  EXPECT_NEAR(full - least_bytes(c), 4 * 2 * c.solver.krylov_restart * unknowns, 1e-6);
}

TEST(Memory, LeastStaysBelowWhatATableOfPartsCounts) {
  // The vectors of the pull (128 x 64) as `softwet check` counts them, control points of the edges included.
  const double counted = 1.2 + 0.7 + 1.2 + 14.4, least = least_bytes(pull_on("[128, 64]")) / 1048576;
  EXPECT_LT(least, counted);
  EXPECT_GT(least, 0.8 * counted);
}

TEST(Memory, MostUnknownsBoundsThoseOfTheMesh) { EXPECT_GE(most_unknowns(pull_on("[128, 64]")), 130 * 68 * 4); }

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// A made-up /proc and /sys.
class FakeRoot {
 public:
  explicit FakeRoot(const std::string& groups_of_process) { write("/proc/self", "cgroup", groups_of_process); }
  void version_1(const std::string& group, const std::string& limit, const std::string& used) const {
    const std::string folder = "/sys/fs/cgroup/memory" + group;
    write(folder, "memory.limit_in_bytes", limit);
    write(folder, "memory.usage_in_bytes", used);
    write(folder, "memory.stat", "inactive_file 7\ntotal_inactive_file 100\ntotal_active_file 20\n");
  }
  void version_2(const std::string& group, const std::string& limit, const std::string& used) const {
    const std::string folder = "/sys/fs/cgroup" + group;
    write(folder, "memory.max", limit);
    write(folder, "memory.current", used);
    write(folder, "memory.stat", "anon 5000\nactive_file 20\ninactive_file 100\n");
  }
  double left() const { return left_by_control_groups(root_ / ""); }

 private:
  void write(const std::string& folder, const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(root_ / folder.substr(1));
    overwrite(root_ / (folder.substr(1) + "/" + name), content + "\n");
  }
  ScratchFolder root_;
};

TEST(Memory, ControlGroupsOfVersion2LeaveTheLeastOfTheirPathWithCachedFiles) {
  const FakeRoot root("0::/slurm/job_1/step_0");
  EXPECT_EQ(root.left(), no_limit);
  root.version_2("/slurm/job_1/step_0", "max", "2000");
  EXPECT_EQ(root.left(), no_limit);
  root.version_2("/slurm/job_1", "10000", "4000");
  EXPECT_EQ(root.left(), 10000 - 4000 + 120);
  root.version_2("/slurm", "20000", "17000");
  EXPECT_EQ(root.left(), 20000 - 17000 + 120);
  root.version_2("/slurm/job_2", "10", "0");  // of others
  EXPECT_EQ(root.left(), 20000 - 17000 + 120);
  root.version_2("/slurm/job_1/step_0", "2000", "2500");
  EXPECT_EQ(root.left(), 0);
}

TEST(Memory, ControlGroupsOfVersion1LeaveTheLeastOfTheirPathWithCachedFiles) {
  const FakeRoot root("5:devices:/other\n4:hugetlb,memory:/slurm/job_1\n1:cpu:/x\n0::/");
  EXPECT_EQ(root.left(), no_limit);
  root.version_1("/other", "10", "0");
  root.version_1("", "9223372036854771712", "30000");  // as the system writes "no limit"
  EXPECT_GT(root.left(), 9e18);
  root.version_1("/slurm", "20000", "4000");
  EXPECT_EQ(root.left(), 20000 - 4000 + 120);
  root.version_1("/slurm/job_1", "5000", "4000");
  EXPECT_EQ(root.left(), 5000 - 4000 + 120);
  root.version_1("/slurm/job_1", "5000", "50");  // more cached than used: a group leaves no more than its limit
  EXPECT_EQ(root.left(), 5000);
}

TEST(Memory, AContainerThatSeesItsOwnGroupOnlyHasItsLimit) {
  const FakeRoot version_2("0::/docker/abc"), version_1("3:memory:/docker/abc");
  version_2.version_2("", "9000", "1000");
  EXPECT_EQ(version_2.left(), 9000 - 1000 + 120);
  version_1.version_1("", "9000", "1000");
  EXPECT_EQ(version_1.left(), 9000 - 1000 + 120);
}

TEST(Memory, LinesThatNameNoGroupAreNoLimit) {
  const FakeRoot root("\nmemory\n4:memory\n::");
  EXPECT_EQ(root.left(), no_limit);
  EXPECT_EQ(left_by_control_groups("/nowhere"), no_limit);
}

TEST(Memory, WhatCanBeHadIsPositiveAndMoreIsRefusedWithBothAmounts) {
  const double all = bytes_to_be_had();
  EXPECT_GT(all, 1e6);
  const Case c = pull_on("[128, 64]");
  require_bytes(c, 1024);
  expect_error(Exit::machine_failed, {"needs 9.313e+08 GiB", "can be had", "[128, 64]", "schwarz"},
               [&] { require_bytes(c, 1e18); });
  require_device_bytes(c, 1024, 2048);
  expect_error(Exit::machine_failed, {"needs 2 GiB of memory of the device", "1 GiB can be had", "schwarz"},
               [&] { require_device_bytes(c, 2.0 * (1 << 30), 1 << 30); });
}

}  // namespace
}  // namespace softwet
