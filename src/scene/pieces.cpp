// The terms in double precision.
#include "scene/make_pieces.hpp"

namespace softwet {

template Pieces<SOFTWET_DIMENSION, double> make_pieces(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Case&);

}  // namespace softwet
