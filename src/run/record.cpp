#include "run/record.hpp"

#include <unistd.h>

#include <Kokkos_Core.hpp>
#include <softwet_version.hpp>

#include "field/exchange.hpp"
#include "run/machine.hpp"
#include "scene/groups.hpp"

namespace softwet {
namespace {

void add_unknowns(RecordValue& unknowns, int velocity, int scalar, int displacement) {
  unknowns["velocity"] = velocity;
  unknowns["density"] = scalar;
  unknowns["chemical_potential"] = scalar;
  unknowns["displacement"] = displacement;  // eliminated: not part of the linear systems
  unknowns["solved"] = velocity + 2 * scalar;
}

void add_timings(RecordValue& timings, const SolverCounts& k, const RunSeconds& s) {
  const double krylov = std::max(0.0, k.krylov_seconds - k.product_seconds - k.apply_seconds);
  const double known = s.setup + k.residual_seconds + k.product_seconds + k.build_seconds + k.apply_seconds + krylov +
                       s.observers + s.output;
  timings["setup"] = s.setup;
  timings["residual"] = k.residual_seconds;
  timings["product"] = k.product_seconds;
  timings["preconditioner_build"] = k.build_seconds;
  timings["preconditioner_apply"] = k.apply_seconds;
  timings["krylov_other"] = krylov;
  timings["observers"] = s.observers;
  timings["output"] = s.output;
  timings["other"] = std::max(0.0, s.total - known);
  timings["total"] = s.total;
}

/// Million unknowns per second and core, or device.
double rate(int unknowns, long calls, double seconds) {
  return seconds > 0 ? 1e-6 * unknowns * static_cast<double>(calls) / seconds / worker_count() : 0;
}

}  // namespace

template <int D, int P>
RunRecord describe_run(const Case& c, const Scene<D, P>& scene, Stepper<D, P>& stepper, const RunSeconds& seconds,
                       long first_step) {
  const Layout<D>& layout = scene.layout();
  const SolverCounts& k = stepper.scheme().counts();
  RunRecord run;
  run["softwet"] = version;
  run["commit"] = commit;
  run["case"] = c.name;
  run["host"] = host_name();
  run["process"] = static_cast<std::int64_t>(::getpid());
  run["backend"] = backend_name();
  run["threads"] = thread_count();
  run["ranks"] = ranks::count();
  run["instructions"] = instruction_set();
  run["precision"] = name_of(scene.equations().precision());
  run["dimension"] = D;
  run["degree"] = P;
  const Layout<D> patch = layout.whole_patch();
  add_unknowns(run["unknowns"], patch.velocity_size(), patch.scalar_size(), patch.solid_size());
  if (layout.has_fluid) {  // of the flat interface in equilibrium; droplets end half way between
    run["equilibrium"]["density_vapour"] = scene.coefficients().coexistence().density_vapour;
    run["equilibrium"]["density_liquid"] = scene.coefficients().coexistence().density_liquid;
  }
  for (const Group& group : groups(c)) run["groups"][group.name] = group.value;
  const Preconditioner* preconditioner = stepper.scheme().preconditioner();
  run["preconditioner"] = preconditioner ? preconditioner->name() : "none";
  add_timings(run["seconds"], k, seconds);
  RecordValue& counts = run["counts"];
  counts["steps"] = stepper.counts().steps;
  counts["steps_before_resume"] = first_step;
  counts["rejected_by_newton"] = stepper.counts().rejected_newton;
  counts["rejected_by_error"] = stepper.counts().rejected_error;
  counts["newton"] = k.newton;
  counts["krylov"] = k.krylov;
  counts["residuals"] = k.residuals;
  counts["products"] = k.products;
  counts["preconditioner_builds"] = k.builds;
  counts["preconditioner_applications"] = k.applications;
  if (ranks::count() > 1) {  // of the first process
    RecordValue& traffic = run["traffic"];
    traffic["messages"] = static_cast<std::int64_t>(ranks::traffic().messages);
    traffic["bytes"] = ranks::traffic().bytes;
    traffic["reductions"] = static_cast<std::int64_t>(ranks::traffic().reductions);
    traffic["collections"] = static_cast<std::int64_t>(ranks::traffic().collections);
    traffic["bytes_collected"] = ranks::traffic().collected;
  }
  RecordValue& throughput = run["million_unknowns_per_second_and_core"];
  throughput["residual"] = rate(layout.size(), k.residuals, k.residual_seconds);
  throughput["product"] = rate(layout.size(), k.products, k.product_seconds);
  run["peak_memory_mib"] = peak_memory_mib();
  run["last_rejection"] = std::string(stepper.counts().last_rejection.text());
  return run;
}

template RunRecord describe_run<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Case&,
                                                                   const Scene<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                                                   Stepper<SOFTWET_DIMENSION, SOFTWET_DEGREE>&,
                                                                   const RunSeconds&, long);

}  // namespace softwet
