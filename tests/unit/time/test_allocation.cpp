// No array is allocated inside a time step after the first ones.
#include <gtest/gtest.h>

#include <Kokkos_Core.hpp>

#include "case/case.hpp"
#include "unit/time/first_steps.hpp"

namespace softwet {
namespace {

int allocations = 0;
std::string last_label;

void count_allocation(Kokkos::Tools::SpaceHandle, const char* label, const void*, std::uint64_t) {
  ++allocations;
  last_label = label;
}

Case small_droplet() {
  Case c;
  c.name = "small";
  c.domain = {.size = {1.0, 0.5}, .elements = {24, 12}, .degree = 2};
  c.fluid = Fluid{};
  c.fluid->viscosity = 1.0 / 64;
  c.fluid->capillarity = 1.0 / 12;
  c.fluid->temperature = 0.85;
  c.fluid->contact_angle = 75;
  c.substrate = Substrate{.thickness = 1.0 / 8, .density = 1.0, .young = 0.75, .poisson = 0.45};
  c.droplets.push_back({{0.5, 0.125}, 0.2});
  c.boundary.side[1][1] = Side::no_slip;
  c.time.end = 1;
  return c;
}

TEST(Allocation, NoneInsideAStep) {
  const Case c = small_droplet();
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  testing_tools::take_first_steps(stepper, scene, c);
  Kokkos::Tools::Experimental::set_allocate_data_callback(count_allocation);
  allocations = 0;
  for (int i = 0; i < 5; ++i) stepper.step();
  Kokkos::Tools::Experimental::set_allocate_data_callback(nullptr);
  EXPECT_EQ(allocations, 0) << "last: " << last_label;
}

}  // namespace
}  // namespace softwet
