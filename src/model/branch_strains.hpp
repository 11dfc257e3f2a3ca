// What the branches of a solid remember under finite strains: the Green-Lagrange strain at its points.
#pragma once

#include <functional>

#include "model/model.hpp"

namespace softwet {

/// Lines of columns that a branch remembers: those of a displacement under small strains, of a strain at each point under finite ones.
template <int D>
int branch_lines(const Layout<D>&, const Substrate&, int points);

/// E of a displacement at all points of the solid, with the places of PointMemory. In the coordinates (r, z) with its hoop entry.
template <int D, int P>
void write_strains(const Model<D, P>&, const ConstArray& displacement, const Array& out);
/// E' of the displacement and the velocity of a stage.
template <int D, int P>
void write_strain_rates(const Model<D, P>&, const Stage&, const Array& out);

/// out = the strain that branches follow, of a displacement; empty where they follow the displacement itself.
using StrainFollowed = std::function<void(const ConstArray& displacement, const Array& out)>;
template <int D, int P>
StrainFollowed strain_followed(const Model<D, P>& model) {
  if (!model.remembers_strains()) return {};
  return [&model](const ConstArray& displacement, const Array& out) { write_strains(model, displacement, out); };
}

}  // namespace softwet
