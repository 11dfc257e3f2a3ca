#include "cli/core/kernel_counts.hpp"

#include <Kokkos_Core.hpp>
#include <cstring>

namespace softwet {

namespace {

namespace tools = Kokkos::Tools::Experimental;

KernelCounts counts;
bool copying = false;
tools::EventSet others;

void count_kernel(const char*, std::uint32_t, std::uint64_t* id) {
  *id = 0;
  ++counts.kernels;
}

/// Where the host is the device, a mirror of an array is the array itself.
void count_copy(Kokkos_Profiling_SpaceHandle to, const char* to_name, const void* to_place,
                Kokkos_Profiling_SpaceHandle from, const char* from_name, const void* from_place, std::uint64_t) {
  copying = true;
  const bool of_host = *to_name == 0 || *from_name == 0;  // arrays without a label wrap memory of the host
  if (std::strcmp(to.name, from.name) != 0 || to_place == from_place || of_host) {
    ++counts.copies;
  } else {
    ++counts.kernels;
  }
}

void end_copy() { copying = false; }

/// Kokkos waits after each kernel for the sake of whoever listens; these waits do not count.
void count_wait(const char* name, std::uint32_t, std::uint64_t* id) {
  *id = 0;
  if (!copying && std::strncmp(name, "Kokkos::Tools", 13) != 0) ++counts.waits;
}

void count_allocation(Kokkos_Profiling_SpaceHandle, const char*, const void*, std::uint64_t) { ++counts.allocations; }

}  // namespace

KernelCounter::KernelCounter() {
  counts = {};
  others = tools::get_callbacks();
  tools::EventSet own{};
  tools::set_callbacks(own);
  tools::set_begin_parallel_for_callback(count_kernel);
  tools::set_begin_parallel_reduce_callback(count_kernel);
  tools::set_begin_parallel_scan_callback(count_kernel);
  tools::set_begin_deep_copy_callback(count_copy);
  tools::set_end_deep_copy_callback(end_copy);
  tools::set_begin_fence_callback(count_wait);
  tools::set_allocate_data_callback(count_allocation);
}

KernelCounts KernelCounter::stop() {
  if (counting_) tools::set_callbacks(others);
  counting_ = false;
  return counts;
}

}  // namespace softwet
