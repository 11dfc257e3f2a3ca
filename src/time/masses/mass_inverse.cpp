#include "time/masses/mass_inverse.hpp"

namespace softwet {
namespace {

constexpr int most_iterations = 400;

Array cut(const Array& a, int first, int last) { return Kokkos::subview(a, Kokkos::make_pair(first, last)); }

using namespace mass_kernels;

}  // namespace

template <int D, int P>
MassInverse<D, P>::MassInverse(const Regions<D>& regions, const Coefficients<D>& coefficients, MassKind kind)
    : regions_(regions),
      coefficients_(coefficients),
      kind_(kind),
      masses_(regions, coefficients),
      kronecker_(regions.layout(), regions.points(), regions.mask()),
      solver_(regions.layout().space(), kind == MassKind::consistent ? regions.layout().size() : 0),
      product_(regions.layout(), P + 1),
      ties_(regions.layout(), regions.mask()),
      neighbours_(regions.layout()),
      scalar_(weights(regions.layout().density_offset(), regions.layout().scalar_size(), D, D + 1)),
      velocity_(weights(0, regions.layout().rows * regions.layout().row_size, 0, D)),
      solid_sums_("masses.solid", velocity_.nodes()),
      ones_("masses.ones", regions.layout().size()),
      scaled_("masses.scaled", regions.layout().size()),
      next_scaled_("masses.scaled", regions.layout().size()),
      image_("masses.image", regions.layout().size()),
      first_("masses.first", regions.layout().size()),
      rows_("masses.rows", regions.layout().has_solid && regions.layout().has_fluid ? regions.layout().size() : 0) {
  Kokkos::deep_copy(ones_, 1.0);
  for (const Weights& w : {scalar_, velocity_}) {
    if (w.nodes() == 0) continue;
    product_.apply(cut(ones_, 0, w.nodes()), w.unit, w.first, w.first + 1);
    product_.fill_ghosts(w.unit, w.first, w.first + 1);
  }
  if (regions.layout().has_solid) add_solid_sums();
}

template <int D, int P>
typename MassInverse<D, P>::Weights MassInverse<D, P>::weights(int begin, int nodes, int first, int last) const {
  Weights w{{}, begin, begin + (last - first) * nodes, first, last};
  for (Array* a : {&w.sums, &w.unit, &w.root, &w.left, &w.right}) *a = Array("masses.weights", nodes);
  return w;
}

template <int D, int P>
void MassInverse<D, P>::add_solid_sums() {
  const Layout<D>& l = regions_.layout();
  const double density = coefficients_.solid().density();
  std::vector<double> sums(velocity_.nodes(), 0.0);
  for (int i = 0; i < l.solid_rows() * l.row_size; ++i) sums[i] = density;
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const Axis& axis = l.axis[d];
    const int last = d == D - 1 ? l.solid_elements : axis.elements();
    std::vector<double> factor = axis.integrals(0, axis.length(), 0, last, l.axisymmetric && d == 0);
    for (int g = axis.owned(); g < axis.functions(); ++g)
      factor[g] = factor[g - axis.owned()] = factor[g] + factor[g - axis.owned()];
    const int extent = d == D - 1 ? l.rows : l.extent(d);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] *= factor[l.function(i / stride % extent, d)];
    stride *= extent;
  }
  Kokkos::deep_copy(solid_sums_, to_device<Array>(sums));
}

template <int D, int P>
void MassInverse<D, P>::set_mesh(const Stage& stage) {
  const Layout<D>& l = regions_.layout();
  const Weights& w = scalar_;
  if (!l.has_fluid || (has_mesh_ && !l.has_solid)) return;
  has_mesh_ = true;
  if (!l.has_solid) return prepare(w, copied(w.sums, w.unit));
  masses_.add_scalar(stage, ones_, rows_);
  prepare(w, ForEach{w.nodes(), TakeScalarRows{w.sums, w.of(rows_), part(regions_.mask(), w.begin, w.end)}});
}

template <int D, int P>
void MassInverse<D, P>::set_weights(const ConstArray& moments, const ConstArray& density) {
  const Layout<D>& l = regions_.layout();
  if (kind_ == MassKind::lumped && l.has_fluid) {  // lumped moments would be those of the density at the control points
    multiply_scalar(density, scalar_.of(first_));
    return weigh_with(scalar_.of(first_));
  }
  weigh_with(moments);
}

