#include "time/implicit_scheme.hpp"

#include "solver/choose.hpp"
#include "solver/recorded_answers.hpp"
#include "solver/scale_fields.hpp"
#include "time/rest_control.hpp"

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

template <int D, int P>
std::unique_ptr<Preconditioner> preconditioner_of(const Case& c, const Model<D, P>& model) {
  auto chosen = choose_preconditioner<D>(c.solver.preconditioner, model.layout(), model.mask());
  return c.solver.launch == "graph" ? record_answers(std::move(chosen)) : std::move(chosen);
}

/// Products in double precision are there in any precision of the model.
LinearSolves linear_solves(const Case& c, Precision precision) {
  return precision == Precision::full || c.solver.precision == "double" ? LinearSolves::full : LinearSolves::single;
}

/// Steps that are longer are stretched ones of this length, see ImplicitScheme::settle. A thin vapour fills in about
/// this time.
constexpr double moderate_step = 2e3;

/// The scales of a stage of a step that is `stretch` times shorter.
Stage shorter(Stage stage, double stretch) {
  stage.rate_scale *= stretch;
  stage.displacement_scale /= stretch;
  return stage;
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
SolidPart solid_part(const Model<D, P>& model, const Stage& stage) {
  const Layout<D>& l = model.layout();
  SolidPart solid;
  if (!l.has_solid) return solid;
  for (int d = 0; d < D; ++d)
    solid.ranges.push_back({l.velocity_offset(d), l.velocity_offset(d) + l.solid_rows() * l.row_size});
  double h = l.axis[0].spacing();
  for (const Axis& axis : l.axis) h = std::min(h, axis.spacing());
  const LameParameters& stiffness = model.stiffness();
  const double density = std::visit([](const auto& term) { return term.density; }, model.solid());
  solid.size = density * stage.rate_scale +
               (stiffness.lambda + 2 * stiffness.shear_modulus) * stage.displacement_scale * 4 / (h * h);
  return solid;
}

template <int D, int P>
ImplicitScheme<D, P>::ImplicitScheme(const Model<D, P>& model, const Case& c, const Judge<D, P>& judge)
    : model_(model),
      judge_(judge),
      integrator_(model, c.time.rho_inf),
      newton_(model.layout().space(), model.layout().size(), c.solver.krylov_restart, preconditioner_of(c, model),
              linear_solves(c, model.precision())),
      newton_control_(newton_control(c)),
      x_("implicit.x", model.layout().size()) {
  double volume = 1;
  for (const Axis& axis : model.layout().axis) volume *= axis.length() / axis.elements();
  if (model.precision() == Precision::single) round_off_ = Array("implicit.round_off", model.layout().size());
  volume_norm_ =
      volume * std::sqrt(entries_of_patch(model.layout(), double(model.layout().rows) * model.layout().row_size));
}

template <int D, int P>
std::vector<FieldRange> ImplicitScheme<D, P>::fields() const {
  const Layout<D>& l = model_.layout();
  const double atol = newton_control_.atol, rate = integrator_.stage().rate_scale;
  const LameParameters& solid = model_.stiffness();
  const double stiffness = solid.lambda + 2 * solid.shear_modulus;
  std::vector<FieldRange> f{{0, l.velocity_size(), atol * volume_norm_ * std::max({rate, 1.0, stiffness})}};
  if (l.has_fluid) {
    f.push_back({l.density_offset(), l.potential_offset(), atol * volume_norm_ * std::max(rate, 1e-2)});
    f.push_back({l.potential_offset(), l.size(), atol * volume_norm_});
  }
  return f;
}

template <int D, int P>
void ImplicitScheme<D, P>::measure_round_off(std::vector<FieldRange>& fields) {
  integrator_.round_off(x_, round_off_);
  const std::vector<double> sizes = norms(model_.layout().space(), round_off_, fields);
  for (std::size_t f = 0; f < fields.size(); ++f) fields[f].round_off = sizes[f];
}

template <int D, int P>
void ImplicitScheme<D, P>::predict(const StepHistory& history, double dt) {
  const Layout<D>& l = model_.layout();
  const ConstArray now = history.state.unknown;
  Kokkos::deep_copy(Exec(), x_, now);
  if (history.previous_dt > 0) {  // extrapolation of the last two states
    const double factor = dt / integrator_.stage().end_scale / history.previous_dt;
    combine(x_, -factor, history.previous, 1 + factor);
    Kokkos::parallel_for("softwet::extrapolate", Items(0, l.scalar_size()),
                         ExtrapolateDensity{x_, now, history.previous, l.density_offset(), factor});
  }
  multiply(Kokkos::subview(x_, Kokkos::make_pair(0, l.velocity_size())), part(model_.mask(), 0, l.velocity_size()));
  if (!judge_.of_values(x_).empty()) Kokkos::deep_copy(Exec(), x_, now);
}

template <int D, int P>
NewtonResult ImplicitScheme<D, P>::solve(const StepHistory& history, double dt) {
  integrator_.begin(history.state, dt, history.previous_dt > 0 ? Rates::known : Rates::unknown);
  predict(history, dt);
  stretch_ = 1;
  std::vector<FieldRange> ranges = fields();
  if (model_.precision() == Precision::single) measure_round_off(ranges);
  NewtonResult result = newton_.solve(system(), ranges, newton_control_, x_);
  if (result.converged) result.refusal = judge_.of_end(integrator_.stage());
  return result;
}

template <int D, int P>
NonlinearSystem ImplicitScheme<D, P>::system() {
  return {[this](const Array& x, const Array& r) {
            integrator_.residual(unstretched(x), r);
            tie_mass(r);
          },
          [this](const Array& z, const Array& out) { product(z, out); },
          [this](const StencilValues& values) { integrator_.jacobian(values, stretch_); },
          [this](const Array& x) { return judge_.of_values(x); },
          [this](const ArrayOf<float>& z, const ArrayOf<float>& out) { product(z, out); },
          solid_part(model_, shorter(integrator_.stage(), stretch_))};
}

template <int D, int P>
void ImplicitScheme<D, P>::product(const Array& z, const Array& out) {
  integrator_.product(unstretched(z), out);
  tie_mass(out);
}

template <int D, int P>
void ImplicitScheme<D, P>::product(const ArrayOf<float>& z, const ArrayOf<float>& out) {
  if (stretch_ == 1) return integrator_.product(z, out);
  convert(wide_, z);
  product(wide_, product_);
  convert(out, product_);
}

template <int D, int P>
void ImplicitScheme<D, P>::tie_mass(const Array& r) const {
  const Layout<D>& l = model_.layout();
  if (stretch_ == 1 || !l.has_fluid) return;
  const double sum = total(l.space(), part(r, l.density_offset(), l.potential_offset()));
  const ConstArray moment = integrator_.moment();
  add_scaled(r, l.density_offset(), (stretch_ - 1) * sum / total(l.space(), moment), moment);
}

template <int D, int P>
Array ImplicitScheme<D, P>::unstretched(const Array& x) const {
  if (stretch_ == 1 || !model_.layout().has_solid) return x;
  RangeFactors factors;
  for (const SolidPart::Range& rows : solid_part(model_, integrator_.stage()).ranges)
    factors.add(rows.first, rows.last, 1 / stretch_);
  ScaleFields<double, double>{unstretched_, x, factors}.run();
  return unstretched_;
}

template <int D, int P>
Settling ImplicitScheme<D, P>::settle(const State& state, double dt) {
  const Layout<D>& l = model_.layout();
  integrator_.begin_still(state, dt);
  Kokkos::deep_copy(Exec(), x_, state.unknown);
  for (const SolidPart::Range& rows : solid_part(model_, integrator_.stage()).ranges)
    Kokkos::deep_copy(Exec(), Kokkos::subview(x_, Kokkos::make_pair(rows.first, rows.last)), 0.0);
  stretch_ = std::max(1.0, dt / moderate_step);
  if (round_off_.extent(0) == 0) round_off_ = Array("implicit.round_off", l.size());
  for (Array* work : {&unstretched_, &wide_, &product_})
    if (work->extent(0) == 0) *work = Array("implicit.settling", l.size());
  newton_.forget_preconditioner();  // steps grow too fast for one of the step before
  std::vector<FieldRange> ranges = fields();
  if (model_.precision() == Precision::single) {
    integrator_.round_off(x_, round_off_);
  } else {
    integrator_.last_digits(x_, wide_, round_off_);
  }
  const std::vector<double> digits = norms(l.space(), round_off_, ranges);
  integrator_.residual(x_, round_off_);
  const std::vector<double> sizes = norms(l.space(), round_off_, ranges);
  Settling settling;
  double level = 0;  // of the residual, in units of what the fields are measured with
  for (std::size_t f = 0; f < ranges.size(); ++f) {
    ranges[f].round_off = digits[f];
    level = std::max(level, sizes[f] / ranges[f].floor);
    if (sizes[f] > 0) settling.excess = std::max(settling.excess, sizes[f] / digits[f]);
  }
  if (settling.excess < digits_of_rest) return settling;
  // A field that starts with less than its share is not solved to digits that the others do not have.
  for (FieldRange& range : ranges) range.floor *= level * newton_control_.rtol;
  const NewtonResult result = newton_.solve(system(), ranges, newton_control_, x_);
  Kokkos::deep_copy(Exec(), x_, unstretched(x_));
  settling.step = {result.refusal, 0, result.iterations, result.krylov, result.iterations + 2 > newton_control_.max};
  if (result.converged) settling.step.refusal = judge_.of_end(integrator_.stage());
  move_ghosts(l, x_, GhostAction::update);
  return settling;
}

template <int D, int P>
NewtonResult ImplicitScheme<D, P>::respond(const State& rest, double dt, const Array& r, const Array& x) {
  stretch_ = 1;
  integrator_.begin_still(rest, dt);
  integrator_.residual(rest.unknown, x_);  // the point at which the products are those of the Jacobian
  Kokkos::deep_copy(Exec(), x, 0.0);
  NonlinearSystem linear = system();
  linear.residual = [this, r](const Array& z, const Array& out) {
    product(z, out);
    add_scaled(out, 0, 1, r);
  };
  linear.complaint = [](const Array&) { return Refusal(); };
  NewtonControl control = newton_control_;
  control.rtol = 1e-7;
  std::vector<FieldRange> ranges = fields();
  // The equation of the potential begins without a residual. Its share is that of the density's change.
  if (ranges.size() > 1) ranges[2].floor = dt * norms(model_.layout().space(), r, ranges)[1];
  const NewtonResult result = newton_.solve(linear, ranges, control, x);
  move_ghosts(model_.layout(), x, GhostAction::update);
  return result;
}

template <int D, int P>
StepAttempt ImplicitScheme<D, P>::attempt(const StepHistory& history, double dt) {
  const NewtonResult result = solve(history, dt);
  StepAttempt attempt{result.refusal, 0, result.iterations, result.krylov, result.iterations + 2 > newton_control_.max};
  if (!attempt.refusal.empty()) return attempt;
  move_ghosts(model_.layout(), x_, GhostAction::update);  // the prediction left them out
  attempt.indicator = judge_.indicator(history, x_, dt / integrator_.stage().end_scale / history.previous_dt, dt);
  return attempt;
}

template <int D, int P>
void ImplicitScheme<D, P>::visit_memory(StepMemory& memory, const State&) {
  newton_.visit_memory(memory);
  if (!newton_.keeps_preconditioner()) return;
  integrator_.visit_memory(memory);
  if (memory.restores())
    newton_.build_again([this](const StencilValues& values) { integrator_.last_jacobian(values); });
}

template SolidPart solid_part<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                                                 const Stage&);
template class ImplicitScheme<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
