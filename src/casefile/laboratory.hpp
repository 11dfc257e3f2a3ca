// The table [laboratory] of a case file: quantities with units, from which other keys of the case follow.
#pragma once

#include <optional>

#include "casefile/case_file.hpp"
#include "casefile/text/document.hpp"

namespace softwet {

/// Enters the keys that follow from the table, as if the file had them in the place of the quantities. A key of the command line
/// wins over a quantity of the file, and the other way round. What is wrong goes to the problems, and is thrown.
/// @return  nothing where the document has no such table
std::optional<Laboratory> follow_laboratory(Document&, const Conversion&, Problems&);

}  // namespace softwet
