// A preconditioner that was built for another time step, in a solid.
#pragma once

#include <vector>

#include "field/range_factors.hpp"

namespace softwet {

/// Unknowns whose own part of the Jacobian grows and falls with the time step as a whole: the velocities of a solid. Their
/// part of the answer of a preconditioner is multiplied by the ratio of the sizes at its build and now. So a preconditioner
/// lives longer while steps grow (docs/development/solver_choices.md).
struct SolidPart {
  struct Range {
    int first, last;
  };
  std::vector<Range> ranges;
  double size = 1;  ///< of this part of the Jacobian, up to a factor that stays the same

  /// What the answer of a preconditioner is multiplied with that was built when the size was `built`.
  RangeFactors factors(double built) const {
    RangeFactors all;
    const double ratio = built / size;
    for (const Range& r : ranges)
      if (ratio != 1) all.add(r.first, r.last, ratio);
    return all;
  }
};

}  // namespace softwet
