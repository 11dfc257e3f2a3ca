// A function as values on a rectangular grid, from a CSV or an HDF5 file.
#pragma once

#include <string>
#include <vector>

#include "case/profile.hpp"
#include "casefile/formula/grid_file.hpp"

namespace softwet {

/// Values on the product of some of the axes x, y, z and t. Between the points of the grid they are interpolated
/// linearly along each axis; outside of the grid the value at the nearest point of its border counts. The function does
/// not depend on axes that the grid lacks. Its kinks are the points of the axis t.
class GridTable final : public Formula {
 public:
  /// @param path  ends with .csv or .h5  @param variables  that the axes may be, out of x, y, z, t
  /// CSV: a line with the names, "x,y,value", then a line for each point of the grid, in any order; empty lines and
  /// lines that begin with # do not count. Semicolons or tabulators may replace the commas. HDF5: a dataset for each
  /// axis, of one dimension and increasing, and the dataset "value", whose dimensions are the axes in the order x, y,
  /// z, t. Throws FormulaError that names the file, and the line and column of a CSV file.
  GridTable(const std::string& path, const std::vector<std::string>& variables);
  /// A table of values over increasing times.
  GridTable(std::vector<double> times, std::vector<double> values);

  /// The table over time that a text in a case file holds: "[[0, 0], [5, 0.1]]".
  static GridTable of_pairs(const std::string& text);
  /// Whether it is one: it begins with [[.
  static bool is_pairs(const std::string& text);
  /// Whether a text in a case file is the path of a table: it ends with .csv or .h5.
  static bool is_path(const std::string& text);
  /// Whether it is the path of a file that somebody takes for a table, and is none: a workbook, or .CSV in capitals.
  static bool is_other_file(const std::string& text);

  double at(const std::array<double, 3>& x, double t) const override;
  std::vector<double> kinks() const override;
  std::string identity() const override;

 private:
  std::vector<GridAxis> axes_;
  std::vector<double> values_;  ///< last axis fastest
};

}  // namespace softwet
