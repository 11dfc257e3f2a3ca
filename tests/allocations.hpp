// How often a test program asks for memory.
#pragma once

#include <atomic>

namespace softwet::testing_tools {

/// Calls of `operator new` for more than a few words (256 bytes); a test may set it, and count further ones.
extern std::atomic<long> large_allocations;

}  // namespace softwet::testing_tools
