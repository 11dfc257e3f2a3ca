// What `softwet units` prints.
#pragma once

#include <ostream>

#include "case/physical.hpp"

namespace softwet {

/// The scales, the same groups in both worlds, what the model cannot reach, and lines for a case file.
void describe_units(const PhysicalScene&, std::ostream&);

}  // namespace softwet
