// The largest and smallest control values of a state, over all processes.
#pragma once

#include "field/layout.hpp"
#include "field/stage.hpp"
#include "operator/integrate.hpp"

namespace softwet {

/// Extremes of control values, not of the fields between them. Speeds are the lengths of velocities.
struct Extremes {
  double density_min = 0, density_max = 0;  ///< 0 without a fluid
  double speed_fluid = 0;                   ///< on the rows of the fluid, the wall included
  double speed_solid = 0;                   ///< on the rows of the solid, the wall included
  double speed_liquid = 0;                  ///< where the density is above a level
};

/// Starts the search for extremes: each process searches its own columns, and all learn the outcome. The result is
/// there when `pending` is finished, and `found` has to stay where it is until then.
/// @param level  density of the liquid's surface
template <int D>
void start_extremes(const Layout<D>& layout, const State& state, double level, PendingIntegrals& pending,
                    Extremes& found);
/// Finds the extremes and waits for them.
template <int D>
Extremes find_extremes(const Layout<D>& layout, const State& state, double level);

}  // namespace softwet
