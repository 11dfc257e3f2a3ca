// Brings a scene to rest before a computation: pseudo-transient continuation.
#pragma once

#include <functional>

#include "time/judge.hpp"

namespace softwet {

/// How a scene came to rest.
struct Relaxation {
  long steps = 0, rejected = 0, newton = 0, krylov = 0;
  double rate = 0;           ///< of change at the end, see `relax`; scale sqrt(ab)/L0
  double time = 0;           ///< sum of the steps
  bool interrupted = false;  ///< the state is on its way to rest
};

/// Advances a state by steps of backward Euler without loads until it is at rest. A step doubles where the one before
/// has changed the state little, so that the way there is not accurate, but the end is: mass is conserved and the
/// equations of the state at rest are those of the scene. At rest means that the rate of change
///   r = max( rms(rho') / (rho_l - rho_v),  rms(rho'/rho in the vapour),  rms(u') / Hs )
/// is below 1e-6. The second one sees a thin vapour that fills slowly. A droplet that creeps more slowly than that counts
/// as at rest. The state gets the time `time` and is as one that `Scheme::initialise` has not seen.
/// Throws Error (computation_failed) where this does not happen, with the reason. Ends earlier when interrupted.
/// @param watch  called with the state after each step
/// Source: Kelley and Keyes 1998.   Tested: tests/unit/time/test_relaxation.cpp
template <int D, int P>
Relaxation relax(
    const Model<D, P>&, const Case&, State&, double time,
    const std::function<bool()>& interrupted = [] { return false; },
    const std::function<void(const State&)>& watch = [](const State&) {});

}  // namespace softwet
