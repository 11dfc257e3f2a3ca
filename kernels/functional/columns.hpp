// The columns of history.csv that are integrals of the state: name, unit and meaning of each, once. The tables of the
// host have them too, so there is no Kokkos here.
#pragma once

#include <string_view>

namespace softwet {

constexpr int any_dimension = 0;
/// What a scene has to have, or the cells of a column stay empty.
enum class Needs { nothing, fluid, solid };

/// A name that continues the name of a column, after "_", is a part of this column, which is the sum of its parts. A
/// part without a unit is no column itself.
struct IntegralColumn {
  const char *name, *unit = "", *meaning = "";
  Needs needs = Needs::nothing;
  int dimension = any_dimension;  ///< 2 or 3: only domains of this dimension have the column
};

inline constexpr const char *energy_unit = "a b^2 L0^d", *power_unit = "a b^2 sqrt(ab) L0^(d-1)";
inline constexpr const char* momentum_columns[] = {"momentum_x", "momentum_y", "momentum_z"};

/// In the order in which the table has them and energies are added up.
inline constexpr IntegralColumn integral_columns[] = {
    {"mass", "b L0^d", "Mass of the fluid, liquid and vapour: the integral of the density rho.", Needs::fluid},
    {"momentum_x", "b sqrt(ab) L0^d",
     "Momentum along x: the integral of rho v_x over the fluid and of rho_0^s v_x over the solid."},
    {"momentum_y", "b sqrt(ab) L0^d", "The same along y; in 2D this is the vertical one."},
    {"momentum_z", "b sqrt(ab) L0^d", "The same along z, the vertical.", Needs::nothing, 3},
    {"energy_kinetic", energy_unit,
     "Kinetic energy: the integral of rho |v|^2/2 over the fluid and of rho_0^s |v|^2/2 over the solid."},
    {"energy_free", energy_unit, "Free energy of the fluid: the integral of W(rho) + g^2 |grad rho|^2/2.",
     Needs::fluid},
    {"energy_free_bulk"},
    {"energy_free_gradient"},
    {"energy_wall", energy_unit,
     "Wall energy: the integral of f_w(rho) over the wall, where f_w(rho) = -cos(alpha) g times the integral of sqrt(2 "
     "D) from rho_v to rho. It is the same formula under both wall laws; with fluid.wall_stretch_exponent the "
     "integrand has the factor a^(-beta).",
     Needs::fluid},
    {"energy_elastic", energy_unit,
     "Elastic energy of the solid and its fibres. With saint_venant_kirchhoff the part of the solid is the integral of "
     "lambda tr(E)^2/2 + G E:E. With substrate.prestretch it is what the stretched layer has more than where its "
     "displacement is 0, and may be negative."},
    {"dissipation", power_unit,
     "Energy dissipated per time: the integral of tau : grad v + eps |grad mu|^2. The first part is viscous, the "
     "second belongs to fluid.stabilisation. dissipation_solid and dissipation_wall are further parts."},
    {"dissipation_viscous"},
    {"dissipation_stabilisation"},
    {"wall_stretch", power_unit,
     "Power that the wall energy gains because the wall stretches: the integral of f_w div_Gamma v over the wall, with "
     "fluid.wall_stretch_exponent of (1 - beta) a^(-beta) f_w div_Gamma v. It is 0 with fluid.wall_tension = \"acts\", "
     "where the solid pays for it. With fluid.wall_law = \"energy\" energy_total changes at the rate power_load + "
     "wall_stretch - dissipation, up to the error of the discretisation.",
     Needs::fluid},
    {"energy_gravity", energy_unit,
     "Potential energy in fluid.gravity and substrate.gravity: minus the integral of rho gravity . x over the fluid, "
     "and of rho_0^s gravity . u over the solid, u its displacement. 0 without gravity."},
    {"energy_surface", energy_unit,
     "Energy of the solid's top face: substrate.surface_tension times the growth of its area by the deformation, and "
     "the elastic energy of substrate.surface_modulus.",
     Needs::solid},
    {"energy_foundation", energy_unit,
     "Energy of the springs of boundary.foundation: the integral of (kap_n u_n^2 + kap_t u_t^2)/2 over the undeformed "
     "bottom of the solid.",
     Needs::solid},
    {"energy_branches", energy_unit,
     "Energy in the springs of [[substrate.branch]] and substrate.gel: the sum of the integrals of G_i dev e : dev e "
     "over the solid, e the strain of u - a_i, with the displacement a_i of the dashpot of a branch; under finite "
     "strains e = E - A_i, the Green-Lagrange strain minus what the branch remembers of it.",
     Needs::solid},
    {"dissipation_solid", power_unit,
     "Part of dissipation that belongs to the solid: to substrate.viscosity and substrate.bulk_viscosity, the integral "
     "of S_v : E' over the undeformed solid, E' the rate of the Green-Lagrange strain; to the dashpots of branches, "
     "the sum of the integrals of 2 G_i tau_i dev e' : dev e' with the strain rate e' of a_i', or A_i'; and to "
     "boundary.foundation_damping, the integral of c_n v_n^2 + c_t v_t^2 over its undeformed bottom.",
     Needs::solid},
    {"dissipation_wall", power_unit,
     "Part of dissipation that belongs to fluid.line_friction and fluid.contact_angle_range: the integral of r' (B r' "
     "+ k g sqrt(2 D) h(r'/r0)) over the wall, r' the rate of the density at a point of the wall.",
     Needs::fluid},
    {"liquid_volume", "L0^d",
     "Volume of the liquid: the integral of s^2 (3 - 2 s) over the fluid, where s = (rho - rho_v)/(rho_l - rho_v), not "
     "below 0 and not above 1. It counts liquid as 1, vapour as 0, and an interface up to its middle. Empty without a "
     "fluid.",
     Needs::fluid},
    {"energy_needle", energy_unit,
     "Energy in the springs of the needles: the sum of k w_i |U - u_i|^2/2 over the control values u_i of the "
     "displacement, w_i the integral of their functions over the box of a needle. Exists with a [[needle]], and is a "
     "part of energy_total."},
};

constexpr bool belongs(std::string_view part, std::string_view column) {
  return part.starts_with(column) && (part.size() == column.size() || part[column.size()] == '_');
}
/// Whether a column is the sum of others.
constexpr bool is_sum(std::string_view column) {
  for (const IntegralColumn& other : integral_columns)
    if (other.name != column && belongs(other.name, column)) return true;
  return false;
}

}  // namespace softwet
