// What selective integration changes in the stress of a solid.
#pragma once

#include <vector>

#include "observe/solid_gradients.hpp"
#include "scene/coefficients.hpp"

namespace softwet {

/// Of a stress at points of which all belongs to Grad u there, the part that takes means over elements (SelectiveParts) becomes that of the
/// means. On lines of elements it is the mean of the elements beside them.
template <int D>
void take_means(const SolidPoints<D>&, const std::vector<Matrix<double, 3>>& gradients, const SolidCoefficients&,
                std::vector<Matrix<double, 3>>& stress);

}  // namespace softwet
