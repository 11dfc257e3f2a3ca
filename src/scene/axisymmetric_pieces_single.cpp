// The terms in the coordinates (r, z), in single precision.
#include "scene/make_pieces.hpp"

namespace softwet {

#if SOFTWET_DIMENSION == 2
template Pieces<SOFTWET_DIMENSION, float> make_axisymmetric_pieces(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                                                   const Case&);
#endif

}  // namespace softwet
