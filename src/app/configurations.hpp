// The configurations this build holds: dimension x degree, and the step from a case to one of them.
#pragma once

#include <softwet_configurations.hpp>
#include <string>

#include "app/case.hpp"
#include "app/error.hpp"

namespace softwet {

template <int D, int P>
struct Configuration {
  static constexpr int dimension = D, degree = P;
};

/// Whether this build has the values "mixed" and "single" of solver.precision.
#ifdef SOFTWET_SINGLE
inline constexpr bool has_single_precision = true;
#else
inline constexpr bool has_single_precision = false;
#endif

/// "2D degree 2, 2D degree 3, ...; double": what `softwet info` and errors show.
inline std::string compiled_configurations() {
  std::string text;
#define SOFTWET_NAME(D, P) text += (text.empty() ? "" : ", ") + std::string(#D "D degree " #P);
  SOFTWET_CONFIGURATIONS(SOFTWET_NAME)
#undef SOFTWET_NAME
  return text + (has_single_precision ? "; double, mixed, single" : "; double");
}

/// Calls visit(Configuration<D, P>{}) for the configuration of a case. Throws Error (invalid_input) that names the
/// option this build lacks.
template <class Visit>
void with_configuration(const Case& c, const Visit& visit) {
  const auto refuse = [](const std::string& option, const char* build_option = "SOFTWET_CONFIGURATIONS") {
    throw Error(Exit::invalid_input, option + ": not in this build, which has: " + compiled_configurations() +
                                         " (CMake option " + build_option + ")");
  };
  if (c.solver.precision != "double" && !has_single_precision)
    refuse("solver.precision = \"" + c.solver.precision + "\"", "SOFTWET_SINGLE");
#define SOFTWET_VISIT(D, P) \
  if (c.dimension() == D && c.domain.degree == P) return visit(Configuration<D, P>{});
  SOFTWET_CONFIGURATIONS(SOFTWET_VISIT)
#undef SOFTWET_VISIT
  refuse("domain.degree = " + std::to_string(c.domain.degree) + " with domain.size of " +
         std::to_string(c.dimension()) + " numbers");
}

}  // namespace softwet
