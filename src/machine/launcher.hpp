// What a launcher of several processes (mpirun, srun, flux) puts into the environment of each.
#pragma once

#include <string>

namespace softwet {

/// What shows that this process is one of several of a job step.
struct LaunchSign {
  std::string sign;   ///< "SLURM_STEP_NUM_TASKS = 4"; empty: it was started alone
  std::string unset;  ///< "-u SLURM_STEP_NUM_TASKS -u SLURM_PROCID": options of env that take the sign away
};

/// Launchers of MPI come first: one inside of a job of Slurm knows better than Slurm.
LaunchSign sign_of_several_processes();

}  // namespace softwet
