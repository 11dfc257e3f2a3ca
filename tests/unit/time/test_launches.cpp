// How many kernels and copies an explicit step starts. On a device each costs some microseconds, however small the scene is.
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>
#include <map>

#include "unit/model/scenes.hpp"
#include "unit/time/first_steps.hpp"

namespace softwet::testing_tools {
namespace {

std::map<std::string, int> started;

void count_kernel(const char* name, std::uint32_t, std::uint64_t* id) {
  *id = 0;
  ++started[name];
}

void count_copy(Kokkos::Tools::SpaceHandle, const char* to, const void*, Kokkos::Tools::SpaceHandle, const char*,
                const void*, std::uint64_t) {
  ++started[std::string("copy to ") + to];
}

/// Kernels and copies of a step, by name.
std::map<std::string, int> launches_of_a_step(Case c) {
  c.time.scheme = "kick_drift";
  c.time.end = 1;
  const Model<2, 2> model(c);
  Stepper<2, 2> stepper(model, c, {});
  take_first_steps(stepper, model, c);
  const Kokkos::Tools::Experimental::EventSet before = Kokkos::Tools::Experimental::get_callbacks();
  Kokkos::Tools::Experimental::set_begin_parallel_for_callback(count_kernel);
  Kokkos::Tools::Experimental::set_begin_parallel_reduce_callback(count_kernel);
  Kokkos::Tools::Experimental::set_begin_deep_copy_callback(count_copy);
  started.clear();
  stepper.step();
  Kokkos::Tools::Experimental::set_callbacks(before);
  return started;
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

// They are far more than a device would like; whoever adds one sees it here.
TEST(Launches, OfAnExplicitStepAreNoMoreThanTheyWere) {
  EXPECT_LE(sum(launches_of_a_step(scene(Scene::rigid, WallLaw::energy))), 104);
  EXPECT_LE(sum(launches_of_a_step(scene(Scene::coupled, WallLaw::energy))), 138);
}

}  // namespace
}  // namespace softwet::testing_tools
