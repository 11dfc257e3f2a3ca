// The state a run starts from, as field files.
#pragma once

#include <string>

#include "case/case.hpp"

namespace softwet {

/// Writes the density of the fluid and the displacement of both materials at the beginning into fields/ below `folder`.
template <int D, int P>
void write_first_fields(const Case&, const std::string& folder);

}  // namespace softwet
