// What `softwet units` prints.
#pragma once

#include <ostream>

#include "case/case.hpp"
#include "case/physical.hpp"

namespace softwet {

/// The scales, the same groups in both worlds, what the model cannot reach, and lines for a case file.
void describe_units(const PhysicalScene&, std::ostream&);

/// What 1 means in a case, and its keys in the units of the laboratory.
void describe_laboratory(const Scales&, const Case&, std::ostream&);

}  // namespace softwet
