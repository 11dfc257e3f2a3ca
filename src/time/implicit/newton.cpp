#include "time/implicit/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

/// Where residuals count as solved because steps make them hardly smaller: the weighted norm of all fields at this many
/// times its measured round-off, or each field at this many times its own. The round-off at the solution differs from the
/// measured one, most where a field begins at rest.
constexpr double weighted_margin = 2, field_margin = 8;
/// A residual of fewer times its round-off is not worth the full weight of a field.
constexpr double signal_over_round_off = 100;

/// Iterations of a lagged preconditioner, over those at its best, that are no waste: they vary from step to step.
constexpr double worn = 1.3;

/// Accepted error of velocity and density up to which the prediction of a step may stand without an iteration: a scene at
/// rest costs nothing so. A looser `atol` ends iterations, but does not save the first one, for steps that extrapolate the
/// states before and solve nothing drift away.
constexpr double at_rest = 1e-10;

/// What the first linear solve of a step is solved to. With 0.02 steps take a fifth fewer iterations, but end closer to
/// `rtol`: a droplet at rest then differs 25 times more from its mirror image (docs/tried_and_left.md).
constexpr double first_forcing = 0.1;

std::variant<LinearSpace<double>, LinearSpace<float>> linear_space(const VectorSpace& space, int size, int restart,
                                                                   LinearSolves precision) {
  if (precision == LinearSolves::single) return LinearSpace<float>(space, size, restart);
  return LinearSpace<double>(space, size, restart);
}

/// Tells when a step is given up, from its third iteration on.
class Trend {
 public:
  /// @param ratio  of the residual to that of the iteration before
  /// @param left   of the residual to that at the start of the step
  /// One rise may be a long step along a soft direction, as the translation of a droplet; Newton's method converges from
  /// there. It does not where the residual rises twice, or stays above that of the start.
  bool diverges(double ratio, double left) {
    const bool again = risen_ && ratio > 2;
    risen_ = risen_ || ratio > 2;
    return again || (left > 1 && ratio > 0.5);
  }

 private:
  bool risen_ = false;
};

}  // namespace

Newton::Newton(const VectorSpace& space, int size, int restart, std::unique_ptr<Preconditioner> preconditioner,
               LinearSolves linear)
    : space_(space),
      linear_(linear_space(space, size, restart, linear)),
      preconditioner_(std::move(preconditioner)),
      residual_("newton.residual", size),
      probe_("newton.probe", size) {
  const auto* full = std::get_if<LinearSpace<double>>(&linear_);
  step_ = full ? full->step : Array("newton.step", size);
}

double Newton::weighted_norm(const std::vector<double>& sizes) const {
  double sum = 0;
  for (std::size_t f = 0; f < sizes.size(); ++f) sum += std::pow(weight_[f] * sizes[f], 2);
  return std::sqrt(sum);
}

double Newton::weighted_round_off(const std::vector<FieldRange>& fields) const {
  std::vector<double> sizes;
  for (const FieldRange& f : fields) sizes.push_back(f.round_off);
  return weighted_norm(sizes);
}

void Newton::set_weights(const std::vector<FieldRange>& fields, const std::vector<double>& sizes) {
  // A field that happens to start without a residual is no measure: its round-off would outweigh the other fields.
  // Products in single precision bring more of it.
  const bool single = std::holds_alternative<LinearSpace<float>>(linear_);
  const double least = (single ? 1e-4 : 1e-6) * *std::max_element(sizes.begin(), sizes.end());
  weight_.resize(fields.size());
  for (std::size_t f = 0; f < fields.size(); ++f)
    weight_[f] = 1 / std::max({sizes[f], fields[f].floor, least, signal_over_round_off * fields[f].round_off});
}

