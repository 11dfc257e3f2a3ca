// How the implicit scheme is set where it looks for a state of rest, and at one.
#pragma once

#include <algorithm>

#include "case/case.hpp"

namespace softwet {

/// A scene is at rest where its residual is less than this many times the change that the last digit of the fields
/// causes in it.
inline constexpr double digits_of_rest = 8;

/// Steps that are longer are stretched ones of this length, see StillSteps::settle. A thin vapour fills in about this
/// time.
inline constexpr double moderate_step = 2e3;

/// Newton's method need not be accurate on the way, but its products and linear solves must be: the steps are long, and
/// the modes of a scene near rest differ by many powers of ten.
inline Case rest_control(const Case& c) {
  Case loose = c;
  loose.time.scheme = TimeScheme::generalized_alpha;
  loose.solver.jacobian = JacobianKind::exact;
  loose.solver.precision = PrecisionChoice::full;
  loose.solver.newton_rtol = 1e-3;
  loose.solver.newton_max = std::max(c.solver.newton_max, 15);
  loose.solver.krylov_rtol = std::min(c.solver.krylov_rtol, 1e-2);
  return loose;
}

}  // namespace softwet
