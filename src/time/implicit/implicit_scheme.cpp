#include "time/implicit/implicit_scheme.hpp"

#include "solver/format.hpp"

namespace softwet {
namespace {

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
ImplicitScheme<D, P>::ImplicitScheme(const Scene<D, P>& scene, const Case& c, const Judge<D, P>& judge)
    : solver_(scene, c, judge) {}

template <int D, int P>
void ImplicitScheme<D, P>::predict(const StepHistory& history, double dt) {
  const Layout<D>& l = solver_.scene.layout();
  const ConstArray now = history.state.unknown;
  const Array& x = solver_.x;
  Kokkos::deep_copy(Exec(), x, now);
  if (history.previous_dt > 0) {  // extrapolation of the last two states
    const double factor = dt / solver_.integrator.stage().end_scale / history.previous_dt;
    combine(x, -factor, history.previous, 1 + factor);
    Kokkos::parallel_for("softwet::extrapolate", Items(0, l.scalar_size()),
                         ExtrapolateDensity{x, now, history.previous, l.density_offset(), factor});
  }
  multiply(Kokkos::subview(x, Kokkos::make_pair(0, l.velocity_size())),
           part(solver_.scene.mask(), 0, l.velocity_size()));
  if (!solver_.judge.of_values(x).empty()) Kokkos::deep_copy(Exec(), x, now);
}

template <int D, int P>
StepAttempt ImplicitScheme<D, P>::attempt(const StepHistory& history, double dt) {
  GeneralizedAlpha<D, P>& integrator = solver_.integrator;
  integrator.begin(history.state, dt, history.previous_dt > 0 ? Rates::known : Rates::unknown);
  predict(history, dt);
  StepAttempt attempt = solver_.solve(solver_.system(), solver_.fields());
  if (!attempt.refusal.empty()) return attempt;
  move_ghosts(solver_.scene.layout(), solver_.x, GhostAction::update);  // the prediction left them out
  const double factor = dt / integrator.stage().end_scale / history.previous_dt;
  attempt.indicator = solver_.judge.indicator(history, solver_.x, factor, dt);
  return attempt;
}

template <int D, int P>
void ImplicitScheme<D, P>::visit_memory(StepMemory& memory, const State&) {
  Newton& newton = solver_.newton;
  newton.visit_memory(memory);
  if (!newton.keeps_preconditioner()) return;
  solver_.integrator.visit_memory(memory);
  if (memory.restores())
    newton.build_again([this](const StencilValues& values) { solver_.integrator.last_jacobian(values); });
}

template <int D, int P>
std::string ImplicitScheme<D, P>::memory_format() const {
  return preconditioner_format();
}

template class ImplicitScheme<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
