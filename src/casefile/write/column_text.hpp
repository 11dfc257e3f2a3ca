// What `softwet explain` says of the columns of history.csv and interface.csv and of the fields, and the page of the
// whole reference.
#pragma once

#include <string>
#include <vector>

namespace softwet {

/// A table ("history"), a column of it ("history.mass"), or a column alone ("mass", "velocity_2"). Empty when there is
/// no such table or column.
std::string explain_columns(const std::string& name);

/// Tables and columns as explain_columns knows them, for "did you mean".
std::vector<std::string> column_names();

/// All columns of all tables as JSON, for programs: {table: {file, meaning, columns: [{name, unit, meaning}]}}, where a
/// column may have `dimension`, the only one that it exists in, and `needs`, "fluid" or "solid".
std::string columns_json();

/// All keys and all columns as a page of Markdown: docs/reference.md.
std::string reference_page();

}  // namespace softwet
