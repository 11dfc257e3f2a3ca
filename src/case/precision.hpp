// Which part of the computation is in single precision.
#pragma once

#include "case/case.hpp"

namespace softwet {

/// full: nothing but the preconditioner. mixed: the linear solves of Newton's method too, with their products of the
/// Jacobian and their vectors. States, residuals, sums, integrals and the mass are always double.
enum class Precision { full, mixed };

/// Least reduction that a linear solve in single precision is asked for.
inline constexpr double least_single_rtol = 1e-5;

/// What keeps a case in double precision.
enum class Hindrance {
  none,
  scheme,      ///< explicit schemes have no linear solves
  difference,  ///< differences of residuals, in place of products, have no digits left
  tolerance    ///< linear solves are to go on to the round-off of single precision
};

inline Hindrance hindrance_of_single(const Case& c) {
  if (!c.time.implicit()) return Hindrance::scheme;
  if (c.solver.jacobian == JacobianKind::difference) return Hindrance::difference;
  return c.solver.krylov_rtol < least_single_rtol ? Hindrance::tolerance : Hindrance::none;
}

/// Automatic is mixed where nothing hinders it: it changes nothing but the cost. A case file that asks for single precision
/// in spite of a hindrance is refused.
inline Precision precision_of(const Case& c) {
  switch (c.solver.precision) {
    case PrecisionChoice::automatic:
      return hindrance_of_single(c) == Hindrance::none ? Precision::mixed : Precision::full;
    case PrecisionChoice::mixed:
      return Precision::mixed;
    case PrecisionChoice::full:
      return Precision::full;
  }
  return Precision::full;
}

inline const char* name_of(Precision p) { return p == Precision::full ? "double" : "mixed"; }

}  // namespace softwet
