// The automatic box of fine elements around droplets, and the warning about boxes that are too small.
#include "casefile/fine_box.hpp"

#include <gtest/gtest.h>

#include "case/mesh.hpp"

namespace softwet {
namespace {

/// A droplet in a box whose other numbers do not matter.
Case droplet_at(double height, const std::string& fine = "automatic") {
  Case c;
  c.domain.size = {2, 1};
  c.domain.elements = {256, 128};
  c.domain.grading.fine = fine;
  c.fluid = Fluid{};
  c.fluid->capillarity = 1.0 / 64;
  c.fluid->temperature = 0.39;
  c.fluid->contact_angle = 75;
  c.substrate = Substrate{};
  c.substrate->thickness = 0.125;
  c.substrate->young = 0.75;
  c.droplets = {{{1.0, height}, 0.15}};
  return c;
}

TEST(FineBox, AnAutomaticOneDoesNotWarnOfItself) {
  for (double height : {0.125, 0.6}) {
    Case c = droplet_at(height);
    choose_fine_box(c);
    EXPECT_LT(c.domain.grading.upper[1], 1) << "it is smaller than the domain";
    EXPECT_EQ(warning_about_fine_box(c), "") << height;
  }
}

TEST(FineBox, ATooSmallOneIsToldWithItsPlace) {
  for (double height : {0.125, 0.6}) {
    Case c = droplet_at(height);
    choose_fine_box(c);
    c.domain.grading.upper[1] -= 1.5 * c.fluid->capillarity;
    EXPECT_NE(warning_about_fine_box(c).find("along axis 1"), std::string::npos) << height;
  }
}

}  // namespace
}  // namespace softwet
