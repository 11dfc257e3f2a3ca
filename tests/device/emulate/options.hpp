// The variables of the environment (README.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace emulate {

struct Options {
  // 0: addresses are checked. 1: also accesses of warps to shared memory. 2: also accesses of the lanes of a warp to it.
  int check = number("EMU_CHECK", 1);
  // Blocks run on so many threads of the host.
  int threads = number("EMU_THREADS", 1);
  // Chooses the order of warps and of blocks; 0: as they are numbered.
  std::uint64_t seed = static_cast<std::uint64_t>(number("EMU_SEED", 0));
  // 1: counts of each kernel are printed. 2: also the lines of the sources with most instructions, and the barriers.
  int report = number("EMU_REPORT", 0);
  std::string only = text("EMU_REPORT_ONLY");
  // New bytes of the device and of shared memory have this value; -1: what was there.
  int fill = number("EMU_FILL", 0xff);
  // Whether reads of shared memory that no thread has written are reported.
  bool uninitialised = number("EMU_UNINITIALISED", 1) != 0;
  // So many faults of a kernel are printed.
  int most = number("EMU_MOST", 8);
  // Whether the program ends at the first fault.
  bool stop = number("EMU_STOP", 0) != 0;
  // Whether each launch is printed.
  bool trace = number("EMU_TRACE", 0) != 0;
  std::size_t memory = std::size_t(number("EMU_MEMORY_MIB", 16384)) << 20;
  // Whether kernels are executed. If not, launches are checked and counted alone.
  bool execute = number("EMU_EXECUTE", 1) != 0;
  // Bytes of shared memory of a multiprocessor.
  int shared = number("EMU_SHARED", 228 << 10);
  // The number of a barrier that is left out, in kernels whose name has a text.
  int drop = number("EMU_DROP", -1);
  std::string drop_in = text("EMU_DROP_IN");

  static int number(const char* name, int otherwise) {
    const char* given = std::getenv(name);
    return given ? std::atoi(given) : otherwise;
  }
  static std::string text(const char* name) {
    const char* given = std::getenv(name);
    return given ? given : "";
  }
};

inline const Options& options() {
  static const Options all;
  return all;
}

}  // namespace emulate
