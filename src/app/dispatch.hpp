// From a validated case (run time) to a compiled configuration (compile time), once.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "app/physical.hpp"
#include "case/case.hpp"

namespace softwet {

struct RunOptions {
  std::string out;               ///< output folder
  bool resume = false;           ///< continue from out/checkpoint.h5
  int threads = 0;               ///< 0: as the environment says, else all cores
  bool quiet = false;            ///< no progress line
  bool preconditioners = false;  ///< bench: compare forms of the preconditioner instead
  std::function<void()> begin;   ///< called by a run from its start: all checks have passed, no file is written yet
  /// Where the output folder is now: `out`, another path where somebody has moved it, empty where it was removed. Asked
  /// of the first process.
  std::function<std::string()> place;
};

/// Computes the case and writes the output folder. Throws Error.
void run_case(const Case&, const RunOptions&);

/// Prints what a case means (stiffness, groups, clock) and what it takes (terms, unknowns, memory, step limits, kernel).
/// A case too large for this machine is described too. Throws Error.
void describe_case(const Case&, std::ostream&);

/// What is likely to go wrong with a case, a sentence each.
std::vector<std::string> forecast_case(const Case&);

/// Prints what physical numbers are in a case, and the other way round. Throws Error.
void convert_units(const PhysicalScene&, std::ostream&);

/// Measures residuals, products and preconditioner of a case and prints throughput, or compares preconditioners. Throws
/// Error.
void bench_case(const Case&, const RunOptions&, std::ostream&);

/// Prints version, commit, backend, threads, instruction set and the compiled configurations.
void describe_build(std::ostream&);

}  // namespace softwet
