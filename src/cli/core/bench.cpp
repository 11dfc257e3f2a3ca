#include "cli/core/dispatched.hpp"

#include <chrono>
#include <cstdio>
#include <limits>
#include <string>

#include "cli/core/bench_stop.hpp"
#include "cli/core/configurations.hpp"
#include "cli/core/kernel_counts.hpp"
#include "run/machine.hpp"
#include "scene/initial.hpp"
#include "solver/choose.hpp"
#include "solver/recorded_answers.hpp"
#include "time/choose_scheme.hpp"
#include "time/explicit/kick_drift.hpp"
#include "time/stepper.hpp"

namespace softwet {
namespace {

/// Shortest mean time of a call, over a few rounds of about 0.1 s; of several processes, that of the slowest. Throws
/// BenchStopped.
template <class Work>
double seconds_per_call(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto round = [&](int calls) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) work();
    Kokkos::fence();
    return std::chrono::duration<double>(Clock::now() - start).count() / calls;
  };
  go_on_with_bench();
  round(1);
  const int calls = std::max(1, static_cast<int>(0.1 / ranks::largest(round(1))));  // all processes make as many
  double best = std::numeric_limits<double>::max();
  for (int i = 0; i < 5; ++i) best = std::min(best, round(calls));
  return ranks::largest(best);
}

/// Flops of one residual counted by hand for 3^D points per element and degree 2; second derivatives included.
double counted_flops(const Case& c, double fluid_elements, double solid_elements) {
  const bool plane = c.dimension() == 2, moving = c.substrate.has_value();
  const double fluid = plane ? (moving ? 5.5e3 : 2.8e3) : (moving ? 42e3 : 18e3), solid = plane ? 1.9e3 : 14e3;
  return fluid * fluid_elements + solid * solid_elements;
}

/// Cores or devices of all processes.
int workers() { return worker_count() * ranks::count(); }

/// Prints one line per measurement.
struct Sheet {
  std::ostream& out;
  int unknowns;  ///< of the whole patch

  void line(const std::string& name, double seconds, const std::string& more = "") const {
    rate(name, seconds, unknowns, "M unknowns", more);
  }
  void rate(const std::string& name, double seconds, double items, const char* unit,
            const std::string& more = "") const {
    char text[200];
    std::snprintf(text, sizeof text, "%-46s %10.4f ms %9.2f %s/s/%s", name.c_str(), 1e3 * seconds,
                  1e-6 * items / seconds / workers(), unit, worker_name());
    out << text << more << "\n";
  }
};

template <int D, class Real>
void bench_terms(const Sheet& sheet, const Layout<D>& layout, const Pieces<D, Real>& pieces, const StageOf<Real>& stage,
                 const ArrayOf<Real>& z, const ArrayOf<Real>& out) {
  const Evaluation<D, Real> plain{layout, stage, {}, out}, tangent{layout, stage, z, out};
  for (const auto& entry : pieces.list) {
    const Piece<D, Real>& piece = *entry.piece;
    const std::string name = piece.name();
    const double elements = piece.region().elements();  // of one process
    if constexpr (std::is_same_v<Real, double>)
      sheet.rate("  residual of " + name, seconds_per_call([&] { piece.residual(plain); }), elements * ranks::count(),
                 "M elements");
    sheet.rate("  product of " + name, seconds_per_call([&] { piece.product(tangent); }), elements * ranks::count(),
               "M elements");
  }
}

/// Product in single precision.
template <int D, int P>
void bench_single(const Sheet& sheet, Case c, const State& state) {
  c.solver.precision = PrecisionChoice::mixed;
  const Scene<D, P> scene(c);
  GeneralizedAlpha<D, P> scheme(scene, c.time.rho_inf);
  scheme.begin(state, 1.0);
  const Array r("r", scheme.size());
  const ArrayOf<float> z("z", scheme.size()), out("out", scheme.size());
  convert(z, state.unknown);
  scheme.residual(state.unknown, r);  // the point of the product
  sheet.line("product, exact, single precision", seconds_per_call([&] { scheme.product(z, out); }));
  bench_terms(sheet, scene.layout(), scene.terms().single_pieces(), scheme.single_stage(), z, out);
  sheet.line("dot, single precision", seconds_per_call([&] { dot(scene.layout().space(), z, out); }));
}

/// What the first process has sent to the others between two moments, for each iteration.
void print_traffic(const Sheet& sheet, const Traffic& before, const Traffic& now, int iterations) {
  char text[200];
  std::snprintf(text, sizeof text,
                "  messages %.1f, of %.1f kB in all; reductions %.1f; collections %.1f, of %.1f kB\n",
                double(now.messages - before.messages) / iterations, 1e-3 * (now.bytes - before.bytes) / iterations,
                double(now.reductions - before.reductions) / iterations,
                double(now.collections - before.collections) / iterations,
                1e-3 * (now.collected - before.collected) / iterations);
  sheet.out << text;
}

