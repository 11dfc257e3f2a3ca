#include "time/masses/mass_inverse.hpp"

namespace softwet {
namespace {

constexpr int most_iterations = 400;

Array cut(const Array& a, int first, int last) { return Kokkos::subview(a, Kokkos::make_pair(first, last)); }

using namespace mass_kernels;

}  // namespace

template <int D, int P>
MassInverse<D, P>::MassInverse(const Model<D, P>& model, MassKind kind)
    : model_(model),
      kind_(kind),
      masses_(model),
      kronecker_(model.layout(), model.points(), model.mask()),
      solver_(model.layout().space(), kind == MassKind::consistent ? model.layout().size() : 0),
      product_(model.layout(), P + 1),
      ties_(model.layout(), model.mask()),
      neighbours_(model.layout()),
      scalar_(weights(model.layout().density_offset(), model.layout().scalar_size(), D, D + 1)),
      velocity_(weights(0, model.layout().rows * model.layout().row_size, 0, D)),
      solid_sums_("masses.solid", velocity_.nodes()),
      ones_("masses.ones", model.layout().size()),
      scaled_("masses.scaled", model.layout().size()),
      next_scaled_("masses.scaled", model.layout().size()),
      image_("masses.image", model.layout().size()),
      first_("masses.first", model.layout().size()),
      rows_("masses.rows", model.layout().has_solid && model.layout().has_fluid ? model.layout().size() : 0),
      later_rows_("masses.rows", host_algorithms ? 0 : rows_.extent(0)) {
  Kokkos::deep_copy(ones_, 1.0);
  if (rows_.extent(0) > 0) later_ = weights(scalar_.begin, scalar_.nodes(), scalar_.first, scalar_.last);
  for (const Weights& w : {scalar_, later_, velocity_}) {
    if (w.nodes() == 0) continue;
    product_.apply(cut(ones_, 0, w.nodes()), w.unit, w.first, w.first + 1);
    product_.fill_ghosts(w.unit, w.first, w.first + 1);
  }
  if (model.layout().has_solid) add_solid_sums();
}

template <int D, int P>
typename MassInverse<D, P>::Weights MassInverse<D, P>::weights(int begin, int nodes, int first, int last) const {
  Weights w{{}, begin, begin + (last - first) * nodes, first, last};
  for (Array* a : {&w.sums, &w.unit, &w.root, &w.left, &w.right}) *a = Array("masses.weights", nodes);
  return w;
}

template <int D, int P>
void MassInverse<D, P>::add_solid_sums() {
  const Layout<D>& l = model_.layout();
  const double density = std::visit([](const auto& solid) { return solid.density; }, model_.solid());
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
  const Layout<D>& l = model_.layout();
  const Weights& w = scalar_;
  if (!l.has_fluid || (has_mesh_ && !l.has_solid)) return;
  has_mesh_ = true;
  if (!l.has_solid) return prepare(w, copied(w.sums, w.unit));
  masses_.add_scalar(stage, ones_, rows_);
  prepare(w, row_sums(w, rows_));
}

template <int D, int P>
void MassInverse<D, P>::set_meshes(const Stage& now, const Stage& later) {
  if constexpr (!host_algorithms)
    if (later_.nodes() > 0 && kind_ != MassKind::consistent && !has_ghosts(model_.layout()))
      return set_meshes_together(now, later);
  set_mesh(now);
  if (later_.nodes() == 0) return;
  std::swap(scalar_, later_);
  set_mesh(later);
  std::swap(scalar_, later_);
}

template <int D, int P>
void MassInverse<D, P>::take_later() {
  if (later_.nodes() > 0) std::swap(scalar_, later_);
}

template <int D, int P>
ForEach<TakeScalarRows> MassInverse<D, P>::row_sums(const Weights& w, const Array& rows) const {
  return {w.nodes(), {w.sums, w.of(rows), part(model_.mask(), w.begin, w.end)}};
}

template <int D, int P>
ForEach<SumVelocityRows> MassInverse<D, P>::row_sums(const ConstArray& moments) const {
  const int shift = model_.layout().fluid_shift(), count = scalar_.nodes();
  return {velocity_.nodes(),
          {velocity_.sums, solid_sums_, moments, scalar_.sums, model_.fluid().inertia_floor, shift, count}};
}

template <int D, int P>
void MassInverse<D, P>::set_weights(const ConstArray& moments, const ConstArray& density) {
  if (kind_ == MassKind::lumped && model_.layout().has_fluid) {
    multiply_scalar(density, scalar_.of(first_));  // lumped moments would be those of the density at the control points
    return prepare(velocity_, row_sums(scalar_.of(first_)));
  }
  prepare(velocity_, row_sums(moments));
}

template <int D, int P>
template <class... Bodies>
auto MassInverse<D, P>::sums_and_roots(const Weights& w, const Array& rough, const ForEach<Bodies>&... sums) const {
  return fused(sums..., ForEach{w.nodes(), FindRoots{rough, w.sums, w.unit}});
}

template <int D, int P>
auto MassInverse<D, P>::cut_roots(const Weights& w, const Array& rough) const {
  constexpr double steepest = 1.2;  // ratio of neighbours
  return neighbours_.limit(rough, w.root, steepest, w.kind());
}

template <int D, int P>
auto MassInverse<D, P>::factors(const Weights& w) const {
  return FindFactors<D, P>{product_.of(w.root, w.kind()), WeightedPointers(w), w.left.data(), w.right.data()}.on_all();
}

template <int D, int P>
template <class... Bodies>
void MassInverse<D, P>::prepare(const Weights& w, const ForEach<Bodies>&... sums) {
  const Array rough = cut(image_, 0, w.nodes());
  run("softwet::mass_sums", sums_and_roots(w, rough, sums...));
  product_.fill_ghosts(w.sums, w.first, w.first + 1);
  // Products with lumped masses are those of scalars alone.
  if (kind_ == MassKind::consistent || (kind_ == MassKind::lumped && w.kind() == Unknowns::velocities)) return;
  product_.fill_ghosts(rough, w.first, w.first + 1);
  run("softwet::smallest_neighbour", cut_roots(w, rough));
  product_.fill_ghosts(w.root, w.first, w.first + 1);
  run("softwet::mass_factors", factors(w));
}

template <int D, int P>
void MassInverse<D, P>::set_meshes_together(const Stage& now, const Stage& later) {
  const Weights &w = scalar_, &v = later_;
  const Array rough = cut(image_, 0, w.nodes()), rough_later = cut(scaled_, 0, w.nodes());
  masses_.add_scalar(now, ones_, rows_);
  masses_.add_scalar(later, ones_, later_rows_);
  run_fused("softwet::mass_sums", row_sums(w, rows_), ForEach{w.nodes(), FindRoots{rough, w.sums, w.unit}},
            row_sums(v, later_rows_), ForEach{v.nodes(), FindRoots{rough_later, v.sums, v.unit}});
  run_beside("softwet::smallest_neighbour", cut_roots(w, rough), cut_roots(v, rough_later));
  run_beside("softwet::mass_factors", factors(w), factors(v));
}

template <int D, int P>
template <class First, class Second, class Third, class After>
int MassInverse<D, P>::solve(const Weights& w, double factor, const RightSide& b, const Array& z,
                             const Counted<First>& beside, const Counted<Second>& beside_second,
                             const Counted<Third>& beside_third, const After& after) {
  const ConstArray mask = part(model_.mask(), w.begin, w.end);
  const int components = w.last - w.first;
  const TieClusters& ties = w.kind() == Unknowns::velocities ? ties_.velocities() : ties_.scalars();
  const bool lumped = kind_ == MassKind::lumped;
  const Array x = lumped ? z : w.of(first_), image = w.of(image_);
  Array scaled = w.of(scaled_), next = w.of(next_scaled_);
  const WeightedPointers mass(w);
  WithTies<DivideBySums<D>>{
      {product_.of(scaled, w.kind()).blocks, b, factor, mask, mass, x.data(), lumped ? nullptr : scaled.data(), -2.0},
      ties}
      .launch("softwet::mass_divide", components);
  // y = -2 x, and three times y = x + e y
  const auto step = [&](int k, const auto& other, const auto& then) {
    product_.fill_ghosts(scaled, w.first, w.last);
    const SeriesStep<D, P> term{
        product_.of(scaled, w.kind()), mass,         mask.data(), k == 0 ? -2.0 : 1.0,           x.data(),
        k == 0 ? x.data() : z.data(),  image.data(), z.data(),    k == 2 ? nullptr : next.data()};
    using Kernel = WithTies<SeriesStep<D, P>, host_algorithms, std::decay_t<decltype(then)>>;
    run_beside("softwet::mass_step", Kernel{term, ties, then}.on(components), other);
    std::swap(scaled, next);
  };
  const bool copies = has_ghosts(model_.layout());  // which come before what follows
  if (lumped) {
    run("softwet::beside_masses", beside);
  } else {
    step(0, beside, Nothing{});
    step(1, beside_second, Nothing{});
    copies ? step(2, beside_third, Nothing{}) : step(2, beside_third, after);
    product_.fill_ghosts(z, w.first, w.last);
  }
  if constexpr (!std::is_same_v<After, Nothing>)
    if (lumped || copies) run("softwet::after_masses", fused(ForEach{static_cast<int>(z.extent(0)), after}));
  return 0;
}

template <int D, int P>
template <class Apply, class Precondition>
int MassInverse<D, P>::solve_consistent(const Weights& w, double factor, const RightSide& b, const Array& z,
                                        double tolerance, const Apply& apply, const Precondition& precondition) {
  // Conjugate gradients take vectors of unknowns, which are zero elsewhere.
  for (const Array& a : {scaled_, image_}) Kokkos::deep_copy(Exec(), a, 0.0);
  const ConstArray mask = part(model_.mask(), w.begin, w.end);
  Kokkos::deep_copy(Exec(), w.of(image_), z);
  multiply(w.of(image_), mask);
  Kokkos::parallel_for("softwet::mass_side", Items(0, z.extent(0)), StoreRightSide<D>{b, factor, mask, w.of(scaled_)});
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
int MassInverse<D, P>::velocity(const Stage& stage, double factor, const RightSide& b, const Array& z, double tolerance,
                                const Companions& with) {
  const auto beside = fused(with.rates, with.copy);
  if (kind_ != MassKind::consistent)
    return solve(velocity_, factor, b, z, beside, Counted<Nothing>{}, Counted<Nothing>{}, with.kick);
  const int iterations = velocity(stage, factor, b, z, tolerance);
  if (iterations < 0) return iterations;
  run("softwet::beside_masses", beside);
  run("softwet::after_masses", fused(ForEach{static_cast<int>(z.extent(0)), with.kick}));
  return iterations;
}

template <int D, int P>
bool MassInverse<D, P>::weighs_beside() const {
  return !host_algorithms && kind_ == MassKind::corrected && !has_ghosts(model_.layout());
}

template <int D, int P>
int MassInverse<D, P>::scalar_and_weights([[maybe_unused]] const RightSide& b, [[maybe_unused]] const Array& z) {
  if constexpr (host_algorithms) {
    return -1;
  } else {
    const Array rough = cut(image_, 0, velocity_.nodes());
    return solve(scalar_, 1, b, z, sums_and_roots(velocity_, rough, row_sums(b.moments)), cut_roots(velocity_, rough),
                 factors(velocity_), Nothing{});
  }
}

template <int D, int P>
void MassInverse<D, P>::multiply_scalar(const ConstArray& z, const Array& out) {
  const Weights& w = scalar_;
  const Array scaled = w.of(scaled_);
  Kokkos::deep_copy(Exec(), scaled, z);
  weigh(scaled, w.root);
  product_.fill_ghosts(scaled, w.first, w.last);
  const MultiplyByMass<D, P> multiplied{product_.of(scaled, w.kind()), WeightedPointers(w),
                                        model_.mask().data() + w.begin, z.data(), out.data()};
  Kokkos::parallel_for("softwet::mass_product", Items(0, multiplied.product.items(1)), multiplied);
}

template <int D, int P>
void MassInverse<D, P>::invert_scalar(const ConstArray& z, const Array& p) {
  // Conjugate gradients for S p = z, preconditioned by the mass: the eigenvalues of their product are 1 - 3 e^3 + 2 e^4.
  constexpr int rounds = 200;
  constexpr double tolerance = 1e-13;
  const VectorSpace space = model_.layout().space();
  const ConstArray mask = part(model_.mask(), scalar_.begin, scalar_.end);
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
  multiply(out, part(model_.mask(), w.begin, w.end));
}

template class MassInverse<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
