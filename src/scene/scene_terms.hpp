// The terms that a device computes in one launch, for scenes with a soft and with a rigid wall.
#pragma once

#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"
#include "operator/device/tile_launch.hpp"

namespace softwet {

/// The terms that most scenes have. A kernel has the registers and the scratch of its largest term, and its code grows
/// with each of them. A term that is not here is launched by itself.
template <class Motion, class... Others>
using FluidTerms = TermList<TermOnMesh<NavierStokesKorteweg, Motion>, TermOnMesh<DensityMoment, Motion>,
                            TermOnMesh<CapillaryTraction, Motion>, TermOnMesh<GradientWall, Motion>, Others...>;

using RigidTerms = FluidTerms<NoMotion>;
/// In 3D and single precision, which products use, the solid has a launch of its own: the code of all terms would be so
/// long that nvcc makes a function of it, which keeps its numbers in memory.
template <int D, class Real>
using SoftTerms =
    std::conditional_t<D == 3 && std::is_same_v<Real, float>, FluidTerms<WallMotion<D, Real>>,
                       FluidTerms<WallMotion<D, Real>, TermOnMesh<Elastodynamics<SaintVenantKirchhoff>, NoMotion>>>;

/// The list that a term belongs to.
template <int D, class Real, class Entry>
using ListOf = std::conditional_t<SoftTerms<D, Real>::template has<Entry>, SoftTerms<D, Real>,
                                  std::conditional_t<RigidTerms::has<Entry>, RigidTerms, TermList<Entry>>>;

}  // namespace softwet
