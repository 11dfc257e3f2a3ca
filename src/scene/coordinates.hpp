// The terms and functionals of a scene in its coordinates.
#pragma once

#include "field/layout.hpp"
#include "kernels/point/fields.hpp"

namespace softwet {

/// What `use` returns for a term or a functional in the coordinates of a layout: as it is, or in (r, z).
template <int D, class Term, class Use>
auto in_coordinates_of(const Layout<D>& layout, const Term& term, const Use& use) {
  if constexpr (D == 2)
    if (layout.axisymmetric()) return use(Axisymmetric<Term>{term});
  return use(term);
}

}  // namespace softwet
