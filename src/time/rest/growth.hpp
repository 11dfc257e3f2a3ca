// Whether a state of rest is stable: the growth rates of small disturbances.
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "time/step/judge.hpp"

namespace softwet {

/// The modes exp(rate t) of a state of rest that grow fastest, or decay slowest.
struct Growth {
  std::vector<std::complex<double>> rates;  ///< the largest real part first; scale sqrt(ab)/L0
  int steps = 0;                            ///< that a disturbance was followed through
  long krylov = 0;
  std::string why;  ///< that there are no rates; empty: there are some
};

/// Rates below this one, up or down, belong to a state that neither returns nor leaves, as a droplet on a rigid wall
/// that may lie anywhere along a periodic axis. A mode that oscillates faster than 1 has this part of its frequency.
inline constexpr double neutral_rate = 1e-6;

/// The equations at a state of rest, linear in the disturbance z of velocities, density and displacement, are M z' = -K
/// z. A step dt of backward Euler, B = (M + dt K)^-1 M, has the same modes, and the factors 1 / (1 - rate dt): the
/// slowest and the growing ones have those of the largest size. Arnoldi's method finds them. B takes a linear solve
/// with the Jacobian of the implicit scheme; what the start of the step adds to it is a difference of residuals. The
/// mode of the total mass, which keeps any value, is taken out: B z - (mass of z / volume) has the others unchanged,
/// because the mass is its left eigenvector (Brauer 1952).
/// Rates are found up to about 0.5, to 1 % or 1e-7. Two are looked for, so that the first one is the rate of the
/// fastest mode.
/// @param rest  a state that `relax` has found
/// Source: Tuckerman and Barkley 2000 (time steppers as operators).   Tested: tests/unit/time/rest/test_growth.cpp
template <int D, int P>
Growth growth_at_rest(
    const Scene<D, P>&, const Case&, const State& rest,
    const std::function<bool()>& interrupted = [] { return false; });

}  // namespace softwet
