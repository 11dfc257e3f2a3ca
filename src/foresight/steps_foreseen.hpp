// How many explicit steps a case would take, before there is a mesh, and which scheme that speaks for (host).
#pragma once

#include "case/case.hpp"

namespace softwet {

/// Steps of kick_drift with corrected masses from the first state to time.end, with time.safety. The bound of
/// StepBound, with the densities of the two phases, an undeformed solid, and a flow as fast as the fastest droplet at
/// the start.
/// Tested against the bound of the first state: tests/unit/foresight/test_steps_foreseen.cpp
double explicit_steps_foreseen(const Case&);

/// Up to this many explicit steps are cheaper than the implicit ones of the same scene. In 3D an implicit step costs
/// more of them. Measured: docs/fast_scenes.md
double most_explicit_steps(int dimension);

}  // namespace softwet
