#include "cli/core/dispatched.hpp"

#include <chrono>
#include <cstdio>
#include <functional>

#include "cli/core/bench_stop.hpp"
#include "run/machine.hpp"
#include "scene/initial.hpp"
#include "solver/choose.hpp"
#include "time/implicit/implicit_scheme.hpp"
#include "time/stepper.hpp"

namespace softwet {
namespace {

/// A form of a preconditioner.
struct Variant {
  std::string name;
  PreconditionerKind kind;
  SchwarzControl control;
};

/// All forms worth a comparison. Factors in 3D are left to small scenes, and none are on several processes.
template <int D>
std::vector<Variant> variants(int unknowns, bool whole) {
  constexpr int largest_factorised = 30000;
  const SchwarzControl usual = SchwarzControl::for_dimension(D);
  std::vector<Variant> all;
  if (whole && (D == 2 || unknowns < largest_factorised)) all.push_back({"lu", PreconditionerKind::lu, usual});
  const auto form = [&](const char* name, auto&& change) {
    SchwarzControl control = usual;
    change(control);
    all.push_back({std::string("schwarz") + name, PreconditionerKind::schwarz, control});
  };
  form("", [](SchwarzControl&) {});
  form(", without coarse levels", [](SchwarzControl& c) { c.coarse = false; });
  form(", coarse levels first", [](SchwarzControl& c) { c.multiplicative = true; });
  form(", fewer levels", [](SchwarzControl& c) { c.direct_up_to *= 4; });
  form(", less overlap", [](SchwarzControl& c) { ++c.stride; });
  form(", wider boxes", [](SchwarzControl& c) { ++c.width, ++c.stride; });
  form(", no shared inverses", [](SchwarzControl& c) { c.share = 0; });
  return all;
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  Kokkos::fence();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Whether the answer of a preconditioner that was built for another step is fitted to the present one.
enum class Answer { as_it_is, renewed };

/// The linear system at the start of a step, with its fields weighted as Newton's method weights them.
template <int D, int P>
class StartOfStep {
 public:
  StartOfStep(const Scene<D, P>& scene, const Case& c)
      : layout_(scene.layout()),
        scheme_(scene, c.time.rho_inf),
        gmres_(layout_.space(), scheme_.size(), 60),
        right_("right", scheme_.size()),
        step_("step", scheme_.size()),
        r_("r", scheme_.size()) {}

  void begin(const State& state, double dt) {
    scheme_.begin(state, dt);
    scheme_.residual(state.unknown, r_);
    const int ends[] = {0, layout_.velocity_size(), layout_.has_fluid ? layout_.potential_offset() : layout_.size(),
                        layout_.size()};
    weights_ = {};
    for (int f = 0; f < 3; ++f) {
      if (ends[f + 1] <= ends[f]) continue;
      const double size = norm(layout_.space(), part(r_, ends[f], ends[f + 1]));
      weights_.add(ends[f], ends[f + 1], size > 0 ? 1 / (size * size) : 1);
    }
    convert(right_, r_);
  }
  void build(Preconditioner& preconditioner) {
    preconditioner.build([this](const StencilValues& values) { scheme_.jacobian(values); });
    built_for_ = solid_part(scheme_.scene(), scheme_.stage()).size;
  }
  KrylovResult solve(Preconditioner& preconditioner, double tolerance, Answer answer = Answer::renewed) {
    const SolidPart solid = solid_part(scheme_.scene(), scheme_.stage());
    const RangeFactors renewed = solid.factors(answer == Answer::renewed ? built_for_ : solid.size);
    const auto product = [this](const ArrayOf<float>& in, const ArrayOf<float>& out) { scheme_.product(in, out); };
    const auto precondition = [&](const ArrayOf<float>& in, const ArrayOf<float>& out) {
      preconditioner.answer(in, out, renewed);
    };
    return gmres_.solve(product, precondition, right_, step_, tolerance, 300, weights_);
  }

 private:
  const Layout<D>& layout_;
  GeneralizedAlpha<D, P> scheme_;
  GmresOf<float> gmres_;
  ArrayOf<float> right_, step_;
  Array r_;
  RangeFactors weights_;
  double built_for_ = 1;
};

/// A line of the table: what a form takes, and its numbers of iterations.
template <int D, int P>
std::string table_row(const std::string& name, Preconditioner& preconditioner, StartOfStep<D, P>& system,
                      const State& state) {
  std::string counts;
  double build = 0, seconds = 0;
  int all = 0;
  const auto count = [&](double tolerance, Answer answer = Answer::renewed) {
    go_on_with_bench();
    KrylovResult result;
    seconds += seconds_of([&] { result = system.solve(preconditioner, tolerance, answer); });
    all += result.iterations;
    const std::string text = result.converged ? std::to_string(result.iterations) : "-";
    return std::string(text.size() < 4 ? 4 - text.size() : 0, ' ') + text;
  };
  for (const double dt : {0.1, 1.0, 10.0}) {
    system.begin(state, 0.5 * dt);
    system.build(preconditioner);
    system.begin(state, dt);
    const std::string plain = count(1e-4, Answer::as_it_is), renewed = count(1e-4);
    build = seconds_of([&] { system.build(preconditioner); });
    const std::string loose = count(1e-2), tight = count(1e-4);
    counts += "  " + loose + tight + plain + renewed;
  }
  char text[120];
  std::snprintf(text, sizeof text, "%-32s %7.2f s %7.0f %8.2f ms", name.c_str(), build,
                preconditioner.bytes() / 1048576, 1e3 * seconds / all);
  return text + counts;
}

}  // namespace

template <int D, int P>
void compare_preconditioners(const Case& asked, std::ostream& out) {
  constexpr int most_steps = 40;
  if (ranks::count() > 1)
    throw Error(Exit::invalid_input, "softwet bench --preconditioners: several processes; start one");
  Case c = asked;
  c.time.scheme = TimeScheme::generalized_alpha;
  c.solver.precision = PrecisionChoice::mixed;
  const Scene<D, P> scene(c);
  Stepper<D, P> stepper(scene, c, {});
  State start = initial_state<D, P>(c, scene);
  stepper.scheme().initialise(start);
  stepper.start(start);
  const int steps = std::min<long>(most_steps, c.time.max_steps);
  for (int i = 0; i < steps; ++i) {
    go_on_with_bench();
    stepper.step();
  }
  const int unknowns = scene.layout().whole_patch().size();
  out << c.name << ": " << unknowns << " unknowns, " << thread_count() << " threads, after " << steps
      << " steps, t = " << stepper.state().time << "\n"
      << "iterations to 1e-2, to 1e-4, and to 1e-4 where the preconditioner was built for half of dt, without and "
         "with\n"
      << "what is done for the solid then; -: not within 300\n"
      << "                                     build     MiB   iteration          dt = 0.1           dt = 1            "
         "dt = 10\n";
  StartOfStep<D, P> system(scene, c);
  for (const Variant& variant : variants<D>(unknowns, scene.layout().whole())) {
    const auto preconditioner = choose_preconditioner<D>(variant.kind, scene.layout(), scene.mask(), variant.control);
    out << table_row(variant.name, *preconditioner, system, stepper.state()) << std::endl;
  }
}

template void compare_preconditioners<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Case&, std::ostream&);

}  // namespace softwet
