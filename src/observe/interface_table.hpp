// The wall in interface.csv: displacement, density and traction along the interface at the field times.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "observe/host/table_file.hpp"
#include "observe/snapshot.hpp"

namespace softwet {

/// time, x_reference[, y_reference], displacement_x, displacement_y[, displacement_z], density, traction_x,
/// traction_y[, traction_z]
template <int D>
std::vector<std::string> interface_columns() {
  const std::string axis = "xyz";
  std::vector<std::string> names{"time"};
  for (int d = 0; d < D - 1; ++d) names.push_back(std::string(1, axis[d]) + "_reference");
  for (int d = 0; d < D; ++d) names.push_back(std::string("displacement_") + axis[d]);
  names.push_back("density");
  for (int d = 0; d < D; ++d) names.push_back(std::string("traction_") + axis[d]);
  return names;
}

/// Force of the fluid on the wall, rigid or the surface of a solid, per area of the wall in the reference
/// configuration: control values of a spline on the wall, one list per component; scale a b^2. Each is minus the
/// fluid's residual of a control point over the integral of its function. So the integral of the traction is the sum of
/// the forces, and a line force is spread over the width of the interface and an element. On a solid these are the very
/// forces that load it in the equations. It is 0 along the normal of a side that the wall meets: that force belongs to
/// the side.
template <int D, int P>
std::array<std::vector<double>, D> wall_traction(const Model<D, P>& model, const Stage& stage);

/// One row for each point of the wall: two per element along each axis, and the ends. Without a fluid the wall is the
/// top of the solid; density and traction are empty.
/// @param stage  at the state of the snapshot
/// @param time   on the clock of the output
template <int D, int P>
void add_interface_rows(TableFile& table, const Model<D, P>& model, const Stage& stage, const Snapshot<D>& snapshot,
                        double time);

}  // namespace softwet
