#include "io/field_file.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include "case/error.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_file.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "io/quadratic_cells.hpp"

namespace softwet {
namespace {

constexpr const char* time_value = "/VTKHDF/FieldData/TimeValue";
constexpr const char *unit_length = "L0", *unit_time = "L0/sqrt(ab)";

[[noreturn]] void refuse_to_write(const std::string& path, const std::string& what) {
  throw Error(Exit::computation_failed, path + ": not written: " + what);
}

void require_size(const std::string& path, const std::string& name, std::size_t found, std::size_t expected) {
  if (found == expected) return;
  refuse_to_write(path, name + " has " + std::to_string(found) + " values where the grid needs " +
                            std::to_string(expected) + "; this is an error in softwet, please report it");
}

std::string position_text(const std::vector<double>& points, std::size_t point, int dimension) {
  std::string text = "(";
  for (int axis = 0; axis < dimension; ++axis) {
    text += (axis == 0 ? "" : ", ") + number_text(points[point * dimension + axis]);
  }
  return text + ")";
}

/// Throws computation_failed at the first value that is not finite.
void require_finite(const std::string& path, const std::string& name, const std::vector<double>& values, int components,
                    const std::vector<double>& points, int dimension) {
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (std::isfinite(values[at])) continue;
    const std::size_t point = at / components;
    const std::string component = components == 1 ? "" : ", component " + std::to_string(at % components) + ",";
    refuse_to_write(path, "field '" + name + "'" + component + " is " + number_text(values[at]) + " at point " +
                              std::to_string(point) + " " + position_text(points, point, dimension) +
                              "; the computation has diverged: take shorter time steps or a finer mesh");
  }
}

void check_fields(const std::string& path, const TensorGrid& grid, const std::vector<double>& points,
                  const std::vector<PointField>& fields, double time) {
  if (grid.dimension != 2 && grid.dimension != 3) refuse_to_write(path, "a grid has dimension 2 or 3");
  for (int axis = 0; axis < grid.dimension; ++axis) {
    if (grid.cells[axis] < 1) refuse_to_write(path, "a grid has at least one cell along each axis");
  }
  if (!std::isfinite(time)) refuse_to_write(path, "the time is " + number_text(time));
  const auto count = static_cast<std::size_t>(point_count(grid));
  require_size(path, "points", points.size(), count * grid.dimension);
  require_finite(path, "points", points, grid.dimension, points, grid.dimension);
  std::set<std::string> names;
  for (const PointField& field : fields) {
    if (field.name.empty() || field.name.find('/') != std::string::npos || !names.insert(field.name).second) {
      refuse_to_write(path, "'" + field.name + "' is not a field name: it is empty, holds a '/' or is taken");
    }
    if (field.components < 1) refuse_to_write(path, "field '" + field.name + "' has no components");
    require_size(path, "field '" + field.name + "'", field.values.size(), count * field.components);
    require_finite(path, field.name, field.values, field.components, points, grid.dimension);
  }
}

/// Vectors of a plane with a third component 0. @return shape (points, 3)
std::vector<double> padded_to_three(const std::vector<double>& plane_vectors) {
  std::vector<double> padded(plane_vectors.size() / 2 * 3, 0.0);
  for (std::size_t at = 0; at < plane_vectors.size(); ++at) padded[at / 2 * 3 + at % 2] = plane_vectors[at];
  return padded;
}

void write_vectors(Hdf5File& file, const std::string& name, const std::vector<double>& values, int components,
                   int dimension, std::size_t count) {
  if (components == 2 && dimension == 2) {
    file.write(name, padded_to_three(values), {count, 3});
  } else if (components == 1) {
    file.write(name, values, {count});
  } else {
    file.write(name, values, {count, std::size_t(components)});
  }
}

void write_cells(Hdf5File& file, const TensorGrid& grid) {
  const std::vector<std::int64_t> connectivity = cell_nodes(grid);
  const std::int64_t count = cell_count(grid);
  const std::int64_t nodes_per_cell = std::int64_t(connectivity.size()) / count;
  std::vector<std::int64_t> offsets(static_cast<std::size_t>(count) + 1);
  for (std::size_t cell = 0; cell < offsets.size(); ++cell) offsets[cell] = std::int64_t(cell) * nodes_per_cell;
  const std::uint8_t type = grid.dimension == 3 ? vtk_triquadratic_hexahedron : vtk_biquadratic_quad;
  const std::vector<std::uint8_t> types(static_cast<std::size_t>(count), type);
  // One partition: each of the numbers is a list of length one.
  file.write("/VTKHDF/NumberOfPoints", std::vector<std::int64_t>{point_count(grid)}, {1});
  file.write("/VTKHDF/NumberOfCells", std::vector<std::int64_t>{count}, {1});
  file.write("/VTKHDF/NumberOfConnectivityIds", std::vector<std::int64_t>{std::int64_t(connectivity.size())}, {1});
  file.write("/VTKHDF/Connectivity", connectivity, {connectivity.size()});
  file.write("/VTKHDF/Offsets", offsets, {offsets.size()});
  file.write("/VTKHDF/Types", types, {types.size()});
}

/// What VTK does not read but a person or a script wants to know.
void write_origin(Hdf5File& file, const FieldOrigin& origin, const TensorGrid& grid, double time) {
  file.write_attribute("/", "case", origin.case_name);
  file.write_attribute("/", "version", origin.version);
  file.write_attribute("/", "commit", origin.commit);
  file.write_attribute("/", "time", time);
  file.write_attribute("/", "unit_length", std::string(unit_length));
  file.write_attribute("/", "unit_time", std::string(unit_time));
  if (grid.rows_below_joint > 0)
    file.write_attribute("/", "rows_below_joint", std::vector<std::int64_t>{grid.rows_below_joint});
  for (std::size_t d = 0; d < grid.ends.size(); ++d)
    if (!grid.ends[d].empty())
      file.write(std::string("/element_ends_") + "xyz"[d], grid.ends[d], {grid.ends[d].size()});
}

}  // namespace

