// Restricted additive Schwarz: dense factors of overlapping boxes of control points, all fields together.
#pragma once

#include "solver/patches.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

struct SchwarzControl {
  int core = 8;     ///< control points per axis in the core of a box
  int overlap = 2;  ///< further control points on each side
};

/// z = sum over boxes of (core restriction) A_box^-1 (r in the box). The rows of A_box^-1 that belong to the core are
/// stored in single precision, so applying is one dense product per box, without atomics, on the host or a device.
/// Cai and Sarkis, SIAM J. Sci. Comput. 21, 1999.
template <int D>
std::unique_ptr<Preconditioner> make_schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control);

}  // namespace softwet
