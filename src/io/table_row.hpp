// A row of a table: cells by the names of their columns.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace softwet {

/// Filled in any order. The table that takes it puts the cells in the order of its columns.
class TableRow {
 public:
  using Cell = std::optional<double>;  ///< empty: the quantity does not exist there

  TableRow() = default;
  TableRow(std::initializer_list<std::pair<std::string, Cell>> cells) : cells_(cells) {}

  void set(const std::string& column, const Cell& value) { cells_.emplace_back(column, value); }
  /// Adds all cells of another row, with an ending behind the names.
  void add(const TableRow& other, const std::string& ending);

  /// Empty also where the row has no such cell.
  Cell cell(const std::string& column) const;

  /// One cell for each column. Throws std::logic_error that names a column without a cell, a cell without a column, or
  /// a column with two cells.
  std::vector<Cell> in_order_of(const std::vector<std::string>& columns) const;

 private:
  std::vector<std::pair<std::string, Cell>> cells_;
};

}  // namespace softwet