void Newton::jacobian_product(const NonlinearSystem& system, const NewtonControl& control, const Array& x,
                              const Array& z, const Array& out) {
  Stopwatch watch(counts_.product_seconds, counts_.products++);
  if (control.jacobian == JacobianKind::exact) return system.product(z, out);
  const double size = norm(space_, z);
  const double epsilon = size > 0 ? 1e-7 * (1 + norm(space_, x)) / size : 1.0;
  Kokkos::deep_copy(Exec(), probe_, x);
  add_scaled(probe_, 0, epsilon, z);
  system.residual(probe_, out);
  add_scaled(out, 0, -1, residual_);
  combine(out, 1 / epsilon, out, 0);
}

void Newton::jacobian_product(const NonlinearSystem& system, const NewtonControl&, const Array&,
                              const ArrayOf<float>& z, const ArrayOf<float>& out) {
  Stopwatch watch(counts_.product_seconds, counts_.products++);
  system.single_product(z, out);
}

template <class Real>
KrylovResult Newton::linear_solve_in(LinearSpace<Real>& space, const NonlinearSystem& system,
                                     const std::vector<FieldRange>& fields, const NewtonControl& control,
                                     double forcing, int limit, const Array& x) {
  using Vector = ArrayOf<Real>;
  constexpr bool full = std::is_same_v<Real, double>;
  const auto apply = [&](const Vector& z, const Vector& out) { jacobian_product(system, control, x, z, out); };
  const RangeFactors renewed = system.solid.factors(built_for_);
  const auto precondition = [&](const Vector& r, const Vector& z) {
    Stopwatch inner(counts_.apply_seconds, counts_.applications++);
    preconditioner_->answer(r, z, renewed);
  };
  RangeFactors weights;
  for (std::size_t f = 0; f < fields.size(); ++f) weights.add(fields[f].first, fields[f].last, weight_[f] * weight_[f]);
  if constexpr (!full) convert(space.right, residual_);
  const KrylovResult result = [&] {
    if constexpr (full) {
      return space.gmres.solve(apply, precondition, residual_, space.step, forcing, limit, weights);
    } else {
      return space.gmres.solve(apply, precondition, space.right, space.step, forcing, limit, weights);
    }
  }();
  if constexpr (!full) convert(step_, space.step);
  return result;
}

KrylovResult Newton::linear_solve(const NonlinearSystem& system, const std::vector<FieldRange>& fields,
                                  const NewtonControl& control, double forcing, int limit, const Array& x) {
  Stopwatch watch(counts_.krylov_seconds);
  return std::visit([&](auto& space) { return linear_solve_in(space, system, fields, control, forcing, limit, x); },
                    linear_);
}

void Wear::renew() {
  const double end = digits_ > 0 ? std::max(last_, iterations_ / digits_) : last_;
  const int times = times_;
  *this = {};
  before_ = end;
  times_ = times;
}

void Wear::add(const KrylovResult& linear) {
  constexpr double window = 4, no_better = 0.8;
  iterations_ += linear.iterations;
  digits_ -= std::log10(std::clamp(linear.reduction, 1e-16, 0.8));
  if (digits_ < window) return;
  last_ = iterations_ / digits_;
  if (best_ == 0 && before_ > 0) times_ = last_ > no_better * before_ ? std::min(4, 2 * times_) : 1;
  if (best_ == 0 || last_ < best_) best_ = last_;
  waste_ += std::max(0.0, iterations_ - worn * best_ * digits_);
  iterations_ = digits_ = 0;
}

int Wear::patience(double tolerance, double cost) const {
  if (best_ == 0) return std::numeric_limits<int>::max();
  return static_cast<int>(std::ceil(worn * best_ * -std::log10(tolerance) + std::max(0.0, allowed(cost) - waste_))) + 1;
}

void Wear::visit_memory(StepMemory& memory) {
  memory.number("wear/best", best_);
  memory.number("wear/last", last_);
  memory.number("wear/iterations", iterations_);
  memory.number("wear/digits", digits_);
  memory.number("wear/waste", waste_);
  memory.number("wear/before", before_);
  memory.count("wear/times", times_);
}

