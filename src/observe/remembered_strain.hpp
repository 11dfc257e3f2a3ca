// What the Gauss points of a solid remember, at other points of it.
#pragma once

#include <vector>

#include "observe/solid_gradients.hpp"

namespace softwet {

/// The strain that branch number `branch` remembers under finite strains: the polynomial through the Gauss points of
/// the element that holds a point. @param gauss_points  of an element along each axis
template <int D>
std::vector<Matrix<double, 3>> remembered_strains(const SolidPoints<D>&, int branch, int gauss_points);

}  // namespace softwet