template <int D, int P>
void MassInverse<D, P>::weigh_with(const ConstArray& moments) {
  const int shift = regions_.layout().fluid_shift(), count = scalar_.nodes();
  prepare(velocity_, ForEach{velocity_.nodes(), SumVelocityRows{velocity_.sums, solid_sums_, moments, scalar_.sums,
                                                                coefficients_.fluid().inertia_floor, shift, count}});
}

template <int D, int P>
template <class... Bodies>
void MassInverse<D, P>::prepare(const Weights& w, const ForEach<Bodies>&... sums) {
  constexpr double steepest = 1.2;  // ratio of neighbours
  const Array rough = cut(image_, 0, w.nodes());
  run_fused("softwet::mass_sums", sums..., ForEach{w.nodes(), FindRoots{rough, w.sums, w.unit}});
  product_.fill_ghosts(w.sums, w.first, w.first + 1);
  // Products with lumped masses are those of scalars alone.
  if (kind_ == MassKind::consistent || (kind_ == MassKind::lumped && w.first == 0)) return;
  product_.fill_ghosts(rough, w.first, w.first + 1);
  neighbours_.limit(rough, w.root, steepest, w.first == 0);
  product_.fill_ghosts(w.root, w.first, w.first + 1);
  const FindFactors<D, P> factors{product_.of(w.root, w.first == 0), WeightedPointers(w), w.left.data(),
                                  w.right.data()};
  Kokkos::parallel_for("softwet::mass_factors", Items(0, factors.product.items(1)), factors);
}

template <int D, int P>
int MassInverse<D, P>::solve(const Weights& w, double factor, const RightSide& b, const Array& z) {
  const ConstArray mask = part(regions_.mask(), w.begin, w.end);
  const bool of_velocity = w.first == 0, lumped = kind_ == MassKind::lumped;
  const TieClusters& ties = of_velocity ? ties_.velocities() : ties_.scalars();
  const Array x = lumped ? z : w.of(first_), image = w.of(image_);
  Array scaled = w.of(scaled_), next = w.of(next_scaled_);
  const WeightedPointers mass(w);
  const BandProduct<D, P> product = product_.of(scaled, of_velocity);
  WithTies<DivideBySums<D>>{{product.blocks, b, factor, mask, mass, x.data(), lumped ? nullptr : scaled.data(), -2.0},
                            ties}
      .launch("softwet::mass_divide", w.last - w.first);
  for (int k = 0; k < 3 && !lumped; ++k) {  // y = -2 x, and three times y = x + e y
    product_.fill_ghosts(scaled, w.first, w.last);
    SeriesStep<D, P> step{
        product_.of(scaled, of_velocity), mass,         mask.data(), k == 0 ? -2.0 : 1.0,           x.data(),
        k == 0 ? x.data() : z.data(),     image.data(), z.data(),    k == 2 ? nullptr : next.data()};
    WithTies<SeriesStep<D, P>>{step, ties}.launch("softwet::mass_step", w.last - w.first);
    std::swap(scaled, next);
  }
  if (!lumped) product_.fill_ghosts(z, w.first, w.last);
  return 0;
}

template <int D, int P>
template <class Apply, class Precondition>
int MassInverse<D, P>::solve_consistent(const Weights& w, double factor, const RightSide& b, const Array& z,
                                        double tolerance, const Apply& apply, const Precondition& precondition) {
  // Conjugate gradients take vectors of unknowns, which are zero elsewhere.
  for (const Array& a : {scaled_, image_}) Kokkos::deep_copy(Exec(), a, 0.0);
  const ConstArray mask = part(regions_.mask(), w.begin, w.end);
  Kokkos::deep_copy(Exec(), w.of(image_), z);
  multiply(w.of(image_), mask);
  Kokkos::parallel_for("softwet::mass_side", Items(0, z.extent(0)), StoreRightSide{b, factor, mask, w.of(scaled_)});
  const int iterations =
      solver_.solve(apply, precondition, scaled_, image_, w.begin, w.end, tolerance, most_iterations);
  if (iterations >= 0) Kokkos::deep_copy(Exec(), z, w.of(image_));
  return iterations;
}

