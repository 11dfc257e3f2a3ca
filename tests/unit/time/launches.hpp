// Counts of the requests to a device, by name.
#pragma once

#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>
#include <cstring>
#include <map>

#include "unit/scene/scenes.hpp"
#include "unit/time/first_steps.hpp"

namespace softwet::testing_tools {

/// Kernels, among which are copies within the memory of the device; copies to the host and from it; and waits.
struct Counts {
  std::map<std::string, int> kernels, copies, waits;
};
inline Counts counted;

inline void count_kernel(const char* name, std::uint32_t, std::uint64_t* id) {
  *id = 0;
  ++counted.kernels[name];
}

inline void count_copy(Kokkos::Tools::SpaceHandle to, const char* name, const void*, Kokkos::Tools::SpaceHandle from,
                       const char*, const void*, std::uint64_t) {
  const bool across = std::strcmp(to.name, from.name) != 0;
  ++(across ? counted.copies : counted.kernels)[std::string("copy to ") + name];
}

/// A fence of all spaces counts once. Fences that Kokkos makes for its tools do not belong to the program.
inline void count_wait(const char* name, std::uint32_t space, std::uint64_t* id) {
  *id = 0;
  if (space != Kokkos::Tools::Experimental::device_id(Exec())) return;
  if (std::string(name).find("Profile Tool Fence") == std::string::npos) ++counted.waits[name];
}

template <class Work>
Counts counts_of(const Work& work) {
  namespace tools = Kokkos::Tools::Experimental;
  const tools::EventSet before = tools::get_callbacks();
  tools::set_begin_parallel_for_callback(count_kernel);
  tools::set_begin_parallel_reduce_callback(count_kernel);
  tools::set_begin_deep_copy_callback(count_copy);
  tools::set_begin_fence_callback(count_wait);
  counted = {};
  work();
  tools::set_callbacks(before);
  return counted;
}

template <int D>
Counts counts_of_a_step(Case c) {
  c.time.scheme = TimeScheme::kick_drift;
  c.time.end = 1;
  const Scene<D, 2> scene(c);
  Stepper<D, 2> stepper(scene, c, {});
  take_first_steps(stepper, scene, c);
  return counts_of([&] { stepper.step(); });
}

inline int sum(const std::map<std::string, int>& counts) {
  int all = 0;
  std::string list;
  for (const auto& [name, count] : counts) {
    all += count;
    list += ", " + std::to_string(count) + " " + name;
  }
  std::printf("  %d%s\n", all, list.c_str());
  return all;
}

}  // namespace softwet::testing_tools
