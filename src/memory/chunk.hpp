// How kernels are cut for the machine: all sizes that a processor and a device want different are given by these
// functions.
#pragma once

#include "memory/array.hpp"

namespace softwet {

/// Neighbouring entries that one item of a kernel takes: on a processor so many as its vector registers and nearest
/// cache hold; on a device one, where nothing else is said, so that neighbouring threads have neighbouring entries.
constexpr int chunk(int of_processor, int of_device = 1) { return host_algorithms ? of_processor : of_device; }

/// Chunks of so many entries that `count` entries make.
KOKKOS_FORCEINLINE_FUNCTION constexpr int chunks_in(int count, int entries) { return (count + entries - 1) / entries; }

/// Threads of a team, or lanes of one of its threads: one where kernels run on the host.
constexpr int team_size(int of_device) { return on_host ? 1 : of_device; }

}  // namespace softwet
