// Kernels that are recorded once and then started as one.
#pragma once

#include <functional>

namespace softwet {

/// Returns what starts all kernels that `launches` starts, in their order and with the arguments that they have now. On CUDA
/// and HIP they are a graph of the device, so that the host makes one call for all of them. Elsewhere it calls `launches`.
///
/// `launches` starts kernels on the default instance of Exec and does nothing else that a device sees: it copies nothing
/// between memories, allocates nothing and waits for nothing. It has been called before, so that its kernels are loaded, and
/// Kokkos has memory for teams (memory/team_scratch.hpp). While a tool of Kokkos listens nothing can be recorded, since Kokkos
/// waits after each kernel then.
std::function<void()> record(std::function<void()> launches);

}  // namespace softwet
