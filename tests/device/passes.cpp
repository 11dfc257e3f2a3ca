// The tile kernels whose machine code machine_code.py counts: the fluid alone, so that a kernel has one loop of passes, and a term of
// explicit steps with reduced quadrature.
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
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, Alone<PressureForce, NoMotion>>;

}  // namespace softwet
