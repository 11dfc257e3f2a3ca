#include "time/masses/mass_weights.hpp"

namespace softwet {
namespace {

using namespace mass_kernels;

}  // namespace

template <int D, int P>
SceneWeights<D, P>::SceneWeights(const Regions<D>& regions, const Coefficients<D>& coefficients, MassKind kind,
                                 const MassProduct<D, P>& product)
    : regions_(regions),
      coefficients_(coefficients),
      kind_(kind),
      product_(product),
      masses_(regions, coefficients),
      neighbours_(regions.layout()),
      scalar_(weights(regions.layout().density_offset(), regions.layout().scalar_size(), D, D + 1)),
      velocity_(weights(0, regions.layout().rows * regions.layout().row_size, 0, D)),
      solid_sums_("masses.solid", velocity_.nodes()),
      ones_("masses.ones", regions.layout().size()),
      rough_("masses.rough", velocity_.nodes()),
      rough_later_("masses.rough", host_algorithms ? 0 : scalar_.nodes()),
      rows_("masses.rows", regions.layout().has_solid && regions.layout().has_fluid ? regions.layout().size() : 0),
      rows_later_("masses.rows", host_algorithms ? 0 : rows_.extent(0)) {
  Kokkos::deep_copy(ones_, 1.0);
  if (rows_.extent(0) > 0) later_ = weights(scalar_.begin, scalar_.nodes(), scalar_.first, scalar_.last);
  for (const MassWeights& w : {scalar_, later_, velocity_}) {
    if (w.nodes() == 0) continue;
    product_.apply(part_of(ones_, w.nodes()), w.unit, w.first, w.first + 1);
    product_.fill_ghosts(w.unit, w.first, w.first + 1);
  }
  if (regions.layout().has_solid) add_solid_sums();
}

template <int D, int P>
MassWeights SceneWeights<D, P>::weights(int begin, int nodes, int first, int last) const {
  MassWeights w{{}, begin, begin + (last - first) * nodes, first, last};
  for (Array* a : {&w.sums, &w.unit, &w.root, &w.left, &w.right}) *a = Array("masses.weights", nodes);
  return w;
}

template <int D, int P>
void SceneWeights<D, P>::add_solid_sums() {
  const Layout<D>& l = regions_.layout();
  const double density = coefficients_.solid().density();
  std::vector<double> sums(velocity_.nodes(), 0.0);
  for (int i = 0; i < l.solid_rows() * l.row_size; ++i) sums[i] = density;
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const Axis& axis = l.axis[d];
    const int last = d == D - 1 ? l.solid_elements : axis.elements();
    std::vector<double> factor = axis.integrals(0, axis.length(), 0, last);
    for (int g = axis.owned(); g < axis.functions(); ++g)
      factor[g] = factor[g - axis.owned()] = factor[g] + factor[g - axis.owned()];
    const int extent = d == D - 1 ? l.rows : l.extent(d);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] *= factor[l.function(i / stride % extent, d)];
    stride *= extent;
  }
  Kokkos::deep_copy(solid_sums_, to_device<Array>(sums));
}

template <int D, int P>
void SceneWeights<D, P>::set_mesh(const Stage& stage) {
  const Layout<D>& l = regions_.layout();
  const MassWeights& w = scalar_;
  if (!l.has_fluid || (has_mesh_ && !l.has_solid)) return;
  has_mesh_ = true;
  if (!l.has_solid) return prepare(w, copied(w.sums, w.unit));
  masses_.add_scalar(stage, ones_, rows_);
  prepare(w, row_sums(w, rows_));
}

template <int D, int P>
void SceneWeights<D, P>::set_meshes(const Stage& now, const Stage& later) {
  if constexpr (!host_algorithms)
    if (later_.nodes() > 0 && kind_ != MassKind::consistent && !has_ghosts(regions_.layout()))
      return set_meshes_together(now, later);
  set_mesh(now);
  if (later_.nodes() == 0) return;
  std::swap(scalar_, later_);
  set_mesh(later);
  std::swap(scalar_, later_);
}

template <int D, int P>
void SceneWeights<D, P>::set_meshes_together(const Stage& now, const Stage& later) {
  const MassWeights &w = scalar_, &v = later_;
  masses_.add_scalar(now, ones_, rows_);
  masses_.add_scalar(later, ones_, rows_later_);
  run_fused("softwet::mass_sums", row_sums(w, rows_), ForEach{w.nodes(), FindRoots{rough_, w.sums, w.unit}},
            row_sums(v, rows_later_), ForEach{v.nodes(), FindRoots{rough_later_, v.sums, v.unit}});
  run_beside("softwet::smallest_neighbour", cut_roots(w, rough_), cut_roots(v, rough_later_));
  run_beside("softwet::mass_factors", factors(w), factors(v));
}

template <int D, int P>
void SceneWeights<D, P>::take_other() {
  if (later_.nodes() > 0) std::swap(scalar_, later_);
}

template <int D, int P>
ForEach<TakeScalarRows> SceneWeights<D, P>::row_sums(const MassWeights& w, const Array& rows) const {
  return {w.nodes(), {w.sums, w.of(rows), part(regions_.mask(), w.begin, w.end)}};
}

template <int D, int P>
ForEach<SumVelocityRows> SceneWeights<D, P>::row_sums(const ConstArray& moments) const {
  const int shift = regions_.layout().fluid_shift(), count = scalar_.nodes();
  return {velocity_.nodes(),
          {velocity_.sums, solid_sums_, moments, scalar_.sums, coefficients_.fluid().inertia_floor, shift, count}};
}

template <int D, int P>
template <class... Bodies>
void SceneWeights<D, P>::prepare(const MassWeights& w, const ForEach<Bodies>&... sums) {
  run("softwet::mass_sums", sums_and_roots(w, rough_, sums...));
  product_.fill_ghosts(w.sums, w.first, w.first + 1);
  // Only scalars have products with lumped masses.
  if (kind_ == MassKind::consistent || (kind_ == MassKind::lumped && w.kind() == Unknowns::velocities)) return;
  product_.fill_ghosts(part_of(rough_, w.nodes()), w.first, w.first + 1);
  run("softwet::smallest_neighbour", cut_roots(w, rough_));
  product_.fill_ghosts(w.root, w.first, w.first + 1);
  run("softwet::mass_factors", factors(w));
}

template class SceneWeights<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
