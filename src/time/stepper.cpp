#include "time/stepper.hpp"

#include <cstdio>

#include "app/error.hpp"
#include "model/initial.hpp"
#include "solver/choose.hpp"

namespace softwet {

namespace {

NewtonControl newton_control(const Case& c) {
  NewtonControl n;
  n.rtol = c.solver.newton_rtol;
  n.atol = c.solver.newton_atol;
  n.max = c.solver.newton_max;
  n.krylov_rtol = c.solver.krylov_rtol;
  n.krylov_max = c.solver.krylov_max;
  n.jacobian = c.solver.jacobian == "difference" ? JacobianKind::difference : JacobianKind::exact;
  return n;
}

void copy_state(State& to, const State& from) {
  to.time = from.time;
  Kokkos::deep_copy(to.unknown, from.unknown);
  Kokkos::deep_copy(to.velocity_rate, from.velocity_rate);
  Kokkos::deep_copy(to.displacement, from.displacement);
  Kokkos::deep_copy(to.displacement_rate, from.displacement_rate);
  Kokkos::deep_copy(to.moment, from.moment);
  Kokkos::deep_copy(to.moment_rate, from.moment_rate);
}

/// Smallest and largest value of an array; a value that is not finite becomes the largest, infinity.
std::pair<double, double> range(const ConstArray& x) {
  Kokkos::MinMaxScalar<double> r;
  Kokkos::parallel_reduce(
      "softwet::range", Kokkos::RangePolicy<Exec>(0, x.extent(0)),
      KOKKOS_LAMBDA(int i, Kokkos::MinMaxScalar<double>& best) {
        const double v = x(i);
        const double high = Kokkos::isfinite(v) ? v : Kokkos::Experimental::infinity_v<double>;
        if (v < best.min_val) best.min_val = v;
        if (high > best.max_val) best.max_val = high;
      },
      Kokkos::MinMax<double>(r));
  return {r.min_val, r.max_val};
}

std::string density_complaint(const ConstArray& density, double undershoot) {
  const auto [least, largest] = range(density);
  if (!(largest < 0.999)) return "the density reaches the close-packed limit (rho >= 0.999 b)";
  // Undershoots of the vapour's small density are admissible: W is continued below it.
  if (least <= -undershoot) return "the density becomes negative (solver.newton.undershoot)";
  return "";
}

/// rho_n + f (rho_n - rho_{n-1}) in the variable ln(rho/(1-rho)): exact for the tail of a travelling interface, and it
/// stays inside (0, 1). Linear where a control value is not inside.
struct ExtrapolateDensity {
  Array out;
  ConstArray now, before;
  int first;
  double factor;
  KOKKOS_FUNCTION void operator()(int k) const {
    const int i = first + k;
    const double a = now(i), b = before(i);
    if (a > 0 && b > 0 && a < 1 && b < 1) {
      const double s = (1 + factor) * Kokkos::log(a / (1 - a)) - factor * Kokkos::log(b / (1 - b));
      out(i) = 1 / (1 + Kokkos::exp(-s));
    } else {
      out(i) = a + factor * (a - b);
    }
  }
};

}  // namespace

template <int D, int P>
Stepper<D, P>::Stepper(const Model<D, P>& model, const Case& c, std::vector<double> events)
    : model_(model),
      integrator_(model, c.time.rho_inf),
      newton_(model.layout().size(), c.solver.krylov_restart,
              choose_preconditioner<D>(c.solver.preconditioner, model.layout(), model.mask())),
      newton_control_(newton_control(c)),
      undershoot_(c.solver.newton_undershoot),
      control_({c.time.dt_initial, c.time.dt_min, c.time.dt_max, c.time.tolerance}, std::move(events)),
      state_(empty_state(model.layout())),
      previous_("stepper.previous", model.layout().size()),
      predicted_("stepper.predicted", model.layout().size()),
      x_("stepper.x", model.layout().size()) {
  double volume = 1;
  for (const Axis& axis : model.layout().axis) volume *= axis.spacing();
  const double thickness = model.wall_height(), height = model.layout().axis[D - 1].length() - thickness;
  length_ = !model.layout().has_fluid ? c.domain.size[D - 1] : thickness > 0 ? std::min(thickness, height) : height;
  volume_norm_ = volume * std::sqrt(static_cast<double>(model.layout().rows) * model.layout().row_size);
}

template <int D, int P>
void Stepper<D, P>::start(const State& state) {
  copy_state(state_, state);
  previous_dt_ = 0;
}

template <int D, int P>
void Stepper<D, P>::restore(const State& state, const Array& previous, double previous_dt, double proposed) {
  copy_state(state_, state);
  Kokkos::deep_copy(previous_, previous);
  previous_dt_ = previous_dt;
  control_.set_proposed(proposed);
}

template <int D, int P>
std::vector<FieldRange> Stepper<D, P>::fields() const {
  const Layout<D>& l = model_.layout();
  const double atol = newton_control_.atol, rate = integrator_.stage().rate_scale;
  const SaintVenantKirchhoff& solid = model_.solid().material;
  const double stiffness = l.has_solid ? solid.lambda + 2 * solid.shear_modulus : 0;
  std::vector<FieldRange> f{{0, l.velocity_size(), atol * volume_norm_ * std::max({rate, 1.0, stiffness})}};
  if (l.has_fluid) {
    f.push_back({l.density_offset(), l.potential_offset(), atol * volume_norm_ * std::max(rate, 1e-2)});
    f.push_back({l.potential_offset(), l.size(), atol * volume_norm_});
  }
  return f;
}

template <int D, int P>
std::string Stepper<D, P>::complaint(const Array& x) const {
  const Layout<D>& l = model_.layout();
  if (!std::isfinite(range(x).second)) return "the solution is not finite";
  return l.has_fluid ? density_complaint(part(x, l.density_offset(), l.potential_offset()), undershoot_) : "";
}

template <int D, int P>
std::string Stepper<D, P>::complaint_of_step() const {
  const Stage& stage = integrator_.stage();
  const Integrals sum = model_.integrals(stage);
  if (sum.inverted > 0) return "the solid is turned inside out somewhere (det F <= 0)";
  if (sum.folded > 0) return "the mesh of the fluid folds over above the deformed solid (J < 0)";
  return model_.layout().has_fluid ? density_complaint(stage.density_end, undershoot_) : "";
}

template <int D, int P>
void Stepper<D, P>::predict(double dt) {
  const Layout<D>& l = model_.layout();
  const double af = dt > 0 ? 1 / integrator_.stage().end_scale : 1;
  Kokkos::deep_copy(Exec(), predicted_, state_.unknown);
  if (previous_dt_ > 0) {  // extrapolation of the last two states
    const double factor = af * dt / previous_dt_;
    combine(predicted_, -factor, previous_, 1 + factor);
    Kokkos::parallel_for("softwet::extrapolate", Kokkos::RangePolicy<Exec>(0, l.scalar_size()),
                         ExtrapolateDensity{predicted_, state_.unknown, previous_, l.density_offset(), factor});
  }
  multiply(Kokkos::subview(predicted_, Kokkos::make_pair(0, l.velocity_size())),
           part(model_.mask(), 0, l.velocity_size()));
  Kokkos::deep_copy(Exec(), x_, complaint(predicted_).empty() ? predicted_ : state_.unknown);
}

template <int D, int P>
double Stepper<D, P>::indicator(double dt) const {
  if (previous_dt_ <= 0) return 0;
  const Layout<D>& l = model_.layout();
  move_ghosts(l, x_, GhostAction::update);  // the predictor masks them
  // x - [y_n + f (y_n - y_{n-1})], f = af dt / dt_n
  const Array difference = predicted_;
  const double f = dt / integrator_.stage().end_scale / previous_dt_;
  Kokkos::deep_copy(Exec(), difference, x_);
  add_scaled(difference, 0, -1 - f, state_.unknown);
  add_scaled(difference, 0, f, previous_);
  const int nv = l.velocity_size();
  const double v = norm(part(difference, 0, nv)) / std::sqrt(static_cast<double>(nv) / D) * dt / length_;
  if (!l.has_fluid) return v;
  const double jump = model_.state().density_liquid - model_.state().density_vapour;
  const double rho = norm(part(difference, l.density_offset(), l.potential_offset()));
  return std::max(v, rho / std::sqrt(static_cast<double>(l.scalar_size())) / jump);
}

template <int D, int P>
NewtonResult Stepper<D, P>::solve(double dt) {
  integrator_.begin(state_, dt, previous_dt_ > 0 ? Rates::known : Rates::unknown);
  predict(dt);
  const auto product = [this](const Array& z, const Array& out) { integrator_.product(z, out, Geometry::exact); };
  const NonlinearSystem system{[this](const Array& x, const Array& r) { integrator_.residual(x, r); }, product,
                               [this](const StencilValues& values) { integrator_.jacobian(values); },
                               [this](const Array& x) { return complaint(x); }};
  NewtonResult result = newton_.solve(system, fields(), newton_control_, x_);
  if (!result.converged) return result;
  result.reason = complaint_of_step();
  result.converged = result.reason.empty();
  return result;
}

template <int D, int P>
StepReport Stepper<D, P>::step() {
  for (;;) {
    const double dt = control_.next(state_.time);
    const NewtonResult result = solve(dt);
    if (!result.converged) {
      ++counts_.rejected_newton;
      counts_.last_rejection = result.reason;
      newton_.forget_preconditioner();
      if (control_.reject(dt)) continue;
      throw Error(Exit::computation_failed,
                  "the computation stopped: " + result.reason + ", even with the smallest step (time.dt_min)");
    }
    const double e = indicator(dt);
    if (e > control_.rejection_level() && control_.reject(dt)) {
      ++counts_.rejected_error;
      continue;
    }
    Kokkos::deep_copy(Exec(), previous_, state_.unknown);
    previous_dt_ = dt;
    integrator_.finish(x_, state_);
    control_.accept(dt, e, result.iterations, newton_control_.max);
    ++counts_.steps;
    return {dt, result.iterations, result.krylov, e};
  }
}

template class Stepper<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
