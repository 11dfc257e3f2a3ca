// The columns of history.csv and interface.csv: name, unit and meaning, once. The writers of the tables take their
// headers from here, and `softwet explain` prints it, together with the fields of field_table.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/table_row.hpp"
#include "kernels/functional/columns.hpp"

namespace softwet {

struct Column {
  std::string name;
  std::string unit;  ///< empty: a pure number
  std::string meaning;
  int dimension = any_dimension;  ///< 2 or 3: only domains of this dimension have the column
  Needs needs = Needs::nothing;
};

/// Names of the columns that each droplet, bubble or film has in history.csv.
std::vector<std::string> contact_names(int dimension);

/// Header of history.csv. The columns of droplet number k = 2, 3, ... end in _k; the numbers of the films follow. The
/// columns of needles are numbered in the same way; without needles there are none.
std::vector<std::string> history_names(int dimension, std::size_t droplets, std::size_t films = 0,
                                       std::size_t needles = 0);

/// What the names of the columns of a body end in. @param body  0 is the first droplet
std::string ending_of_body(std::size_t body);

/// The column of history.csv with this name, of a first droplet where it is one's. Throws std::logic_error where there
/// is none.
const Column& history_column(const std::string& name);

/// Header of interface.csv.
std::vector<std::string> interface_names(int dimension);

/// A table, all columns it can have, and what holds for the whole of it. The fields count as a table too.
struct ColumnTable {
  std::string name;  ///< as `softwet explain` calls it
  std::string file;
  std::string meaning;
  std::vector<Column> columns;
};

const std::vector<ColumnTable>& column_tables();

}  // namespace softwet
