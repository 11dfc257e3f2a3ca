// The volume of the liquid of a state.
#pragma once

#include "scene/model.hpp"

namespace softwet {

/// Integral of LiquidVolume over the moved fluid domain, of a whole turn in the coordinates (r, z); L0^D, there L0^3. All processes
/// have to call it. 0 without a fluid.
template <int D, int P>
double liquid_volume(const Model<D, P>&, const Stage&);

}  // namespace softwet
