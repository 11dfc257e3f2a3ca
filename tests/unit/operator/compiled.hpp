// The pieces that the program has compiled, in src/scene/pieces.cpp and pieces_single.cpp: it is these that tests are
// to test.
#pragma once

#include "kernels/fluid/line_friction.hpp"
#include "kernels/fluid/stretched_wall.hpp"
#include "kernels/foundation/terms.hpp"
#include "kernels/solid/branches.hpp"
#include "kernels/solid/fibres.hpp"
#include "kernels/solid/graded.hpp"
#include "kernels/solid/kelvin_voigt.hpp"
#include "kernels/solid/surface_elasticity.hpp"
#include "kernels/solid/surface_tension.hpp"
#include "patch.hpp"

// The members that are no part of the class, one by one: compilers need not inline the others.
#define SOFTWET_COMPILED(D, TERM, MOTION)                                                                        \
  extern template void softwet::PieceOf<D, 2, softwet::TERM, softwet::MOTION<D, double>, double>::residual(      \
      const softwet::Evaluation<D, double>&) const;                                                              \
  extern template void softwet::PieceOf<D, 2, softwet::TERM, softwet::MOTION<D, double>, double>::product(       \
      const softwet::Evaluation<D, double>&) const;                                                              \
  extern template void softwet::PieceOf<D, 2, softwet::TERM, softwet::MOTION<D, float>, float>::product(         \
      const softwet::Evaluation<D, float>&) const;                                                               \
  extern template void softwet::PieceOf<D, 2, softwet::TERM, softwet::MOTION<D, double>, double>::add_integrals( \
      const softwet::Evaluation<D, double>&, softwet::PendingIntegrals&, softwet::Integrals&) const;             \
  extern template void softwet::PieceOf<D, 2, softwet::TERM, softwet::MOTION<D, float>, float>::jacobian(        \
      const softwet::Evaluation<D, float>&, const softwet::Stencil<D>&, const softwet::StencilValues&) const;
#define SOFTWET_COMPILED_SOLID(D, MATERIAL) SOFTWET_COMPILED(D, Elastodynamics<softwet::MATERIAL>, Still)
#define SOFTWET_COMPILED_ALL(D, MOTION)                         \
  SOFTWET_COMPILED(D, NavierStokesKorteweg, MOTION)             \
  SOFTWET_COMPILED(D, DensityMoment, MOTION)                    \
  SOFTWET_COMPILED(D, GradientWall, MOTION)                     \
  SOFTWET_COMPILED(D, EnergyWall, MOTION)                       \
  SOFTWET_COMPILED(D, LineFriction, MOTION)                     \
  SOFTWET_COMPILED(D, CapillaryTraction, MOTION)                \
  SOFTWET_COMPILED_SOLID(D, SaintVenantKirchhoff)               \
  SOFTWET_COMPILED_SOLID(D, Hooke)                              \
  SOFTWET_COMPILED_SOLID(D, NeoHookean)                         \
  SOFTWET_COMPILED(D, PaintedWall<softwet::EnergyWall>, MOTION) \
  SOFTWET_COMPILED(D, PaintedWall<softwet::GradientWall>, MOTION)
#define SOFTWET_COMPILED_ONCE(D)                                                            \
  SOFTWET_COMPILED(D, WallTension, WallMotion)                                              \
  SOFTWET_COMPILED(D, StretchedWall<softwet::WallTension>, WallMotion)                      \
  SOFTWET_COMPILED(D, StretchedWall<softwet::PaintedWall<softwet::EnergyWall>>, WallMotion) \
  SOFTWET_COMPILED(D, GradedSolid, Still)                                                   \
  SOFTWET_COMPILED(D, Foundation, Still)                                                    \
  SOFTWET_COMPILED(D, Dashpots, Still)                                                      \
  SOFTWET_COMPILED(D, Fibres, Still)                                                        \
  SOFTWET_COMPILED(D, KelvinVoigt, Still)                                                   \
  SOFTWET_COMPILED(D, BranchStress, Still)                                                  \
  SOFTWET_COMPILED(D, FiniteBranchStress, Still)                                            \
  SOFTWET_COMPILED(D, SurfaceTension, Still)                                                \
  SOFTWET_COMPILED(D, SurfaceElasticity, Still)
namespace softwet {
template <int, class>
using Still = NoMotion;
}
SOFTWET_COMPILED_ALL(2, WallMotion)
SOFTWET_COMPILED_ALL(2, Still)
SOFTWET_COMPILED_ALL(3, WallMotion)
SOFTWET_COMPILED_ALL(3, Still)
SOFTWET_COMPILED_ONCE(2)
SOFTWET_COMPILED_ONCE(3)
