// What runs the blocks of threads of a launch.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "program.hpp"

namespace emulate {

struct Group;

/// What one thread of the host has counted of a kernel.
struct Counts {
  std::vector<std::uint64_t> runs, lanes;  // of each block of code: how many warps and lanes have run it
  std::uint64_t sectors_read = 0, sectors_written = 0, bytes_read = 0, bytes_written = 0, accesses_global = 0;
  std::uint64_t shared_accesses = 0, shared_cycles = 0, shared_least = 0, atomics_global = 0, atomics_shared = 0,
                local_accesses = 0;
  std::uint64_t diverged = 0;
  void add(const Counts& other);
};

/// Which warp wrote 4 bytes of shared memory and which warps read them last, and at which epoch. Barriers begin epochs.
struct Shadow {
  std::uint32_t written = 0, read = 0;
  std::uint32_t readers = 0;  // warps
  std::uint8_t writer = 0, writer_lane = 0;
  std::uint16_t atomic = 0;
};
/// Which lanes of a warp read 4 bytes of shared memory last.
struct LaneShadow {
  std::uint32_t readers = 0;                      // lanes of the warp that read last
  std::uint32_t written_sync = 0, read_sync = 0;  // how often the lanes of the warp had met
  std::uint32_t reader = 0;
};

struct Warp {
  char* bases[3] = {};
  Group* group = nullptr;
  int index = 0;
  std::uint32_t live = 0, existing = 0;
  std::uint32_t sync = 1;   // how often its lanes have met
  std::uint32_t carry = 0;  // carry flags
  struct Fragment {
    int block;
    std::uint32_t mask;
    bool waiting;
  };
  std::vector<Fragment> fragments;
  // At a barrier of the block:
  bool at_barrier = false;
  int barrier = 0, barrier_threads = -1, barrier_block = -1;
  std::uint32_t barrier_mask = 0;
  char* local[32] = {};
};

struct Launch {
  const Kernel* kernel = nullptr;
  std::uint32_t grid[3] = {1, 1, 1}, team[3] = {1, 1, 1};
  std::int64_t dynamic_shared = 0;
  std::vector<char> params;
  std::uint64_t number = 0;
};

/// A block of threads that is being executed.
struct Group {
  const Launch* launch = nullptr;
  const Kernel* kernel = nullptr;
  std::uint32_t at[3] = {};
  std::uint64_t number = 0;
  char* shared = nullptr;
  std::int64_t shared_bytes = 0;
  char* local = nullptr;
  std::int64_t local_all = 0;
  const char* params = nullptr;
  std::vector<Warp> warps;
  Counts* counts = nullptr;
  std::vector<Shadow> shadow;
  std::vector<LaneShadow> lane_shadow;
  std::vector<std::uint32_t> write_lines;
  std::uint32_t epoch = 1, first_epoch = 1;
  int check = 0;
  bool counting = false, stopped = false;
  int line = 0;  // of PTX, for messages
};

/// Number of a thread of a block along each axis.
void thread_of(const Group& group, int thread, std::uint32_t* at);
/// Runs a warp until it meets a barrier of its block or ends.
void run_warp(Warp& warp);
/// Runs all blocks of a launch. Adds what was counted to `counts` if that is not null.
void execute(const Launch& launch, Counts* counts);

/// Counts a fault of a kernel, and prints it once for its kind and place in the code.
void fault(const Warp& warp, int lane, int line, const std::string& what);
/// Number of faults that were found.
std::uint64_t faults();

/// Checks the addresses of lanes and finds them in the memory of the host. Returns the lanes whose access is allowed.
std::uint32_t places(Warp& warp, const Instruction& instruction, std::uint32_t mask, char** places);

/// Shuffles, votes, matches and reductions of the lanes of `mask`.
void warp_sync(Warp& warp, const End& end, std::uint32_t mask);
/// A call of a function of the runtime: printf, and failed assertions.
void call_host(Warp& warp, const End& end, std::uint32_t mask);

}  // namespace emulate
