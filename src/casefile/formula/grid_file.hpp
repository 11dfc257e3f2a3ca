// The file of a table on a rectangular grid: CSV or HDF5.
#pragma once

#include <string>
#include <vector>

namespace softwet {

struct GridAxis {
  std::size_t variable;  ///< 0, 1, 2: x, y, z; 3: t
  std::vector<double> points;
};
/// What a file holds.
struct GridData {
  std::vector<GridAxis> axes;
  std::vector<double> values;  ///< last axis fastest
};

/// What the files look like is said in grid_table.hpp. @param variables  that the axes may be, out of x, y, z, t
/// Throw FormulaError that names the file, and the line and column of a CSV file.
GridData read_csv_grid(const std::string& path, const std::vector<std::string>& variables);
GridData read_hdf5_grid(const std::string& path, const std::vector<std::string>& variables);

}  // namespace softwet
