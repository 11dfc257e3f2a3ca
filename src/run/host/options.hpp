// What the command line says of a run.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "case/physical.hpp"
#include "run/host/file_writer.hpp"

namespace softwet {

struct RunOptions {
  std::string out;               ///< output folder
  bool resume = false;           ///< continue from out/checkpoint.h5
  int threads = 0;               ///< 0: as the environment says, else all cores
  bool quiet = false;            ///< no progress line
  bool steady = false;           ///< find the state of rest under the full loads, in place of a motion
  bool preconditioners = false;  ///< bench: compare forms of the preconditioner instead
  std::function<void()> begin;   ///< called by a run from its start: all checks have passed, no file is written yet
  /// Where the output folder is now: `out`, another path where somebody has moved it, empty where it was removed. Asked
  /// of the first process.
  std::function<std::string()> place;
  std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();  ///< seconds of a run count from here
  std::optional<Scales> laboratory;  ///< in whose units the result is printed; none: in those of the case
  std::optional<Writes> writes;      ///< when field files are written; none: as it suits the machine
};

}  // namespace softwet
