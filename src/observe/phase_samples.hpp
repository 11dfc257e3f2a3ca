// Where liquid and vapour are in a state, on a grid.
#pragma once

#include "observe/host/droplet_watch.hpp"
#include "observe/snapshot.hpp"
#include "observe/surface.hpp"

namespace softwet {

/// The corners of the elements of the fluid.
template <int D>
PhaseSamples sample_phase(const Snapshot<D>&, const Surface&);

}  // namespace softwet
