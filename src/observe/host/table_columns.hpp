// The columns of history.csv and interface.csv: name, unit and meaning, once. The writers of the tables take their
// headers from here, and `softwet explain` prints it, together with the fields of field_table.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace softwet {

struct Column {
  std::string name;
  std::string unit;  ///< empty: a pure number
  std::string meaning;
  int dimension = 0;  ///< 2 or 3: only domains of this dimension have the column
};

/// Names of the columns that each droplet, bubble or film has in history.csv.
std::vector<std::string> contact_names(int dimension);

/// Header of history.csv. The columns of droplet number k = 2, 3, ... end in _k; the films are numbered on behind them.
std::vector<std::string> history_names(int dimension, std::size_t droplets, std::size_t films = 0);

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
