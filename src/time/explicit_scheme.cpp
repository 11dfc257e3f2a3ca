#include "time/explicit_scheme.hpp"

#include <algorithm>

#include "case/error.hpp"
#include "time/energy_of.hpp"

namespace softwet {
namespace {

std::unique_ptr<RungeKutta> runge_kutta(const std::string& name, int size) {
  if (name == "rkl2") return std::make_unique<StrangRkl2>(size);
  if (name == "imex") return std::make_unique<ImexArs343>(size);
  return std::make_unique<SspRk3>(size);
}

/// Part of the density of the liquid from which on a side limits the step: the square of the ratio of the capillary
/// frequencies at the ends of an axis and inside, 0.97 and 1.97 g sqrt(rho)/h^2 with lumped masses.
constexpr double wet_part = 0.17;

/// Times in a row that a step is refused for its growth, and halved.
constexpr int most_growths = 6;

}  // namespace

template <int D, int P>
ExplicitScheme<D, P>::ExplicitScheme(const Model<D, P>& model, const Case& c, const Judge<D, P>& judge)
    : model_(model),
      judge_(judge),
      system_(model, c.time.mass == "lumped" ? MassKind::lumped : MassKind::consistent),
      scheme_(runge_kutta(c.time.scheme, system_.size())),
      linear_(system_, model.layout().space()),
      spectrum_(model.layout().space(), system_.size(), system_.free_values()),
      stiff_spectrum_(model.layout().space(), scheme_->needs_stiff_radius() ? system_.size() : 0,
                      system_.free_values()),
      stability_(model.layout().space(), system_.size(), system_.free_values()),
      side_density_(model.layout()),
      watch_(wet_part * model.state().density_liquid, c.has_energy_law() && c.keeps_shown_energy()),
      safety_(c.time.safety) {
  for (Array* a : {&y_, &rates_, &next_, &next_rates_}) *a = Array("explicit.vector", system_.size());
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
  if (known_rates_ && !watch_.begun()) watch_.begin(signs(state.time, model_.integrals(system_.stage())));
  return problem;
}

template <int D, int P>
StepSigns ExplicitScheme<D, P>::signs(double t, const Integrals& sum) const {
  const Layout<D>& l = model_.layout();
  const ConstArray unknown = system_.stage().unknown;
  StepSigns s;
  s.energy = energy_of(t, model_.load_power(t, unknown), sum);
  if (l.has_fluid) s.density = side_density_.largest(part(unknown, l.density_offset(), l.potential_offset()));
  return s;
}

template <int D, int P>
void ExplicitScheme<D, P>::measure_limit(double t) {
  constexpr double rough = 1e-5;
  const double before = limit_;
  const int steps_before = stability_.steps();
  linear_.set_base(t, y_, rates_, scheme_->treats_stiff_part());
  limit_ = 0;
  if (!measure_stiff_part().empty()) return;
  system_.set_stiff_tolerance(rough);
  limit_ = stability_.follow(*scheme_, linear_, t, contact_ ? StabilityLimit::Sight::far : StabilityLimit::Sight::near);
  if (!(limit_ > 0) && before > 0) limit_ = stability_.search(*scheme_, linear_, t, before);
  if (!(limit_ > 0)) limit_ = limit_from_radius(t);
  system_.set_stiff_tolerance(system_.velocity_tolerance);
  plan_search(before, stability_.steps() - steps_before);
}

template <int D, int P>
void ExplicitScheme<D, P>::plan_search(double before, int cost) {
  constexpr int shortest = 5, seldom = 10;  // of steps between searches, and for each step of a search
  constexpr double same = 0.03, lower = 0.9;
  const bool steady = std::abs(limit_ - before) < same * before;
  const int kept = contact_ ? cost / 4 : steady ? std::min(2 * most_age_, seldom * cost) : cost;  // contact goes on
  most_age_ = before == 0 ? shortest : std::max(shortest, kept);
  deaf_ = alarm_ && limit_ > lower * before ? cost : 0;  // what grew was not the scheme
  age_ = 0;
  contact_ = alarm_ = false;
  watch_.searched();
}

template <int D, int P>
double ExplicitScheme<D, P>::limit_from_radius(double t) {
  spectrum_.measure([&](const Array& z, const Array& out) { return linear_.gentle_rates(t, z, out).empty(); });
  if (!(spectrum_.radius() > 0)) return 0;
  const double guess = scheme_->limit(spectrum_.radius(), spectrum_.imaginary());
  const double found = stability_.search(*scheme_, linear_, t, guess);
  return found > 0 ? found : guess;
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::measure_stiff_part() {
  if (!scheme_->needs_stiff_radius()) return {};
  const Refusal problem =
      stiff_spectrum_.measure([&](const Array& z, const Array& out) { return system_.stiff_rates(z, out); },
                              [&](const Array& z) { return system_.stiff_quotient(z); });
  scheme_->set_stiff_radius(stiff_spectrum_.radius());
  return problem;
}

template <int D, int P>
double ExplicitScheme<D, P>::largest_step(const State& state) {
  if (!begin(state).empty()) return std::numeric_limits<double>::infinity();  // the attempt tells
  if (age_ >= most_age_) {
    measure_limit(state.time);
  } else if (scheme_->needs_stiff_radius()) {
    stiff_spectrum_.follow([&](const Array& z) { return system_.stiff_quotient(z); });
    scheme_->set_stiff_radius(stiff_spectrum_.radius());
  }
  if (!(limit_ > 0))
    throw Error(Exit::computation_failed,
                "the largest stable step of time.scheme could not be measured at this state; write time.scheme = "
                "\"generalized_alpha\"");
  return safety_ * limit_;
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
  tried_ = dt;
  attempt.refusal = scheme_->advance(system_, history.state.time, dt, next_, rates_);
  if (attempt.refusal.empty()) attempt.refusal = rates(end_, next_, next_rates_);
  if (attempt.refusal.empty()) attempt.refusal = judge_.of_values(system_.stage().unknown);
  if (attempt.refusal.empty()) attempt.refusal = judge_end();
  const MassCounts& now = system_.counts();
  attempt.krylov = static_cast<int>(now.iterations() - before.iterations());
  counts_.residuals += 2 * (now.rates - before.rates);
  counts_.krylov += attempt.krylov;
  if (attempt.refusal.empty())
    attempt.indicator = judge_.indicator(history, system_.stage().unknown, dt / history.previous_dt, dt);
  return attempt;
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::judge_end() {
  const Refusal problem = judge_.of_end(system_.stage());
  if (!problem.empty()) return problem;
  next_signs_ = signs(end_, model_.integrals(system_.stage()));
  return growths_ < most_growths && watch_.grows(next_signs_) ? Refusal{Refusal::growth} : Refusal{};
}

template <int D, int P>
void ExplicitScheme<D, P>::refuse(const Refusal& why) {
  known_rates_ = false;
  const bool growth = why.cause == Refusal::growth;
  if (growth) ++growths_;
  const bool far_below = why.empty() && tried_ < 0.5 * safety_ * limit_;  // too long for accuracy alone
  if (age_ == 0 || far_below || (growth && age_ <= deaf_)) return;
  age_ = most_age_;
  alarm_ = growth;
  stability_.forget();
}

template <int D, int P>
void ExplicitScheme<D, P>::accept(State& state) {
  system_.copy_stage(end_, next_, next_rates_, state);
  std::swap(y_, next_);
  std::swap(rates_, next_rates_);
  known_rates_ = true;
  growths_ = 0;
  ++age_;
  if (!watch_.accept(next_signs_)) return;
  contact_ = true;
  age_ = most_age_;
}

template <int D, int P>
void ExplicitScheme<D, P>::visit_memory(StepMemory& memory, const State& state) {
  memory.number("limit/step", limit_);
  memory.count("limit/age", age_);
  memory.count("limit/most_age", most_age_);
  memory.count("limit/deaf", deaf_);
  memory.flag("limit/contact", contact_);
  memory.flag("limit/alarm", alarm_);
  memory.flag("rates/known", known_rates_);
  if (known_rates_) {
    memory.vector("rates/at", y_);
    memory.vector("rates/values", rates_);
  }
  system_.visit_memory(memory, state);
  watch_.visit_memory(memory);
  spectrum_.visit_memory(memory);
  stability_.visit_memory(memory);
  if (!scheme_->needs_stiff_radius()) return;
  stiff_spectrum_.visit_memory(memory);
  scheme_->set_stiff_radius(stiff_spectrum_.radius());
}

template class ExplicitScheme<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
