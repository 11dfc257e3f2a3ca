#include "time/mass_inverse.hpp"

namespace softwet {
namespace {

constexpr int most_iterations = 400;
constexpr double tight = 1e-12;

Array cut(const Array& a, int first, int last) { return Kokkos::subview(a, Kokkos::make_pair(first, last)); }

/// x(i) *= sqrt(a(i) / b(i)) by control point, 0 where b is.
void scale_by_root(const Array& x, const ConstArray& a, const ConstArray& b) {
  const int nodes = static_cast<int>(a.extent(0));
  Kokkos::parallel_for(
      "softwet::scale_by_root", Items(0, x.extent(0)),
      KOKKOS_LAMBDA(int i) { x(i) = b(i % nodes) > 0 ? x(i) * Kokkos::sqrt(a(i % nodes) / b(i % nodes)) : 0.0; });
}

/// z = mask b / a
void divide(const Array& z, const ConstArray& b, const ConstArray& a, const ConstArray& mask) {
  const int nodes = static_cast<int>(a.extent(0));
  Kokkos::parallel_for(
      "softwet::divide", Items(0, z.extent(0)),
      KOKKOS_LAMBDA(int i) { z(i) = mask(i) != 0 ? b(i) / a(i % nodes) : 0.0; });
}

/// y = a y by control point.
void weigh(const Array& y, const ConstArray& a) {
  const int nodes = static_cast<int>(a.extent(0));
  Kokkos::parallel_for("softwet::weigh", Items(0, y.extent(0)), KOKKOS_LAMBDA(int i) { y(i) *= a(i % nodes); });
}

/// Row sums of velocities: those of the solid, and where there is fluid its moments, at least the floor.
void sum_velocity_rows(const Array& sums, const ConstArray& solid, const ConstArray& moments, const ConstArray& volume,
                       double floor, int shift) {
  const int count = static_cast<int>(volume.extent(0));
  Kokkos::parallel_for(
      "softwet::velocity_sums", Items(0, sums.extent(0)), KOKKOS_LAMBDA(int i) {
        const int k = i - shift;
        sums(i) = solid(i) + (k >= 0 && k < count ? Kokkos::max(moments(k), floor * volume(k)) : 0.0);
      });
}

/// root = sqrt(sums / unit), also in `copy`.
void find_roots(const Array& root, const Array& copy, const ConstArray& sums, const ConstArray& unit) {
  Kokkos::parallel_for(
      "softwet::mass_roots", Items(0, root.extent(0)),
      KOKKOS_LAMBDA(int i) { copy(i) = root(i) = Kokkos::sqrt(sums(i) / unit(i)); });
}

/// From image = M root: the factors of A c = a (left c + right M (root c)).
void find_factors(const Array& left, const Array& right, const ConstArray& image, const ConstArray& root,
                  const ConstArray& unit) {
  Kokkos::parallel_for(
      "softwet::mass_factors", Items(0, left.extent(0)), KOKKOS_LAMBDA(int i) {
        right(i) = 1 / (root(i) * unit(i));
        left(i) = 1 - image(i) * right(i);
      });
}

/// y = factor x, and scaled = root y.
void begin_series(const Array& y, double factor, const ConstArray& x, const Array& scaled, const ConstArray& root) {
  const int nodes = static_cast<int>(root.extent(0));
  Kokkos::parallel_for(
      "softwet::begin_series", Items(0, y.extent(0)), KOKKOS_LAMBDA(int i) {
        y(i) = factor * x(i);
        scaled(i) = root(i % nodes) * y(i);
      });
}

/// image = mask (left y + right image): from M (root y) to A y / a.
void combine_images(const Array& image, const ConstArray& y, const ConstArray& left, const ConstArray& right,
                    const ConstArray& mask) {
  const int nodes = static_cast<int>(left.extent(0));
  Kokkos::parallel_for(
      "softwet::mass_image", Items(0, y.extent(0)),
      KOKKOS_LAMBDA(int i) { image(i) = mask(i) * (left(i % nodes) * y(i) + right(i % nodes) * image(i)); });
}

/// next = x + y - image, and scaled = root next.
void next_of_series(const Array& next, const ConstArray& x, const ConstArray& y, const ConstArray& image,
                    const Array& scaled, const ConstArray& root) {
  const int nodes = static_cast<int>(root.extent(0));
  Kokkos::parallel_for(
      "softwet::next_of_series", Items(0, next.extent(0)), KOKKOS_LAMBDA(int i) {
        next(i) = x(i) + y(i) - image(i);
        scaled(i) = root(i % nodes) * next(i);
      });
}

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
      scalar_(weights(model.layout().density_offset(), model.layout().scalar_size(), D, D + 1)),
      velocity_(weights(0, model.layout().rows * model.layout().row_size, 0, D)),
      solid_sums_("masses.solid", velocity_.nodes()),
      ones_("masses.ones", model.layout().size()),
      scaled_("masses.scaled", model.layout().size()),
      image_("masses.image", model.layout().size()),
      iterate_("masses.iterate", model.layout().size()) {
  Kokkos::deep_copy(ones_, 1.0);
  for (const Weights& w : {scalar_, velocity_}) {
    if (w.nodes() == 0) continue;
    multiply_fixed(w, ones_, image_);
    move_ghosts(model.layout(), image_, GhostAction::update);
    Kokkos::deep_copy(w.unit, part(image_, w.begin, w.begin + w.nodes()));
  }
  if (model.layout().has_solid) add_solid_sums();
}

template <int D, int P>
typename MassInverse<D, P>::Weights MassInverse<D, P>::weights(int begin, int nodes, int first, int last) const {
  Weights w{begin, begin + (last - first) * nodes, first, last, {}, {}, {}, {}, {}};
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
    std::vector<double> factor = axis.integrals(0, axis.length(), 0, d == D - 1 ? l.solid_elements : axis.elements());
    for (int g = axis.owned(); g < axis.functions(); ++g)
      factor[g] = factor[g - axis.owned()] = factor[g] + factor[g - axis.owned()];
    const int extent = d == D - 1 ? l.rows : l.extent(d);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] *= factor[l.function(i / stride % extent, d)];
    stride *= extent;
  }
  Kokkos::deep_copy(solid_sums_, to_device<Array>(sums));
}

