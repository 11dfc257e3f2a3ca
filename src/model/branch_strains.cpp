#include "model/branch_strains.hpp"

#include <climits>

#include "case/error.hpp"
#include "case/gel.hpp"
#include "model/coordinates.hpp"
#include "operator/at_points.hpp"

namespace softwet {
namespace {

template <int D, int P, class Function>
void write(const Model<D, P>& model, const Function& function, const Stage& stage, const Array& out) {
  const Evaluation<D> at{model.layout(), stage, {}, {}};
  in_coordinates_of(model.layout(), function, [&](const auto& here) {
    ReduceTask<D, std::remove_cvref_t<decltype(here)>, NoMotion> task{model.solid_region(), here, {}, {}, {}};
    bind_fields(at, model.blend(), task);
    write_at_points<P>(task, out);
  });
}

}  // namespace

template <int D>
int branch_lines(const Layout<D>& l, const Substrate& s, int points) {
  const double count = static_cast<double>(all_branches(s).size());
  if (count == 0) return 0;
  const int rows = D == 3 ? l.axis[1].elements() : 1, entries = l.axisymmetric ? 4 : D * (D + 1) / 2;
  const double of_points = static_cast<double>(l.solid_elements) * rows * entries * power(points, D);
  const double lines = s.strain == Strain::small ? l.solid_size() / l.extent(0) : of_points;
  if (const double all = count * lines * l.extent(0); all > INT_MAX)
    throw Error(Exit::invalid_input, "substrate.branch: the branches of this solid remember " + std::to_string(all) +
                                         " numbers, and at most " + std::to_string(INT_MAX) +
                                         " can be; write fewer branches, fewer domain.elements, or strain = \"small\"");
  return static_cast<int>(lines);
}

template <int D, int P>
void write_strains(const Model<D, P>& model, const ConstArray& displacement, const Array& out) {
  Stage stage;
  stage.displacement = Array(const_cast<double*>(displacement.data()), displacement.extent(0));  // which is read alone
  write(model, StrainEntries{}, stage, out);
}

template <int D, int P>
void write_strain_rates(const Model<D, P>& model, const Stage& stage, const Array& out) {
  write(model, StrainRateEntries{}, stage, out);
}

template int branch_lines(const Layout<SOFTWET_DIMENSION>&, const Substrate&, int);
template void write_strains(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const ConstArray&, const Array&);
template void write_strain_rates(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Stage&, const Array&);

}  // namespace softwet
