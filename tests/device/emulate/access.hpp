// What the sources of accesses share: checks and counts of the accesses of a warp to memory.
#pragma once

#include <cstdint>

#include "lanes.hpp"

namespace emulate {

/// 32-byte sectors that the lanes touch.
int sectors(const std::uint64_t* address, std::uint32_t mask, unsigned bytes);

/// Cycles of the banks: 128 bytes in a cycle, so a warp in one, two or four parts; in each part as many as a bank has different words.
/// `least`: without conflicts.
int bank_cycles(const std::uint64_t* offset, std::uint32_t mask, unsigned bytes, int& least);

/// Looks for races of warps in shared memory, and for reads of what no thread has written.
void check_shared(Warp& w, const Instruction& i, std::uint32_t mask, const std::uint64_t* offset, unsigned bytes);

/// Looks for races of lanes of a warp. Before check_shared, which forgets who wrote last.
void check_lanes(Warp& w, const Instruction& i, std::uint32_t mask, const std::uint64_t* offset, unsigned bytes);

}  // namespace emulate
