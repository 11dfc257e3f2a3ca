// Numbers that kernels leave for the host.
#pragma once

#include "memory/array.hpp"

namespace softwet {

/// The host asks for several of them at once, in one copy, and waits once for all.
struct HostNumbers {
  Array device;
  HostArray host;

  HostNumbers(const char* name, int size) : device(name, size), host(mirror_of(device)) {}
  int size() const { return static_cast<int>(device.extent(0)); }
  /// Part [first, last) of the numbers.
  HostNumbers part(int first, int last) const {
    const auto range = Kokkos::make_pair(first, last);
    return {Kokkos::subview(device, range), Kokkos::subview(host, range)};
  }

  /// Copies the numbers to the host, after the kernels that write them were started.
  void ask() const {
    if constexpr (!on_host) Kokkos::deep_copy(Exec(), host, device);
  }
  /// Waits for the numbers that were asked for.
  static void wait() { Exec().fence("softwet: numbers for the host"); }

 private:
  HostNumbers(const Array& of_device, const HostArray& of_host) : device(of_device), host(of_host) {}
};

}  // namespace softwet
