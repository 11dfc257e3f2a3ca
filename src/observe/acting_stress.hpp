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

// Parts of it, each with a source.
/// stress_of_means: takes a stress at points that follows from Grad u there alone, and replaces the part that takes means
/// over elements (SelectiveParts) by the stress of the means. On lines between elements it is the mean of the
/// neighbouring elements.
template <int D>
void take_means(const SolidPoints<D>&, const std::vector<Matrix<double, 3>>& gradients, const SolidCoefficients&,
                std::vector<Matrix<double, 3>>& stress);
/// remembered_strain: the strain that branch number `branch` remembers under finite strains: the polynomial through the
/// Gauss points of the element that holds a point. @param gauss_points  of an element along each axis
template <int D>
std::vector<Matrix<double, 3>> remembered_strains(const SolidPoints<D>&, int branch, int gauss_points);

}  // namespace softwet
