// The tile kernels whose machine code machine_code.py counts: the fluid alone, so that a kernel has one loop of passes,
// and with reduced quadrature the terms of explicit steps, each in a launch of its own as there, and the fluid.
#include "kernels/fluid/explicit_terms.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "scene/piece.hpp"

namespace softwet {

template <class Term, class Motion>
using Alone = TermList<TermOnMesh<Term, Motion>>;
template <class Motion>
using Fluid = Alone<NavierStokesKorteweg, Motion>;

template struct TileKernel<ChosenTile<3, 2, false, double>, false, double, Fluid<WallMotion<3>>>;
template struct TileKernel<ChosenTile<3, 2, false, double>, false, double, Fluid<NoMotion>>;
template struct TileKernel<ChosenTile<3, 2, true, float>, true, float, Fluid<WallMotion<3, float>>>;
template struct TileKernel<ChosenTile<2, 2, false, double>, false, double, Fluid<WallMotion<2>>>;

// Reduced quadrature.
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<ConvectionViscosity, NoMotion>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<ConvectionViscosity, WallMotion<3>>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<PressureForce, NoMotion>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<PressureForce, WallMotion<3>>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<MassFlux, NoMotion>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<MassFlux, WallMotion<3>>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<VariationalDerivative, NoMotion>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<VariationalDerivative, WallMotion<3>>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Fluid<WallMotion<3>>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<ConvectionViscosity, NoMotion>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<ConvectionViscosity, WallMotion<2>>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<PressureForce, NoMotion>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<PressureForce, WallMotion<2>>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<MassFlux, NoMotion>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<MassFlux, WallMotion<2>>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<VariationalDerivative, NoMotion>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Alone<VariationalDerivative, WallMotion<2>>>;
template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, Fluid<WallMotion<2>>>;

}  // namespace softwet
