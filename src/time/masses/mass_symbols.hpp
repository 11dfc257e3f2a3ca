// How fast the shortest waves of a mesh are under the masses of explicit schemes.
#pragma once

#include <algorithm>
#include <vector>

#include "case/choices.hpp"

namespace softwet {

/// Largest frequencies and rates on elements of length 1, over all waves that the mesh has:
///   sound w = acoustic c / h,  capillary waves w = capillary g sqrt(rho) / h^2,  viscosity s = viscous (4/3 m / rho) /
///     h^2,
///   stabilisation  k = diffusive / h^2,  convection w = convective |v| / h,  elastic waves w = elastic c_p / h,
///   waves of a face with the tension Ups on a solid w = surface sqrt(Ups / rho_0) / h^(3/2), for each axis of the
///     face,
///   a face on springs, which is free otherwise, w = springs sqrt(kap / rho_0 / h),
///   springs of the stiffness k at control values  w = sqrt(held k / rho_0).
/// With lumped and corrected masses they are equal in 2D and 3D. With consistent masses the symbols of the axes add up
/// (acoustic and elastic: their squares), except for `held`, whose factors of the axes multiply.
struct MassSymbols {
  double acoustic = 0, capillary = 0, viscous = 0, diffusive = 0, convective = 0, elastic = 0, surface = 0, springs = 0,
         held = 0;
};

/// Away from the ends of axes: the extremes of the Fourier symbols.
MassSymbols inside_symbols(int degree, MassKind);
/// The fewest elements that a material has along an axis with ends, of all of these but zeros; from ten on more make no
/// difference.
inline int fewest_that_matter(const std::vector<int>& elements) {
  int fewest = 10;
  for (const int n : elements)
    if (n > 0) fewest = std::min(fewest, n);
  return fewest;
}
/// Symbols at an end with an open knot, with its ties, at least the symbols inside. They are the eigenvalues of a line
/// of this many elements; where it is short, its two ends affect each other. The elastic symbol is for a layer that is
/// held below and free above, or free on both sides.
/// @param coordinates  in (r, z) the line begins at the axis of symmetry: masses and stiffnesses have the weight r, and
///   vectors their hoop strain v_r / r. These symbols are up to a fifth larger.
MassSymbols end_symbols(int degree, MassKind, int elements = 10, Coordinates coordinates = Coordinates::plane);
/// Elements of a solid below and above its joint. Zeros: there is no joint.
struct JoinedElements {
  int below = 0, above = 0;
};
/// At least `ends`: symbols of a solid with a joint, where the knot is repeated and a tie holds the lower part to the
/// joint. They are the eigenvalues of a line of this many elements, ten of each at most. They hold for any stiffness up
/// to the given one on either side, since a softer side has slower waves.
MassSymbols with_joint(MassSymbols ends, int degree, MassKind, JoinedElements);

}  // namespace softwet
