// The wall in interface.csv: displacement and density along the interface at the field times.
#pragma once

#include <string>
#include <vector>

#include "observe/host/table_file.hpp"
#include "observe/snapshot.hpp"

namespace softwet {

/// time, x_reference[, y_reference], displacement_x, displacement_y[, displacement_z], density
template <int D>
std::vector<std::string> interface_columns();

/// One row for each point of the wall: two per element along each axis, and the ends. Without a fluid the wall is the
/// top of the solid and the density is empty.
/// @param time  on the clock of the output
template <int D>
void add_interface_rows(TableFile& table, const Snapshot<D>& snapshot, double time);

}  // namespace softwet
