// Colours of unknowns, and the walk over all stored unknowns that index tables are built with.
#pragma once

#include <vector>

#include "field/ghosts.hpp"

namespace softwet {

/// Two unknowns of one colour share no row of the Jacobian with frozen geometry: control points further apart than the
/// degree do not couple, so one product yields all columns of a colour. (2 degree + 1)^D colours per component.
struct Colours {
  int count = 0;
  std::vector<int> of;     ///< per unknown; -1: prescribed or ghost
  std::vector<int> point;  ///< [unknown][3] control point of the patch
};

template <int D>
Colours make_colours(const Layout<D>&, const std::vector<double>& mask);

/// Calls visit(unknown, component, point) for every stored unknown; point: control point of the patch.
template <int D, class Visit>
void for_unknowns(const Layout<D>& layout, const Visit& visit) {
  const std::vector<Box<D>> all = boxes(layout);
  for (std::size_t c = 0; c < all.size(); ++c) {
    int points = 1;
    for (int d = 0; d < D; ++d) points *= all[c].extent[d];
    for (int p = 0; p < points; ++p) {
      int point[3] = {0, 0, 0};
      for (int d = 0, rest = p; d < D; ++d) {
        point[d] = rest % all[c].extent[d];
        rest /= all[c].extent[d];
      }
      if (c >= static_cast<std::size_t>(D)) point[D - 1] += layout.wall_row;
      visit(all[c].offset + p, static_cast<int>(c), point);
    }
  }
}

}  // namespace softwet
