// How many kernels and copies an explicit step starts, and how often it waits for them. On a device each costs some
// microseconds, however small the scene is.
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>
#include <map>

#include "unit/scene/scenes.hpp"
#include "unit/time/first_steps.hpp"

namespace softwet::testing_tools {
namespace {

std::map<std::string, int> started, fences;

void count_kernel(const char* name, std::uint32_t, std::uint64_t* id) {
  *id = 0;
  ++started[name];
}

void count_copy(Kokkos::Tools::SpaceHandle, const char* to, const void*, Kokkos::Tools::SpaceHandle, const char*,
                const void*, std::uint64_t) {
  ++started[std::string("copy to ") + to];
}

/// A fence of all spaces counts once. Those that Kokkos makes for its tools are none of the program's.
void count_fence(const char* name, std::uint32_t space, std::uint64_t* id) {
  *id = 0;
  if (space != Kokkos::Tools::Experimental::device_id(Exec())) return;
  if (std::string(name).find("Profile Tool Fence") == std::string::npos) ++fences[name];
}

/// What a step has started and waited for, by name.
struct Counts {
  std::map<std::string, int> started, fences;
};
Counts counts_of_a_step(Case c) {
  c.time.scheme = TimeScheme::kick_drift;
  c.time.end = 1;
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  take_first_steps(stepper, scene, c);
  const Kokkos::Tools::Experimental::EventSet before = Kokkos::Tools::Experimental::get_callbacks();
  Kokkos::Tools::Experimental::set_begin_parallel_for_callback(count_kernel);
  Kokkos::Tools::Experimental::set_begin_parallel_reduce_callback(count_kernel);
  Kokkos::Tools::Experimental::set_begin_deep_copy_callback(count_copy);
  Kokkos::Tools::Experimental::set_begin_fence_callback(count_fence);
  started.clear();
  fences.clear();
  stepper.step();
  Kokkos::Tools::Experimental::set_callbacks(before);
  return {started, fences};
}

int sum(const std::map<std::string, int>& counts) {
  int all = 0;
  std::string list;
  for (const auto& [name, count] : counts) {
    all += count;
    list += ", " + std::to_string(count) + " " + name;
  }
  std::printf("  %d%s\n", all, list.c_str());
  return all;
}

// Whoever adds one sees it here. The integrals that find a folded mesh wait by themselves. The algorithms of a device start one more for
// what the tiles of a term have summed, and none that zeroes a vector.
TEST(Launches, AnExplicitStepIsFewOfThemAndOneWait) {
  const Counts rigid = counts_of_a_step(small_case(SceneKind::rigid, WallLaw::energy));
  EXPECT_LE(sum(rigid.started), host_algorithms ? 39 : 43);
  EXPECT_EQ(sum(rigid.fences), 1);
  const Counts coupled = counts_of_a_step(small_case(SceneKind::coupled, WallLaw::energy));
  EXPECT_LE(sum(coupled.started), host_algorithms ? 56 : 62);
  EXPECT_LE(sum(coupled.fences), 3);
}

}  // namespace
}  // namespace softwet::testing_tools
