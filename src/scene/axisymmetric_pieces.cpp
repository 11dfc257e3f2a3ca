// The terms in the coordinates (r, z), in double precision.
#include "scene/make_pieces.hpp"

namespace softwet {

#if SOFTWET_DIMENSION == 2
template Pieces<SOFTWET_DIMENSION, double> make_axisymmetric_pieces(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                                                    const Case&);
#endif

}  // namespace softwet
