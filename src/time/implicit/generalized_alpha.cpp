#include "time/implicit/generalized_alpha.hpp"

#include "time/step/sum_of.hpp"

namespace softwet {

namespace {

void add_constant(const Array& y, double a) {
  Kokkos::parallel_for(
      "softwet::add_constant", Items(0, y.extent(0)), KOKKOS_LAMBDA(int i) { y(i) += a; });
}

/// y += scale * one unit in the last place of x, or of `least` where that is larger; up or down as the digits of x
/// fall, which is the same on any number of processes, and alternately up and down where x is 0.
void add_last_digits(const Array& y, const ConstArray& x, double least, double scale) {
  Kokkos::parallel_for(
      "softwet::last_digits", Items(0, y.extent(0)), KOKKOS_LAMBDA(int i) {
        const double unit = scale * Kokkos::Experimental::epsilon_v<double> * Kokkos::max(Kokkos::abs(x(i)), least);
        const bool up = x(i) == 0 ? i % 2 == 0 : Kokkos::bit_cast<unsigned long long>(x(i)) % 2 == 0;
        y(i) += up ? unit : -unit;
      });
}

/// The solid's rows of velocity component d inside a vector of unknowns, for d = 0.
template <int D>
ConstArray solid_velocity(const Layout<D>& layout, const ConstArray& unknown, int d) {
  const int first = layout.velocity_offset(d);
  return part(unknown, first, first + layout.solid_rows() * layout.row_size);
}

Array piece_of(const Array& a, int first, int count) {
  return Kokkos::subview(a, Kokkos::make_pair(first, first + count));
}

}  // namespace

template <int D, int P>
GeneralizedAlpha<D, P>::GeneralizedAlpha(const Scene<D, P>& scene, double rho_inf)
    : scene_(scene),
      scheme_(rho_inf),
      alpha_(rho_inf),
      friction_(scene.layout(), scene.regions().points(), scene.mask()),
      branches_(scene.coefficients().solid().branches, scene.layout().branch_size(),
                strain_followed<P>(scene.regions())),
      work_("work", scene.layout().size()) {
  const Layout<D>& l = scene.layout();
  stage_ = make_stage<double>(l);
  if (scene.equations().precision() != Precision::full) single_stage_ = make_stage<float>(l);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::begin(const State& state, double dt, Rates rates) {
  alpha_ = rates == Rates::known ? scheme_ : AlphaParameters::backward_euler();
  start_ = state;
  dt_ = dt;
  end_time_ = state.time + dt;
  stage_.time = state.time + alpha_.af * dt;
  stage_.rate_scale = alpha_.am / (alpha_.ga * dt * alpha_.af);
  stage_.displacement_scale = dt * alpha_.af * alpha_.ga / alpha_.am;
  stage_.end_scale = 1 / alpha_.af;
  stage_.moment_rate = alpha_.am / (alpha_.ga * dt);
  stage_.density_rate_scale = stage_.rate_scale;
  if (scene_.coefficients().solid().branches.count == 0) return;
  const double ratio = alpha_.ga / alpha_.am;
  branches_.begin(state, {alpha_.af, dt * (1 - ratio), dt * ratio, 1 - 1 / alpha_.am, 1 / alpha_.am}, stage_.lag);
  stage_.branch_weight = branches_.weight(stage_.displacement_scale);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::begin_still(const State& state, double dt) {
  begin(state, dt, Rates::unknown);
  stage_.time = end_time_ = state.time;
  stage_.density_rate_scale = 0;
  stage_.branch_weight = 0;
}

template <int D, int P>
void GeneralizedAlpha<D, P>::fill_stage(const Array& x) {
  const Layout<D>& l = scene_.layout();
  const State& n = start_;
  Kokkos::deep_copy(Exec(), stage_.unknown, x);
  move_ghosts(l, stage_.unknown, GhostAction::update);
  const ConstArray u = stage_.unknown;
  const double rate = stage_.rate_scale, af = alpha_.af, ratio = alpha_.ga / alpha_.am;
  sum_of(stage_.acceleration, rate, u, -rate, n.unknown, 1 - alpha_.am / alpha_.ga, n.velocity_rate);
  if (l.rate_rows > 0 && stage_.density_rate_scale == 0)
    Kokkos::deep_copy(Exec(), piece_of(stage_.acceleration, l.velocity_size(), l.rate_rows * l.row_size), 0.0);
  const int count = l.solid_rows() * l.row_size;
  for (int d = 0; d < D && l.has_solid; ++d) {
    const int o = l.displacement_offset(d);
    const ConstArray v = solid_velocity(l, u, d), u0 = part(n.displacement, o, o + count);
    const ConstArray rate0 = part(n.displacement_rate, o, o + count);
    const double a = dt_ * ratio, b = dt_ * (1 - ratio);
    sum_of(piece_of(stage_.displacement_end, o, count), 1, u0, a, v, b, rate0);
    sum_of(piece_of(stage_.displacement, o, count), 1, u0, af * a, v, af * b, rate0);
  }
  if (stage_.branch_weight > 0) branches_.set_lag(stage_.displacement, stage_.lag);
  if (l.has_fluid) {
    const ConstArray rho = part(u, l.density_offset(), l.potential_offset());
    const ConstArray rho0 = part(n.unknown, l.density_offset(), l.potential_offset());
    sum_of(stage_.density_end, 1 / af, rho, 1 - 1 / af, rho0, 0, rho0);
  }
}

template <int D, int P>
void GeneralizedAlpha<D, P>::residual(const Array& x, const Array& r) {
  fill_stage(x);
  if (scene_.equations().precision() != Precision::full) round_stage(single_stage_, stage_);
  scene_.equations().residual(stage_, r);
  const Layout<D>& l = scene_.layout();
  if (!l.has_fluid) return;
  add_scaled(r, l.density_offset(), 1 - alpha_.am / alpha_.ga, start_.moment_rate);
  add_scaled(r, l.density_offset(), -stage_.moment_rate, start_.moment);
  friction_.set(r);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::last_digits(const Array& x, const Array& near, const Array& out) {
  const Layout<D>& l = scene_.layout();
  Kokkos::deep_copy(Exec(), near, x);
  add_last_digits(near, x, 0, 1);
  for (int d = 0; d < D && l.has_solid; ++d) {
    const int count = l.solid_rows() * l.row_size, o = l.displacement_offset(d);
    add_last_digits(piece_of(near, l.velocity_offset(d), count), part(start_.displacement, o, o + count),
                    l.axis[D - 1].length(), 1 / dt_);
  }
  residual(near, out);
  residual(x, work_);
  add_scaled(out, 0, -1, work_);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::product(const Array& z, const Array& out) const {
  scene_.equations().product(stage_, z, out, Geometry::exact, friction_.unbalanced());
}

template <int D, int P>
void GeneralizedAlpha<D, P>::product(const ArrayOf<float>& z, const ArrayOf<float>& out) const {
  scene_.equations().product(single_stage_, z, out, Geometry::exact, friction_.single_unbalanced());
}

template <int D, int P>
void GeneralizedAlpha<D, P>::jacobian(const StencilValues& values, double stretch) {
  if (jacobian_stage_.unknown.extent(0) == 0) jacobian_stage_ = make_stage<float>(scene_.layout());
  round_stage(jacobian_stage_, stage_);
  jacobian_stage_.moment_rate *= stretch;
  jacobian_stage_.rate_scale *= stretch;
  jacobian_stage_.density_rate_scale *= stretch;
  jacobian_stage_.displacement_scale /= stretch;
  if (jacobian_stage_.branch_weight > 0)
    jacobian_stage_.branch_weight = branches_.weight(jacobian_stage_.displacement_scale);
  last_jacobian(values);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::visit_memory(StepMemory& memory) {
  StageOf<float>& s = jacobian_stage_;
  if (s.unknown.extent(0) == 0) s = make_stage<float>(scene_.layout());
  memory.number("jacobian/time", s.time);
  memory.number("jacobian/rate_scale", s.rate_scale);
  memory.number("jacobian/displacement_scale", s.displacement_scale);
  memory.number("jacobian/end_scale", s.end_scale);
  memory.number("jacobian/moment_rate", s.moment_rate);
  if (scene_.layout().rate_rows > 0) memory.number("jacobian/density_rate_scale", s.density_rate_scale);
  if (scene_.layout().branches > 0) memory.number("jacobian/branch_weight", s.branch_weight);
  memory.vector("jacobian/unknown", s.unknown);
  memory.vector("jacobian/acceleration", s.acceleration);
  memory.vector("jacobian/displacement", s.displacement);
  memory.vector("jacobian/displacement_end", s.displacement_end);
  memory.vector("jacobian/density_end", s.density_end);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::initialise(State& state) {
  const Layout<D>& l = scene_.layout();
  move_ghosts(l, state.unknown, GhostAction::update);
  for (int d = 0; d < D && l.has_solid; ++d)  // u' = v
    Kokkos::deep_copy(piece_of(state.displacement_rate, l.displacement_offset(d), l.solid_rows() * l.row_size),
                      solid_velocity(l, state.unknown, d));
  branches_.rest(state);
  if (!l.has_fluid) return;
  Stage s = stage_at(l, state);
  s.moment_rate = 0;
  scene_.equations().residual(s, work_);
  Kokkos::deep_copy(state.moment_rate, part(work_, l.density_offset(), l.potential_offset()));
  s.moment_rate = 1;
  scene_.equations().residual(s, work_);
  Kokkos::deep_copy(state.moment, part(work_, l.density_offset(), l.potential_offset()));
  combine(state.moment, -1, state.moment_rate, 1);
  combine(state.moment_rate, -1, state.moment_rate, 0);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::finish(const Array& x, State& state) {
  const Layout<D>& l = scene_.layout();
  const double am = alpha_.am, af = alpha_.af, ga = alpha_.ga;
  fill_stage(x);
  if (l.has_fluid) {
    // p_{n+1} = p_n - (ga dt / am) [(1 - am/ga) p'_n + F]: equal to M rho_{n+1} minus the final residual.
    Stage flux = stage_;
    flux.moment_rate = 0;
    scene_.equations().residual(flux, work_);
    const ConstArray f = part(work_, l.density_offset(), l.potential_offset());
    // p'_{n+1} = (1 - 1/ga) p'_n + (p_{n+1} - p_n) / (ga dt)  =  (1 - 1/am) p'_n - F / am
    const double step = ga * dt_ / am;
    sum_of(state.moment, 1, start_.moment, -step * (1 - am / ga), start_.moment_rate, -step, f);
    sum_of(state.moment_rate, 1 - 1 / am, start_.moment_rate, -1 / am, f, 0, f);
  }
  for (int d = 0; d < D && l.has_solid; ++d) {
    const int o = l.displacement_offset(d), count = l.solid_rows() * l.row_size;
    const ConstArray v = solid_velocity(l, stage_.unknown, d), r = part(start_.displacement_rate, o, o + count);
    sum_of(piece_of(state.displacement_rate, o, count), 1 - 1 / am, r, 1 / am, v, 0, v);
  }
  if (stage_.branch_weight > 0) branches_.finish(start_, stage_.displacement, state);
  state.memory_shift = stage_.branch_weight > 0 ? (am - af) * dt_ : 0;
  if (l.has_solid) Kokkos::deep_copy(state.displacement, stage_.displacement_end);
  if (stage_.branch_weight == 0) branches_.rest(state);
  sum_of(state.velocity_rate, 1 - 1 / am, start_.velocity_rate, 1 / am, stage_.acceleration, 0, stage_.acceleration);
  sum_of(state.unknown, 1 / af, stage_.unknown, 1 - 1 / af, start_.unknown, 0, start_.unknown);
  state.time = end_time_;
  if (l.has_fluid) match_mass(state);
}

template <int D, int P>
void GeneralizedAlpha<D, P>::match_mass(const State& state) const {
  const Layout<D>& l = scene_.layout();
  const Filling sum = scene_.balance().filling(stage_at(l, state));
  const double shift = (total(l.space(), state.moment) - sum.mass) / sum.volume;
  add_constant(piece_of(state.unknown, l.density_offset(), l.scalar_size()), shift);
}

template class GeneralizedAlpha<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
