// The configurations this build holds: dimension x degree, and the step from a case to one of them.
#pragma once

#include <softwet_configurations.hpp>
#include <string>

#include "case/case.hpp"
#include "case/error.hpp"

namespace softwet {

template <int D, int P>
struct Configuration {
  static constexpr int dimension = D, degree = P;
};

/// "2D degree 2, 2D degree 3, ...": what `softwet info` and errors show.
inline std::string compiled_configurations() {
  std::string text;
#define SOFTWET_NAME(D, P) text += (text.empty() ? "" : ", ") + std::string(#D "D degree " #P);
  SOFTWET_CONFIGURATIONS(SOFTWET_NAME)
#undef SOFTWET_NAME
  return text;
}

/// Calls visit(Configuration<D, P>{}) for the configuration of a case. Throws Error (invalid_input) that names the
/// option this build lacks.
template <class Visit>
void with_configuration(const Case& c, const Visit& visit) {
#define SOFTWET_VISIT(D, P) \
  if (c.dimension() == D && c.domain.degree == P) return visit(Configuration<D, P>{});
  SOFTWET_CONFIGURATIONS(SOFTWET_VISIT)
#undef SOFTWET_VISIT
  throw Error(Exit::invalid_input, "domain.degree = " + std::to_string(c.domain.degree) + " with domain.size of " +
                                       std::to_string(c.dimension()) + " numbers: not in this build, which has: " +
                                       compiled_configurations() + " (CMake option SOFTWET_CONFIGURATIONS)");
}

}  // namespace softwet
