// The profile of the interface against 40-digit decimals (tests/oracle/interface_profile.py).
#include "kernels/fluid/interface_profile.hpp"

#include <gtest/gtest.h>

#include "scene/equilibrium.hpp"

namespace softwet {
namespace {

struct ProfileRow {
  double theta, part, distance;  ///< s/g where f has this value
};
const ProfileRow profile_rows[] = {
    {0.2, 1e-09, 1.46183964663027},  {0.2, 0.0001, 1.40246980510429},  {0.2, 0.01, 1.20758894164742},
    {0.2, 0.1, 0.804597926990844},   {0.2, 0.3, 0.358058932932725},    {0.2, 0.7, -0.372736663431808},
    {0.2, 0.9, -0.904157109568582},  {0.2, 0.99, -1.64279410260576},   {0.2, 0.9999, -2.89648077001075},
    {0.39, 1e-09, 3.4264145632075},  {0.39, 0.0001, 2.16669569865861}, {0.39, 0.01, 1.58259958745715},
    {0.39, 0.1, 0.997039868516163},  {0.39, 0.3, 0.43701874987585},    {0.39, 0.7, -0.460055700853133},
    {0.39, 0.9, -1.15243091120345},  {0.39, 0.99, -2.23571364190036},  {0.39, 0.9999, -4.21021807837363},
    {0.85, 1e-09, 21.5535433135801}, {0.85, 0.0001, 9.80622805040596}, {0.85, 0.01, 5.0889691474801},
    {0.85, 0.1, 2.56897839467957},   {0.85, 0.3, 1.0323811411361},     {0.85, 0.7, -1.06549902540056},
    {0.85, 0.9, -2.77271845139431},  {0.85, 0.99, -5.77459971933644},  {0.85, 0.9999, -11.5252164762226}};

InterfaceProfile profile_at(double theta, double capillarity) {
  return {VanDerWaals{theta, 0}, coexistence(theta), capillarity};
}

TEST(InterfaceProfile, Table) {
  for (const ProfileRow& r : profile_rows) {
    const InterfaceProfile profile = profile_at(r.theta, 0.03);
    EXPECT_NEAR(profile.liquid(0.03 * r.distance), r.part, 2e-8 * r.part) << r.theta << " " << r.part;
    EXPECT_NEAR(profile.vapour(0.03 * r.distance), 1 - r.part, 1e-8) << r.theta << " " << r.part;
  }
}

TEST(InterfaceProfile, FallsAndHasAMiddle) {
  for (double theta : {0.3, 0.39, 0.85, 0.9999}) {
    const InterfaceProfile profile = profile_at(theta, 1);
    EXPECT_NEAR(profile.liquid(0), 0.5, 1e-8);
    double before = 1;
    for (double s = -30; s < 30; s += 0.01) {
      const double now = profile.liquid(s);
      EXPECT_LE(now, before) << theta << " " << s;
      EXPECT_NEAR(now + profile.vapour(s), 1, 1e-15);
      before = now;
    }
  }
}

/// Deep in a phase f or 1 - f falls by e over g / sqrt(W''), W'' = c^2 / rho, as far out as anybody looks.
TEST(InterfaceProfile, EndsExponentially) {
  const InterfaceProfile profile = profile_at(0.39, 1);
  const double vapour = std::sqrt(0.001352289801) / 0.3363987816, liquid = std::sqrt(0.8666990997) / 2.183979206;
  for (double s : {5.0, 10.0, 40.0})
    EXPECT_NEAR(std::log(profile.liquid(s) / profile.liquid(s + 1)) * vapour, 1, 1e-5) << s;
  for (double s : {8.0, 20.0, 80.0})
    EXPECT_NEAR(std::log(profile.vapour(-s) / profile.vapour(-s - 1)) * liquid, 1, 1e-5) << s;
}

}  // namespace
}  // namespace softwet
