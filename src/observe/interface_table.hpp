// The wall in interface.csv: displacement, density and traction along the interface at the field times.
#pragma once

#include <string>
#include <vector>

#include "io/table_file.hpp"
#include "observe/host/table_columns.hpp"
#include "observe/snapshot.hpp"
#include "scene/equations.hpp"

namespace softwet {

/// Header of the table.
template <int D>
std::vector<std::string> interface_columns() {
  return interface_names(D);
}

/// Force of the fluid on the wall, rigid or the surface of a solid, per area of the wall in the reference
/// configuration: control values of a spline on the wall, one list per component; scale a b^2. Each is minus the
/// fluid's residual of a control point over the integral of its function. So the integral of the traction is the sum of
/// the forces, and a line force is spread over the width of the interface and an element. On a solid these are the very
/// forces that load it in the equations. It is 0 along the normal of a side that the wall meets: that force belongs to
/// the side. All processes have to call it; the first one gets the traction, the others nothing. Empty without a fluid
/// or a wall.
template <int D, int P>
std::array<std::vector<double>, D> wall_traction(const Regions<D>&, const Equations<D, P>&, const Stage& stage);

/// One row for each point of the wall: two per element along each axis, and the ends. Without a fluid the wall is the
/// top of the solid; density and traction are empty.
/// @param traction  wall_traction() at the state of the snapshot
/// @param time      on the clock of the output
template <int D>
void add_interface_rows(TableFile& table, const Snapshot<D>& snapshot,
                        const std::array<std::vector<double>, D>& traction, double time);

}  // namespace softwet
