// Schema, first part: what is simulated. Equation numbers are those of Bueno et al. 2017.
#include "casefile/binding.hpp"
#include "casefile/quality.hpp"
#include "casefile/schema.hpp"

namespace softwet {
namespace {

std::vector<Key> domain_keys() {
  return {
      {.name = "name",
       .kind = Kind::text,
       .required = true,
       .example = "\"tensotaxis_pull_2d\"",
       .source = "Bueno et al. 2017, Fig. 2, left column; [?] = not stated in the paper",
       .help = "Name of the case, and of its output folder: letters, digits, '_', '-' and '.'.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.name; })},
      {.name = "quality",
       .kind = Kind::choice,
       .choices = {"draft", "standard", "reference"},
       .help = "Accuracy for speed, measured in docs/tradeoff.md: the values of some keys where the case does not give "
               "them. " +
               describe_qualities(),
       .bind = at([](Case & c, std::size_t) -> auto& { return c.quality; })},
      {.name = "domain.size",
       .kind = Kind::numbers,
       .unit = "L0",
       .range = positive,
       .required = true,
       .example = "[1.0, 0.5]",
       .source = "solid and fluid together; the last axis is vertical",
       .help = "Extents of the box of solid and fluid: 2 numbers (plane strain) or 3. The last axis is vertical.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.size; })},
      {.name = "domain.elements",
       .kind = Kind::integers,
       .range = {1, 100000, false, false},
       .required = true,
       .example = "[128, 64]",
       .help = "Elements along each axis; as many numbers as domain.size.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.elements; })},
      {.name = "domain.degree",
       .kind = Kind::integer,
       .range = {2, 3, false, false},
       .example = "2",
       .help = "Degree p of the B-splines. The fields have p - 1 continuous derivatives inside each material.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.degree; })},
      {.name = "domain.quadrature",
       .kind = Kind::choice,
       .choices = {"full", "reduced"},
       .example = "\"full\"",
       .help = "Gauss points of an element along each axis: full has degree + 1, reduced has as many as the degree, "
               "which computes less at each evaluation of the equations.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.quadrature; }),
       .default_note = "\"full\"; \"reduced\" with an explicit time.scheme"},
  };
}

std::vector<Key> fluid_keys() {
  return {
      {.name = "fluid.viscosity",
       .unit = "L0 b sqrt(ab)",
       .range = positive,
       .required = true,
       .example = "\"1/256\"",
       .source = "mu-hat, eq. (9)",
       .help = "Viscosity mu-hat, eq. (9).",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->viscosity; })},
      {.name = "fluid.capillarity",
       .unit = "L0",
       .range = positive,
       .required = true,
       .example = "\"1/64\"",
       .source = "gamma-hat, eq. (8)",
       .help = "Capillarity gamma-hat = sqrt(lambda/a)/L0, eq. (8): half the width of the liquid-vapour interface. "
               "Two elements or more resolve it well.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->capillarity; })},
      {.name = "fluid.temperature",
       .unit = "theta_c",
       .range = {0.3, 1, false, true},
       .required = true,
       .example = "0.39",
       .source = "theta-hat, eq. (10)",
       .help = "Temperature theta-hat, eq. (10).",
       .reason = "there are no two phases above the critical temperature, choose below 1; below 0.3 the vapour is too "
                 "thin to compute",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->temperature; })},
      {.name = "fluid.contact_angle",
       .kind = Kind::profile,
       .unit = "degrees",
       .range = {0, 180, true, true},
       .example = "75.0",
       .source = "measured in the liquid",
       .help = "Static contact angle alpha with the wall, measured in the liquid. Where it varies, it belongs to the "
               "points of "
               "the undeformed wall; it must stay smooth over two elements.",
       .reason = "the liquid wets for angles below 90 and is repelled above",
       .bind = profile_at([](Case & c, std::size_t) -> auto& { return c.fluid->contact_angle; }),
       .support = Support::wall},
      {.name = "fluid.wall_law",
       .kind = Kind::choice,
       .choices = words_of(WallLaw{}),
       .help = "Law that gives the contact angle. \"gradient\" is the paper's |grad rho| cos(alpha). \"energy\" is the "
               "variational wall energy: it has an exact energy law, bears angles near 0 and 180 degrees, and moves "
               "droplets 23 to 40 % more slowly.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->wall_law; })},
      {.name = "fluid.wall_tension",
       .kind = Kind::choice,
       .choices = words_of(WallTensionModel{}),
       .help =
           "Whether the wall energy acts on the wall as a tension. \"none\" is the paper: the fluid pulls with its "
           "full "
           "surface tension, along the wall too, and the wall energy changes with the stretch of the wall at nobody's "
           "cost (column wall_stretch). \"acts\" adds the derivative of the wall energy by the place of the wall: the "
           "energy law is exact, Young's and Neumann's laws hold together, and the pull along the wall is gone. It "
           "needs wall_law = \"energy\", a solid, and a substrate.surface_tension that outweighs it.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->wall_tension; })},
      {.name = "fluid.gravity",
       .kind = Kind::numbers,
       .unit = "ab/L0",
       .help = "Uniform force per unit mass on the fluid, one component for each axis; the last is vertical. The solid "
               "does not feel it, it has substrate.gravity. Periodic sides allow none along their axis.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->gravity; }),
       .default_note = "[], none"},
      {.name = "fluid.traction",
       .kind = Kind::choice,
       .choices = words_of(Traction{}),
       .help =
           "How the capillary force reaches the solid. \"layer\": through the test functions of the elements next to "
           "the wall. \"blended\": through test functions that reach into the fluid as its mesh motion does; the "
           "energy law is then exact in space, and the run is slower.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->traction; })},
      {.name = "fluid.stabilisation",
       .range = {0, 1, false, false},
       .help = "Constant C of the term eps = C h^2 rho^2 / mu-hat, which damps oscillations of the density from one "
               "element to the next and keeps the mass; 0 switches it off.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->stabilisation; })},
      {.name = "fluid.smoothing",
       .unit = "b/L0",
       .range = positive,
       .help = "The wall law \"gradient\" uses sqrt(|grad rho|^2 + d^2) in place of |grad rho|; this is d.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->smoothing; })},
      {.name = "fluid.ambient",
       .kind = Kind::choice,
       .choices = words_of(Phase{}),
       .help = "Phase around the droplets at the start; \"liquid\" makes them bubbles of vapour.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->ambient; })},
      {.name = "fluid.initial",
       .kind = Kind::numbers,
       .unit = "b",
       .range = {0, 0.999, true, false},
       .help = "Densities of vapour and liquid at the start, two numbers in this order.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->initial; }),
       .default_note = "[], those of the equilibrium with the curved interface (Kelvin, Laplace)"},
  };
}

std::vector<Key> substrate_keys() {
  return {
      {.name = "substrate.thickness",
       .unit = "L0",
       .range = positive,
       .required = true,
       .example = "0.125",
       .source = "[?]",
       .help =
           "Height of the solid layer. It is a whole number of rows of elements: less than the height of the domain "
           "with a fluid, equal to it without.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->thickness; })},
      {.name = "substrate.density",
       .unit = "b",
       .range = positive,
       .example = "1.0",
       .source = "[?] rho_0^s / b",
       .help = "Density rho_0^s of the undeformed solid. It also multiplies substrate.young and load[].force.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->density; })},
      {.name = "substrate.young",
       .kind = Kind::profile,
       .unit = "rho_0^s ab",
       .range = positive,
       .required = true,
       .example = "0.7554",
       .source = "E-hat, eq. (12): Young modulus / (rho_0^s ab)",
       .help =
           "Young modulus divided by rho_0^s ab, the E-hat of eq. (12). The Young modulus in units of ab^2 is "
           "substrate.density times this number, so another density is another stiffness; 'softwet check' prints it.",
       .bind = profile_at([](Case & c, std::size_t) -> auto& { return c.substrate->young; }),
       .support = Support::solid},
      {.name = "substrate.poisson",
       .range = {-1, 0.5, true, true},
       .required = true,
       .example = "0.45",
       .source = "eq. (11)",
       .help = "Poisson ratio nu, eq. (11).",
       .reason = "0.5 would be incompressible, choose 0.49 at most for a nearly incompressible solid",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->poisson; })},
      {.name = "substrate.material",
       .kind = Kind::choice,
       .choices = {"saint_venant_kirchhoff", "neo_hookean"},
       .help = "Law of the solid. saint_venant_kirchhoff is that of the paper; it softens when it is squeezed hard. "
               "neo_hookean is compressible and stays stiff under any compression. For small strains both are Hooke's "
               "law, with the same young and poisson.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->material; })},
      {.name = "substrate.strain",
       .kind = Kind::choice,
       .choices = {"finite", "small"},
       .help = "Strain of the solid. finite is what substrate.material says. small is the limit of linear elasticity, "
               "Hooke's law, in place of the material: for deformations of a few per cent.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->strain; })},
      {.name = "substrate.inertia",
       .kind = Kind::choice,
       .choices = {"full", "none"},
       .help =
           "Inertia of the solid. none leaves the solid in equilibrium with the fluid and the loads at every time: for "
           "motion that is slow against elastic waves. Explicit schemes need full.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->inertia; })},
      {.name = "substrate.viscosity",
       .unit = "L0 b sqrt(ab)",
       .range = {0, infinity, false, true},
       .help =
           "Shear viscosity eta of the solid, beside its elasticity (Kelvin-Voigt): stress 2 eta dev(E') for the rate "
           "E' "
           "of the Green-Lagrange strain. A shear wave of wave number k is damped at the rate eta k^2 / (2 rho_0^s).",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->viscosity; })},
      {.name = "substrate.bulk_viscosity",
       .unit = "L0 b sqrt(ab)",
       .range = {0, infinity, false, true},
       .help = "Bulk viscosity zeta of the solid: stress zeta tr(E').",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->bulk_viscosity; })},
      {.name = "substrate.surface_tension",
       .unit = "a b^2 L0",
       .range = {0, infinity, false, true},
       .help = "Surface tension of the solid's dry top face, the same at any stretch. Soft gels need it: where the "
               "elastocapillary length sigma/E is as long as the interface is wide, it holds the ridge at the contact "
               "line. "
               "'softwet units' converts from mN/m.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->surface_tension; })},
      {.name = "substrate.surface_tension_wet",
       .unit = "a b^2 L0",
       .range = {0, infinity, false, true},
       .help =
           "Surface tension of the top face below liquid, where it is given by hand. No energy belongs to a difference "
           "that is given by hand; fluid.wall_tension = \"acts\" gives the one that follows from the contact angle.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->surface_tension_wet; }),
       .default_note = "that of the dry face"},
      {.name = "substrate.gravity",
       .kind = Kind::numbers,
       .unit = "ab/L0",
       .help = "Uniform force per unit mass on all of the solid, one component for each axis; the last is vertical.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->gravity; }),
       .default_note = "[], none"},
      {.name = "substrate.fibre.stiffness",
       .unit = "a b^2",
       .range = {0, infinity, false, true},
       .help = "Stiffness k of parallel fibres in the solid: energy k/2 (I_4 - 1)^2 of each volume beside that of the "
               "material, I_4 the square of the fibres' stretch. Small strains along them meet 4 k more.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->fibre.stiffness; })},
      {.name = "substrate.fibre.angle",
       .unit = "degrees",
       .range = {-180, 180, false, false},
       .help = "Direction of the fibres in the undeformed solid: angle above the plane of the wall, in 2D from x.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->fibre.angle; })},
      {.name = "substrate.fibre.azimuth",
       .unit = "degrees",
       .range = {-180, 180, false, false},
       .help = "Direction of the fibres in the plane of the wall, from x towards y.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->fibre.azimuth; }),
       .three_dimensional = true},
  };
}

std::vector<Key> load_keys() {
  constexpr Range not_negative{0, infinity, false, true};
  return {
      {.name = "load[].box",
       .kind = Kind::box,
       .unit = "L0",
       .required = true,
       .example = "[[0.7, 0.0], [0.8, 0.125]]",
       .source = "[?]",
       .help = "Lower and upper corner of the loaded part of the solid, in the undeformed state.",
       .bind = box_of([](Case & c, std::size_t i) -> auto& { return c.loads[i]; })},
      {.name = "load[].force",
       .kind = Kind::numbers,
       .unit = "ab/L0",
       .required = true,
       .example = "[0.16215, 0.0]",
       .source = "f-hat, eq. (13)",
       .help = "Force per unit mass f-hat, eq. (13), at its full strength: one component for each axis, the last is "
               "vertical.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.loads[i].force; })},
      {.name = "load[].start",
       .unit = "L0/sqrt(ab)",
       .range = not_negative,
       .example = "30.0",
       .source = "[?] after relaxation; time zero of the output is the start of the load",
       .help =
           "Run time at which the load begins. Run time is 0 at the beginning of the computation; the time t of all "
           "results is 0 when the first load begins. 'softwet check' prints both.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.loads[i].start; })},
      {.name = "load[].ramp",
       .unit = "L0/sqrt(ab)",
       .range = not_negative,
       .example = "5.0",
       .source = "[?]",
       .help = "Duration over which the force grows linearly from 0 to its full strength.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.loads[i].ramp; })},
      {.name = "load[].factor",
       .kind = Kind::profile,
       .help = "Factor of the force over time, beside the ramp: the force is load[].force times the ramp times this. A "
               "factor "
               "of \"sin(2*pi*t/5)\" shakes the box with the period 5.",
       .bind = profile_at([](Case & c, std::size_t i) -> auto& { return c.loads[i].factor; }),
       .support = Support::time},
      {.name = "load[].path",
       .kind = Kind::profiles,
       .unit = "L0",
       .help = "Displacement of the box over time, one entry for each axis: [\"0.1*t\", 0.0] moves it along x. Round a "
               "periodic "
               "axis it comes in on the other side; what leaves the solid elsewhere does not act.",
       .bind = profile_at([](Case & c, std::size_t i) -> auto& { return c.loads[i].path; }),
       .default_note = "[], the box rests",
       .support = Support::time},
  };
}

}  // namespace

std::vector<Key> scene_keys() {
  std::vector<Key> keys;
  for (auto part : {domain_keys, fluid_keys, substrate_keys, initial_keys, load_keys}) {
    for (Key& key : part()) keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace softwet
