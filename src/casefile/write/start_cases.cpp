#include "casefile/write/start_cases.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "casefile/case_file.hpp"

namespace softwet {
namespace {

struct StartCase {
  const char* scene;
  const char* text;  ///< without the name of the case
};

constexpr StartCase all_start_cases[]{{"pattern", R"toml(
# A droplet on a stripe of a rigid wall that wets better than the wall around it: 60 degrees and 110.
[domain]
size = [1.0, 0.5]
elements = [128, 64]

[fluid]
viscosity = "1/256"
capillarity = "1/64"       # half the width of the interface: two elements
temperature = 0.39         # over the critical one; the vapour has 1/641 of the liquid's density
contact_angle = "85 + 25*tanh((abs(x - 0.5) - 0.15)/0.015)"  # degrees; a number, an expression or a table
wall_law = "energy"

[[droplet]]
centre = [0.5, 0.0]        # on the wall
radius = 0.221

[boundary]
bottom = "no_slip"

[time]
end = 100.0

[output]
fields = { times = [0.0, 10.0, 100.0] }
)toml"},
                                      {"needle", R"toml(
# A droplet of water on a gel (2D), and a needle that sticks in the gel beside it and pulls it away: the droplet follows.
[laboratory]
length = "100 um"          # L0, a length of 1 in the other tables
surface_tension = "72 mN/m"
density = "1000 kg/m3"
viscosity = "10 mPa.s"
capillarity = "8.333333333 um"  # half the width of the interface: two elements
radius = "100 um"
thickness = "100 um"
young = "3 kPa"
solid_surface_tension = "50 mN/m"
solid_viscosity = "1 Pa.s"

[domain]
size = [6.0, 3.5]
elements = [144, 84]
grading = { fine = "automatic", coarsest = 8 }

[fluid]
temperature = 0.39         # over the critical one
contact_angle = 90.0       # degrees
wall_law = "energy"
wall_tension = "acts"

[substrate]
poisson = 0.45
material = "neo_hookean"

[[droplet]]
centre = [2.5, 1.0]        # on the gel

[[needle]]
box = [[4.75, 0.25], [5.0, 1.0]]      # what it holds of the gel
path = ["0.05*min(t/30, 1)", 0.0]     # where it goes, over the time t: 5 um
stiffness = 5e3            # holds almost rigidly; its force is needle_force_x in history.csv

[time]
start = "equilibrium"      # the scene comes to rest before the needle moves
end = 300.0
)toml"},
                                      {"impact", R"toml(
# A droplet falls onto a soft layer, dents it, spreads and springs back a little.
[domain]
size = [1.0, 1.0]
elements = [64, 64]

[fluid]
viscosity = 3e-4
capillarity = "1/48"       # half the width of the interface
temperature = 0.85         # near the critical one: the vapour between droplet and layer is thick
contact_angle = 75.0       # degrees
wall_law = "energy"

[substrate]
thickness = 0.125
young = 0.3                # Young's modulus over the density of the solid
poisson = 0.4

[[droplet]]
centre = [0.5, 0.49]       # in the air
radius = 0.15
velocity = [0.0, -0.15]

[boundary]
bottom = "no_slip"         # glued to the ground

[time]
scheme = "kick_drift"      # explicit steps, fast where waves have to be followed anyway
end = 5.0

[output]
fields = { times = [0.0, 1.5, 2.0, 3.0, 5.0] }
)toml"},
                                      {"3d", R"toml(
# A droplet on a rigid wall that wets better to the right, in 3D, on a coarse mesh: it moves there.
[domain]
size = [1.4, 1.24, 0.6]
elements = [35, 31, 15]

[fluid]
viscosity = 0.05
capillarity = 0.08         # half the width of the interface: two elements
temperature = 0.39         # over the critical one; the vapour has 1/641 of the liquid's density
contact_angle = "90 - 25*(x - 0.7)"  # degrees; a number, an expression or a table
wall_law = "energy"

[[droplet]]
centre = [0.62, 0.62, 0.0]   # on the wall; a table [substrate] would put it on a solid
radius = 0.24

[boundary]
bottom = "no_slip"

[time]
end = 10.0

[output]
fields = { times = "0:10:3" }
)toml"}};

}  // namespace

std::vector<std::string> start_cases() {
  std::vector<std::string> names;
  for (const StartCase& start : all_start_cases) names.emplace_back(start.scene);
  return names;
}

std::string start_case(const std::string& scene, const std::string& name) {
  const auto found = std::find_if(std::begin(all_start_cases), std::end(all_start_cases),
                                  [&](const StartCase& start) { return scene == start.scene; });
  initial_case(name);  // refuses what cannot be the name of a case
  return fmt::format("name = \"{}\"\n{}", name, found->text);
}

}  // namespace softwet
