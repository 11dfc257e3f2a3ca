// The terms in single precision: products and matrices, with twice as many elements in a pack.
#include "scene/make_pieces.hpp"

namespace softwet {

template Pieces<SOFTWET_DIMENSION, float> make_pieces<SOFTWET_DIMENSION, SOFTWET_DEGREE>(
    const Regions<SOFTWET_DIMENSION>&, const Coefficients<SOFTWET_DIMENSION>&, const Case&);

}  // namespace softwet
