// Whether a launcher has started this process as one of several.
#include "machine/launcher.hpp"

#include <gtest/gtest.h>

#include "unit/machine/environment_variable.hpp"

namespace softwet {
namespace {

using testing_tools::Environment;
using testing_tools::Variables;

const Variables of_no_launcher{
    {"OMPI_COMM_WORLD_SIZE", {}}, {"OMPI_COMM_WORLD_RANK", {}}, {"PMI_SIZE", {}},        {"PMI_RANK", {}},
    {"MV2_COMM_WORLD_SIZE", {}},  {"MV2_COMM_WORLD_RANK", {}},  {"MPI_LOCALNRANKS", {}}, {"MPI_LOCALRANKID", {}},
    {"FLUX_JOB_SIZE", {}},        {"FLUX_TASK_RANK", {}},       {"PMIX_RANK", {}},       {"PALS_RANKID", {}},
    {"SLURM_STEP_NUM_TASKS", {}}, {"SLURM_PROCID", {}},         {"SLURM_NTASKS", {}},    {"SLURM_ARRAY_TASK_ID", {}}};

std::string sign_with(const Variables& variables) {
  const Environment cleared(of_no_launcher), set(variables);
  return sign_of_several_processes().sign;
}

TEST(Launcher, OneOfSeveralProcessesIsRecognised) {
  EXPECT_EQ(sign_with({{"OMPI_COMM_WORLD_SIZE", "2"}, {"OMPI_COMM_WORLD_RANK", "0"}}), "OMPI_COMM_WORLD_SIZE = 2");
  EXPECT_EQ(sign_with({{"PMI_SIZE", "4"}, {"PMI_RANK", "0"}}), "PMI_SIZE = 4");
  EXPECT_EQ(sign_with({{"PMI_RANK", "3"}}), "PMI_RANK = 3");
  EXPECT_EQ(sign_with({{"PMIX_RANK", "1"}}), "PMIX_RANK = 1");
  EXPECT_EQ(sign_with({{"MPI_LOCALRANKID", "1"}}), "MPI_LOCALRANKID = 1");
  EXPECT_EQ(sign_with({{"SLURM_STEP_NUM_TASKS", "4"}, {"SLURM_PROCID", "0"}}), "SLURM_STEP_NUM_TASKS = 4");
  EXPECT_EQ(sign_with({{"SLURM_PROCID", "2"}}), "SLURM_PROCID = 2");
  EXPECT_EQ(sign_with({{"FLUX_JOB_SIZE", "2"}, {"FLUX_TASK_RANK", "0"}}), "FLUX_JOB_SIZE = 2");
}

TEST(Launcher, AProcessOfItsOwnIsNot) {
  EXPECT_EQ(sign_with({}), "");
  // The script of a job with four tasks, which starts one program by itself; a task of an array; a step of one task.
  EXPECT_EQ(sign_with({{"SLURM_NTASKS", "4"}, {"SLURM_PROCID", "0"}}), "");
  EXPECT_EQ(sign_with({{"SLURM_NTASKS", "1"}, {"SLURM_PROCID", "0"}, {"SLURM_ARRAY_TASK_ID", "7"}}), "");
  EXPECT_EQ(sign_with({{"SLURM_STEP_NUM_TASKS", "1"}, {"SLURM_PROCID", "0"}, {"PMIX_RANK", "0"}, {"PMI_RANK", "0"}}),
            "");
  EXPECT_EQ(sign_with({{"OMPI_COMM_WORLD_SIZE", "1"}, {"OMPI_COMM_WORLD_RANK", "0"}}), "");
}

TEST(Launcher, ALauncherOfMpiKnowsBetterThanSlurmAroundIt) {
  EXPECT_EQ(sign_with({{"OMPI_COMM_WORLD_SIZE", "1"}, {"SLURM_STEP_NUM_TASKS", "2"}, {"SLURM_PROCID", "1"}}), "");
}

TEST(Launcher, WhatTakesTheSignAwayIsReported) {
  const Environment cleared(of_no_launcher), set(Variables{{"SLURM_STEP_NUM_TASKS", "4"}});
  EXPECT_EQ(sign_of_several_processes().unset, "-u SLURM_STEP_NUM_TASKS -u SLURM_PROCID");
}

}  // namespace
}  // namespace softwet
