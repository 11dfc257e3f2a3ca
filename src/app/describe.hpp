// What `softwet check` prints of a case.
#pragma once

#include <ostream>

#include "app/case.hpp"

namespace softwet {

/// Terms in play, unknowns per field, memory by part, limits of explicit steps, kernel.
template <int D, int P>
void describe_model(const Case&, std::ostream&);

}  // namespace softwet