template <int D, int P>
void MassInverse<D, P>::multiply_fixed(const Weights& w, const Array& in, const Array& out) {
  const bool ghosts = has_ghosts(model_.layout());
  if (ghosts) move_ghosts(model_.layout(), in, GhostAction::update);
  product_.apply(in, out, w.first, w.last);
  if (ghosts) move_ghosts(model_.layout(), out, GhostAction::add);
}

template <int D, int P>
void MassInverse<D, P>::set_mesh(const Stage& stage) {
  const Layout<D>& l = model_.layout();
  if (!l.has_fluid || (has_mesh_ && !l.has_solid)) return;
  has_mesh_ = true;
  if (!l.has_solid) {
    Kokkos::deep_copy(Exec(), scalar_.sums, scalar_.unit);
  } else {
    masses_.scalar(stage, ones_, image_);
    move_ghosts(l, image_, GhostAction::update);
    Kokkos::deep_copy(Exec(), scalar_.sums, part(image_, scalar_.begin, scalar_.end));
  }
  if (kind_ != MassKind::consistent) prepare(scalar_);
}

template <int D, int P>
void MassInverse<D, P>::set_weights(const ConstArray& moments, const Array& density) {
  const Layout<D>& l = model_.layout();
  if (kind_ == MassKind::lumped && l.has_fluid) {  // lumped moments would be those of the density at the control points
    multiply_scalar(density, image_);
    return weigh_with(part(image_, scalar_.begin, scalar_.end));
  }
  weigh_with(moments);
}

template <int D, int P>
void MassInverse<D, P>::weigh_with(const ConstArray& moments) {
  const Layout<D>& l = model_.layout();
  const Array sums = velocity_.sums;
  sum_velocity_rows(sums, solid_sums_, moments, scalar_.sums, model_.fluid().inertia_floor, l.fluid_shift());
  if (has_ghosts(l)) {
    Kokkos::deep_copy(Exec(), cut(image_, 0, velocity_.nodes()), sums);
    move_ghosts(l, image_, GhostAction::update);
    Kokkos::deep_copy(Exec(), sums, part(image_, 0, velocity_.nodes()));
  }
  if (kind_ == MassKind::corrected) prepare(velocity_);
}

