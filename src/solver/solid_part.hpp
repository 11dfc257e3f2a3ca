// A preconditioner that was built for another time step, in a solid.
#pragma once

#include "solver/scale_fields.hpp"

namespace softwet {

/// Unknowns whose own part of the Jacobian grows and falls with the time step as a whole: the velocities of a solid. Their
/// part of the answer of a preconditioner is multiplied by the ratio of the sizes at its build and now. So a preconditioner
/// lives longer while steps grow (docs/performance.md).
struct SolidPart {
  struct Range {
    int first, last;
  };
  std::vector<Range> ranges;
  double size = 1;  ///< of this part of the Jacobian, up to a factor that stays the same

  /// to = the answer `from` of a preconditioner that was built when the size was `built`. Both may be one vector.
  template <class To>
  void renew(double built, const Array& from, const ArrayOf<To>& to) const {
    const double ratio = built / size;
    if (std::is_same_v<To, double> && ratio == 1 && from.data() == static_cast<const void*>(to.data())) return;
    ScaleFields<To, double> scale{to, from};
    for (const Range& r : ranges) scale.factors.add(r.first, r.last, ratio);
    scale.run();
  }
};

}  // namespace softwet
