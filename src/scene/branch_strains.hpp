// What the branches of a solid remember under finite strains: the Green-Lagrange strain at its points.
#pragma once

#include <functional>

#include "field/stage.hpp"
#include "scene/regions.hpp"

namespace softwet {

/// E of a displacement at all points of the solid, at the places of PointMemory. In the coordinates (r, z) with its
/// hoop entry.
template <int P, int D>
void write_strains(const Regions<D>&, const ConstArray& displacement, const Array& out);
/// E' of the displacement and the velocity of a stage.
template <int P, int D>
void write_strain_rates(const Regions<D>&, const Stage&, const Array& out);

/// out = the strain that branches follow, of a displacement; empty where they follow the displacement itself.
using StrainFollowed = std::function<void(const ConstArray& displacement, const Array& out)>;
template <int P, int D>
StrainFollowed strain_followed(const Regions<D>& regions) {
  if (!regions.layout().branches_at_points) return {};
  return [&regions](const ConstArray& displacement, const Array& out) { write_strains<P>(regions, displacement, out); };
}

}  // namespace softwet
