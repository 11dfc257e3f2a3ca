#include "io/table_row.hpp"

#include <algorithm>
#include <stdexcept>

namespace softwet {
namespace {

template <class Cells>
auto find(const Cells& cells, const std::string& column) {
  return std::find_if(cells.begin(), cells.end(), [&](const auto& cell) { return cell.first == column; });
}

}  // namespace

void TableRow::add(const TableRow& other, const std::string& ending) {
  for (const auto& [column, value] : other.cells_) set(column + ending, value);
}

TableRow::Cell TableRow::cell(const std::string& column) const {
  const auto found = find(cells_, column);
  return found == cells_.end() ? std::nullopt : found->second;
}

std::vector<TableRow::Cell> TableRow::in_order_of(const std::vector<std::string>& columns) const {
  std::vector<Cell> ordered;
  ordered.reserve(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool here = i < cells_.size() && cells_[i].first == columns[i];  // a row that is filled in order
    const auto found = here ? cells_.begin() + static_cast<std::ptrdiff_t>(i) : find(cells_, columns[i]);
    if (found == cells_.end()) throw std::logic_error("the row has no cell for the column '" + columns[i] + "'");
    ordered.push_back(found->second);
  }
  if (cells_.size() == columns.size()) return ordered;
  for (auto cell = cells_.begin(); cell != cells_.end(); ++cell) {
    if (std::find(columns.begin(), columns.end(), cell->first) == columns.end())
      throw std::logic_error("the table has no column '" + cell->first + "'");
    if (find(cells_, cell->first) != cell)
      throw std::logic_error("the row has two cells for the column '" + cell->first + "'");
  }
  return ordered;
}

}  // namespace softwet
