#include "observe/host/table_columns.hpp"

#include <cctype>
#include <stdexcept>

#include "observe/host/field_table.hpp"

namespace softwet {
namespace {

const char* const time_unit = "L0/sqrt(ab)";
const char* const speed_unit = "sqrt(ab)";

/// The integrals of the state from one to another.
std::vector<Column> integrals(std::string_view first, std::string_view last) {
  std::vector<Column> all;
  const IntegralColumn* one = integral_columns;
  while (one->name != first) ++one;
  do {
    if (*one->unit) all.push_back({one->name, one->unit, one->meaning, one->dimension, one->needs});
  } while ((one++)->name != last);
  return all;
}
std::vector<Column> joined(std::initializer_list<std::vector<Column>> lists) {
  std::vector<Column> all;
  for (const std::vector<Column>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// The first columns of history.csv, which every run has.
const std::vector<Column> before_integrals{
    {"step", "", "Number of the time step. Step 0 is the initial state."},
    {"t", time_unit,
     "Time at the end of the step. It is 0 at the start of the first load and negative during the relaxation before."},
    {"dt", time_unit, "Length of the step that ends at t."},
    {"newton", "", "Newton iterations of the step, without those of attempts that were rejected."},
    {"krylov", "", "GMRES iterations of the step, without those of attempts that were rejected."},
};
const Column power_load{"power_load", power_unit,
                        "Power of the loads: the integral of rho_0^s f.v over their boxes, at time t."};
const std::vector<Column> of_extremes{
    {"rho_min", "b", "Smallest control value of the density. The density itself is nowhere smaller.", any_dimension,
     Needs::fluid},
    {"rho_max", "b", "Largest control value of the density. The density itself is nowhere larger.", any_dimension,
     Needs::fluid},
    {"speed_max_fluid", speed_unit, "Largest |v| of a control point of the fluid, the wall included.", any_dimension,
     Needs::fluid},
    {"speed_max_solid", speed_unit, "Largest |v| of a control point of the solid, the wall included.", any_dimension,
     Needs::solid},
};

const std::vector<Column> of_step = joined({before_integrals,
                                            integrals("mass", "energy_elastic"),
                                            {power_load},
                                            integrals("dissipation", "dissipation"),
                                            of_extremes});

/// The columns of a droplet, bubble or film.
const std::vector<Column> of_droplet{
    {"contact_area", "L0^2",
     "Area of the deformed wall that is wetted, which means rho > (rho_l + rho_v)/2; of a bubble, the area that is "
     "dry.",
     3},
    {"x_left", "L0",
     "Left contact point of a droplet, bubble or film: where rho = (rho_l + rho_v)/2 on the deformed wall, rho being a "
     "mean over two elements to each side, which does not swing with the mesh as single points do. One that is "
     "cut by a side of the domain ends at the side; on an axis of symmetry its left contact point is minus the right "
     "one.",
     2},
    {"x_right", "L0", "Right contact point; the contact radius of a droplet on an axis of symmetry.", 2},
    {"x_centre", "L0", "In 2D the midpoint of x_left and x_right; in 3D x of the centroid of the wetted wall."},
    {"y_centre", "L0", "y of the centroid of the wetted wall.", 3},
    {"velocity", speed_unit,
     "Velocity of the droplet since the row before: in 2D of x_centre, in 3D of the centroid along "
     "output.history.track."},
    {"angle_left", "degrees",
     "Left apparent contact angle, measured in the liquid, also of a bubble. A circle is fitted to the left half of "
     "the "
     "outline of the droplet, from 2 capillarities above the wall upwards. The angle is the one at which this circle "
     "meets the height "
     "of the left contact point.",
     2},
    {"angle_right", "degrees", "Right apparent contact angle, measured in the same way.", 2},
    {"ridge_left", "L0",
     "Height of the ridge that the left contact line pulls out of the solid: the largest vertical displacement of the "
     "wall within 4 capillarities of it.",
     2},
    {"ridge_right", "L0", "The same at the right contact point.", 2},
    {"wall_angle_left_wet", "degrees",
     "Angle of the wall to the horizontal on the liquid's side of the left contact point, 4 capillarities from it; "
     "positive where the wall rises towards the contact line. 180 degrees minus the angles of both sides is the angle "
     "of the solid's wedge.",
     2},
    {"wall_angle_left_dry", "degrees", "The same on the side of the vapour.", 2},
    {"liquid_angle_left", "degrees",
     "Angle of the droplet's outline to the horizontal, 4 capillarities above the left contact point, measured in the "
     "liquid. It is the local angle, where angle_left is the one of the whole outline.",
     2},
    {"wall_angle_right_wet", "degrees", "As wall_angle_left_wet, at the right contact point.", 2},
    {"wall_angle_right_dry", "degrees", "As wall_angle_left_dry, at the right contact point.", 2},
    {"liquid_angle_right", "degrees", "As liquid_angle_left, at the right contact point.", 2},
    {"track_rear", "L0",
     "Rear contact point in the vertical section through the centroid along output.history.track. It is a position "
     "along the track, counted from the middle of the domain.",
     3},
    {"track_front", "L0", "Front contact point in the same section.", 3},
    {"angle_rear", "degrees",
     "Apparent contact angle at track_rear, measured in the liquid by a circle fitted to the rear half of the outline "
     "in that section, as angle_left is in 2D.",
     3},
    {"angle_front", "degrees", "Apparent contact angle at track_front.", 3},
    {"ridge_rear", "L0", "As ridge_left in 2D, at track_rear in that section.", 3},
    {"ridge_front", "L0", "The same at track_front.", 3},
    {"wall_angle_rear_wet", "degrees", "As wall_angle_left_wet in 2D, in that section.", 3},
    {"wall_angle_rear_dry", "degrees", "As wall_angle_left_dry in 2D, in that section.", 3},
    {"liquid_angle_rear", "degrees", "As liquid_angle_left in 2D, in that section.", 3},
    {"wall_angle_front_wet", "degrees", "As wall_angle_rear_wet, at track_front.", 3},
    {"wall_angle_front_dry", "degrees", "As wall_angle_rear_dry, at track_front.", 3},
    {"liquid_angle_front", "degrees", "As liquid_angle_rear, at track_front.", 3},
    {"dimple", "L0",
     "Smallest vertical displacement of the wall below the droplet, between its contact points; negative where the "
     "wall is pressed down. In 3D in the section along output.history.track."},
};

const std::vector<Column> of_whole{
    {"energy_total", energy_unit, "Sum of all energies: the other columns that begin with energy_."},
    {"mass_drift", "", "mass divided by the mass of step 0, minus 1.", any_dimension, Needs::fluid},
    {"speed_max_liquid", speed_unit, "Largest |v| of a control point whose density is above (rho_l + rho_v)/2.",
     any_dimension, Needs::fluid},
};
const Column laplace{
    "laplace", "ab",
    "Excess of the chemical potential inside the first droplet, mu - mu_sat. At rest it is sigma/(R (rho_l - rho_v)) "
    "in 2D and twice that in 3D and in axisymmetric scenes."};
/// The columns of history.csv that follow the columns of the droplets; laplace exists only with droplets.
const std::vector<Column> of_balance = joined({of_whole, integrals("wall_stretch", "liquid_volume"), {laplace}});

const Column power_needle{
    "power_needle", power_unit,
    "Power of the needles that move: their force times the velocity of their paths. energy_total changes by it as by "
    "power_load; where a path jumps it jumps too."};
/// Columns of a scene with needles: the sum over all needles, and the force of each.
const std::vector<Column> of_needles = joined({integrals("energy_needle", "energy_needle"), {power_needle}});
const std::vector<Column> of_needle{
    {"needle_force_x", "a b^2 L0^(d-1)",
     "Force of the needle on the solid along x: its reading. For the second needle it is needle_force_x_2. In "
     "axisymmetric scenes it is 0, and the one along y is along the axis of symmetry."},
    {"needle_force_y", "a b^2 L0^(d-1)", "The same along y; in 2D this is the vertical one."},
    {"needle_force_z", "a b^2 L0^(d-1)", "The same along z, the vertical.", 3},
};

const std::vector<Column> of_interface{
    {"time", time_unit, "Time of the row, when field files are written too; the same clock as t in history.csv."},
    {"x_reference", "L0", "Position of the point of the wall along x before any deformation."},
    {"y_reference", "L0", "The same along y.", 3},
    {"displacement_x", "L0", "Displacement of that point along x."},
    {"displacement_y", "L0", "Displacement along y; in 2D this is the vertical one."},
    {"displacement_z", "L0", "Vertical displacement.", 3},
    {"density", "b", "Density of the fluid at that point. Empty without a fluid."},
    {"traction_x", "a b^2",
     "Force of the fluid on the wall along x, per area of the undeformed wall. A line force is spread over the width "
     "of the interface and an element. With fluid.wall_tension = \"acts\" it has the pull of that tension too. Empty "
     "without a fluid."},
    {"traction_y", "a b^2", "The same along y; in 2D this is the vertical one."},
    {"traction_z", "a b^2", "The same along z, the vertical.", 3},
};

const std::vector<Column> of_history = joined({of_step, of_droplet, of_balance, of_needles, of_needle});

/// The fields as columns of a table.
std::vector<Column> of_fields() {
  std::vector<Column> columns;
  for (const FieldInfo& field : field_table()) {
    std::string meaning = field.meaning;
    if (meaning.find('=') == std::string::npos)  // a symbol keeps its letter
      meaning[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(meaning[0])));
    const std::string where = !field.in_solid ? "the fluid" : field.in_fluid ? "fluid and solid" : "the solid";
    columns.push_back({field.name, field.unit == "1" ? "" : field.unit, meaning + ". In " + where + "."});
  }
  return columns;
}

std::vector<std::string> names_of(const std::vector<Column>& columns, int dimension) {
  std::vector<std::string> names;
  for (const Column& column : columns)
    if (column.dimension == 0 || column.dimension == dimension) names.push_back(column.name);
  return names;
}

}  // namespace

std::vector<std::string> contact_names(int dimension) { return names_of(of_droplet, dimension); }

std::vector<std::string> history_names(int dimension, std::size_t droplets, std::size_t films, std::size_t needles) {
  std::vector<std::string> names = names_of(of_step, dimension);
  for (std::size_t k = 0; k < droplets + films; ++k)
    for (const std::string& name : contact_names(dimension)) names.push_back(name + ending_of_body(k));
  for (const std::string& name : names_of(of_balance, dimension))
    if (name != laplace.name || droplets > 0) names.push_back(name);
  if (needles > 0)
    for (const std::string& name : names_of(of_needles, dimension)) names.push_back(name);
  for (std::size_t k = 0; k < needles; ++k)
    for (const std::string& name : names_of(of_needle, dimension)) names.push_back(name + ending_of_body(k));
  return names;
}

std::string ending_of_body(std::size_t body) { return body == 0 ? "" : "_" + std::to_string(body + 1); }

const Column& history_column(const std::string& name) {
  for (const Column& column : of_history)
    if (column.name == name) return column;
  throw std::logic_error("history.csv has no column '" + name + "'");
}

std::vector<std::string> interface_names(int dimension) { return names_of(of_interface, dimension); }

const std::vector<ColumnTable>& column_tables() {
  static const std::vector<ColumnTable> tables{
      {"history", "history.csv",
       "A row for every output.history.every steps, and one for the last step. An empty cell means that the quantity "
       "does not exist there: no fluid, no solid, no contact line. d is the dimension of the domain; in 2D integrals "
       "are per depth, and in axisymmetric scenes over the whole turn, with d = 3. The columns of the second "
       "droplet, bubble or needle end in _2, of the third in _3, and so on; the numbers of films "
       "follow those of droplets (around bubbles they have none). When droplets merge, the first one continues "
       "and "
       "the others stay empty. The columns of probes ([[probe]]) come last.",
       of_history},
      {"interface", "interface.csv",
       "The wall at the field times: two points for each element along each axis, and the ends. Without a fluid it is "
       "the top of the solid.",
       of_interface},
      {"fields", "fields/*.hdf",
       "The fields at the field times, on the deformed mesh. output.fields.select chooses among them. A tensor has "
       "nine components, row by row.",
       of_fields()}};
  return tables;
}

}  // namespace softwet
