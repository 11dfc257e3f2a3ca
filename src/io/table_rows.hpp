// The rows of a table that lies there when a run is resumed, judged as rows of a run.
#pragma once

#include <string>
#include <vector>

#include "io/table_file.hpp"

namespace softwet {

/// The first line of a table, with its end.
std::string header_line(const std::vector<std::string>& columns);

/// The header and the rows up to the mark. Throws Error (invalid_input) where they are not those that were written.
std::string rows_up_to_mark(const std::string& path, const std::string& text, const std::vector<std::string>& columns,
                            const TableMark&);

[[noreturn]] void refuse_table(const std::string& place, const std::string& problem);

}  // namespace softwet