void Newton::visit_memory(StepMemory& memory) {
  memory.flag("newton/rebuild", rebuild_);
  memory.number("newton/built_for", built_for_);
  wear_.visit_memory(memory);
  preconditioner_->visit_memory(memory);
}

void Newton::build(const NonlinearSystem& system) {
  Stopwatch watch(counts_.build_seconds);
  ++counts_.builds;
  preconditioner_->build(system.jacobian);
  built_for_ = system.solid.size;
  wear_.renew();
}

Refusal Newton::update(const NonlinearSystem& system, const Array& x) {
  Refusal complaint;
  double length = 1;
  for (int halvings = 0; halvings < 4; ++halvings, length *= 0.5) {
    Kokkos::deep_copy(Exec(), probe_, x);
    add_scaled(probe_, 0, -length, step_);
    complaint = system.complaint(probe_);
    if (complaint.empty()) {
      Kokkos::deep_copy(Exec(), x, probe_);
      break;
    }
  }
  return complaint;
}

NewtonResult Newton::solve(const NonlinearSystem& system, const std::vector<FieldRange>& fields,
                           const NewtonControl& control, const Array& x) {
  NewtonResult result;
  double start = 0, previous = 0, forcing = first_forcing;
  Trend trend;
  bool moved = false;
  for (;; ++result.iterations) {
    {
      Stopwatch watch(counts_.residual_seconds);
      ++counts_.residuals;
      system.residual(x, residual_);
    }
    const std::vector<double> sizes = norms(space_, residual_, fields);
    if (result.iterations == 0) set_weights(fields, sizes);
    const double size = weighted_norm(sizes);
    if (!std::isfinite(size)) {
      result.refusal = {Refusal::not_finite};
      return result;
    }
    if (result.iterations == 0) start = std::sqrt(static_cast<double>(fields.size()));
    result.reduction = size / start;
    // A field below its floor has a weight by that floor, so that the prediction may look small without being it.
    const bool predicted = result.iterations == 0;
    result.converged = !predicted && size <= control.rtol * start;
    // When every field is at its floor it is as exact as asked for, whatever the relative reduction.
    const double part = predicted ? std::min(1.0, at_rest / control.atol) : 1;
    bool at_floor = true;
    for (std::size_t f = 0; f < fields.size(); ++f)
      at_floor = at_floor && sizes[f] <= std::max(part * fields[f].floor, field_margin * fields[f].round_off);
    result.converged = result.converged || at_floor || size <= weighted_margin * weighted_round_off(fields);
    if (result.converged) return result;
    const bool diverges = moved && result.iterations > 2 && trend.diverges(size / previous, size / start);
    if (result.iterations == control.max || diverges) {
      result.refusal = {Refusal::newton};
      return result;
    }
    const double ratio = result.iterations > 0 ? size / previous : 1.0;
    previous = size;
    const bool fresh = rebuild_;
    if (fresh) build(system);
    // Eisenstat and Walker 1996, choice 2, without solving beyond what the step needs.
    const double tightest = std::min(0.1, control.krylov_rtol);
    if (result.iterations > 0) forcing = std::clamp(0.9 * ratio * ratio, tightest, 0.1);
    forcing = std::max(forcing, std::min(0.1, 0.5 * control.rtol * start / size));
    const double cost = preconditioner_->build_cost();
    const int limit = fresh ? control.krylov_max : std::min(control.krylov_max, wear_.patience(forcing, cost));
    const KrylovResult linear = linear_solve(system, fields, control, forcing, limit, x);
    result.krylov += linear.iterations;
    counts_.krylov += linear.iterations;
    ++counts_.newton;
    wear_.add(linear);
    rebuild_ = wear_.due(cost) || !linear.converged;
    moved = fresh || linear.reduction <= 0.5;
    if (!moved) continue;  // once more with a new preconditioner
    if (linear.reduction > 0.9) {
      result.refusal = {Refusal::linear_solver};
      return result;
    }
    const Refusal complaint = update(system, x);
    if (!complaint.empty()) {
      result.refusal = complaint;
      return result;
    }
  }
}

}  // namespace softwet
