// In place of the terms in the coordinates (r, z) in a build without them, which refuses their cases
// (cli/core/configurations.hpp).
#include <stdexcept>

#include "scene/pieces.hpp"

namespace softwet {

template <int D, int P, class Real>
Pieces<D, Real> make_axisymmetric_pieces(const Regions<D>&, const Coefficients<D>&, const Case&) {
  throw std::logic_error("this build has no terms in the coordinates (r, z)");
}

template Pieces<2, double> make_axisymmetric_pieces<2, SOFTWET_DEGREE>(const Regions<2>&, const Coefficients<2>&,
                                                                       const Case&);
template Pieces<2, float> make_axisymmetric_pieces<2, SOFTWET_DEGREE>(const Regions<2>&, const Coefficients<2>&,
                                                                      const Case&);

}  // namespace softwet
