#include "time/step/judge.hpp"

#include <utility>

#include "field/fused.hpp"
#include "field/vector.hpp"
#include "scene/admissible.hpp"
#include "time/step/sum_of.hpp"

namespace softwet {
namespace {

/// Smallest and largest value of an array over all processes, each in its own columns; a value that is not finite
/// becomes the largest, infinity.
std::pair<double, double> range(const VectorSpace& space, const ConstArray& x) {
  Kokkos::MinMaxScalar<double> r;
  const int stored = space.stored, begin = space.begin, width = space.end - space.begin;
  const bool all = width == stored;
  Kokkos::parallel_reduce(
      "softwet::range", Items(0, all ? x.extent(0) : x.extent(0) / stored * width),
      KOKKOS_LAMBDA(int i, Kokkos::MinMaxScalar<double>& best) {
        const double v = x(all ? i : i / width * stored + begin + i % width);
        const double high = Kokkos::isfinite(v) ? v : Kokkos::Experimental::infinity_v<double>;
        if (v < best.min_val) best.min_val = v;
        if (high > best.max_val) best.max_val = high;
      },
      Kokkos::MinMax<double>(r));
  double ends[2] = {-r.min_val, r.max_val};
  ranks::largest(ends, 2);
  return {-ends[0], ends[1]};
}

/// Sums of the squares of a x + b z + c w, times roots of weights where there are some.
struct SquaresOfChange {
  StripSums<double> sums;
  double a;
  Factor b, c;
  const double *x, *z, *w, *root;
  template <class Sum>
  KOKKOS_FORCEINLINE_FUNCTION void add(int item, Sum& sum) const {
    const auto change = [this](int i) { return a * x[i] + b * z[i] + c * w[i]; };
    if (root) {
      sums.add_entries(item, sum, [&](int i) {
        const double d = change(i) * root[i];
        return d * d;
      });
    } else {
      sums.add_entries(item, sum, [&](int i) {
        const double d = change(i);
        return d * d;
      });
    }
  }
};

/// Squares of the velocities, followed by squares of the density.
struct SquaresOfBoth {
  SquaresOfChange velocity, density;
  int of_velocity;  ///< items
  template <class Sum>
  KOKKOS_FORCEINLINE_FUNCTION void add(int item, Sum& sum) const {
    if (item < of_velocity) {
      velocity.add(item, sum);
    } else {
      density.add(item - of_velocity, sum);
    }
  }
};

int items_of(const std::vector<StripSums<double>>& sums) {
  int items = 0;
  for (const StripSums<double>& s : sums) items += s.items();
  return items;
}

Refusal density_complaint(double least, double largest, double undershoot) {
  if (!(largest < close_packed)) return {Refusal::close_packed};
  // Undershoots of the vapour's small density are admissible: W is continued below it.
  if (least <= -undershoot) return {Refusal::negative_density};
  return {};
}

}  // namespace

template <int D, int P>
Judge<D, P>::Judge(const Scene<D, P>& scene, const Case& c)
    : scene_(scene),
      faults_(scene.regions(), scene.balance()),
      undershoot_(c.solver.newton_undershoot),
      squares_count_(items_of(squares())),
      partial_("judge.partial", squares_count_) {
  const double thickness = scene.regions().wall_height(), height = scene.layout().axis[D - 1].length() - thickness;
  length_ = !scene.layout().has_fluid ? c.domain.size[D - 1] : thickness > 0 ? std::min(thickness, height) : height;
  bool graded = false;
  for (const Axis& axis : scene.layout().axis) graded = graded || axis.graded();
  if (graded) weigh(scene.layout());
}

template <int D, int P>
void Judge<D, P>::weigh(const Layout<D>& l) {
  const auto integral = [](const Axis& axis, int function) {
    return axis.periodic() && function >= axis.owned() ? 0.0 : axis.integral(function);
  };
  volume_ = of_scalars_ = 1;
  for (int d = 0; d < D; ++d) {
    double all = 0, scalars = 0;
    for (int i = 0; i < l.axis[d].functions(); ++i) {
      all += integral(l.axis[d], i);
      scalars += d < D - 1 || i >= l.wall_row ? integral(l.axis[d], i) : 0.0;
    }
    volume_ *= all;
    of_scalars_ *= scalars;
  }
  std::vector<double> root(l.size(), 0.0);
  const std::vector<Box<D>> all = boxes(l);
  for (std::size_t k = 0; k < all.size(); ++k) {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= all[k].extent[d];
    for (int i = 0; i < n; ++i) {
      double weight = 1;
      for (int d = 0, rest = i; d < D; ++d) {
        const int place = rest % all[k].extent[d], first = k >= D && d == D - 1 ? l.wall_row : 0;
        weight *= integral(l.axis[d], l.function(place, d) + first);
        rest /= all[k].extent[d];
      }
      root[all[k].offset + i] = std::sqrt(weight);
    }
  }
  root_of_weight_ = to_device<Array>(root, "judge.root_of_weight");
}

template <int D, int P>
Refusal Judge<D, P>::of_ranges(bool finite, double least_density, double most_density) const {
  if (!finite) return {Refusal::not_finite};
  return scene_.layout().has_fluid ? density_complaint(least_density, most_density, undershoot_) : Refusal{};
}

template <int D, int P>
Refusal Judge<D, P>::of_values(const ConstArray& x) const {
  const Layout<D>& l = scene_.layout();
  const bool finite = std::isfinite(range(l.space(), x).second);
  if (!finite || !l.has_fluid) return of_ranges(finite, 0, 0);
  const auto [least, most] = range(l.space(), part(x, l.density_offset(), l.potential_offset()));
  return of_ranges(true, least, most);
}

template <int D, int P>
Refusal Judge<D, P>::of_mesh(const Stage& stage) const {
  return of_faults(scene_.balance().faults(stage));
}

template <int D, int P>
Refusal Judge<D, P>::of_faults(const MeshFaults& faults) const {
  if (faults.inverted > 0) return {Refusal::solid_inverted};
  if (faults.folded > 0) return {Refusal::mesh_folded};
  return {};
}

template <int D, int P>
Refusal Judge<D, P>::of_end(const Stage& stage) const {
  const Refusal of_its_mesh = of_mesh(stage);
  const Layout<D>& l = scene_.layout();
  if (!of_its_mesh.empty() || !l.has_fluid) return of_its_mesh;
  const auto [least, most] = range(l.space(), stage.density_end);
  return density_complaint(least, most, undershoot_);
}

template <int D, int P>
std::vector<StripSums<double>> Judge<D, P>::squares() const {
  const Layout<D>& l = scene_.layout();
  std::vector<StripSums<double>> sums;
  const auto add = [&](int first, int last) {
    sums.push_back({l.space(), nullptr, 0, 1, {nullptr}, SquareOfFirst::left_out, last - first});
  };
  add(0, l.velocity_size());
  if (l.has_fluid) add(l.density_offset(), l.potential_offset());
  return sums;
}

template <int D, int P>
void Judge<D, P>::ask_squares(const StepHistory& history, const Array& values, const ChangeFactors& of,
                              const Array& partial) const {
  const auto kernel = [&](const StripSums<double>& sums, int first) {
    const double* root = root_of_weight_.data() ? root_of_weight_.data() + first : nullptr;
    return SquaresOfChange{sums,
                           1,
                           of.last,
                           of.before,
                           values.data() + first,
                           history.state.unknown.data() + first,
                           history.previous.data() + first,
                           root};
  };
  const std::vector<StripSums<double>> sums = squares();
  const auto of_velocity = kernel(sums.front(), 0);
  if (sums.size() == 1) return start_sums("softwet::sums", of_velocity, squares_count_, partial);
  const auto of_density = kernel(sums.back(), scene_.layout().density_offset());
  start_sums("softwet::sums", SquaresOfBoth{of_velocity, of_density, sums.front().items()}, squares_count_, partial);
}

template <int D, int P>
void Judge<D, P>::ask(const StepHistory& history, const Stage& end, const ChangeFactors& of,
                      const HostNumbers& at) const {
  faults_.ask(end, at.part(squares_count_, at.size()).device);
  if (history.previous_dt > 0) ask_squares(history, end.unknown, of, at.device);
}

template <int D, int P>
Refusal Judge<D, P>::take_mesh(const Stage& end, const HostNumbers& at) const {
  return of_faults(faults_.take(end, at.host.data() + squares_count_));
}

template <int D, int P>
double Judge<D, P>::take_indicator(const StepHistory& history, double dt, const HostNumbers& at) const {
  if (history.previous_dt <= 0) return 0;
  const Layout<D>& l = scene_.layout();
  const VectorSpace space = l.space();
  std::vector<double> sizes;
  const double* partial = at.host.data();
  for (const StripSums<double>& s : squares()) {
    StripTotals totals(space.strips, 1, strips_here(space));
    add_partial_sums(totals, s, std::exchange(partial, partial + s.items()), s.items(), 0);
    sizes.push_back(std::sqrt(totals.total(0)));
  }
  const bool weighted = volume_ > 0;
  const double points = weighted ? volume_ : entries_of_patch(l, l.velocity_size()) / D;
  const double v = sizes[0] / std::sqrt(points) * dt / length_;
  if (!l.has_fluid) return v;
  const Coexistence& phases = scene_.coefficients().coexistence();
  const double jump = phases.density_liquid - phases.density_vapour;
  return std::max(v, sizes[1] / std::sqrt(weighted ? of_scalars_ : entries_of_patch(l, l.scalar_size())) / jump);
}

template <int D, int P>
double Judge<D, P>::indicator(const StepHistory& history, const Array& values, double f, double dt) const {
  if (history.previous_dt > 0)
    ask_squares(history, values, {ChangeFactors::of_last(f), ChangeFactors::of_before(f)}, partial_.device);
  partial_.ask();
  HostNumbers::wait();
  return take_indicator(history, dt, partial_);
}

template class Judge<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
