// Multilevel Schwarz: dense inverses of overlapping boxes of control points, over a coarse space.
#pragma once

#include "solver/preconditioner.hpp"
#include "solver/schwarz/patches.hpp"

namespace softwet {

struct SchwarzControl {
  int width;                    ///< control points of a box along an axis
  int stride;                   ///< of the boxes; neighbours share width - stride layers of control points, or more
  bool coarse = true;           ///< with coarse levels
  bool multiplicative = false;  ///< see below; always on coarse levels
  int direct_up_to = 60000;     ///< unknowns of a coarse space that is solved directly; above, Schwarz again
  float share = 0;              ///< distance below which boxes share an inverse; 0: none does
  bool dense_bottom = false;    ///< directly: by a dense inverse on the device, or by factors on the host (block LU)

  /// Wider boxes need fewer iterations and more memory; these are a compromise. In three dimensions one more level is
  /// faster than factors of 25 000 unknowns. Boxes share inverses as far as that costs no iterations
  /// (docs/development/solver_choices.md). On a device nothing is done on the host.
  static SchwarzControl for_dimension(int d) {
    SchwarzControl c = d == 2 ? SchwarzControl{.width = box_width(2), .stride = 6}
                              : SchwarzControl{.width = box_width(3), .stride = 3, .direct_up_to = 10000};
    c.share = 0.1f;
    if (!host_algorithms) {
      c.direct_up_to = 3000;
      c.dense_bottom = true;
    }
    return c;
  }
};

/// z = P A_c^-1 P^T r + sum over boxes of W_b A_b^-1 W_b r_b. A_b: all fields of the box; W_b: one over the square root
/// of the number of boxes that hold the unknown; A_c = P^T A P on half as many elements per axis, and so on below.
/// With `multiplicative` the boxes get the residual that the coarse correction leaves, r - A P A_c^-1 P^T r, and half of
/// their answer is added. This takes fewer iterations and costs a product with A P, which is cheap on the coarse levels.
/// The finest level is additive (docs/development/solver_choices.md says why).
/// Applying is one dense product for each box, on the host or a device (solver/schwarz/boxes.hpp); sums have a fixed order.
/// Of several processes each has the boxes that touch its own columns, on every level whose columns can be cut as the
/// finest one's are. The others are collected and done alike by all. The layout has width - 1 columns beside one's own, the
/// mask is right in these too, and the answer is right in one's own columns.
/// Source: Toselli and Widlund, Domain Decomposition Methods, Springer 2005.
template <int D>
std::unique_ptr<StencilSolver<D>> make_schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control);

}  // namespace softwet
