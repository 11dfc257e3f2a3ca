// Brings a scene to rest before a computation: pseudo-transient continuation.
#pragma once

#include <functional>
#include <string>

#include "time/step/judge.hpp"

namespace softwet {

/// How a scene came to rest.
struct Relaxation {
  long steps = 0, rejected = 0, newton = 0, krylov = 0;
  double rate = 0;           ///< of change at the end, see `relax`; scale sqrt(ab)/L0
  double time = 0;           ///< sum of the steps
  double excess = 0;         ///< of the residual at the end over its round-off, see `Settling`
  bool interrupted = false;  ///< the state is on its way to rest
  std::string why;           ///< it is not at rest; empty: it is
  Refusal refusal;           ///< of the last step, where it is not at rest
};

/// Advances a state by steps of backward Euler, under the loads of its time, until it is at rest. A step is up to ten
/// times as long as the one before where that has changed the state little, without a longest one, so that the way
/// there is not accurate, but the end is: mass is conserved and the equations of the state at rest are those of the
/// scene. At rest means that what is left of them without rates of change is less than `digits_of_rest` times what the
/// last digit of the fields makes of them, that a long step does not move the solid, and that nothing flows. Where
/// Newton's method does not get so far, a rate of change
///   r = max( rms(rho') / (rho_l - rho_v),  rms(rho'/rho in the vapour),  rms(u') / Hs )
/// below 1e-6 counts as rest too, at last after 200 steps. The second one sees a thin vapour that fills slowly.
/// The state keeps its time, and is as one that `Scheme::initialise` has not seen. Ends earlier when interrupted, or
/// where the scene does not come to rest, with the last state and the reason.
/// @param watch  called after each step, with the state and what has been done so far
/// Source: Kelley and Keyes 1998.   Tested: tests/unit/time/rest/test_relaxation.cpp
template <int D, int P>
Relaxation relax(
    const Scene<D, P>&, const Case&, State&, const std::function<bool()>& interrupted = [] { return false; },
    const std::function<void(const State&, const Relaxation&)>& watch = [](const State&, const Relaxation&) {});

}  // namespace softwet
