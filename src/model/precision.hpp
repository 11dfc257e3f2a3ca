// Which part of the computation is in single precision.
#pragma once

#include "app/case.hpp"

namespace softwet {

/// full: nothing but the preconditioner. mixed: the linear solves of Newton's method too, with their products of the
/// Jacobian and their vectors. single: its residuals too. States, sums, integrals and the mass are always double.
enum class Precision { full, mixed, single };

inline Precision precision_of(const Case& c) {
  if (c.solver.precision == "mixed") return Precision::mixed;
  return c.solver.precision == "single" ? Precision::single : Precision::full;
}

}  // namespace softwet
