// Two-level additive Schwarz: dense inverses of overlapping boxes of control points, over a coarse space.
#pragma once

#include "solver/preconditioner.hpp"

namespace softwet {

struct SchwarzControl {
  int width;                 ///< control points of a box along an axis
  int stride;                ///< of the boxes; neighbours share width - stride layers of control points, or more
  bool coarse = true;        ///< with the coarse space
  int direct_up_to = 60000;  ///< unknowns of a coarse space that is factorised (block LU); above, Schwarz again

  /// Wider boxes take fewer iterations and more memory; these are a compromise.
  static SchwarzControl for_dimension(int d) { return d == 2 ? SchwarzControl{8, 6} : SchwarzControl{4, 3}; }
};

/// z = P A_c^-1 P^T r, then z += 1/2 sum over boxes of W_b A_b^-1 W_b (r - A z)_b. A_b: all fields of the box; W_b: one
/// over the square root of the number of boxes that hold the unknown; A_c = P^T A P on half as many elements per axis.
/// A z is the operator that was set, matrix-free, or the assembled matrix. Inverses are stored in single precision, so
/// applying is one dense product per box, on the host or a device; sums have a fixed order. Toselli and Widlund, Domain
/// Decomposition Methods, Springer 2005.
template <int D>
std::unique_ptr<StencilSolver<D>> make_schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control);

}  // namespace softwet
