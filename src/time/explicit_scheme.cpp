#include "time/explicit_scheme.hpp"

namespace softwet {
namespace {

/// Fraction of the largest stable step that is taken.
constexpr double safety = 0.9;

std::unique_ptr<RungeKutta> runge_kutta(const std::string& name, int size) {
  if (name == "imex") return std::make_unique<ImexArs343>(size);
  return std::make_unique<SspRk3>(size);
}

/// Adds numbers between -size and size that look random and are the same in every run.
void add_noise(const Array& a, double size) {
  Kokkos::parallel_for(
      "softwet::noise", Kokkos::RangePolicy<Exec>(0, a.extent(0)), KOKKOS_LAMBDA(int i) {
        const unsigned mixed = (static_cast<unsigned>(i) * 2654435761u) ^ (static_cast<unsigned>(i) >> 7);
        a(i) += size * ((mixed % 20011u) / 10005.0 - 1.0);
      });
}

}  // namespace

template <int D, int P>
ExplicitScheme<D, P>::ExplicitScheme(const Model<D, P>& model, const Case& c, const Judge<D, P>& judge)
    : judge_(judge),
      system_(model, c.time.mass == "lumped" ? MassKind::lumped : MassKind::consistent),
      scheme_(runge_kutta(c.time.scheme, system_.size())) {
  for (Array* a : {&y_, &rates_, &next_, &next_rates_, &probe_, &direction_})
    *a = Array("explicit.vector", system_.size());
}

template <int D, int P>
std::string ExplicitScheme<D, P>::rates(double t, const Array& y, const Array& out) {
  return scheme_->treats_stiff_part() ? system_.gentle_rates(t, y, out) : system_.rates(t, y, out);
}

template <int D, int P>
std::string ExplicitScheme<D, P>::begin(const State& state) {
  if (known_rates_) return "";
  system_.pack(state, y_);
  const std::string problem = rates(state.time, y_, rates_);
  known_rates_ = problem.empty();
  return problem;
}

template <int D, int P>
double ExplicitScheme<D, P>::grow_direction(double t) {
  const double length = norm(direction_), step = 1e-7 * (1 + norm(y_)) / length;
  Kokkos::deep_copy(Exec(), probe_, y_);
  add_scaled(probe_, 0, step, direction_);
  if (!rates(t, probe_, next_rates_).empty()) return 0;
  add_scaled(next_rates_, 0, -1, rates_);
  const double size = norm(next_rates_) / (step * length);
  if (!(size > 0) || !std::isfinite(size)) return 0;
  combine(direction_, 1 / (size * step * length), next_rates_, 0);
  return size;
}

template <int D, int P>
void ExplicitScheme<D, P>::measure_radius(double t) {
  // The length of one product swings, for the velocities and moments in the direction trade places. The mean growth over
  // a window does not.
  constexpr int window = 8, most = 80;
  constexpr double settled = 0.02;
  double growth[most + 1] = {};  // logarithm of that since the first iteration
  // The noise lets modes grow that have become the largest since the last time.
  add_noise(direction_, 0.1 / std::sqrt(static_cast<double>(direction_.extent(0))));
  radius_ = 0;
  for (int k = 1; k <= most; ++k) {
    const double size = grow_direction(t);
    if (size == 0) break;
    growth[k] = growth[k - 1] + std::log(size);
    const int first = std::max(0, k - window);
    const double now = std::exp((growth[k] - growth[first]) / (k - first));
    const bool still = k > 2 * window && std::abs(now - radius_) < settled * now;
    radius_ = now;
    if (still) break;
  }
  age_ = 0;
}

template <int D, int P>
double ExplicitScheme<D, P>::largest_step(const State& state) {
  if (!begin(state).empty()) return std::numeric_limits<double>::infinity();  // the attempt tells
  if (age_ >= most_age) measure_radius(state.time);
  return safety * scheme_->limit(radius_);
}

template <int D, int P>
StepAttempt ExplicitScheme<D, P>::attempt(const StepHistory& history, double dt) {
  Stopwatch watch(counts_.residual_seconds);
  const MassCounts before = system_.counts();
  StepAttempt attempt;
  attempt.reason = begin(history.state);
  if (!attempt.reason.empty()) return attempt;
  Kokkos::deep_copy(Exec(), next_, y_);
  end_ = history.state.time + dt;
  attempt.reason = scheme_->advance(system_, history.state.time, dt, next_, rates_);
  if (attempt.reason.empty()) attempt.reason = rates(end_, next_, next_rates_);
  if (attempt.reason.empty()) attempt.reason = judge_.of_values(system_.stage().unknown);
  if (attempt.reason.empty()) attempt.reason = judge_.of_end(system_.stage());
  const MassCounts& now = system_.counts();
  attempt.krylov = static_cast<int>(now.iterations() - before.iterations());
  counts_.residuals += 2 * (now.rates - before.rates);
  counts_.krylov += attempt.krylov;
  if (attempt.reason.empty())
    attempt.indicator = judge_.indicator(history, system_.stage().unknown, dt / history.previous_dt, dt);
  return attempt;
}

template <int D, int P>
void ExplicitScheme<D, P>::accept(State& state) {
  system_.copy_stage(end_, next_, next_rates_, state);
  std::swap(y_, next_);
  std::swap(rates_, next_rates_);
  known_rates_ = true;
  ++age_;
}

template class ExplicitScheme<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
