#include "time/implicit/implicit_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/choose.hpp"
#include "solver/recorded_answers.hpp"

namespace softwet {
namespace {

/// Change of the displacement in a step, relative, that needs no solve.
constexpr double negligible_change = 1e-10;

NewtonControl newton_control(const Case& c) {
  NewtonControl n;
  n.rtol = c.solver.newton_rtol;
  n.atol = c.solver.newton_atol;
  n.max = c.solver.newton_max;
  n.krylov_rtol = c.solver.krylov_rtol;
  n.krylov_max = c.solver.krylov_max;
  n.jacobian = c.solver.jacobian;
  n.bends = c.fluid && c.fluid->resists_lines();
  return n;
}

template <int D, int P>
std::unique_ptr<Preconditioner> preconditioner_of(const Case& c, const Scene<D, P>& scene) {
  auto chosen = choose_preconditioner<D>(c.solver.preconditioner, scene.layout(), scene.mask());
  return c.solver.launch == Launch::graph ? record_answers(std::move(chosen)) : std::move(chosen);
}

/// Products in double precision are there in any precision of the equations.
LinearSolves linear_solves(const Case& c, Precision precision) {
  return precision == Precision::full || c.solver.precision == PrecisionChoice::full ? LinearSolves::full
                                                                                     : LinearSolves::single;
}

/// Share of the solid without its needles in its part of the Jacobian, 1 without needles. Residuals begin as large as
/// stiff springs make them: a residual that is smaller by a factor is not small enough for unknowns that no spring
/// holds.
template <int D, int P>
double share_of_solid(const Scene<D, P>& scene, const Stage& stage) {
  if (scene.forces().needles().empty()) return 1;
  const double free = solid_part(scene, stage).size;
  return free / (free + scene.coefficients().solid().rates.held * stage.displacement_scale);
}

}  // namespace

template <int D, int P>
SolidPart solid_part(const Scene<D, P>& scene, const Stage& stage) {
  const Layout<D>& l = scene.layout();
  SolidPart solid;
  if (!l.has_solid) return solid;
  for (int d = 0; d < D; ++d)
    solid.ranges.push_back({l.velocity_offset(d), l.velocity_offset(d) + l.solid_rows() * l.row_size});
  const double h = l.shortest();
  const SolidCoefficients& material = scene.coefficients().solid();
  const LameParameters& stiffness = material.stiffness;
  // 4/3 of the shear modulus of branches resists such waves.
  const double of_branches = 2.0 / 3 * (stage.branch_weight * stage.displacement_scale);
  solid.size =
      material.density() * stage.rate_scale +
      ((stiffness.lambda + 2 * stiffness.shear_modulus) * stage.displacement_scale + of_branches) * 4 / (h * h);
  return solid;
}

template <int D, int P>
ImplicitSolver<D, P>::ImplicitSolver(const Scene<D, P>& m, const Case& c, const Judge<D, P>& j)
    : scene(m),
      judge(j),
      integrator(m, c.time.rho_inf),
      newton(m.layout().space(), m.layout().size(), c.solver.krylov_restart, preconditioner_of(c, m),
             linear_solves(c, m.equations().precision())),
      judges_solid(m.layout().has_solid && c.solver.preconditioner != PreconditionerKind::none),
      control(newton_control(c)),
      x("implicit.x", m.layout().size()) {
  double volume = 1;
  for (const Axis& axis : m.layout().axis) volume *= axis.length() / axis.elements();
  volume_norm = volume * std::sqrt(entries_of_patch(m.layout(), double(m.layout().rows) * m.layout().row_size));
}

template <int D, int P>
std::vector<FieldRange> ImplicitSolver<D, P>::fields() const {
  const Layout<D>& l = scene.layout();
  const double atol = control.atol, rate = integrator.stage().rate_scale;
  const SolidCoefficients& solid = scene.coefficients().solid();
  const double stiffness =
      solid.stiffness.lambda + 2 * solid.stiffness.shear_modulus + 2.0 / 3 * solid.branches.weight(0);
  constexpr double digits = 1e-15;  // of the forces of needles, whose stiffness takes them from displacements
  const double held = digits * solid.rates.held * l.axis[D - 1].length();
  std::vector<FieldRange> f{
      {0, l.velocity_size(), volume_norm * std::max(atol * std::max({rate, 1.0, stiffness}), held)}};
  if (l.has_fluid) {
    f.push_back({l.density_offset(), l.potential_offset(), atol * volume_norm * std::max(rate, 1e-2)});
    f.push_back({l.potential_offset(), l.size(), atol * volume_norm});
  }
  return f;
}

template <int D, int P>
double ImplicitSolver<D, P>::remaining(const Array& at, const Array& correction, double stretch) const {
  const Layout<D>& l = scene.layout();
  const Stage& stage = integrator.stage();
  const auto rows = solid_part(scene, stage).ranges;
  double moves = 0;
  for (const double along : norms(l.space(), correction, rows)) moves = std::hypot(moves, along);
  const double speed = norm(l.space(), part(at, 0, l.velocity_size())),
               moved = norm(l.space(), stage.displacement) / stage.displacement_scale * stretch,
               at_rest = l.has_fluid ? control.atol * std::sqrt(entries_of_patch(l, l.velocity_size())) : 0;
  return moves /
         std::max({control.rtol * speed, negligible_change * moved, at_rest, std::numeric_limits<double>::min()});
}

template <int D, int P>
NonlinearSystem ImplicitSolver<D, P>::system() {
  NonlinearSystem system{[this](const Array& at, const Array& r) { integrator.residual(at, r); },
                         [this](const Array& z, const Array& out) { integrator.product(z, out); },
                         [this](const StencilValues& values) { integrator.jacobian(values); },
                         [this](const Array& at) { return judge.of_values(at); },
                         [this](const ArrayOf<float>& z, const ArrayOf<float>& out) { integrator.product(z, out); },
                         solid_part(scene, integrator.stage())};
  if (judges_solid)
    system.remaining = [this](const Array& at, const Array& correction) { return remaining(at, correction); };
  return system;
}

template <int D, int P>
StepAttempt ImplicitSolver<D, P>::solve(const NonlinearSystem& system, const std::vector<FieldRange>& ranges) {
  NewtonControl of_step = control;
  of_step.rtol *= share_of_solid(scene, integrator.stage());
  const NewtonResult result = newton.solve(system, ranges, of_step, x);
  StepAttempt attempt{result.refusal, 0, result.iterations, result.krylov, result.iterations + 2 > control.max};
  if (result.converged) attempt.refusal = judge.of_end(integrator.stage());
  return attempt;
}

template SolidPart solid_part<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Scene<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                                                 const Stage&);
template struct ImplicitSolver<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
