// Body force per unit mass on a box of the solid, switched on by a linear ramp.
#pragma once

namespace softwet {

/// Fraction of the load at time t: 0 before `start`, growing linearly to 1 over `ramp`.
inline double load_fraction(double t, double start, double ramp) {
  if (t <= start) return 0.0;
  return t >= start + ramp ? 1.0 : (t - start) / ramp;
}

}  // namespace softwet
