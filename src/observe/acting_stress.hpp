// The stress that acts in the solid: of its elasticity, as it is integrated, its fibres, its viscosity and its
// branches.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "observe/solid_gradients.hpp"
#include "scene/coefficients.hpp"

namespace softwet {

/// First Piola-Kirchhoff stress at points of the solid, the sum of the stresses of its terms in the equations. With
/// selective integration the part that takes means over elements is uniform in each element; between elements it is the
/// mean of their stresses.
/// @param gradients  displacement_gradients of the points
template <int D>
std::vector<Matrix<double, 3>> acting_stress(const SolidPoints<D>&, const std::vector<Matrix<double, 3>>& gradients,
                                             const Case&, const SolidCoefficients&);

}  // namespace softwet
