// The configurations this build holds: dimension x degree x precision, and the step from a case to one of them.
#pragma once

#include <string>

#include "app/case.hpp"
#include "app/error.hpp"

namespace softwet {

template <int D, int P>
struct Configuration {
  static constexpr int dimension = D, degree = P;
};

inline constexpr const char* compiled_configurations = "2D, degree 2, double";

/// Calls visit(Configuration<D, P>{}) for the configuration of a case. Throws Error (invalid_input) that names the
/// option this build lacks.
template <class Visit>
auto with_configuration(const Case& c, const Visit& visit) {
  const auto refuse = [](const std::string& option) {
    throw Error(Exit::invalid_input, option + ": not in this build, which has: " + compiled_configurations);
  };
  if (c.dimension() != 2) refuse("domain.size with " + std::to_string(c.dimension()) + " numbers");
  if (c.domain.degree != 2) refuse("domain.degree = " + std::to_string(c.domain.degree));
  if (c.solver.precision != "double") refuse("solver.precision = \"" + c.solver.precision + "\"");
  if (c.time.scheme != "generalized_alpha") refuse("time.scheme = \"" + c.time.scheme + "\"");
  return visit(Configuration<2, 2>{});
}

}  // namespace softwet
