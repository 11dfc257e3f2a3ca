#include "model/fault_search.hpp"

#include "model/coordinates.hpp"
#include "operator/integrate.hpp"

namespace softwet {
namespace {

/// Numbers on the host, as `IntegralItems::total` reads them.
struct PartialsOnHost {
  const double* first;
  double operator()(int i) const { return first[i]; }
};

/// The task of a functional in the coordinates of the scene.
template <class Motion, int D, class Functional, class Visit>
void visit_task(const Region<D>& region, const Functional& functional, const Evaluation<D>& at, const Blend& blend,
                const Visit& visit) {
  in_coordinates_of(at.layout, functional, [&](const auto& integrand) {
    ReduceTask<D, std::remove_cvref_t<decltype(integrand)>, Motion> task{region, integrand, {}, {}, {}};
    bind_fields(at, blend, task);
    visit(task);
  });
}

}  // namespace

template <int D, int P>
FaultSearch<D, P>::FaultSearch(const Model<D, P>& model) : model_(model) {
  if (!model.layout().has_solid) return;
  of_solid_ = InvertedSolid::count * IntegralItems<D>(model.solid_region()).items;
  if (model.layout().has_fluid) of_fluid_ = FluidContents::count * IntegralItems<D>(model.fluid_region()).items;
}

template <int D, int P>
void FaultSearch<D, P>::ask(const Stage& stage, const Array& numbers) const {
  if (of_solid_ == 0) return;
  const Evaluation<D> at{model_.layout(), stage, {}, {}};
  const Array fluid = Kokkos::subview(numbers, Kokkos::make_pair(0, of_fluid_)),
              solid = Kokkos::subview(numbers, Kokkos::make_pair(of_fluid_, of_fluid_ + of_solid_));
  visit_task<NoMotion>(model_.solid_region(), InvertedSolid{}, at, model_.blend(), [&](const auto& inverted) {
    if (of_fluid_ == 0) return start_integral<P>(inverted, solid);
    visit_task<WallMotion<D>>(model_.fluid_region(), FluidContents{}, at, model_.blend(),
                              [&](const auto& folded) { start_integrals<P>(folded, fluid, inverted, solid); });
  });
}

template <int D, int P>
MeshFaults FaultSearch<D, P>::faults(const double* numbers) const {
  MeshFaults faults;
  if (of_solid_ == 0) return faults;
  if (of_fluid_ > 0)
    faults.folded = IntegralItems<D>(model_.fluid_region())
                        .template total<FluidContents::count>(PartialsOnHost{numbers})[FluidContents::folded];
  faults.inverted = IntegralItems<D>(model_.solid_region())
                        .template total<InvertedSolid::count>(PartialsOnHost{numbers + of_fluid_})[0];
  return faults;
}

template class FaultSearch<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
