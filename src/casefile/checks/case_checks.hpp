// Checks that need more than one key: shapes, and how solid, fluid, droplets, loads and sides fit together.
#pragma once

#include "case/case.hpp"
#include "casefile/text/document.hpp"

namespace softwet {

/// Contradictions go to `problems`; `document` knows where the values stand. A check that needs a value which is wrong
/// already is left out, for what it said would mislead.
void check_case(const Case& c, const Document& document, Problems& problems);

}  // namespace softwet
