// The terms in the coordinates (r, z), in double precision.
#include "scene/make_pieces.hpp"

namespace softwet {

template Pieces<SOFTWET_DIMENSION, double> make_axisymmetric_pieces<SOFTWET_DIMENSION, SOFTWET_DEGREE>(
    const Regions<SOFTWET_DIMENSION>&, const Coefficients<SOFTWET_DIMENSION>&, const Case&);

}  // namespace softwet
