// Counts of each kernel, and the end of the program.
#pragma once

#include "machine.hpp"

namespace emulate {

struct Total {
  const Kernel* kernel = nullptr;
  std::uint64_t launches = 0, teams = 0, threads = 0;
  std::int64_t shared = 0;
  double seconds = 0;
  Counts counts;
  void add(const Launch& launch, double seconds_taken);
};
Total& total_of(const Kernel& kernel);

/// Prints the report once, when the program ends. Ends the process with exit code 86 where faults were found.
void print_report();

}  // namespace emulate