template <int D, int P>
void MassInverse<D, P>::prepare(const Weights& w) {
  const int last = w.begin + w.nodes();
  find_roots(w.root, cut(scaled_, w.begin, last), w.sums, w.unit);
  Weights one = w;  // of the components
  one.last = w.first + 1;
  multiply_fixed(one, scaled_, image_);
  if (has_ghosts(model_.layout())) move_ghosts(model_.layout(), image_, GhostAction::update);
  find_factors(w.left, w.right, part(image_, w.begin, last), w.root, w.unit);
}

template <int D, int P>
void MassInverse<D, P>::tie(const Weights& w, const Array& x) const {
  w.first == 0 ? ties_.velocities(x, w.sums) : ties_.scalars(x, w.sums);
}

template <int D, int P>
int MassInverse<D, P>::solve(const Weights& w, const Array& b, const Array& z) {
  const auto of = [&w](const Array& a) { return cut(a, w.begin, w.end); };
  const ConstArray mask = part(model_.mask(), w.begin, w.end);
  divide(of(z), part(b, w.begin, w.end), w.sums, mask);
  tie(w, z);
  if (kind_ == MassKind::lumped) return 0;
  begin_series(of(iterate_), -2, of(z), of(scaled_), w.root);
  for (int k = 0; k < 3; ++k) {  // y = z + e y
    multiply_fixed(w, scaled_, image_);
    combine_images(of(image_), of(iterate_), w.left, w.right, mask);
    tie(w, image_);
    next_of_series(of(k < 2 ? iterate_ : z), of(z), of(iterate_), of(image_), of(scaled_), w.root);
  }
  return 0;
}

template <int D, int P>
int MassInverse<D, P>::scalar(const Stage& stage, const Array& b, const Array& z, double tolerance) {
  if (kind_ != MassKind::consistent) return solve(scalar_, b, z);
  const Weights& w = scalar_;
  const auto fixed_mesh = [&](const Array& r, const Array& x) {
    Kokkos::deep_copy(Exec(), cut(x, w.begin, w.end), part(r, w.begin, w.end));
    kronecker_.solve(x, w.first, w.last);
  };
  if (!model_.layout().has_solid && kronecker_.exact()) return fixed_mesh(b, z), 0;
  return solver_.solve([&](const Array& x, const Array& out) { masses_.scalar(stage, x, out); }, fixed_mesh, b, z,
                       w.begin, w.end, tolerance, most_iterations);
}

template <int D, int P>
int MassInverse<D, P>::velocity(const Stage& stage, const Array& b, const Array& z, double tolerance) {
  const Weights& w = velocity_;
  if (kind_ != MassKind::consistent) return solve(w, b, z);
  return solver_.solve([&](const Array& x, const Array& out) { masses_.velocity(stage, 1, 0, x, out); },
                       [&](const Array& r, const Array& x) {
                         const Array v = cut(x, w.begin, w.end);
                         Kokkos::deep_copy(Exec(), v, part(r, w.begin, w.end));
                         scale_by_root(v, w.unit, w.sums);
                         kronecker_.solve(x, w.first, w.last);
                         scale_by_root(v, w.unit, w.sums);
                       },
                       b, z, w.begin, w.end, tolerance, most_iterations);
}

template <int D, int P>
void MassInverse<D, P>::multiply_scalar(const Array& z, const Array& out) {
  const Weights& w = scalar_;
  const Array moments = cut(out, w.begin, w.end);
  begin_series(cut(iterate_, w.begin, w.end), 1, part(z, w.begin, w.end), cut(scaled_, w.begin, w.end), w.root);
  multiply_fixed(w, scaled_, out);
  combine_images(moments, part(z, w.begin, w.end), w.left, w.right, part(model_.mask(), w.begin, w.end));
  weigh(moments, w.sums);
}

template <int D, int P>
void MassInverse<D, P>::find_moments(const Stage& stage, const Array& z, const Array& out) {
  if (kind_ == MassKind::consistent) return masses_.scalar(stage, z, out);
  if (kind_ == MassKind::corrected) return multiply_scalar(z, out);
  const Array moments = cut(out, scalar_.begin, scalar_.end);
  Kokkos::deep_copy(Exec(), moments, part(z, scalar_.begin, scalar_.end));
  ties_.untie_scalars(out, scalar_.sums);
  weigh(moments, scalar_.sums);
  multiply(moments, part(model_.mask(), scalar_.begin, scalar_.end));
}

template class MassInverse<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
