// Whether a run can start from its first state.
#pragma once

#include "field/stage.hpp"
#include "scene/balance.hpp"

namespace softwet {

/// Largest density of a state that can be computed; the fluid is close-packed at 1.
constexpr double close_packed = 0.999;

/// Refuses a density with a control value below 0 or from `close_packed` on. The density of an earlier run may
/// undershoot 0 as far as the density of this run may (solver.newton.undershoot). The message names the position of the
/// value that is furthest outside, the value, the range, and by which factor smaller waves would fit. All processes
/// decide alike.
/// @param without_waves  control values of droplets, films and the vapour around them
/// @param density        control values with the waves
/// Errors: invalid_input.   Tested: tests/unit/scene/test_initial.cpp
template <int D>
void require_density(const Case&, const Layout<D>&, const std::vector<double>& without_waves,
                     const std::vector<double>& density);

/// Refuses waves of the displacement that turn the solid inside out (det F <= 0), or fold the mesh of the fluid above
/// it (J < 0), at a Gauss point. All processes decide alike.
/// Errors: invalid_input.   Tested: tests/unit/scene/test_initial.cpp
template <int D, int P>
void require_upright(const Case&, const Layout<D>&, const Balance<D, P>&, const State&);

}  // namespace softwet