/// Time of a GMRES iteration with vectors of the precision Real, its product and the preconditioner included, and its kernels if
/// they are counted.
template <class Real, int D, int P>
void bench_gmres(const Sheet& sheet, const std::string& name, const GeneralizedAlpha<D, P>& scheme, const Array& right,
                 Preconditioner& preconditioner, bool counted = true) {
  GmresOf<Real> gmres(scheme.scene().layout().space(), scheme.size(), 30);
  const ArrayOf<Real> b("b", scheme.size()), x("x", scheme.size());
  convert(b, right);
  const auto product = [&](const ArrayOf<Real>& in, const ArrayOf<Real>& out) { scheme.product(in, out); };
  const auto precondition = [&](const ArrayOf<Real>& in, const ArrayOf<Real>& out) {
    preconditioner.answer(in, out, {});
  };
  const auto solve = [&] { return gmres.solve(product, precondition, b, x, 1e-4, 200).iterations; };
  const Traffic before = ranks::traffic();
  KernelCounter counter;
  const int iterations = solve();
  const KernelCounts counts = counter.stop();
  const Traffic after = ranks::traffic();
  sheet.line(name, seconds_per_call(solve) / iterations, ", " + std::to_string(iterations) + " iterations to 1e-4");
  if (!counted) return;
  char text[160];
  std::snprintf(text, sizeof text, "  kernels %.1f, copies to or from the host %.1f, waits %.1f\n",
                double(counts.kernels) / iterations, double(counts.copies) / iterations,
                double(counts.waits) / iterations);
  sheet.out << text;
  if (ranks::count() > 1) print_traffic(sheet, before, after, iterations);
}

/// Build and apply of each preconditioner, and GMRES iterations to 1e-4 of the first linear system of a step from a
/// relaxed state, at several step sizes.
template <int D, int P>
void bench_preconditioners(const Sheet& sheet, const Case& c, const Scene<D, P>& scene) {
  Stepper<D, P> stepper(scene, c, {});
  State start = initial_state<D, P>(c, scene);
  stepper.scheme().initialise(start);
  stepper.start(start);
  for (int i = 0; i < 40; ++i) {
    go_on_with_bench();
    stepper.step();
  }
  Case mixed = c;
  mixed.solver.precision = PrecisionChoice::mixed;
  const Scene<D, P> both(mixed);
  GeneralizedAlpha<D, P> scheme(both, c.time.rho_inf);
  const Array r("r", scheme.size()), z("z", scheme.size());
  const Jacobian frozen = [&](const StencilValues& values) { scheme.jacobian(values); };
  Gmres gmres(scheme.scene().layout().space(), scheme.size(), 200);
  constexpr int largest_factorised = 20000;
  const double product = seconds_per_call([&] { scheme.product(z, r); });
  for (const PreconditionerKind kind : {PreconditionerKind::lu, PreconditionerKind::schwarz}) {
    const std::string name = word_of(kind);
    if (kind != PreconditionerKind::schwarz && kind != c.solver.preconditioner && D == 3 &&
        sheet.unknowns > largest_factorised) {
      sheet.out << "preconditioner " << name << ": left out, too large; name it in solver.krylov.preconditioner\n";
      continue;
    }
    const bool divided = !scene.layout().whole();
    if (divided && (kind == PreconditionerKind::lu || scene.layout().columns.beside < box_width(D) - 1)) {
      sheet.out << "preconditioner " << name << ": left out on several processes"
                << (kind == PreconditionerKind::lu ? "" : "; name it in solver.krylov.preconditioner") << "\n";
      continue;
    }
    auto preconditioner = choose_preconditioner<D>(kind, scene.layout(), scene.mask());
    std::string counts;
    for (const double dt : {0.01, 0.1, 1.0, 5.0}) {
      scheme.begin(stepper.state(), dt);
      scheme.residual(stepper.state().unknown, r);
      preconditioner->build(frozen);
      const KrylovResult result =
          gmres.solve([&](const Array& x, const Array& y) { scheme.product(x, y); },
                      [&](const Array& x, const Array& y) { preconditioner->apply(x, y); }, r, z, 1e-4, 200);
      counts += (counts.empty() ? "" : " / ") + std::to_string(result.iterations);
    }
    const double build = seconds_per_call([&] { preconditioner->build(frozen); });
    const double apply = seconds_per_call([&] { preconditioner->apply(r, z); });
    char text[120];
    std::snprintf(text, sizeof text, ", worth %.0f iterations", build / (product + apply));
    sheet.line("preconditioner " + name + ", build", build, text);
    sheet.line("preconditioner " + name + ", apply", apply);
    std::snprintf(text, sizeof text, "  %.0f MiB", preconditioner->bytes() / 1048576);
    sheet.out << text << "; iterations at dt = 0.01 / 0.1 / 1 / 5: " << counts << "\n";
    scheme.begin(stepper.state(), 0.1);
    scheme.residual(stepper.state().unknown, r);
    preconditioner->build(frozen);
    const Array right = Kokkos::create_mirror(Exec(), r);
    Kokkos::deep_copy(right, r);
    bench_gmres<double>(sheet, "GMRES iteration, " + name, scheme, right, *preconditioner);
    bench_gmres<float>(sheet, "GMRES iteration, " + name + ", single precision", scheme, right, *preconditioner);
    if (!preconditioner->recordable()) continue;
    preconditioner = record_answers(std::move(preconditioner));
    sheet.line("  answer, as a graph", seconds_per_call([&] { preconditioner->answer(r, z, {}); }));
    constexpr bool counted = false;  // while kernels are counted they are not recorded
    bench_gmres<float>(sheet, "  the same, preconditioner as a graph", scheme, right, *preconditioner, counted);
  }
}

