// The terms that a device computes in one launch: those of scenes with a soft or with a rigid wall.
#pragma once

#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"
#include "operator/tile_launch.hpp"

namespace softwet {

/// The terms that most scenes have. With more of them the kernel would be so large that its code was called as a function, and
/// numbers would spill; in three dimensions one solid is too much. A term that is not here is launched by itself.
template <class Motion, class... Others>
using FluidTerms = TermList<TermOnMesh<NavierStokesKorteweg, Motion>, TermOnMesh<DensityMoment, Motion>,
                            TermOnMesh<CapillaryTraction, Motion>, TermOnMesh<GradientWall, Motion>, Others...>;

using RigidTerms = FluidTerms<NoMotion>;
template <int D, class Real>
using SoftTerms =
    std::conditional_t<D == 2,
                       FluidTerms<WallMotion<D, Real>, TermOnMesh<Elastodynamics<SaintVenantKirchhoff>, NoMotion>>,
                       FluidTerms<WallMotion<D, Real>>>;

/// The list that a term belongs to.
template <int D, class Real, class Entry>
using ListOf = std::conditional_t<SoftTerms<D, Real>::template has<Entry>, SoftTerms<D, Real>,
                                  std::conditional_t<RigidTerms::has<Entry>, RigidTerms, TermList<Entry>>>;

}  // namespace softwet
