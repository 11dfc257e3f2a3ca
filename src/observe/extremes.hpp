// The largest and smallest control values of a state, over all processes.
#pragma once

#include "field/layout.hpp"
#include "field/stage.hpp"
#include "operator/integrate.hpp"

namespace softwet {

/// Of control values, not of the fields between them. Speeds are the lengths of velocities.
struct Extremes {
  double density_min = 0, density_max = 0;  ///< 0 without a fluid
  double speed_fluid = 0;                   ///< on the rows of the fluid, the wall included
  double speed_solid = 0;                   ///< on the rows of the solid, the wall included
  double speed_liquid = 0;                  ///< where the density is above a level
};

/// Starts to look for them: each process looks at its own columns, and all learn the outcome. It is there when `pending` is finished, and
/// `found` has to stay where it is until then.
/// @param level  density of the liquid's surface
template <int D>
void start_extremes(const Layout<D>& layout, const State& state, double level, PendingIntegrals& pending,
                    Extremes& found);
/// The same, and waits.
template <int D>
Extremes find_extremes(const Layout<D>& layout, const State& state, double level);

}  // namespace softwet
