// The pieces that the program has compiled, in src/model/pieces.cpp and pieces_single.cpp: it is these that tests are to test.
#pragma once

#include "patch.hpp"

#define SOFTWET_COMPILED(D, TERM, MOTION)                                                          \
  extern template class softwet::PieceOf<D, 2, softwet::TERM, softwet::MOTION<D, double>, double>; \
  extern template class softwet::PieceOf<D, 2, softwet::TERM, softwet::MOTION<D, float>, float>;
#define SOFTWET_COMPILED_SOLID(D, MATERIAL) SOFTWET_COMPILED(D, Elastodynamics<softwet::MATERIAL>, Still)
#define SOFTWET_COMPILED_ALL(D, MOTION)             \
  SOFTWET_COMPILED(D, NavierStokesKorteweg, MOTION) \
  SOFTWET_COMPILED(D, DensityMoment, MOTION)        \
  SOFTWET_COMPILED(D, GradientWall, MOTION)         \
  SOFTWET_COMPILED(D, EnergyWall, MOTION)           \
  SOFTWET_COMPILED(D, CapillaryTraction, MOTION)    \
  SOFTWET_COMPILED_SOLID(D, SaintVenantKirchhoff)   \
  SOFTWET_COMPILED_SOLID(D, Hooke)                  \
  SOFTWET_COMPILED_SOLID(D, NeoHookean)
namespace softwet {
template <int, class>
using Still = NoMotion;
}
SOFTWET_COMPILED_ALL(2, WallMotion)
SOFTWET_COMPILED_ALL(2, Still)
SOFTWET_COMPILED_ALL(3, WallMotion)
SOFTWET_COMPILED_ALL(3, Still)
