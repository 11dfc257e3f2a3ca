#include "cli/core/dispatch.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <new>

#include <softwet_version.hpp>
#include "cli/core/bench_stop.hpp"
#include "cli/core/configurations.hpp"
#include "cli/core/describe.hpp"
#include "cli/core/dispatched.hpp"
#include "cli/core/scales.hpp"
#include "cli/core/units.hpp"
#include "cli/core/units_case.hpp"
#include "field/ranks.hpp"
#include "foresight/forecast.hpp"
#include "foresight/steps_foreseen.hpp"
#include "foresight/width.hpp"
#include "machine/backend_error.hpp"
#include "machine/terminal.hpp"
#include "machine/threads.hpp"
#include "run/earlier_run.hpp"
#include "run/machine.hpp"
#include "run/motion.hpp"
#include "run/rest.hpp"

namespace softwet {
namespace {

/// Runs `work` with the backend up; what the backend throws becomes an Error of the machine.
template <class Work>
void on_machine(int threads, const Work& work) {
  const ParallelRuntime runtime(threads);
  try {
    work();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(Exit::machine_failed, "out of memory; 'softwet check CASE' shows how much a case needs");
  } catch (const std::runtime_error& error) {
    throw backend_error(error.what());
  }
}

/// Threads that have to share cores wait for each other most of the time.
void warn_of_threads() {
  const double granted = std::min<double>(core_count(), std::ceil(cores_by_control_groups()));
  if (!ranks::root() || thread_count() <= granted) return;
  std::cerr << "softwet: warning: " << thread_count() << " threads share " << granted
            << (granted == 1 ? " core" : " cores") << " and wait for each other most of the time: write --threads "
            << granted << "\n";
}

void warn_of_loss(const std::string& sentence) {
  if (ranks::root()) std::cerr << for_stderr("softwet: warning: " + sentence) << std::endl;
}

/// The case with the result that it starts from. In a state of rest branches carry nothing, whatever they carried before.
Case with_start(const Case& given, const RunOptions& options) {
  if (options.resume) return given;
  Case c = given;
  if (options.steady) c.time.start = StartState::equilibrium;
  c = with_earlier_run(c, warn_of_loss);
  c.time.start = given.time.start;
  return c;
}

}  // namespace

void run_case(const Case& given, const RunOptions& options) {
  on_machine(options.threads, [&] {
    const Case c = with_start(given, options);
    warn_of_threads();
    with_configuration(c, [&](auto configuration) {
      using Chosen = decltype(configuration);
      if (options.steady) return Rest<Chosen::dimension, Chosen::degree>(c, options).run();
      Motion<Chosen::dimension, Chosen::degree>(c, options).run();
    });
  });
}

void describe_case(const Case& given, std::ostream& out) {
  describe_scene(given, out);
  on_machine(0, [&] {  // what a preconditioner holds depends on the number of threads
    const Case c = with_earlier_run(given, warn_of_loss);
    with_configuration(c, [&](auto configuration) {
      using Chosen = decltype(configuration);
      describe_discretisation<Chosen::dimension, Chosen::degree>(c, out);
    });
  });
}

void write_first_state(const Case& given, const std::string& folder) {
  on_machine(0, [&] {
    const Case c = with_earlier_run(given);
    with_configuration(c, [&](auto configuration) {
      using Chosen = decltype(configuration);
      write_first_fields<Chosen::dimension, Chosen::degree>(c, folder);
    });
  });
}

StepsForeseen foresee_steps(const Case& c) { return {explicit_steps_foreseen(c), most_explicit_steps(c.dimension())}; }

std::vector<std::string> forecast_case(const Case& c) { return forecast(c); }

std::string judge_width(const Case& c) { return warning_about_width(c); }

void convert_units(const PhysicalScene& scene, const WrittenCase& written, std::ostream& out) {
  written.path.empty() ? describe_units(scene, out) : write_units_case(scene, written, out);
}

std::string gel_case(const std::string& name) { return units_case(water_on_gel(), {}, name); }

Conversion conversion_of_quantities() { return {scales_of, case_of_laboratory}; }

void print_laboratory(const Scales& scales, const Case& c, std::ostream& out) { describe_laboratory(scales, c, out); }

void bench_case(const Case& given, const RunOptions& options, std::ostream& out) {
  on_machine(options.threads, [&] {
    const Case c = with_earlier_run(given);
    warn_of_threads();
    with_configuration(c, [&](auto configuration) {
      using Chosen = decltype(configuration);
      const auto measure = options.preconditioners ? compare_preconditioners<Chosen::dimension, Chosen::degree>
                                                   : bench_scene<Chosen::dimension, Chosen::degree>;
      try {
        measure(c, out);
      } catch (const BenchStopped&) {
        out << "stopped by user; the lines above are complete" << std::endl;
      }
    });
  });
}

std::string configuration_line(const Case& c) { return configuration_of(c) + (is_compiled(c) ? " built" : " missing"); }

void describe_build(std::ostream& out) {
  const ParallelRuntime runtime(0);
  out << "softwet         " << version << " (" << commit << ")"
      << "\n"
      << "configurations  " << compiled_configurations() << "\n"
      << "backend         " << backend_name() << ", " << thread_count() << " threads\n";
  if (const int devices = Kokkos::num_devices(); devices > 0) out << "devices         " << devices << "\n";
  out << "MPI             " << (ranks::has_mpi() ? "yes" : "no") << "\n"
      << "instructions    " << instruction_set() << ", " << lanes() << " elements per pack\n"
      << "Kokkos          " << KOKKOS_VERSION / 10000 << "." << KOKKOS_VERSION / 100 % 100 << "."
      << KOKKOS_VERSION % 100 << "\n";
}

}  // namespace softwet