void write_fields(const std::string& path, const FieldOrigin& origin, const TensorGrid& grid,
                  const std::vector<double>& points, const std::vector<PointField>& fields, double time) {
  check_fields(path, grid, points, fields, time);
  AtomicFile target(path);
  Hdf5File file = Hdf5File::create(target.partial_path(), Hdf5Format::compatible);
  write_origin(file, origin, grid, time);
  file.make_group("/VTKHDF");
  file.write_attribute("/VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
  file.write_attribute("/VTKHDF", "Type", std::string("UnstructuredGrid"));
  write_cells(file, grid);
  const auto count = static_cast<std::size_t>(point_count(grid));
  write_vectors(file, "/VTKHDF/Points", points, grid.dimension, grid.dimension, count);
  file.write_attribute("/VTKHDF/Points", "unit", std::string(unit_length));
  file.make_group("/VTKHDF/PointData");
  for (const PointField& field : fields) {
    const std::string name = "/VTKHDF/PointData/" + field.name;
    write_vectors(file, name, field.values, field.components, grid.dimension, count);
    file.write_attribute(name, "unit", field.unit);
  }
  file.make_group("/VTKHDF/CellData");
  file.make_group("/VTKHDF/FieldData");
  file.write(time_value, std::vector<double>{time}, {1});
  file.write_attribute(time_value, "unit", std::string(unit_time));
  file.close();
  target.commit();
}

std::string field_file_name(const std::string& part, std::size_t number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "_%04zu.hdf", number);
  return part + digits;
}

std::vector<double> field_file_times(const std::string& folder, const std::string& part) {
  std::vector<double> times;
  for (;;) {
    const std::string path = folder + "/" + field_file_name(part, times.size());
    if (!std::filesystem::exists(path)) return times;
    const Hdf5File file = Hdf5File::open(path, "put back the file, or remove it and those after it");
    const std::vector<double> time = file.read<double>(time_value);
    if (time.size() != 1 || !std::isfinite(time[0])) file.fail("holds no time");
    times.push_back(time[0]);
  }
}

std::vector<double> read_field(const std::string& path, const std::string& name) {
  const Hdf5File file = Hdf5File::open(path, "put back the file, or write it again");
  const std::string array = "/VTKHDF/PointData/" + name;
  if (!file.has(array)) file.fail("lacks the field " + name + ", which output.fields.select left out");
  return file.read<double>(array);
}

void write_series(const std::string& path, const std::vector<std::pair<std::string, double>>& files_and_times) {
  std::string text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [";
  const char* separator = "\n";
  for (const auto& [file, time] : files_and_times) {
    if (!std::isfinite(time)) refuse_to_write(path, "the time of " + file + " is " + number_text(time));
    text += separator + ("    {\"name\": " + json_string(file) + ", \"time\": " + number_text(time) + "}");
    separator = ",\n";
  }
  write_text_atomically(path, text + "\n  ]\n}\n");
}

}  // namespace softwet
