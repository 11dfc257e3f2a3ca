// Schema, the solid, its loads and needles. Equation numbers are those of Bueno et al. 2017.
#include "casefile/schema/binding.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {

std::vector<Key> substrate_keys() {
  return {
      {.name = "substrate.thickness",
       .unit = "L0",
       .range = positive,
       .required = true,
       .example = "0.125",
       .source = "[?]",
       .help = "Height of the solid layer. It is a whole number of rows of elements: less than the height of the "
               "domain with a fluid, equal to it without.",
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
      {.name = "substrate.joint",
       .unit = "L0",
       .range = {0, infinity, false, true},
       .help =
           "Height in the solid at which two materials are joined: substrate.young may jump there, and the slope of "
           "the displacement with it. It is the end of a row of elements. Without it, 0, a jump is smeared over a row.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->joint; })},
      {.name = "substrate.poisson",
       .range = {-1, 0.5, true, true},
       .required = true,
       .example = "0.45",
       .source = "eq. (11)",
       .help = "Poisson ratio nu, eq. (11).",
       .reason = "0.5 would be incompressible, choose 0.49 at most for a nearly incompressible solid",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->poisson; })},
      {.name = "substrate.volume_quadrature",
       .kind = Kind::choice,
       .choices = words_of(VolumeQuadrature{}),
       .help = "How the stiffness against changes of volume is integrated. full: at all points. selective: what a "
               "solid with nu = 0.4 has at all points, and the rest for the means over elements, so that a nearly "
               "incompressible solid does not lock. Up to nu = 0.4 both are the same.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->volume_quadrature; })},
      {.name = "substrate.material",
       .kind = Kind::choice,
       .choices = words_of(MaterialModel{}),
       .help = "Law of the solid. saint_venant_kirchhoff is the paper's; it softens when it is squeezed hard. "
               "neo_hookean is compressible and stays stiff under any compression. For small strains both are Hooke's "
               "law, with the same young and poisson.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->material; })},
      {.name = "substrate.strain",
       .kind = Kind::choice,
       .choices = words_of(Strain{}),
       .help = "Strain of the solid. finite is what substrate.material says. small is the limit of linear elasticity, "
               "Hooke's law, in place of the material: for deformations of a few per cent.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->strain; })},
      {.name = "substrate.inertia",
       .kind = Kind::choice,
       .choices = words_of(Inertia{}),
       .help = "Inertia of the solid. none leaves the solid in equilibrium with the fluid and the loads at every time: "
               "for motion that is slow against elastic waves. Explicit schemes need full.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->inertia; })},
      {.name = "substrate.prestretch",
       .kind = Kind::numbers,
       .range = {0.4, 3, false, false},
       .lengths = {0, 1, 2},
       .help = "Stretch along the wall before the scene begins: [l_1] in 2D, where the strain stays plane, [l_1, l_2] "
               "along x and y in 3D, [l] along r and around the axis in (r, z). The height of the layer adapts so that "
               "its top is free of stress. All lengths, the density and the viscosity refer to the stretched layer, "
               "young to the material before, and the displacement counts from the stretched state. The sides have to "
               "hold the stretch. With it choose material = \"neo_hookean\".",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->prestretch; }),
       .default_note = "[], none"},
      {.name = "substrate.viscosity",
       .unit = "L0 b sqrt(ab)",
       .range = {0, infinity, false, true},
       .help = "Shear viscosity eta of the solid, beside its elasticity (Kelvin-Voigt): stress 2 eta dev(E') for the "
               "rate E' of the Green-Lagrange strain. A shear wave of wave number k is damped at the rate eta k^2 / (2 "
               "rho_0^s).",
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
               "line. docs/your_droplet.md gets it from mN/m.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->surface_tension; })},
      {.name = "substrate.surface_tension_wet",
       .unit = "a b^2 L0",
       .range = {0, infinity, false, true},
       .help =
           "Surface tension of the top face below liquid, where it is given by hand. No energy belongs to a difference "
           "that is given by hand; fluid.wall_tension = \"acts\" gives the one that follows from the contact angle.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->surface_tension_wet; }),
       .default_note = "as on the dry face"},
      {.name = "substrate.surface_modulus",
       .kind = Kind::numbers,
       .unit = "a b^2 L0",
       .range = {0, infinity, false, true},
       .lengths = {0, 2},
       .help = "Moduli [lambda_s, G_s] of the solid's top face, which then resists stretch along itself: energy "
               "lambda_s/2 (tr E_s)^2 + G_s E_s : E_s of each undeformed area, with the Green strain E_s of the face, "
               "whose stress is the second Piola-Kirchhoff stress. In 2D only lambda_s + 2 G_s counts. Its energy is "
               "part of energy_surface.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->surface_modulus; }),
       .default_note = "[], none"},
      {.name = "substrate.gravity",
       .kind = Kind::numbers,
       .unit = "ab/L0",
       .lengths = of_axes_or_none(),
       .help = "Uniform force per unit mass on all of the solid, one component for each axis; the last is vertical.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->gravity; }),
       .default_note = "[], none"},
      {.name = "substrate.fibre.stiffness",
       .unit = "a b^2",
       .range = {0, infinity, false, true},
       .help = "Stiffness k of parallel fibres in the solid: energy k/2 (I_4 - 1)^2 of each volume beside the "
               "material's, I_4 the square of the fibres' stretch. Small strains along them meet 4 k more.",
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
       .only_in = 3},
      {.name = "substrate.gel.exponent",
       .range = {0, 1, false, true},
       .help = "Exponent n of a gel whose shear modulus grows with the angular frequency w, G (1 + (i w time)^n), G "
               "from young and poisson; 0: none. It stands for the branches and the viscosity that come closest to it "
               "in gel.decades, beside those that are given. 'softwet check' prints them and how close they come.",
       .reason = "1 would be substrate.viscosity = G time",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->gel.exponent; })},
      {.name = "substrate.gel.time",
       .unit = "L0/sqrt(ab)",
       .range = {0, infinity, false, true},
       .help = "Time of gel.exponent: at w = 1/time the growing part of the modulus is as large as G.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->gel.time; })},
      {.name = "substrate.gel.decades",
       .kind = Kind::numbers,
       .range = {-12, 12, false, false},
       .lengths = {2},
       .help = "Decades of w time between which gel.exponent has to hold: [-2, 2] is 0.01 < w time < 100. 1.5 branches "
               "stand for a decade, and for one more on both sides, up to 12 in all. A motion of the speed V over the "
               "length l has w = V/l.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.substrate->gel.decades; })},
  };
}

std::vector<Key> branch_keys() {
  return {
      {.name = "substrate.branch[].modulus",
       .unit = "a b^2",
       .range = positive,
       .required = true,
       .example = "0.26",
       .help = "Shear modulus G_i of the branch. A deformation that is faster than its time meets it in addition to "
               "that of the solid at rest, E / (2 (1 + nu)).",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.substrate->branches[i].modulus; })},
      {.name = "substrate.branch[].time",
       .unit = "L0/sqrt(ab)",
       .range = positive,
       .required = true,
       .example = "1.0",
       .help = "Time tau_i in which the stress of the branch fades. The viscosity of a slow motion is G_i tau_i.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.substrate->branches[i].time; })},
  };
}

std::vector<Key> load_keys() {
  constexpr Range not_negative{0, infinity, false, true};
  return {
      {.name = "load[].box",
       .kind = Kind::box,
       .unit = "L0",
       .lengths = of_axes(),
       .required = true,
       .example = "[[0.7, 0.0], [0.8, 0.125]]",
       .source = "[?]",
       .help = "Lower and upper corner of the loaded part of the solid, in the undeformed state.",
       .bind = box_of([](Case & c, std::size_t i) -> auto& { return c.loads[i]; })},
      {.name = "load[].force",
       .kind = Kind::numbers,
       .unit = "ab/L0",
       .lengths = of_axes(),
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
       .help = "Run time at which the load begins. Run time is 0 at the beginning of the computation; the time t of "
               "all results is 0 when the first load begins. 'softwet check' prints both.",
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
               "factor of \"sin(2*pi*t/5)\" shakes the box with the period 5.",
       .bind = profile_at([](Case & c, std::size_t i) -> auto& { return c.loads[i].factor; }),
       .support = Support::time},
      {.name = "load[].path",
       .kind = Kind::profiles,
       .unit = "L0",
       .lengths = of_axes_or_none(),
       .help = "Displacement of the box over time, one entry for each axis: [\"0.1*t\", 0.0] moves it along x, and so "
               "does the table [[0, 0, 0], [10, 1, 0]], linear between its times. Round a periodic axis it comes in on "
               "the other side; what leaves the solid elsewhere does not act.",
       .bind = profile_at([](Case & c, std::size_t i) -> auto& { return c.loads[i].path; }),
       .default_note = "[], the box rests",
       .support = Support::time},
  };
}

std::vector<Key> needle_keys() {
  return {
      {.name = "needle[].box",
       .kind = Kind::box,
       .unit = "L0",
       .lengths = of_axes(),
       .required = true,
       .example = "[[0.7, 0.0], [0.8, 0.125]]",
       .help = "Lower and upper corner of the part of the solid that the needle holds, in the undeformed state. It "
               "moves with the needle.",
       .bind = box_of([](Case & c, std::size_t i) -> auto& { return c.needles[i]; })},
      {.name = "needle[].stiffness",
       .unit = "a b^2/L0^2",
       .range = positive,
       .required = true,
       .example = "1e5",
       .help = "Stiffness k of the springs between the needle and its box: force k (U - u) for each volume, U the "
               "position of the needle and u the displacement. With the Young modulus E, elements of h and a box of "
               "the width w, 100 E/h^2 holds rigidly, and E/w^2 yields as much as the solid. An explicit step is at "
               "most about 1.8 sqrt(rho_0^s/k).",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.needles[i].stiffness; })},
      {.name = "needle[].path",
       .kind = Kind::profiles,
       .unit = "L0",
       .lengths = of_axes_or_none(),
       .help = "Displacement U of the needle over time, one entry for each axis: [\"0.1*t\", 0.0] moves the box along "
               "x, and so does the table [[0, 0, 0], [10, 1, 0]], linear between its times. Before t = 0 the needle "
               "stands where it is then. In axisymmetric scenes it moves along the second axis alone.",
       .bind = profile_at([](Case & c, std::size_t i) -> auto& { return c.needles[i].path; }),
       .default_note = "[], the needle holds the box where it is",
       .support = Support::time},
  };
}

}  // namespace softwet
