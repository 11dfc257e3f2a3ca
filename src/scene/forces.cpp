#include "scene/forces.hpp"

#include <algorithm>

#include "field/factor.hpp"

namespace softwet {
namespace {

/// out -= force weight, by control point of the solid.
template <int D>
struct SubtractForce {
  Array out;
  ConstArray weight;
  Factor minus[D];
  int apart;  ///< from one velocity to the next
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int d = 0; d < D; ++d) out(d * apart + i) += minus[d] * weight(i);
  }
};
bool acts(const std::vector<double>& force) {
  return std::any_of(force.begin(), force.end(), [](double f) { return f != 0; });
}
/// @param minus  where kernels read minus the force; null: they have it as an argument
template <int D>
void subtract_force(const Layout<D>& l, const std::vector<double>& force, const ConstArray& weight, const Array& out,
                    const double* minus = nullptr) {
  SubtractForce<D> subtract{out, weight, {}, l.rows * l.row_size};
  for (int d = 0; d < D; ++d) subtract.minus[d] = factor_at(minus ? minus + d : nullptr, -force[d]);
  if (acts(force)) Kokkos::parallel_for("softwet::subtract_force", Items(0, weight.extent(0)), subtract);
}

}  // namespace

template <int D>
Forces<D>::Forces(const Layout<D>& layout, const Case& c) : layout_(layout) {
  if (!c.substrate) return;
  const Substrate& s = *c.substrate;
  for (const Load& load : c.loads) loads_.emplace_back(layout_, load, s.density, c.clock_zero());
  needles_ = Needles<D>(layout_, c);
  if (s.gravity.empty()) return;
  std::vector<double> upper = c.domain.size;
  upper[D - 1] = s.thickness;
  const std::vector<double> w = weights_on_box(layout_, std::vector<double>(D, 0.0), upper, s.density);
  gravity_ = {to_device<Array>(w, "gravity"), s.gravity};
}

template <int D>
void Forces<D>::find(double time, double* numbers) const {
  for (const LoadVector<D>& load : loads_) {
    load.move(layout_, time);
    for (double f : load.force(time)) *numbers++ = -f;
  }
  needles_.find_places(time, numbers);
}

template <int D>
std::vector<bool> Forces<D>::acting(double time) const {
  std::vector<bool> all;
  for (const LoadVector<D>& load : loads_) all.push_back(acts(load.force(time)));
  return all;
}

template <int D>
void Forces<D>::add_loads(double time, const Array& out, const double* numbers) const {
  for (std::size_t k = 0; k < loads_.size(); ++k) {
    const LoadVector<D>& load = loads_[k];
    if (!numbers) load.move(layout_, time);
    subtract_force(layout_, load.force(time), load.weight(), out, numbers ? numbers + D * k : nullptr);
  }
  if (!gravity_.force.empty()) subtract_force(layout_, gravity_.force, gravity_.weight, out);
}

template <int D>
void Forces<D>::start_load_power(double time, const ConstArray& unknown, PendingIntegrals& pending,
                                 double& power) const {
  power = 0;
  for (const LoadVector<D>& load : loads_) {
    const std::vector<double> force = load.force(time);
    load.move(layout_, time);
    const ConstArray weight = load.weight();
    const int count = static_cast<int>(weight.extent(0));
    for (int d = 0; d < D; ++d) {
      const int first = layout_.velocity_offset(d);
      if (force[d] != 0)
        pending.start_sum(layout_.space(), weight, part(unknown, first, first + count),
                          [&power, f = force[d]](double sum) { power += f * sum; });
    }
  }
}

template class Forces<2>;
template class Forces<3>;

}  // namespace softwet
