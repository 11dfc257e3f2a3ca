#include "scene/fault_search.hpp"

#include "kernels/functional/fluid_integrals.hpp"
#include "kernels/functional/solid_integrals.hpp"
#include "operator/integrate.hpp"
#include "scene/functional_task.hpp"

namespace softwet {
namespace {

/// Numbers on the host, as `IntegralItems::total` reads them.
struct PartialsOnHost {
  const double* first;
  double operator()(int i) const { return first[i]; }
};

}  // namespace

template <int D, int P>
FaultSearch<D, P>::FaultSearch(const Regions<D>& regions) : regions_(regions) {
  if (!regions.layout().has_solid) return;
  of_solid_ = InvertedSolid::count * IntegralItems<D>(regions.solid()).items;
  if (regions.layout().has_fluid) of_fluid_ = FluidContents::count * IntegralItems<D>(regions.fluid()).items;
}

template <int D, int P>
void FaultSearch<D, P>::ask(const Stage& stage, const Array& numbers) const {
  if (of_solid_ == 0) return;
  const Evaluation<D> at{regions_.layout(), stage, {}, {}};
  const Array fluid = Kokkos::subview(numbers, Kokkos::make_pair(0, of_fluid_)),
              solid = Kokkos::subview(numbers, Kokkos::make_pair(of_fluid_, of_fluid_ + of_solid_));
  with_task_of<NoMotion>(regions_.solid(), InvertedSolid{}, at, regions_.blend(), [&](const auto& inverted) {
    if (of_fluid_ == 0) return start_integral<P>(inverted, solid);
    with_task_of<WallMotion<D>>(regions_.fluid(), FluidContents{}, at, regions_.blend(),
                                [&](const auto& folded) { start_integrals<P>(folded, fluid, inverted, solid); });
  });
}

template <int D, int P>
MeshFaults FaultSearch<D, P>::faults(const double* numbers) const {
  MeshFaults faults;
  if (of_solid_ == 0) return faults;
  if (of_fluid_ > 0) {
    const IntegralItems<D> fluid(regions_.fluid());
    faults.folded =
        fluid.template total<FluidContents::count>(PartialsOnHost{numbers}, fluid.items)[FluidContents::folded];
  }
  const IntegralItems<D> solid(regions_.solid());
  faults.inverted = solid.template total<InvertedSolid::count>(PartialsOnHost{numbers + of_fluid_}, solid.items)[0];
  return faults;
}

template class FaultSearch<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
