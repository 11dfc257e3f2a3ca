#include "machine/launcher.hpp"

#include <cstdlib>

namespace softwet {
namespace {

/// Where a launcher gives the number of processes, and which of them this one is; null where it does not.
struct Launcher {
  const char *size, *rank;
};

constexpr Launcher launchers[] = {
    {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
    {"PMI_SIZE", "PMI_RANK"},
    {"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK"},
    {"MPI_LOCALNRANKS", "MPI_LOCALRANKID"},
    {"FLUX_JOB_SIZE", "FLUX_TASK_RANK"},
    // A script of sbatch has SLURM_PROCID = 0 too, and SLURM_NTASKS of its job, while it is one process.
    {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"},
    {nullptr, "PMIX_RANK"},
    {nullptr, "PALS_RANKID"},
};

const char* told_by(const char* name) { return name == nullptr ? nullptr : std::getenv(name); }

LaunchSign sign(const Launcher& launcher, const char* name, const char* value) {
  std::string unset;
  for (const char* variable : {launcher.size, launcher.rank})
    if (variable != nullptr) unset += (unset.empty() ? "-u " : " -u ") + std::string(variable);
  return {std::string(name) + " = " + value, unset};
}

}  // namespace

LaunchSign sign_of_several_processes() {
  for (const Launcher& launcher : launchers) {
    const char *size = told_by(launcher.size), *rank = told_by(launcher.rank);
    if (size != nullptr && std::atoi(size) > 1) return sign(launcher, launcher.size, size);
    if (rank != nullptr && std::atoi(rank) > 0) return sign(launcher, launcher.rank, rank);
    if (size != nullptr && std::atoi(size) == 1) return {};
  }
  return {};
}

}  // namespace softwet
