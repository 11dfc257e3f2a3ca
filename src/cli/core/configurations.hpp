// The configurations this build holds: dimension x degree and (r, z), and the step from a case to one of them.
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

/// "2D degree 2, (r, z) degree 2, ...": what `softwet info` and errors show.
inline std::string compiled_configurations() {
  std::string text;
#define SOFTWET_NAME(D, P) text += (text.empty() ? "" : ", ") + std::string(#D "D degree " #P);
  SOFTWET_CONFIGURATIONS(SOFTWET_NAME)
#undef SOFTWET_NAME
#define SOFTWET_NAME(P) text += ", (r, z) degree " #P;
  SOFTWET_AXISYMMETRIC_DEGREES(SOFTWET_NAME)
#undef SOFTWET_NAME
  return text;
}

/// What a case needs, as the CMake list SOFTWET_CONFIGURATIONS has it: "3x2", "rz2".
inline std::string configuration_of(const Case& c) {
  const std::string degree = std::to_string(c.domain.degree);
  return c.axisymmetric() ? "rz" + degree : std::to_string(c.dimension()) + "x" + degree;
}

inline bool is_compiled(const Case& c) {
#define SOFTWET_MATCH(D, P) \
  if (!c.axisymmetric() && c.dimension() == D && c.domain.degree == P) return true;
  SOFTWET_CONFIGURATIONS(SOFTWET_MATCH)
#undef SOFTWET_MATCH
#define SOFTWET_MATCH(P) \
  if (c.axisymmetric() && c.domain.degree == P) return true;
  SOFTWET_AXISYMMETRIC_DEGREES(SOFTWET_MATCH)
#undef SOFTWET_MATCH
  return false;
}

/// Calls visit(Configuration<D, P>{}) for the configuration of a case. Throws Error (invalid_input) that names the
/// option this build lacks.
template <class Visit>
void with_configuration(const Case& c, const Visit& visit) {
  if (!is_compiled(c))
    throw Error(Exit::invalid_input,
                "domain.degree = " + std::to_string(c.domain.degree) + " in " +
                    (c.axisymmetric() ? "the coordinates (r, z)" : std::to_string(c.dimension()) + "D") +
                    ": not in this build, which has: " + compiled_configurations() + "; 'tools/setup --with " +
                    configuration_of(c) + " softwet' adds it, and tools/run does so by itself");
#define SOFTWET_VISIT(D, P) \
  if (c.dimension() == D && c.domain.degree == P) return visit(Configuration<D, P>{});
  SOFTWET_CONFIGURATIONS(SOFTWET_VISIT)
#undef SOFTWET_VISIT
}

}  // namespace softwet
