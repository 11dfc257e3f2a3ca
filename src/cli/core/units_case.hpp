// The case that `softwet units --case` writes: a droplet on a layer, with a table [laboratory].
#pragma once

#include <ostream>
#include <string>

#include "case/physical.hpp"

namespace softwet {

/// Water with the radius 500 um on a gel of 3 kPa, 100 um thick.
PhysicalScene water_on_gel();

/// The text of the case. Throws Error where the quantities make no such scene, and when no case can have the name.
std::string units_case(const PhysicalScene&, const WrittenCase&, const std::string& name);

/// Writes the file and says what to do with it. Throws Error where the quantities make no such scene.
void write_units_case(const PhysicalScene&, const WrittenCase&, std::ostream&);

}  // namespace softwet
