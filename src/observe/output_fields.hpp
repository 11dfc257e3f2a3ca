// Field files of the fluid and the solid at one time, for ParaView.
#pragma once

#include <string>
#include <vector>

#include "io/field_file.hpp"
#include "observe/snapshot.hpp"
#include "scene/coefficients.hpp"

namespace softwet {

/// Writes fields/fluid_NNNN.hdf and fields/solid_NNNN.hdf (what the scene has) below `folder`, and the .series
/// files that list the times so far. Points, 2 cells + 1 per axis, lie at their deformed positions; exact for degree 2.
/// The points of a joint are there twice, with the values from below and from above.
/// @param selected  names of `field_table`; empty: all. A file has those that its material has.
/// @param times     of all field files of the run, on the clock of the output; this one's, the last, is file
///   times.size() - 1
template <int D>
void write_field_files(const std::string& folder, const FieldOrigin& origin, const std::vector<std::string>& selected,
                       const Case&, const Coefficients<D>& coefficients, const Snapshot<D>& snapshot,
                       const std::vector<double>& times);

}  // namespace softwet
