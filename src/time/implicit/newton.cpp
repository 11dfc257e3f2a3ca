#include "time/implicit/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

/// Ratio of the solid's part of the Jacobian to that at the build from which on a preconditioner does not measure what
/// remains.
constexpr double other_step = 6;

std::variant<LinearSpace<double>, LinearSpace<float>> linear_space(const VectorSpace& space, int size, int restart,
                                                                   LinearSolves precision) {
  if (precision == LinearSolves::single) return LinearSpace<float>(space, size, restart);
  return LinearSpace<double>(space, size, restart);
}

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
                                     const RangeFactors& weights, const NewtonControl& control, double forcing,
                                     int limit, const Array& x) {
  using Vector = ArrayOf<Real>;
  constexpr bool full = std::is_same_v<Real, double>;
  const auto apply = [&](const Vector& z, const Vector& out) { jacobian_product(system, control, x, z, out); };
  const RangeFactors renewed = system.solid.factors(built_for_);
  const auto precondition = [&](const Vector& r, const Vector& z) {
    Stopwatch inner(counts_.apply_seconds, counts_.applications++);
    preconditioner_->answer(r, z, renewed);
  };
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

KrylovResult Newton::linear_solve(const NonlinearSystem& system, const RangeFactors& weights,
                                  const NewtonControl& control, double forcing, int limit, const Array& x) {
  Stopwatch watch(counts_.krylov_seconds);
  return std::visit([&](auto& space) { return linear_solve_in(space, system, weights, control, forcing, limit, x); },
                    linear_);
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

LinearStep Newton::linear_step(const NonlinearSystem& system, const Convergence& convergence,
                               const NewtonControl& control, const Array& x) {
  const bool fresh = rebuild_;
  if (fresh) build(system);
  const double forcing = convergence.forcing(), cost = preconditioner_->build_cost();
  const int limit = fresh ? control.krylov_max : std::min(control.krylov_max, wear_.patience(forcing, cost));
  const KrylovResult linear = linear_solve(system, convergence.weights(), control, forcing, limit, x);
  counts_.krylov += linear.iterations;
  ++counts_.newton;
  wear_.add(linear);
  rebuild_ = wear_.due(cost) || !linear.converged;
  return {linear, fresh || linear.reduction <= 0.5};
}

std::vector<double> Newton::residual(const NonlinearSystem& system, const std::vector<FieldRange>& fields,
                                     const Array& x) {
  Stopwatch watch(counts_.residual_seconds);
  ++counts_.residuals;
  system.residual(x, residual_);
  return norms(space_, residual_, fields);
}

void Newton::rough_correction(const NonlinearSystem& system) {
  Stopwatch watch(counts_.apply_seconds, counts_.applications++);
  const RangeFactors renewed = system.solid.factors(built_for_);
  if (auto* single = std::get_if<LinearSpace<float>>(&linear_)) {
    convert(single->right, residual_);
    preconditioner_->answer(single->right, single->step, renewed);
    convert(step_, single->step);
  } else {
    preconditioner_->answer(residual_, step_, renewed);
  }
}

bool Newton::settled(const NonlinearSystem& system, Convergence& convergence, bool moved, const Array& x) {
  if (!convergence.reached()) return false;
  if (!system.remaining || convergence.vanishes()) return true;
  // One that was built for a step of another length judges soft parts by the change of the stiff ones.
  const double ratio = built_for_ / system.solid.size;
  if (moved && std::max(ratio, 1 / ratio) > other_step) {
    build(system);
    rebuild_ = false;
  }
  if (moved) rough_correction(system);
  return convergence.accepts(moved ? system.remaining(x, step_) : std::numeric_limits<double>::infinity());
}

NewtonResult Newton::solve(const NonlinearSystem& system, const std::vector<FieldRange>& fields,
                           const NewtonControl& control, const Array& x) {
  NewtonResult result;
  const auto refuse = [&](const Refusal& why) {
    result.refusal = why;
    return result;
  };
  // Products in single precision bring more round-off.
  const bool single = std::holds_alternative<LinearSpace<float>>(linear_);
  Convergence convergence(fields, control, single ? 1e-4 : 1e-6);
  bool moved = false, ever = false;
  for (;; ++result.iterations) {
    convergence.add(residual(system, fields, x));
    if (!convergence.finite()) return refuse({Refusal::not_finite});
    result.reduction = convergence.reduction();
    const bool small = convergence.reached();
    result.converged = settled(system, convergence, ever, x) || (small && result.iterations == control.max);
    if (result.converged) return result;
    if (result.iterations == control.max || (moved && convergence.diverges())) return refuse({Refusal::newton});
    const LinearStep step = linear_step(system, convergence, control, x);
    result.krylov += step.linear.iterations;
    moved = step.moves;
    if (!moved) continue;  // once more with a new preconditioner
    if (step.linear.reduction > 0.9) {
      result.converged = small;  // round-off that no solve makes smaller
      return small ? result : refuse({Refusal::linear_solver});
    }
    const Refusal complaint = update(system, x);
    if (!complaint.empty()) return refuse(complaint);
    ever = true;
  }
}

}  // namespace softwet
