#include "time/semi_discrete.hpp"

namespace softwet {
namespace {

constexpr int most_iterations = 400;
constexpr double tight = 1e-12;

Array cut(const Array& a, int first, int last) { return Kokkos::subview(a, Kokkos::make_pair(first, last)); }

/// x(i) /= w(i) where w is not 0: on held values and ghosts it is.
void divide(const Array& x, const ConstArray& w) {
  Kokkos::parallel_for(
      "softwet::divide", Items(0, x.extent(0)), KOKKOS_LAMBDA(int i) { x(i) = w(i) != 0 ? x(i) / w(i) : 0.0; });
}

/// x(i) *= sqrt(a(i) / b(i)), 0 where b is.
void scale_by_root(const Array& x, const ConstArray& a, const ConstArray& b) {
  Kokkos::parallel_for(
      "softwet::scale_by_root", Items(0, x.extent(0)),
      KOKKOS_LAMBDA(int i) { x(i) = b(i) > 0 ? x(i) * Kokkos::sqrt(a(i) / b(i)) : 0.0; });
}

}  // namespace

template <int D, int P>
SemiDiscrete<D, P>::SemiDiscrete(const Model<D, P>& model, MassKind kind)
    : model_(model),
      masses_(model),
      kind_(kind),
      kronecker_(model.layout(), model.points(), model.mask()),
      solver_(model.layout().space(), model.layout().size()),
      velocity_(model.layout().velocity_size()),
      solid_(model.layout().solid_size()),
      scalar_(model.layout().scalar_size()),
      stiff_("explicit.stiff", velocity_),
      zero_("explicit.zero", velocity_),
      force_("explicit.force", model.layout().size()),
      right_("explicit.right", model.layout().size()),
      solution_("explicit.solution", model.layout().size()),
      ones_("explicit.ones", model.layout().size()),
      scalar_weight_("explicit.scalar_weight", model.layout().size()),
      velocity_weight_("explicit.velocity_weight", model.layout().size()) {
  const Layout<D>& l = model.layout();
  stage_.unknown = Array("explicit.unknown", l.size());
  stage_.acceleration = zero_;
  stage_.displacement = stage_.displacement_end = Array("explicit.displacement", l.solid_size());
  if (l.has_fluid) stage_.density_end = cut(stage_.unknown, l.density_offset(), l.potential_offset());
  Kokkos::deep_copy(ones_, 1.0);
}

template <int D, int P>
void SemiDiscrete<D, P>::pack(const State& s, const Array& y) const {
  Kokkos::deep_copy(cut(y, 0, velocity_), part(s.unknown, 0, velocity_));
  Kokkos::deep_copy(cut(y, velocity_, velocity_ + solid_), s.displacement);
  Kokkos::deep_copy(cut(y, velocity_ + solid_, size()), s.moment);
}

template <int D, int P>
Array SemiDiscrete<D, P>::free_values() const {
  const Layout<D>& l = model_.layout();
  const Array free("explicit.free", size());
  Kokkos::deep_copy(cut(free, 0, velocity_), part(model_.mask(), 0, velocity_));
  if (l.has_fluid)
    Kokkos::deep_copy(cut(free, velocity_ + solid_, size()),
                      part(model_.mask(), l.density_offset(), l.potential_offset()));
  return free;
}

template <int D, int P>
void SemiDiscrete<D, P>::copy_stage(double t, const Array& y, const Array& rates, State& s) const {
  s.time = t;
  Kokkos::deep_copy(s.unknown, stage_.unknown);
  Kokkos::deep_copy(s.displacement, stage_.displacement);
  Kokkos::deep_copy(s.moment, cut(y, velocity_ + solid_, size()));
  Kokkos::deep_copy(Exec(), right_, 0.0);  // rates are zero at ghosts, those of a state are not
  Kokkos::deep_copy(Exec(), cut(right_, 0, velocity_), cut(rates, 0, velocity_));
  move_ghosts(model_.layout(), right_, GhostAction::update);
  Kokkos::deep_copy(s.velocity_rate, part(right_, 0, velocity_));
  Kokkos::deep_copy(s.displacement_rate, cut(rates, velocity_, velocity_ + solid_));
  Kokkos::deep_copy(s.moment_rate, cut(rates, velocity_ + solid_, size()));
}

template <int D, int P>
void SemiDiscrete<D, P>::set_moments(State& s) {
  const Layout<D>& l = model_.layout();
  move_ghosts(l, s.unknown, GhostAction::update);
  if (!l.has_fluid) return;
  Kokkos::deep_copy(stage_.displacement, s.displacement);
  const int first = l.density_offset(), last = l.potential_offset();
  if (kind_ == MassKind::lumped) {
    masses_.scalar(stage_, ones_, scalar_weight_);
    Kokkos::deep_copy(s.moment, part(s.unknown, first, last));
    multiply(s.moment, part(scalar_weight_, first, last));
  } else {
    Kokkos::deep_copy(right_, s.unknown);
    masses_.scalar(stage_, right_, solution_);
    Kokkos::deep_copy(s.moment, part(solution_, first, last));
  }
  Kokkos::deep_copy(stage_.unknown, s.unknown);  // where the searches for density and potential begin
}

template <int D, int P>
void SemiDiscrete<D, P>::place_motion(const Array& y) {
  Kokkos::deep_copy(Exec(), cut(stage_.unknown, 0, velocity_), cut(y, 0, velocity_));
  move_ghosts(model_.layout(), stage_.unknown, GhostAction::update);
  Kokkos::deep_copy(Exec(), stage_.displacement, cut(y, velocity_, velocity_ + solid_));
}

template <int D, int P>
int SemiDiscrete<D, P>::solve_scalar(const Array& b, const Array& z, double tolerance) {
  const Layout<D>& l = model_.layout();
  const int first = l.density_offset(), last = l.potential_offset();
  if (kind_ == MassKind::lumped) {
    Kokkos::deep_copy(Exec(), cut(z, first, last), part(b, first, last));
    divide(cut(z, first, last), part(scalar_weight_, first, last));
    return 0;
  }
  const auto fixed_mesh = [&](const Array& r, const Array& x) {
    Kokkos::deep_copy(Exec(), cut(x, first, last), part(r, first, last));
    kronecker_.solve(x, D, D + 1);
  };
  if (!l.has_solid && kronecker_.exact()) return fixed_mesh(b, z), 0;
  return solver_.solve([&](const Array& x, const Array& out) { masses_.scalar(stage_, x, out); }, fixed_mesh, b, z,
                       first, last, tolerance, most_iterations);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::find_density(const ConstArray& moments) {
  const Layout<D>& l = model_.layout();
  const int first = l.density_offset(), last = l.potential_offset();
  if (kind_ == MassKind::lumped) masses_.scalar(stage_, ones_, scalar_weight_);
  Kokkos::deep_copy(Exec(), right_, 0.0);
  Kokkos::deep_copy(Exec(), cut(right_, first, last), moments);
  Kokkos::deep_copy(Exec(), solution_, 0.0);
  Kokkos::deep_copy(Exec(), cut(solution_, first, last), part(stage_.unknown, first, last));
  multiply(solution_, model_.mask());
  const int iterations = solve_scalar(right_, solution_, tight);
  if (iterations < 0) return {Refusal::density_of_moments};
  counts_.density += iterations;
  Kokkos::deep_copy(Exec(), cut(stage_.unknown, first, last), part(solution_, first, last));
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::find_potential() {
  const Layout<D>& l = model_.layout();
  const int first = l.density_offset(), last = l.potential_offset(), count = last - first;
  const Array potential = cut(stage_.unknown, last, l.size());
  Kokkos::deep_copy(Exec(), solution_, 0.0);  // from the last one
  Kokkos::deep_copy(Exec(), cut(solution_, first, last), potential);
  model_.potential_moments(stage_, force_);
  Kokkos::deep_copy(Exec(), right_, 0.0);
  Kokkos::deep_copy(Exec(), cut(right_, first, last), part(force_, last, last + count));
  multiply(solution_, model_.mask());
  const int iterations = solve_scalar(right_, solution_, tight);
  if (iterations < 0) return {Refusal::potential};
  counts_.potential += iterations;
  Kokkos::deep_copy(Exec(), potential, part(solution_, first, last));
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::place(double t, const Array& y) {
  stage_.time = t;
  place_motion(y);
  if (!model_.layout().has_fluid) return {};
  Refusal problem = find_density(part(y, velocity_ + solid_, size()));
  move_ghosts(model_.layout(), stage_.unknown, GhostAction::update);
  if (problem.empty()) problem = find_potential();
  move_ghosts(model_.layout(), stage_.unknown, GhostAction::update);
  return problem;
}

template <int D, int P>
void SemiDiscrete<D, P>::weigh_velocities() {
  masses_.velocity(stage_, 1, 0, ones_, velocity_weight_);
}

template <int D, int P>
int SemiDiscrete<D, P>::solve_velocity(double c, const Array& b, const Array& z, double tolerance) {
  const ConstArray weight = part(velocity_weight_, 0, velocity_), sums = part(kronecker_.row_sums(), 0, velocity_);
  if (kind_ == MassKind::lumped && c == 0) {
    Kokkos::deep_copy(Exec(), cut(z, 0, velocity_), part(b, 0, velocity_));
    divide(cut(z, 0, velocity_), weight);
    return 0;
  }
  const double viscosity = c * model_.fluid().viscosity;
  return solver_.solve([&](const Array& x, const Array& out) { masses_.velocity(stage_, 1, viscosity, x, out); },
                       [&](const Array& r, const Array& x) {
                         const Array v = cut(x, 0, velocity_);
                         Kokkos::deep_copy(Exec(), v, part(r, 0, velocity_));
                         scale_by_root(v, sums, weight);
                         kronecker_.solve(x, 0, D);
                         scale_by_root(v, sums, weight);
                       },
                       b, z, 0, velocity_, tolerance, most_iterations);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::all_rates(double t, const Array& y, const Array& out, bool viscous) {
  ++counts_.rates;
  const Refusal problem = place(t, y);
  if (!problem.empty()) return problem;
  const Layout<D>& l = model_.layout();
  model_.residual(stage_, force_);
  Kokkos::deep_copy(Exec(), cut(out, velocity_, velocity_ + solid_), 0.0);
  for (int d = 0; d < D && l.has_solid; ++d) {
    const int count = l.solid_rows() * l.row_size, first = velocity_ + l.displacement_offset(d);
    Kokkos::deep_copy(Exec(), cut(out, first, first + count),
                      part(stage_.unknown, l.velocity_offset(d), l.velocity_offset(d) + count));
  }
  if (l.has_fluid)
    combine(cut(out, velocity_ + solid_, size()), -1, part(force_, l.density_offset(), l.potential_offset()), 0);
  if (!viscous && l.has_fluid) {
    Kokkos::deep_copy(Exec(), solution_, stage_.unknown);
    masses_.velocity(stage_, 0, model_.fluid().viscosity, solution_, right_);
    add_scaled(force_, 0, -1, part(right_, 0, velocity_));
  }
  Kokkos::deep_copy(Exec(), right_, 0.0);
  combine(cut(right_, 0, velocity_), -1, part(force_, 0, velocity_), 0);
  weigh_velocities();
  Kokkos::deep_copy(Exec(), solution_, 0.0);
  const int iterations = solve_velocity(0, right_, solution_, velocity_tolerance);
  if (iterations < 0) return {Refusal::acceleration};
  counts_.velocity += iterations;
  Kokkos::deep_copy(Exec(), cut(out, 0, velocity_), part(solution_, 0, velocity_));
  return {};
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::hold(const Array& y) {
  place_motion(y);
  if (!model_.layout().has_fluid) return {};
  const Refusal problem = find_density(part(y, velocity_ + solid_, size()));
  move_ghosts(model_.layout(), stage_.unknown, GhostAction::update);
  weigh_velocities();
  return problem;
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::stiff_rates(const Array& y, const Array& out) {
  Kokkos::deep_copy(Exec(), out, 0.0);
  if (!model_.layout().has_fluid) return {};
  Kokkos::deep_copy(Exec(), solution_, 0.0);
  Kokkos::deep_copy(Exec(), cut(solution_, 0, velocity_), part(y, 0, velocity_));
  masses_.velocity(stage_, 0, -model_.fluid().viscosity, solution_, right_);
  Kokkos::deep_copy(Exec(), solution_, 0.0);
  const int iterations = solve_velocity(0, right_, solution_, stiff_tolerance_);
  if (iterations < 0) return {Refusal::viscous_rate};
  counts_.viscous += iterations;
  Kokkos::deep_copy(Exec(), cut(out, 0, velocity_), part(solution_, 0, velocity_));
  return {};
}

template <int D, int P>
double SemiDiscrete<D, P>::stiff_quotient(const Array& y) {
  if (!model_.layout().has_fluid) return 0;
  const VectorSpace space = model_.layout().space();
  const auto square = [&](const Array& a) { return dot(space, part(solution_, 0, velocity_), part(a, 0, velocity_)); };
  Kokkos::deep_copy(Exec(), solution_, 0.0);
  Kokkos::deep_copy(Exec(), cut(solution_, 0, velocity_), part(y, 0, velocity_));
  masses_.velocity(stage_, 0, model_.fluid().viscosity, solution_, right_);
  const double power = square(right_);
  if (kind_ == MassKind::lumped) {
    Kokkos::deep_copy(Exec(), right_, solution_);
    multiply(right_, velocity_weight_);
  } else {
    masses_.velocity(stage_, 1, 0, solution_, right_);
  }
  return power / square(right_);
}

template <int D, int P>
Refusal SemiDiscrete<D, P>::implicit_part(double c, const Array& y, const Array& out) {
  Kokkos::deep_copy(Exec(), out, 0.0);
  if (!model_.layout().has_fluid || c == 0) return {};
  // (A + c K) v = A w; with v = w + c g this is (A + c K) g = -K w, which keeps small g accurate.
  Kokkos::deep_copy(Exec(), solution_, 0.0);
  Kokkos::deep_copy(Exec(), cut(solution_, 0, velocity_), part(y, 0, velocity_));
  masses_.velocity(stage_, 0, -model_.fluid().viscosity, solution_, right_);
  Kokkos::deep_copy(Exec(), solution_, 0.0);  // the search begins at what was found last
  Kokkos::deep_copy(Exec(), cut(solution_, 0, velocity_), stiff_);
  const int iterations = solve_velocity(c, right_, solution_, stiff_tolerance_);
  if (iterations < 0) return {Refusal::implicit_viscosity};
  counts_.viscous += iterations;
  Kokkos::deep_copy(Exec(), stiff_, part(solution_, 0, velocity_));
  solved_ = true;
  Kokkos::deep_copy(Exec(), cut(out, 0, velocity_), part(solution_, 0, velocity_));
  add_scaled(cut(y, 0, velocity_), 0, c, part(solution_, 0, velocity_));
  return {};
}

template <int D, int P>
void SemiDiscrete<D, P>::visit_memory(StepMemory& memory, const State& state) {
  memory.flag("viscous/solved", solved_);
  if (solved_) memory.vector("viscous/rates", stiff_);
  if (!memory.restores()) return;
  stage_.time = state.time;
  Kokkos::deep_copy(stage_.unknown, state.unknown);
  Kokkos::deep_copy(stage_.displacement, state.displacement);
  weigh_velocities();
}

template class SemiDiscrete<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
