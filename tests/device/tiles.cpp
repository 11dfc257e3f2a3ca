// The tile kernels whose instructions loops.py counts: the fluid on a moving mesh, with full and with reduced
// quadrature, whose kernels a CUDA build need not have.
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "scene/piece.hpp"

namespace softwet {

template <int D, class Real>
using Fluid = PieceOf<D, 2, NavierStokesKorteweg, WallMotion<D, Real>, Real>;

template void Fluid<2, double>::residual(const Evaluation<2, double>&) const;
template void Fluid<3, double>::residual(const Evaluation<3, double>&) const;
template void Fluid<2, float>::product(const Evaluation<2, float>&) const;
template void Fluid<3, float>::product(const Evaluation<3, float>&) const;

template struct TileKernel<SlopeTileShape<2, 2, 2>, false, double, SoftTerms<2, double>>;
template struct TileKernel<SlopeTileShape<3, 2, 2>, false, double, SoftTerms<3, double>>;

}  // namespace softwet
