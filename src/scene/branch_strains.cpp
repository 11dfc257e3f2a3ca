#include "scene/branch_strains.hpp"

#include "kernels/solid/branches.hpp"
#include "operator/at_points.hpp"
#include "scene/functional_task.hpp"

namespace softwet {
namespace {

template <int P, int D, class Function>
void write(const Regions<D>& regions, const Function& function, const Stage& stage, const Array& out) {
  with_task_of<NoMotion>(regions.solid(), function, Evaluation<D>{regions.layout(), stage, {}, {}}, regions.blend(),
                         [&](const auto& task) { write_at_points<P>(task, out); });
}

}  // namespace

template <int P, int D>
void write_strains(const Regions<D>& regions, const ConstArray& displacement, const Array& out) {
  Stage stage;
  stage.displacement = Array(const_cast<double*>(displacement.data()), displacement.extent(0));  // which is read alone
  write<P>(regions, StrainEntries{}, stage, out);
}

template <int P, int D>
void write_strain_rates(const Regions<D>& regions, const Stage& stage, const Array& out) {
  write<P>(regions, StrainRateEntries{}, stage, out);
}

template void write_strains<SOFTWET_DEGREE>(const Regions<SOFTWET_DIMENSION>&, const ConstArray&, const Array&);
template void write_strain_rates<SOFTWET_DEGREE>(const Regions<SOFTWET_DIMENSION>&, const Stage&, const Array&);

}  // namespace softwet
