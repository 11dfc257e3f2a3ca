// Numbers that kernels leave for the host.
#pragma once

#include "memory/array.hpp"

namespace softwet {

/// The host asks for several of them, and waits once for all.
struct HostNumbers {
  Array device;
  Array::host_mirror_type host;

  HostNumbers(const char* name, int size) : device(name, size), host(Kokkos::create_mirror_view(device)) {}

  /// After the kernels that write them were started.
  void ask() const {
    if constexpr (!on_host) Kokkos::deep_copy(Exec(), host, device);
  }
  /// What has been asked for is there.
  static void wait() { Exec().fence("softwet: numbers for the host"); }
};

}  // namespace softwet
