// Fields on quadratic cells in VTKHDF 1.0 files, which ParaView and VTK (9.1 and newer) open, and the series of their
// times.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace softwet {

/// A block of quadratic cells sharing their nodes: (2 cells + 1) points per axis, x fastest.
/// 2D: VTK_BIQUADRATIC_QUAD (9 nodes), 3D: VTK_TRIQUADRATIC_HEXAHEDRON (27 nodes).
struct TensorGrid {
  int dimension = 2;                          ///< 2 or 3
  std::array<int, 3> cells = {1, 1, 1};       ///< per axis; the third is not read in 2D
  std::array<std::vector<double>, 3> ends{};  ///< of the cells in the undeformed mesh; empty where they are equal
  int rows_below_joint =
      0;  ///< along the last axis, where cells above do not share the points of those below; 0: all share
};

/// One field at the points of a TensorGrid.
struct PointField {
  std::string name;            ///< without "/"
  int components = 1;          ///< 2 in a 2D grid is a vector and gets a third component 0 on writing, as VTK wants
  std::vector<double> values;  ///< shape (points, components), components fastest
  std::string unit = "1";      ///< scale of the values
};

/// Origin of the fields: attributes of the file.
struct FieldOrigin {
  std::string case_name, version, commit;
};

/// Writes one block (the fluid, the solid) at one time, atomically: PATH holds the whole file or is left as it was.
/// Attributes of the file: case, version, commit, time, unit_length, unit_time; each array has the attribute unit.
/// Along axes whose elements are graded: the arrays element_ends_x, _y, _z next to the group of VTK. With a joint: the
/// attribute rows_below_joint; the points of the joint appear first as points of the cells below, then as points of the
/// cells above.
/// @param path    ends with .hdf
/// @param points  positions, shape (points, dimension), components fastest
/// @param time    stored as field data "TimeValue" too
/// Throws Error: computation_failed for a size that does not fit and for a value that is not finite (names field, point
/// and position), machine_failed for the disk.
void write_fields(const std::string& path, const FieldOrigin& origin, const TensorGrid& grid,
                  const std::vector<double>& points, const std::vector<PointField>& fields, double time);

/// "fluid_0003.hdf".
std::string field_file_name(const std::string& part, std::size_t number);

/// Times stored in the files part_0000, part_0001, ... of a folder, up to the first that is missing. Throws Error
/// (invalid_input) for a file that cannot be read.
std::vector<double> field_file_times(const std::string& folder, const std::string& part);

/// Values of a field of a file, shape (points, components), components fastest; a vector in 2D has three. Throws Error
/// (invalid_input) for a file that cannot be read or lacks the field.
std::vector<double> read_field(const std::string& path, const std::string& name);

/// Writes the list of files that ParaView opens as one animation, atomically.
/// @param path             ends with .hdf.series
/// @param files_and_times  file names relative to the folder of `path`, and their times
/// Throws Error: computation_failed for a time that is not finite, machine_failed for the disk.
void write_series(const std::string& path, const std::vector<std::pair<std::string, double>>& files_and_times);

}  // namespace softwet