template <int D, int P>
int MassInverse<D, P>::scalar(const Stage& stage, double factor, const RightSide& b, const Array& z, double tolerance) {
  const Weights& w = scalar_;
  if (kind_ != MassKind::consistent) return solve(w, factor, b, z);
  const auto fixed_mesh = [&](const Array& r, const Array& x) {
    Kokkos::deep_copy(Exec(), w.of(x), w.of(r));
    kronecker_.solve(x, w.first, w.last);
  };
  return solve_consistent(
      w, factor, b, z, tolerance, [&](const Array& x, const Array& out) { masses_.scalar(stage, x, out); }, fixed_mesh);
}

template <int D, int P>
int MassInverse<D, P>::velocity(const Stage& stage, double factor, const RightSide& b, const Array& z,
                                double tolerance) {
  const Weights& w = velocity_;
  if (kind_ != MassKind::consistent) return solve(w, factor, b, z);
  return solve_consistent(
      w, factor, b, z, tolerance, [&](const Array& x, const Array& out) { masses_.velocity(stage, 1, 0, x, out); },
      [&](const Array& r, const Array& x) {
        const Array v = w.of(x);
        Kokkos::deep_copy(Exec(), v, w.of(r));
        scale_by_root(v, w.unit, w.sums);
        kronecker_.solve(x, w.first, w.last);
        scale_by_root(v, w.unit, w.sums);
      });
}

template <int D, int P>
void MassInverse<D, P>::multiply_scalar(const ConstArray& z, const Array& out) {
  const Weights& w = scalar_;
  const Array scaled = w.of(scaled_);
  Kokkos::deep_copy(Exec(), scaled, z);
  weigh(scaled, w.root);
  product_.fill_ghosts(scaled, w.first, w.last);
  const MultiplyByMass<D, P> multiplied{product_.of(scaled, false), WeightedPointers(w),
                                        regions_.mask().data() + w.begin, z.data(), out.data()};
  Kokkos::parallel_for("softwet::mass_product", Items(0, multiplied.product.items(1)), multiplied);
}

template <int D, int P>
void MassInverse<D, P>::invert_scalar(const ConstArray& z, const Array& p) {
  // Conjugate gradients for S p = z, preconditioned by the mass: the eigenvalues of their product are 1 - 3 e^3 + 2 e^4.
  constexpr int rounds = 200;
  constexpr double tolerance = 1e-13;
  const VectorSpace space = regions_.layout().space();
  const ConstArray mask = part(regions_.mask(), scalar_.begin, scalar_.end);
  const auto vector = [&] { return Array("masses.search", z.extent(0)); };
  const Array rest = vector(), step = vector(), image = vector(), along = vector();
  multiply_scalar(z, p);
  solve(scalar_, 1, RightSide::of(p), rest);
  combine(rest, 1, z, -1);
  multiply(rest, mask);
  multiply_scalar(rest, along);
  double size = dot(space, rest, along);
  const double enough = tolerance * tolerance * std::abs(dot(space, z, p));
  for (int k = 0; k < rounds && size > enough; ++k) {
    solve(scalar_, 1, RightSide::of(along), image);
    multiply(image, mask);
    const double part_of_step = size / dot(space, along, image);
    add_scaled(p, 0, part_of_step, along);
    add_scaled(rest, 0, -part_of_step, image);
    multiply_scalar(rest, step);
    const double next = dot(space, rest, step);
    combine(along, 1, step, next / size);
    size = next;
  }
}

template <int D, int P>
void MassInverse<D, P>::find_moments(const Stage& stage, const ConstArray& z, const Array& out) {
  const Weights& w = scalar_;
  if (kind_ == MassKind::corrected) return invert_scalar(z, out);
  if (kind_ == MassKind::consistent) {
    Kokkos::deep_copy(Exec(), w.of(scaled_), z);
    masses_.scalar(stage, scaled_, image_);
    return Kokkos::deep_copy(Exec(), out, w.of(image_));
  }
  Kokkos::deep_copy(Exec(), out, z);
  ties_.untie_scalars(out, w.sums);
  weigh(out, w.sums);
  multiply(out, part(regions_.mask(), w.begin, w.end));
}

template class MassInverse<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
