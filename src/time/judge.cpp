#include "time/judge.hpp"

#include "field/vector.hpp"

namespace softwet {
namespace {

/// Smallest and largest value of an array over all processes, each in its own columns; a value that is not finite becomes
/// the largest, infinity.
std::pair<double, double> range(const ConstArray& x) {
  Kokkos::MinMaxScalar<double> r;
  const SumColumns& c = sum_columns();
  const bool all = c.stored == 0 || c.end - c.begin == c.stored;
  const int stored = c.stored, begin = c.begin, width = c.end - c.begin;
  Kokkos::parallel_reduce(
      "softwet::range", Items(0, all ? x.extent(0) : x.extent(0) / stored * width),
      KOKKOS_LAMBDA(int i, Kokkos::MinMaxScalar<double>& best) {
        const double v = x(all ? i : i / width * stored + begin + i % width);
        const double high = Kokkos::isfinite(v) ? v : Kokkos::Experimental::infinity_v<double>;
        if (v < best.min_val) best.min_val = v;
        if (high > best.max_val) best.max_val = high;
      },
      Kokkos::MinMax<double>(r));
  return {ranks::least(r.min_val), ranks::largest(r.max_val)};
}

Refusal density_complaint(const ConstArray& density, double undershoot) {
  const auto [least, largest] = range(density);
  if (!(largest < 0.999)) return {Refusal::close_packed};
  // Undershoots of the vapour's small density are admissible: W is continued below it.
  if (least <= -undershoot) return {Refusal::negative_density};
  return {};
}

}  // namespace

template <int D, int P>
Judge<D, P>::Judge(const Model<D, P>& model, const Case& c)
    : model_(model), undershoot_(c.solver.newton_undershoot), difference_("judge.difference", model.layout().size()) {
  const double thickness = model.wall_height(), height = model.layout().axis[D - 1].length() - thickness;
  length_ = !model.layout().has_fluid ? c.domain.size[D - 1] : thickness > 0 ? std::min(thickness, height) : height;
}

template <int D, int P>
Refusal Judge<D, P>::of_values(const ConstArray& x) const {
  const Layout<D>& l = model_.layout();
  if (!std::isfinite(range(x).second)) return {Refusal::not_finite};
  return l.has_fluid ? density_complaint(part(x, l.density_offset(), l.potential_offset()), undershoot_) : Refusal{};
}

template <int D, int P>
Refusal Judge<D, P>::of_end(const Stage& stage, const Integrals& sum) const {
  if (sum.inverted > 0) return {Refusal::solid_inverted};
  if (sum.folded > 0) return {Refusal::mesh_folded};
  return model_.layout().has_fluid ? density_complaint(stage.density_end, undershoot_) : Refusal{};
}

template <int D, int P>
double Judge<D, P>::indicator(const StepHistory& history, const Array& values, double f, double dt) const {
  if (history.previous_dt <= 0) return 0;
  const Layout<D>& l = model_.layout();
  Kokkos::deep_copy(Exec(), difference_, values);
  add_scaled(difference_, 0, -1 - f, history.state.unknown);
  add_scaled(difference_, 0, f, history.previous);
  const int nv = l.velocity_size();
  const double v = norm(part(difference_, 0, nv)) / std::sqrt(entries_of_patch(l, nv) / D) * dt / length_;
  if (!l.has_fluid) return v;
  const double jump = model_.state().density_liquid - model_.state().density_vapour;
  const double rho = norm(part(difference_, l.density_offset(), l.potential_offset()));
  return std::max(v, rho / std::sqrt(entries_of_patch(l, l.scalar_size())) / jump);
}

template class Judge<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
