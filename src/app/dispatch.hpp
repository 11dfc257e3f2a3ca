// From a validated case (run time) to a compiled configuration (compile time), once.
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "app/case.hpp"

namespace softwet {

struct RunOptions {
  std::string out;              ///< output folder
  bool resume = false;          ///< continue from out/checkpoint.h5
  int threads = 0;              ///< 0: all cores
  bool quiet = false;           ///< no progress line
  std::function<void()> begin;  ///< called by a run from its start: all checks have passed, no file is written yet
};

/// Computes the case and writes the output folder. Throws Error.
void run_case(const Case&, const RunOptions&);

/// Prints the terms in play, unknowns per field, memory, step limits and kernel of a case. Throws Error.
void describe_case(const Case&, std::ostream&);

/// Measures residuals, products and preconditioner of a case and prints throughput. Throws Error.
void bench_case(const Case&, const RunOptions&, std::ostream&);

/// Prints version, commit, backend, threads, instruction set and the compiled configurations.
void describe_build(std::ostream&);

}  // namespace softwet
