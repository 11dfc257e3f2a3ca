#include "time/explicit_scheme.hpp"

#include "case/text.hpp"
#include "time/kick_drift.hpp"
#include "time/runge_kutta_step.hpp"

namespace softwet {
namespace {

template <int D, int P>
std::unique_ptr<ExplicitStep<D, P>> explicit_step(const std::string& name, SemiDiscrete<D, P>& system) {
  if (name == "kick_drift") return std::make_unique<KickDrift<D, P>>(system);
  return std::make_unique<RungeKuttaStep<D, P>>(system, name == "rkl2");
}

}  // namespace

template <int D, int P>
ExplicitScheme<D, P>::ExplicitScheme(const Model<D, P>& model, const Case& c, const Judge<D, P>& judge)
    : judge_(judge),
      system_(model, mass_kind(c.time.mass)),
      step_(explicit_step(c.time.scheme, system_)),
      bound_(model, mass_kind(c.time.mass), step_->formula()),
      safety_(c.time.safety) {}

template <int D, int P>
StepRates ExplicitScheme<D, P>::rates_of(const ConstArray& moments) const {
  return bound_.rates(system_.stage().unknown, system_.stage().displacement, moments, system_.masses().scalar_sums());
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::begin(const State& state) {
  if (begun_) return {};
  const Refusal problem = step_->begin(state);
  begun_ = problem.empty();
  if (begun_) rates_ = rates_of(step_->moments());
  return problem;
}

template <int D, int P>
double ExplicitScheme<D, P>::largest_step(const State& state, double wish) {
  if (!begin(state).empty() || !(rates_.combined > 0)) return std::numeric_limits<double>::infinity();
  const Layout<D>& l = system_.model().layout();
  const bool damps = step_->formula() != StepFormula::kick_drift || !l.has_solid;  // the waves that swings could feed
  if (damps) return safety_ / rates_.combined;
  held_.follow(l.has_fluid ? rates_.combined : std::max(rates_.combined, safety_ / wish));
  return safety_ / held_.value();
}

template <int D, int P>
std::string ExplicitScheme<D, P>::limit(const State&) {
  LoneRate most{};
  for (const LoneRate& lone : lone_rates(rates_of(step_->moments())))  // a checkpoint has two of them
    if (lone.rate > most.rate) most = lone;
  const std::array<double, D> place = bound_.place_of_largest(system_.stage().unknown, system_.stage().displacement,
                                                              step_->moments(), system_.masses().scalar_sums());
  std::string text = std::string(most.name ? most.name : "nothing finite") + " limits it, at the place (";
  for (int d = 0; d < D; ++d) text += (d > 0 ? ", " : "") + short_text(place[d]);
  return text + ")";
}

template <int D, int P>
StepAttempt ExplicitScheme<D, P>::attempt(const StepHistory& history, double dt) {
  constexpr double change = 1.1;  // of the bound in a step that counts as none
  Stopwatch watch(counts_.residual_seconds);
  const long before = system_.counts().iterations();
  StepAttempt attempt;
  attempt.refusal = begin(history.state);
  if (!attempt.refusal.empty()) return attempt;
  end_ = history.state.time + dt;
  dt_ = dt;
  attempt.refusal = step_->advance(history.state.time, dt, rates_);
  const Array unknown = system_.stage().unknown;
  if (attempt.refusal.empty()) attempt.refusal = judge_.of_values(unknown);
  if (attempt.refusal.empty()) attempt.refusal = judge_.of_end(system_.stage());
  if (attempt.refusal.empty()) {
    next_rates_ = rates_of(step_->next_moments());
    if (dt * next_rates_.combined > std::max(1.0, change * safety_)) attempt.refusal = {Refusal::beyond_bound};
  }
  attempt.krylov = static_cast<int>(system_.counts().iterations() - before);
  ++counts_.residuals;
  counts_.krylov += attempt.krylov;
  if (attempt.refusal.empty()) attempt.indicator = judge_.indicator(history, unknown, dt / history.previous_dt, dt);
  return attempt;
}

template <int D, int P>
void ExplicitScheme<D, P>::accept(State& state) {
  step_->accept(end_, dt_, state);
  rates_ = next_rates_;
}

template <int D, int P>
void ExplicitScheme<D, P>::visit_memory(StepMemory& memory, const State& state) {
  memory.flag("bound/known", begun_);
  system_.visit_memory(memory, state);
  if (!begun_) return;
  step_->visit_memory(memory);
  memory.number("bound/combined", rates_.combined);
  memory.number("bound/viscosity", rates_.viscosity);
  held_.visit_memory(memory);
}

template class ExplicitScheme<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
