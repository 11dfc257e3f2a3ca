#include "time/explicit_scheme.hpp"

#include "case/error.hpp"

namespace softwet {
namespace {

std::unique_ptr<RungeKutta> runge_kutta(const std::string& name, int size) {
  if (name == "rkl2") return std::make_unique<StrangRkl2>(size);
  if (name == "imex") return std::make_unique<ImexArs343>(size);
  return std::make_unique<SspRk3>(size);
}

}  // namespace

template <int D, int P>
ExplicitScheme<D, P>::ExplicitScheme(const Model<D, P>& model, const Case& c, const Judge<D, P>& judge)
    : judge_(judge),
      system_(model, c.time.mass == "lumped" ? MassKind::lumped : MassKind::consistent),
      scheme_(runge_kutta(c.time.scheme, system_.size())),
      spectrum_(system_.size(), system_.free_values()),
      stiff_spectrum_(scheme_->needs_stiff_radius() ? system_.size() : 0, system_.free_values()),
      safety_(c.time.safety) {
  for (Array* a : {&y_, &rates_, &next_, &next_rates_, &probe_}) *a = Array("explicit.vector", system_.size());
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::rates(double t, const Array& y, const Array& out) {
  return scheme_->treats_stiff_part() ? system_.gentle_rates(t, y, out) : system_.rates(t, y, out);
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::begin(const State& state) {
  if (known_rates_) return {};
  system_.pack(state, y_);
  const Refusal problem = rates(state.time, y_, rates_);
  known_rates_ = problem.empty();
  return problem;
}

template <int D, int P>
void ExplicitScheme<D, P>::measure_radius(double t) {
  constexpr int shortest = 10, longest = 80;
  constexpr double same = 0.02;
  const double before = spectrum_.radius();
  spectrum_.measure([&](const Array& z, const Array& out) {
    const double step = 1e-7 * (1 + norm(y_)) / norm(z);
    Kokkos::deep_copy(Exec(), probe_, y_);
    add_scaled(probe_, 0, step, z);
    if (!rates(t, probe_, out).empty()) return false;
    add_scaled(out, 0, -1, rates_);
    combine(out, 1 / step, out, 0);
    return true;
  });
  if (scheme_->needs_stiff_radius() && system_.hold(y_).empty()) {
    stiff_spectrum_.measure([&](const Array& z, const Array& out) { return system_.stiff_rates(z, out), true; });
    scheme_->set_stiff_radius(stiff_spectrum_.radius());
  }
  const bool steady = std::abs(spectrum_.radius() - before) < same * before;
  most_age_ = steady ? std::min(2 * most_age_, longest) : shortest;
  age_ = 0;
}

template <int D, int P>
double ExplicitScheme<D, P>::largest_step(const State& state) {
  if (!begin(state).empty()) return std::numeric_limits<double>::infinity();  // the attempt tells
  if (age_ >= most_age_) measure_radius(state.time);
  if (!(spectrum_.radius() > 0))
    throw Error(Exit::computation_failed,
                "the largest stable step of time.scheme could not be measured at this state; write time.scheme = "
                "\"generalized_alpha\"");
  return safety_ * scheme_->limit(spectrum_.radius(), spectrum_.imaginary());
}

template <int D, int P>
StepAttempt ExplicitScheme<D, P>::attempt(const StepHistory& history, double dt) {
  Stopwatch watch(counts_.residual_seconds);
  const MassCounts before = system_.counts();
  StepAttempt attempt;
  attempt.refusal = begin(history.state);
  if (!attempt.refusal.empty()) return attempt;
  Kokkos::deep_copy(Exec(), next_, y_);
  end_ = history.state.time + dt;
  attempt.refusal = scheme_->advance(system_, history.state.time, dt, next_, rates_);
  if (attempt.refusal.empty()) attempt.refusal = rates(end_, next_, next_rates_);
  if (attempt.refusal.empty()) attempt.refusal = judge_.of_values(system_.stage().unknown);
  if (attempt.refusal.empty()) attempt.refusal = judge_.of_end(system_.stage());
  const MassCounts& now = system_.counts();
  attempt.krylov = static_cast<int>(now.iterations() - before.iterations());
  counts_.residuals += 2 * (now.rates - before.rates);
  counts_.krylov += attempt.krylov;
  if (attempt.refusal.empty())
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
