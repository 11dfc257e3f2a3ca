// Schema, first part: the scene. Equation numbers refer to Bueno et al. 2017.
#include "casefile/schema/binding.hpp"
#include "casefile/schema/quality.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {
namespace {

std::vector<Key> domain_keys() {
  return {
      {.name = "name",
       .kind = Kind::text,
       .letters = "_.-",
       .first = "A-Za-z0-9_-",
       .longest = 200,
       .required = true,
       .example = "\"tensotaxis_pull_2d\"",
       .source = "Bueno et al. 2017, Fig. 2, left column; [?] = not stated in the paper",
       .help = "Name of the case, and of its output folder: letters, digits, '_', '-' and '.', 200 at most, and no '.' "
               "in front.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.name; })},
      {.name = "quality",
       .kind = Kind::choice,
       .choices = words_of(Quality{}),
       .help = "Accuracy for speed, measured in docs/tradeoff.md: the values of some keys where the case does not give "
               "them. " +
               describe_qualities(),
       .bind = at([](Case & c, std::size_t) -> auto& { return c.quality; })},
      {.name = "domain.size",
       .kind = Kind::numbers,
       .unit = "L0",
       .range = positive,
       .lengths = of_axes(),
       .required = true,
       .example = "[1.0, 0.5]",
       .source = "solid and fluid together; the last axis is vertical",
       .help = "Extents of the box of solid and fluid: 2 numbers (plane strain) or 3. The last axis is vertical.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.size; })},
      {.name = "domain.elements",
       .kind = Kind::integers,
       .range = {1, 100000, false, false},
       .lengths = of_axes(),
       .required = true,
       .example = "[128, 64]",
       .help = "Elements along each axis; as many numbers as domain.size.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.elements; })},
      {.name = "domain.coordinates",
       .kind = Kind::choice,
       .choices = words_of(Coordinates{}),
       .example = "\"plane\"",
       .help =
           "What the two axes of a 2D case are. \"plane\": x and y; the scene is the same at any depth, and strain is "
           "plane. \"axisymmetric\": the distance r from an axis of symmetry, which is the left side, and the height; "
           "droplets are balls and caps centred on the axis, and masses and energies cover the whole turn.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.coordinates; }),
       .only_in = 2},
      {.name = "domain.degree",
       .kind = Kind::integer,
       .range = {2, 3, false, false},
       .example = "2",
       .help = "Degree p of the B-splines. The fields have p - 1 continuous derivatives inside each material.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.degree; })},
      {.name = "domain.quadrature",
       .kind = Kind::choice,
       .choices = words_of(Quadrature{}),
       .example = "\"full\"",
       .help = "Gauss points of an element along each axis: full has degree + 1, reduced has as many as the degree, "
               "which computes less at each evaluation of the equations.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.quadrature; }),
       .default_note = "\"full\"; \"reduced\" with an explicit time.scheme"},
      {.name = "domain.grading.fine",
       .kind = Kind::choice,
       .choices = words_of(FineElements{}),
       .help = "Where elements have the length domain.size / domain.elements. Elsewhere they grow towards the sides. "
               "\"automatic\" chooses a box from droplets and loads; softwet check and case.toml show which. Of equal "
               "elements "
               "softwet check shows how many \"automatic\" would leave, and whether it was measured in scenes of that "
               "kind that "
               "the path of the droplet is kept.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.grading.fine; }),
       .default_note = "\"everywhere\"; \"box\" where a box is given"},
      {.name = "domain.grading.box",
       .kind = Kind::box,
       .unit = "L0",
       .lengths = of_axes_or_none(),
       .help =
           "Lower and upper corner of the box of fine elements. Keep it four capillarities away from interfaces and "
           "contact lines, also from where they move to: a mesh that grows within an interface drives droplets. Along "
           "a "
           "periodic axis it may reach around the ends, as [-0.2, 0.2] or [0.8, 1.2] of an axis of length 1.",
       .bind = box_of([](Case & c, std::size_t) -> auto& { return c.domain.grading; }),
       .default_note = "[[], []], none"},
      {.name = "domain.grading.coarsest",
       .range = {1, 64, false, false},
       .help = "Longest element over the fine ones.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.grading.coarsest; })},
      {.name = "domain.grading.ratio",
       .range = {1, 2, true, false},
       .help = "Largest ratio of the lengths of two neighbours.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.domain.grading.ratio; })},
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
       .default_note = "90; with a contact_angle_range the angle of the mean cosine",
       .support = Support::wall},
      {.name = "fluid.contact_angle_range",
       .kind = Kind::numbers,
       .unit = "degrees",
       .range = {0, 180, true, true},
       .lengths = {0, 2},
       .help =
           "Hysteresis: receding and advancing contact angle, two numbers in this order. A line between these angles "
           "sticks, up to the creep of fluid.creep_speed. The static angle fluid.contact_angle is then the one whose "
           "cosine is the mean of theirs. It needs wall_law = \"energy\" and implicit steps.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->contact_angle_range; }),
       .default_note = "[], no hysteresis"},
      {.name = "fluid.creep_speed",
       .unit = "sqrt(ab)",
       .range = {1e-5, 1, false, false},
       .help =
           "Speed below which a contact line with a contact_angle_range counts as at rest. A load of x times the one "
           "at which the line comes loose lets it creep at about x / sqrt(1 - x^2) times this speed: choose it a "
           "hundred times smaller than the speeds of interest.",
       .reason = "with less, Newton's method does not find where lines stick",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->creep_speed; })},
      {.name = "fluid.line_friction",
       .unit = "L0 b sqrt(ab)",
       .range = {0, infinity, false, true},
       .help = "Friction mu_f of a contact line that moves with the speed U, so that sigma (cos(static angle) - "
               "cos(dynamic angle)) = mu_f U; 0: none. It needs wall_law = \"energy\" and implicit steps.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->line_friction; })},
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
           "cost (column wall_stretch). \"acts\" adds the derivative of the wall energy by the wall's position: the "
           "energy law is exact, Young's and Neumann's laws hold together, and the pull along the wall is gone. It "
           "needs wall_law = \"energy\", a solid, and a substrate.surface_tension that outweighs it.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->wall_tension; })},
      {.name = "fluid.wall_stretch_exponent",
       .range = {0, 1, false, false},
       .help = "Exponent beta of the wall energy: the wall has a^(1 - beta) f_w for each area that it has before any "
               "stretch, a the deformed over that area. With 0 the energy belongs to the deformed area, as in a "
               "liquid, with 1 to the one before. The effective contact angle has the cosine a^(-beta) "
               "cos(contact_angle); with wall_tension = \"acts\" the tension is (1 - beta) a^(-beta) f_w. A "
               "substrate.prestretch counts in a. It needs wall_law = \"energy\" and a solid.",
       .reason = "between an energy for each deformed area and one for each area before any stretch",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->wall_stretch_exponent; })},
      {.name = "fluid.gravity",
       .kind = Kind::numbers,
       .unit = "ab/L0",
       .lengths = of_axes_or_none(),
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
       .lengths = {0, 2},
       .help = "Densities of vapour and liquid at the start, two numbers in this order.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.fluid->initial; }),
       .default_note = "[], in equilibrium with the curved interface (Kelvin, Laplace)"},
  };
}

}  // namespace

std::vector<Key> scene_keys() {
  std::vector<Key> keys;
  for (auto part : {domain_keys, fluid_keys, substrate_keys, branch_keys, initial_keys, load_keys, needle_keys}) {
    for (Key& key : part()) keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace softwet
