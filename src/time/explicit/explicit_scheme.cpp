#include "time/explicit/explicit_scheme.hpp"

#include <chrono>

#include "case/text.hpp"
#include "time/explicit/kick_drift.hpp"
#include "time/explicit/runge_kutta_step.hpp"

namespace softwet {
namespace {

template <int D, int P>
std::unique_ptr<ExplicitStep<D, P>> explicit_step(TimeScheme scheme, SemiDiscrete<D, P>& system) {
  if (scheme == TimeScheme::kick_drift) return std::make_unique<KickDrift<D, P>>(system);
  return std::make_unique<RungeKuttaStep<D, P>>(system,
                                                scheme == TimeScheme::rkl2 ? Viscosity::apart : Viscosity::among_all);
}

}  // namespace

template <int D, int P>
ExplicitScheme<D, P>::ExplicitScheme(const Scene<D, P>& scene, const Case& c, const Judge<D, P>& judge)
    : judge_(judge),
      system_(scene, c.time.mass),
      step_(explicit_step(c.time.scheme, system_)),
      bound_(scene.regions(), scene.coefficients(), c.time.mass, step_->formula()),
      of_bound_and_judge_("explicit.numbers", bound_.numbers() + judge.numbers()),
      of_bound_(of_bound_and_judge_.part(0, bound_.numbers())),
      of_judge_(of_bound_and_judge_.part(bound_.numbers(), of_bound_and_judge_.size())),
      safety_(c.time.safety) {
  if (c.solver.launch != Launch::graph || !step_->recordable()) return;
  constexpr std::size_t most = 16;
  recordings_ = std::make_unique<Recordings<std::vector<std::uintptr_t>>>(most);
  system_.numbers().keep_in_memory();
}

template <int D, int P>
BoundState ExplicitScheme<D, P>::bound_state(const ConstArray& moments) const {
  return {system_.stage().unknown, system_.stage().displacement, moments, system_.masses().scalar_sums()};
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::begin(const State& state) {
  if (begun_) return {};
  const Refusal problem = step_->begin(state);
  begun_ = problem.empty();
  if (begun_) rates_ = bound_.rates(bound_state(step_->moments()));
  return problem;
}

template <int D, int P>
double ExplicitScheme<D, P>::largest_step(const State& state, double wish) {
  if (!begin(state).empty() || !(rates_.combined > 0)) return std::numeric_limits<double>::infinity();
  const Layout<D>& l = system_.scene().layout();
  const bool damps = step_->formula() != StepFormula::kick_drift || !l.has_solid;  // the waves that swings could feed
  if (damps) return safety_ / rates_.combined;
  held_.follow(l.has_fluid ? rates_.combined : std::max(rates_.combined, safety_ / wish));
  return safety_ / held_.value();
}

template <int D, int P>
std::string ExplicitScheme<D, P>::limit(const State&) {
  LoneRate most{};
  for (const LoneRate& lone : lone_rates(bound_.rates(bound_state(step_->moments()))))  // a checkpoint has two of them
    if (lone.rate > most.rate) most = lone;
  const std::array<double, D> place = bound_.place_of_largest(bound_state(step_->moments()));
  std::string text = std::string(most.name ? most.name : "nothing finite") + " limits it, at the place (";
  for (int d = 0; d < D; ++d) text += (d > 0 ? ", " : "") + short_text(place[d]);
  return text + ")";
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::start_kernels(const StepHistory& history, double t, double dt) {
  const StepNumbers& numbers = system_.numbers();
  numbers.send();
  const Refusal problem = step_->start(t, dt, rates_);
  if (!problem.empty()) return problem;
  bound_.ask(bound_state(step_->next_moments()), of_bound_);
  judge_.ask(history, system_.stage(), {numbers.factor(StepNumbers::last), numbers.factor(StepNumbers::before)},
             of_judge_);
  of_bound_and_judge_.ask();
  return {};
}

template <int D, int P>
std::vector<std::uintptr_t> ExplicitScheme<D, P>::key_of(const StepHistory& history, double t_end) const {
  const auto address = [](const void* place) { return reinterpret_cast<std::uintptr_t>(place); };
  std::vector<std::uintptr_t> key{address(step_->moments().data()),
                                  address(history.state.unknown.data()),
                                  address(history.previous.data()),
                                  history.previous_dt > 0,
                                  static_cast<std::uintptr_t>(moves_of_term_memory()),
                                  address(memory_of_sums())};
  for (const bool acts : system_.scene().forces().acting(t_end)) key.push_back(acts);
  return key;
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::start_step(const StepHistory& history, double dt) {
  const double t = history.state.time;
  StepNumbers& numbers = system_.numbers();
  numbers[StepNumbers::last] = ChangeFactors::of_last(dt / history.previous_dt);
  numbers[StepNumbers::before] = ChangeFactors::of_before(dt / history.previous_dt);
  step_->prepare(t, dt);
  if (!recordings_ || !step_->recordable()) return start_kernels(history, t, dt);
  const std::vector<std::uintptr_t> key = key_of(history, t + dt);
  if (!recordings_->ready(key)) return start_kernels(history, t, dt);
  recordings_->start(key, [this, history, t, dt] { (void)start_kernels(history, t, dt); });
  system_.end_recorded(t + dt);
  return {};
}

template <int D, int P>
Refusal ExplicitScheme<D, P>::judge_end(const StepHistory& history, double dt, double& indicator) {
  constexpr double change = 1.1;  // of the bound in a step that counts as none
  HostNumbers::wait();
  const ValueRanges values = bound_.ranges(of_bound_);
  Refusal refusal = judge_.of_ranges(values.finite, values.least_density, values.most_density);
  if (refusal.empty()) refusal = judge_.take_mesh(system_.stage(), of_judge_);
  if (!refusal.empty()) return refusal;
  next_rates_ = bound_.rates(of_bound_);
  if (dt * next_rates_.combined > std::max(1.0, change * safety_)) return {Refusal::beyond_bound};
  indicator = judge_.take_indicator(history, dt, of_judge_);
  return {};
}

template <int D, int P>
StepAttempt ExplicitScheme<D, P>::attempt(const StepHistory& history, double dt) {
  const auto start = std::chrono::steady_clock::now();
  const long before = system_.counts().iterations();
  StepAttempt attempt;
  attempt.refusal = begin(history.state);
  if (!attempt.refusal.empty()) return attempt;
  end_ = history.state.time + dt;
  dt_ = dt;
  attempt.refusal = start_step(history, dt);
  if (attempt.refusal.empty()) attempt.refusal = judge_end(history, dt, attempt.indicator);
  attempt.krylov = static_cast<int>(system_.counts().iterations() - before);
  ++counts_.residuals;
  counts_.krylov += attempt.krylov;
  counts_.residual_seconds +=  // the judgement of the end has waited for all that the step started
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return attempt;
}

template <int D, int P>
void ExplicitScheme<D, P>::accept(State& state, const Array& before) {
  step_->accept(end_, dt_, state, before);
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
