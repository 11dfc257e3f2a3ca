// What selective integration changes in the stress of a solid.
#pragma once

#include <vector>

#include "observe/solid_gradients.hpp"
#include "scene/coefficients.hpp"

namespace softwet {

/// Takes a stress at points that follows from Grad u there alone, and replaces the part that takes means over elements
/// (SelectiveParts) by the stress of the means. On lines between elements it is the mean of the neighbouring elements.
template <int D>
void take_means(const SolidPoints<D>&, const std::vector<Matrix<double, 3>>& gradients, const SolidCoefficients&,
                std::vector<Matrix<double, 3>>& stress);

}  // namespace softwet