/// Whole steps of kick_drift with each kind of mass, and what they are made of.
template <int D, int P>
void bench_explicit(const Sheet& sheet, const Scene<D, P>& scene, State state) {
  for (const MassKind kind : {MassKind::consistent, MassKind::lumped, MassKind::corrected}) {
    const std::string name = word_of(kind);
    SemiDiscrete<D, P> system(scene, kind);
    system.set_moments(state);
    KickDrift<D, P> step(system);
    step.begin(state);
    const StepBound<D, P> bound(scene.regions(), scene.coefficients(), kind, step.formula());
    const auto rates = [&] {
      return bound.rates(
          {system.stage().unknown, system.stage().displacement, step.moments(), system.masses().scalar_sums()});
    };
    const StepRates now = rates();
    const double dt = 0.9 / now.combined;
    sheet.line(std::string("step of kick_drift, ") + name,
               seconds_per_call([&] { step.advance(state.time, dt, now); }));
    if (kind != MassKind::corrected) continue;
    const Array a("a", system.velocities()), m("m", system.moments());
    sheet.line("  density from moments",
               seconds_per_call([&] { (void)system.find_density(system.evaluated(), step.moments()); }));
    sheet.line("  chemical potential", seconds_per_call([&] { (void)system.find_potential(system.evaluated()); }));
    sheet.line("  flux of mass, and density", seconds_per_call([&] {
                 (void)system.move_moments(system.find_flux(system.evaluated()), dt, step.moments(), step.moments(), m);
               }));
    sheet.line("  pressure and its acceleration",
               seconds_per_call([&] { (void)system.take_rates(system.pressure(system.evaluated(), a), m); }));
    sheet.line("  convection, viscosity, acceleration",
               seconds_per_call([&] { (void)system.convection(system.evaluated(), Viscosity::among_all, a); }));
    sheet.line("  weights of velocities",
               seconds_per_call([&] { (void)system.weigh_velocities(system.evaluated(), step.moments()); }));
    sheet.line("  bound of the step", seconds_per_call([&] { rates(); }));
  }
}

}  // namespace

template <int D, int P>
void bench_scene(const Case& asked, std::ostream& out) {
  Case c = asked;
  c.solver.precision = PrecisionChoice::full;  // single precision is measured beside it
  const Scene<D, P> scene(c);
  const Layout<D>& layout = scene.layout();
  GeneralizedAlpha<D, P> scheme(scene, c.time.rho_inf);
  State state = initial_state<D, P>(c, scene);
  scheme.initialise(state);
  scheme.begin(state, 1.0);
  const Array r("r", scheme.size()), z("z", scheme.size());
  Kokkos::deep_copy(z, state.unknown);
  scheme.residual(state.unknown, r);

  const Sheet sheet{out, layout.whole_patch().size()};
  out << c.name << ": " << sheet.unknowns << " unknowns, " << backend_name() << ", ";
  if (ranks::count() > 1) out << ranks::count() << " processes with ";
  out << thread_count() << " threads, " << lanes() << " elements per pack (" << instruction_set() << ")\n";
  double wall_elements = 1;
  for (int d = 0; d < D - 1; ++d) wall_elements *= layout.axis[d].elements();
  const double solid = layout.has_solid ? wall_elements * layout.solid_elements : 0;
  const double fluid = layout.has_fluid ? wall_elements * (layout.axis[D - 1].elements() - layout.solid_elements) : 0;
  const double residual = seconds_per_call([&] { scheme.residual(state.unknown, r); });
  char flops[80] = "";
  if (scene.regions().points() == 3)
    std::snprintf(flops, sizeof flops, ", %.1f GFLOP/s/%s of the counted work",
                  1e-9 * counted_flops(c, fluid, solid) / residual / workers(), worker_name());
  sheet.line("residual", residual, flops);
  sheet.line("product, exact", seconds_per_call([&] { scheme.product(z, r); }));
  const StencilValues values("jacobian", Stencil<D>(layout).size());
  sheet.line("Jacobian as a matrix", seconds_per_call([&] { scheme.jacobian(values); }));
  bench_terms(sheet, layout, scene.terms().pieces(), scheme.stage(), z, r);
  sheet.line("dot", seconds_per_call([&] { dot(layout.space(), z, r); }));
  bench_single<D, P>(sheet, c, state);

  bench_explicit(sheet, scene, state);
  if (c.time.implicit()) bench_preconditioners(sheet, c, scene);
  out << "peak memory";
  for (double memory : peak_memory_of_processes()) out << " " << memory << " MiB";
  out << "\n";
}

template void bench_scene<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Case&, std::ostream&);

}  // namespace softwet
