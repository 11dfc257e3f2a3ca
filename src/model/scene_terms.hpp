// The terms that a device computes in one launch: those of scenes with a soft or with a rigid wall.
#pragma once

#include "kernels/fluid/gravity.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/hooke.hpp"
#include "kernels/solid/neo_hookean.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"
#include "operator/tile_launch.hpp"

namespace softwet {

template <class Motion, class... Others>
using FluidTerms = TermList<TermOnMesh<NavierStokesKorteweg, Motion>, TermOnMesh<DensityMoment, Motion>,
                            TermOnMesh<Gravity, Motion>, TermOnMesh<CapillaryTraction, Motion>,
                            TermOnMesh<GradientWall, Motion>, TermOnMesh<EnergyWall, Motion>, Others...>;

using RigidTerms = FluidTerms<NoMotion>;
template <int D, class Real>
using SoftTerms =
    FluidTerms<WallMotion<D, Real>, TermOnMesh<Elastodynamics<SaintVenantKirchhoff>, NoMotion>,
               TermOnMesh<Elastodynamics<Hooke>, NoMotion>, TermOnMesh<Elastodynamics<NeoHookean>, NoMotion>>;

/// The list that a term belongs to; a term of none is launched by itself.
template <int D, class Real, class Entry>
using ListOf = std::conditional_t<SoftTerms<D, Real>::template has<Entry>, SoftTerms<D, Real>,
                                  std::conditional_t<RigidTerms::has<Entry>, RigidTerms, TermList<Entry>>>;

}  // namespace softwet
