#include "time/rest/still_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/scale_fields.hpp"
#include "time/rest/rest_control.hpp"

namespace softwet {
namespace {

/// Change of the displacement in a step, relative, that counts as none.
constexpr double still_part = 1e-6;

/// The scales of a stage of a step that is `stretch` times shorter.
Stage shorter(Stage stage, double stretch) {
  stage.rate_scale *= stretch;
  stage.displacement_scale /= stretch;
  return stage;
}

}  // namespace

template <int D, int P>
StillSteps<D, P>::StillSteps(const Scene<D, P>& scene, const Case& c, const Judge<D, P>& judge)
    : solver_(scene, c, judge) {
  for (Array* work : {&unstretched_, &wide_, &product_, &round_off_})
    *work = Array("implicit.still", scene.layout().size());
}

template <int D, int P>
NonlinearSystem StillSteps<D, P>::system() {
  NonlinearSystem system{[this](const Array& x, const Array& r) {
                           solver_.integrator.residual(unstretched(x), r);
                           tie_mass(r);
                         },
                         [this](const Array& z, const Array& out) { product(z, out); },
                         [this](const StencilValues& values) { solver_.integrator.jacobian(values, stretch_); },
                         [this](const Array& x) { return solver_.judge.of_values(x); },
                         [this](const ArrayOf<float>& z, const ArrayOf<float>& out) { product(z, out); },
                         solid_part(solver_.scene, shorter(solver_.integrator.stage(), stretch_))};
  if (solver_.judges_solid)
    system.remaining = [this](const Array& x, const Array& correction) {
      return solver_.remaining(x, correction, stretch_);
    };
  return system;
}

template <int D, int P>
void StillSteps<D, P>::product(const Array& z, const Array& out) {
  solver_.integrator.product(unstretched(z), out);
  tie_mass(out);
}

template <int D, int P>
void StillSteps<D, P>::product(const ArrayOf<float>& z, const ArrayOf<float>& out) {
  if (stretch_ == 1) return solver_.integrator.product(z, out);
  convert(wide_, z);
  product(wide_, product_);
  convert(out, product_);
}

template <int D, int P>
void StillSteps<D, P>::tie_mass(const Array& r) const {
  const Layout<D>& l = solver_.scene.layout();
  if (stretch_ == 1 || !l.has_fluid) return;
  const double sum = total(l.space(), part(r, l.density_offset(), l.potential_offset()));
  const ConstArray moment = solver_.integrator.moment();
  add_scaled(r, l.density_offset(), (stretch_ - 1) * sum / total(l.space(), moment), moment);
}

template <int D, int P>
Array StillSteps<D, P>::unstretched(const Array& x) const {
  if (stretch_ == 1 || !solver_.scene.layout().has_solid) return x;
  RangeFactors factors;
  for (const SolidPart::Range& rows : solid_part(solver_.scene, solver_.integrator.stage()).ranges)
    factors.add(rows.first, rows.last, 1 / stretch_);
  ScaleFields<double, double>{unstretched_, x, factors}.run();
  return unstretched_;
}

template <int D, int P>
std::vector<FieldRange> StillSteps<D, P>::measure(Settling& settling) {
  GeneralizedAlpha<D, P>& integrator = solver_.integrator;
  const VectorSpace space = solver_.scene.layout().space();
  std::vector<FieldRange> ranges = solver_.fields();
  integrator.last_digits(solver_.x, wide_, round_off_);
  const std::vector<double> digits = norms(space, round_off_, ranges);
  integrator.residual(solver_.x, round_off_);
  const std::vector<double> sizes = norms(space, round_off_, ranges);
  double level = 0;  // of the residual, in units of what the fields are measured with
  for (std::size_t f = 0; f < ranges.size(); ++f) {
    ranges[f].round_off = digits[f];
    level = std::max(level, sizes[f] / ranges[f].floor);
    if (sizes[f] > 0) settling.excess = std::max(settling.excess, sizes[f] / digits[f]);
  }
  // A field that starts with less than its share is not solved to digits that the others do not have.
  for (FieldRange& range : ranges) range.floor *= level * solver_.control.rtol;
  return ranges;
}

template <int D, int P>
Settling StillSteps<D, P>::settle(const State& state, double dt) {
  solver_.integrator.begin_still(state, dt);
  Kokkos::deep_copy(Exec(), solver_.x, state.unknown);
  for (const SolidPart::Range& rows : solid_part(solver_.scene, solver_.integrator.stage()).ranges)
    Kokkos::deep_copy(Exec(), Kokkos::subview(solver_.x, Kokkos::make_pair(rows.first, rows.last)), 0.0);
  stretch_ = std::max(1.0, dt / moderate_step);
  solver_.newton.forget_preconditioner();  // steps grow too fast for one of the step before
  Settling settling;
  const std::vector<FieldRange> ranges = measure(settling);
  if (settling.excess < digits_of_rest && !solver_.scene.layout().has_solid) return settling;
  settling.step = solver_.solve(system(), ranges);
  Kokkos::deep_copy(Exec(), solver_.x, unstretched(solver_.x));
  move_ghosts(solver_.scene.layout(), solver_.x, GhostAction::update);
  settling.still = !still_moves();
  return settling;
}

template <int D, int P>
bool StillSteps<D, P>::still_moves() const {
  const Layout<D>& l = solver_.scene.layout();
  const Stage& stage = solver_.integrator.stage();
  double moves = 0;
  for (const double along : norms(l.space(), solver_.x, solid_part(solver_.scene, stage).ranges))
    moves = std::hypot(moves, along * stage.displacement_scale);
  const double last_digit =
      std::numeric_limits<double>::epsilon() * l.axis[D - 1].length() * std::sqrt(entries_of_patch(l, l.solid_size()));
  return moves > std::max(still_part * norm(l.space(), stage.displacement), 0.1 * last_digit);
}

template <int D, int P>
NewtonResult StillSteps<D, P>::respond(const State& rest, double dt, const Array& r, const Array& x) {
  stretch_ = 1;
  solver_.integrator.begin_still(rest, dt);
  solver_.integrator.residual(rest.unknown, solver_.x);  // the point at which the products are those of the Jacobian
  Kokkos::deep_copy(Exec(), x, 0.0);
  NonlinearSystem linear = system();
  linear.residual = [this, r](const Array& z, const Array& out) {
    product(z, out);
    add_scaled(out, 0, 1, r);
  };
  linear.remaining = {};
  linear.complaint = [](const Array&) { return Refusal(); };
  NewtonControl control = solver_.control;
  control.rtol = 1e-7;
  std::vector<FieldRange> ranges = solver_.fields();
  // The equation of the potential begins without a residual. Its share is that of the density's change.
  if (ranges.size() > 1) ranges[2].floor = dt * norms(solver_.scene.layout().space(), r, ranges)[1];
  const NewtonResult result = solver_.newton.solve(linear, ranges, control, x);
  move_ghosts(solver_.scene.layout(), x, GhostAction::update);
  return result;
}

template class StillSteps<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
