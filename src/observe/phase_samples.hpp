// Where liquid and vapour are in a state, on a grid.
#pragma once

#include "observe/host/droplet_watch.hpp"
#include "observe/snapshot.hpp"

namespace softwet {

/// The corners of the elements of the fluid. @param middle  (rho_l + rho_v)/2: a droplet is where the density is at
/// least that, a bubble where it is less.
template <int D>
PhaseSamples sample_phase(const Snapshot<D>&, double middle, Phase ambient);

}  // namespace softwet
