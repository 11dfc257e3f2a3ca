// Which part of the computation is in single precision.
#pragma once

#include "case/case.hpp"

namespace softwet {

/// full: nothing but the preconditioner. mixed: the linear solves of Newton's method too, with their products of the
/// Jacobian and their vectors. single: its residuals too. States, sums, integrals and the mass are always double.
enum class Precision { full, mixed, single };

/// Automatic is mixed where that changes nothing but the cost: not for explicit schemes, which have no linear solves; not
/// where differences of residuals stand for products; and not where linear solves are to go on to the round-off of
/// single precision.
inline Precision precision_of(const Case& c) {
  const SolverControl& s = c.solver;
  if (s.precision == "single") return Precision::single;
  if (s.precision != "automatic") return s.precision == "mixed" ? Precision::mixed : Precision::full;
  const bool serves = c.time.scheme == implicit_scheme && s.jacobian != "difference" && s.krylov_rtol >= 1e-5;
  return serves ? Precision::mixed : Precision::full;
}

inline const char* name_of(Precision p) {
  return p == Precision::full ? "double" : p == Precision::mixed ? "mixed" : "single";
}

}  // namespace softwet
