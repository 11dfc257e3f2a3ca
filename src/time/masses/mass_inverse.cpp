#include "time/masses/mass_inverse.hpp"

namespace softwet {
namespace {

constexpr int most_iterations = 400;

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
      weights_(regions, coefficients, kind, product_),
      ties_(regions.layout(), regions.mask()),
      scaled_("masses.scaled", regions.layout().size()),
      next_scaled_("masses.scaled", regions.layout().size()),
      image_("masses.image", regions.layout().size()),
      first_("masses.first", regions.layout().size()) {}

template <int D, int P>
void MassInverse<D, P>::set_weights(const ConstArray& moments, const ConstArray& density) {
  if (kind_ != MassKind::lumped || !regions_.layout().has_fluid) return weights_.set_moments(moments);
  const Array product = weights_.scalar().of(first_);
  multiply_scalar(density, product);  // lumped moments would give the density at the control points
  weights_.set_moments(product);
}

template <int D, int P>
template <class First, class Second, class Third, class After>
int MassInverse<D, P>::solve(const MassWeights& w, double factor, const RightSide& b, const Array& z,
                             const Counted<First>& beside, const Counted<Second>& beside_second,
                             const Counted<Third>& beside_third, const After& after) {
  const ConstArray mask = part(regions_.mask(), w.begin, w.end);
  const int components = w.last - w.first;
  const TieClusters& ties = w.kind() == Unknowns::velocities ? ties_.velocities() : ties_.scalars();
  const bool lumped = kind_ == MassKind::lumped;
  const Array x = lumped ? z : w.of(first_), image = w.of(image_);
  Array before = x, next = w.of(scaled_), spare = w.of(next_scaled_);
  const WeightedPointers mass(w);
  const double* root = lumped ? nullptr : mass.root;  // vectors of the series are scaled with the roots
  WithTies<DivideBySums<D>>{{product_.of(x, w.kind()).blocks, b, factor, mask, mass.sums, root, x.data()}, ties}.launch(
      "softwet::mass_divide", components);
  // y = -2 x, and three times y = x + e y
  const auto step = [&](int k, const auto& other, const auto& then) {
    product_.fill_ghosts(before, w.first, w.last);
    const SeriesStep<D, P> term{
        product_.of(before, w.kind()), mass, mask.data(), k == 0 ? -2.0 : 1.0, x.data(), image.data(), next.data(),
        k == 2 ? z.data() : nullptr};
    using Kernel = WithTies<SeriesStep<D, P>, ValuesOfItem, std::decay_t<decltype(then)>>;
    run_beside("softwet::mass_step", Kernel{term, ties, then}.on(components), other);
    before = next;
    std::swap(next, spare);
  };
  const bool copies = has_ghosts(regions_.layout());  // which come before what follows
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
int MassInverse<D, P>::solve_consistent(const MassWeights& w, double factor, const RightSide& b, const Array& z,
                                        double tolerance, const Apply& apply, const Precondition& precondition) {
  // Conjugate gradients take vectors of unknowns, which are zero elsewhere.
  for (const Array& a : {scaled_, image_}) Kokkos::deep_copy(Exec(), a, 0.0);
  const ConstArray mask = part(regions_.mask(), w.begin, w.end);
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
  const MassWeights& w = weights_.scalar();
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
  const MassWeights& w = weights_.velocity();
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
    return solve(weights_.velocity(), factor, b, z, beside, Counted<Nothing>{}, Counted<Nothing>{}, with.kick);
  const int iterations = velocity(stage, factor, b, z, tolerance);
  if (iterations < 0) return iterations;
  run("softwet::beside_masses", beside);
  run("softwet::after_masses", fused(ForEach{static_cast<int>(z.extent(0)), with.kick}));
  return iterations;
}

template <int D, int P>
bool MassInverse<D, P>::weighs_beside() const {
  return kind_ == MassKind::corrected && !has_ghosts(regions_.layout());
}

template <int D, int P>
void MassInverse<D, P>::scalar_and_weights(const RightSide& b, const Array& z) {
  solve(weights_.scalar(), 1, b, z, weights_.sums_by_moments(b.moments), weights_.roots_by_moments(),
        weights_.factors_by_moments(), Nothing{});
}

template <int D, int P>
void MassInverse<D, P>::multiply_scalar(const ConstArray& z, const Array& out) {
  const MassWeights& w = weights_.scalar();
  const Array scaled = w.of(scaled_);
  Kokkos::deep_copy(Exec(), scaled, z);
  weigh(scaled, w.root);
  product_.fill_ghosts(scaled, w.first, w.last);
  const MultiplyByMass<D, P> multiplied{product_.of(scaled, w.kind()), WeightedPointers(w),
                                        regions_.mask().data() + w.begin, z.data(), out.data()};
  Kokkos::parallel_for("softwet::mass_product", Items(0, multiplied.product.blocks.items(1)), multiplied);
}

template <int D, int P>
void MassInverse<D, P>::invert_scalar(const ConstArray& z, const Array& p) {
  // Conjugate gradients for S p = z, preconditioned by the mass: the eigenvalues of their product are 1 - 3 e^3 + 2
  // e^4.
  constexpr int rounds = 200;
  constexpr double tolerance = 1e-13;
  const VectorSpace space = regions_.layout().space();
  const ConstArray mask = part(regions_.mask(), weights_.scalar().begin, weights_.scalar().end);
  const auto vector = [&] { return Array("masses.search", z.extent(0)); };
  const Array rest = vector(), step = vector(), image = vector(), along = vector();
  multiply_scalar(z, p);
  solve(weights_.scalar(), 1, RightSide::of(p), rest);
  combine(rest, 1, z, -1);
  multiply(rest, mask);
  multiply_scalar(rest, along);
  double size = dot(space, rest, along);
  const double enough = tolerance * tolerance * std::abs(dot(space, z, p));
  for (int k = 0; k < rounds && size > enough; ++k) {
    solve(weights_.scalar(), 1, RightSide::of(along), image);
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
  const MassWeights& w = weights_.scalar();
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
