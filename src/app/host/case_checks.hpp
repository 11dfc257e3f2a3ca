// Checks that need more than one key: shapes, and how solid, fluid, droplets, loads and sides fit together.
#pragma once

#include "app/case.hpp"
#include "app/host/document.hpp"

namespace softwet {

/// Throws Error invalid_input at the first contradiction; `document` tells where its values stand.
void check_case(const Case& c, const Document& document);

}  // namespace softwet
