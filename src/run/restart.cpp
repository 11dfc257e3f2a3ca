#include "run/restart.hpp"

#include <algorithm>
#include <optional>

#include "case/error.hpp"
#include "field/exchange.hpp"
#include "field/together.hpp"
#include "io/checkpoint_file.hpp"
#include "io/number_text.hpp"
#include "run/host/checkpoint_entries.hpp"
#include "run/host/fingerprint.hpp"
#include "scene/initial.hpp"

namespace softwet {
namespace {

const std::string of_scheme = "memory/", settings_entry = "memory/settings";

/// What the memory of a scheme fits to: the settings of the solver, and how this program computes. The number at the
/// beginning is raised when the schemes visit something else.
template <int D, int P>
std::string memory_settings(const Case& c, Stepper<D, P>& stepper) {
  return "memory 3, " + stepper.scheme().memory_format() + "\n" + solver_settings(c);
}

/// Writes what a scheme remembers. All processes collect it, and the first one has the file.
template <int D>
class MemoryToFile final : public StepMemory {
 public:
  MemoryToFile(const Layout<D>& layout, std::optional<CheckpointWriter>& file) : layout_(layout), file_(file) {}

  bool restores() const override { return false; }
  void number(const std::string& name, double& value) override {
    on_root([&] { file_->value(of_scheme + name, value); });
  }
  void count(const std::string& name, int& value) override {
    on_root([&] { file_->value(of_scheme + name, value); });
  }
  void vector(const std::string& name, const Array& values) override {
    const std::vector<double> all = to_host_on_root(layout_, values);
    on_root([&] { file_->array(of_scheme + name, all); });
  }
  void vector(const std::string& name, const ArrayOf<float>& values) override {
    const Array wide("checkpoint.wide", values.extent(0));
    convert(wide, values);
    const std::vector<double> all = to_host_on_root(layout_, wide);
    on_root([&] { file_->single_array(of_scheme + name, std::vector<float>(all.begin(), all.end())); });
  }

 private:
  const Layout<D>& layout_;
  std::optional<CheckpointWriter>& file_;
};

/// Puts it back.
template <int D>
class MemoryFromFile final : public StepMemory {
 public:
  MemoryFromFile(const Layout<D>& layout, EntriesFromFile& file) : layout_(layout), file_(file) {}

  bool restores() const override { return true; }
  void number(const std::string& name, double& value) override { file_.number(of_scheme + name, value); }
  void count(const std::string& name, int& value) override { file_.count(of_scheme + name, value); }
  void vector(const std::string& name, const Array& values) override {
    Kokkos::deep_copy(values, read(name, values.extent(0)));
  }
  void vector(const std::string& name, const ArrayOf<float>& values) override {
    convert(values, read(name, values.extent(0)));
  }

 private:
  Array read(const std::string& name, std::size_t stored) const {
    const double entries = entries_of_patch(layout_, static_cast<double>(stored));
    return from_patch(layout_, file_.array(of_scheme + name, static_cast<std::size_t>(entries)));
  }

  const Layout<D>& layout_;
  EntriesFromFile& file_;
};

/// The arrays of a state under the names they have in the file.
std::vector<std::pair<std::string, Array>> arrays_of(const State& s) {
  std::vector<std::pair<std::string, Array>> all{{"state/unknown", s.unknown},
                                                 {"state/velocity_rate", s.velocity_rate},
                                                 {"state/displacement", s.displacement},
                                                 {"state/displacement_rate", s.displacement_rate},
                                                 {"state/moment", s.moment},
                                                 {"state/moment_rate", s.moment_rate}};
  if (s.memory.extent(0) > 0) {
    all.emplace_back("state/memory", s.memory);
    all.emplace_back("state/memory_rate", s.memory_rate);
  }
  return all;
}

/// What a run has cost.
void visit_costs(RunEntries& run, SolverCounts& k, RunSeconds& s) {
  run.count("costs/newton", k.newton);
  run.count("costs/krylov", k.krylov);
  run.count("costs/residuals", k.residuals);
  run.count("costs/products", k.products);
  run.count("costs/builds", k.builds);
  run.count("costs/applications", k.applications);
  const std::string seconds = "costs/seconds/";
  run.not_negative(seconds + "residual", k.residual_seconds);
  run.not_negative(seconds + "product", k.product_seconds);
  run.not_negative(seconds + "build", k.build_seconds);
  run.not_negative(seconds + "apply", k.apply_seconds);
  run.not_negative(seconds + "krylov", k.krylov_seconds);
  run.not_negative(seconds + "setup", s.setup);
  run.not_negative(seconds + "observers", s.observers);
  run.not_negative(seconds + "output", s.output);
  run.not_negative(seconds + "total", s.total);
  run.number("run/started", s.started);
}

/// Whether all processes have found the same state in the file.
void require_same_time(const std::string& path, double time) {
  const double of_root = ranks::of_root(time);
  together([&] {
    if (time != of_root)
      throw Error(Exit::machine_failed, path + ": this process reads the state of time " + number_text(time) +
                                            ", the first one that of " + number_text(of_root) +
                                            "; put the output folder where all machines see the same files");
  });
}

/// The arrays of a checkpoint, in the order in which they are asked for.
struct SavedArrays {
  std::vector<std::pair<std::string, Array>> targets;
  std::vector<std::vector<double>> values;

  template <int D>
  void read(const EntriesFromFile& file, const Layout<D>& layout) {
    for (const auto& [name, array] : targets) {
      const double entries = entries_of_patch(layout, static_cast<double>(array.extent(0)));
      values.push_back(file.array(name, static_cast<std::size_t>(entries)));
    }
  }
  template <int D>
  void put_back(const Layout<D>& layout) const {
    for (std::size_t i = 0; i < targets.size(); ++i)
      Kokkos::deep_copy(targets[i].second, from_patch(layout, values[i]));
  }
};

/// Opens a checkpoint of the same case and reads it.
template <int D>
void open_and_read(const std::string& path, const Case& c, const Layout<D>& layout,
                   std::optional<EntriesFromFile>& file, RunMemory& run, SolverCounts& counts, RunSeconds& seconds,
                   SavedArrays& saved) {
  together([&] {
    file.emplace(path);
    file->require_case(c);
    visit(*file, run);
    visit_costs(*file, counts, seconds);
    saved.read(*file, layout);
  });
}

}  // namespace

template <int D, int P>
void write_checkpoint(const std::string& path, const Case& c, Stepper<D, P>& stepper, const HistoryMemory& history,
                      const WrittenFiles& files, RunSeconds seconds) {
  auto arrays = arrays_of(stepper.state());
  arrays.emplace_back("previous/unknown", stepper.previous());
  std::optional<CheckpointWriter> file;
  on_root([&] { file.emplace(path); });
  for (const auto& entry : arrays) {
    const std::vector<double> values = to_host_on_root(stepper.scene().layout(), entry.second);
    on_root([&] { file->array(entry.first, values); });
  }
  MemoryToFile<D> memory(stepper.scene().layout(), file);
  stepper.scheme().visit_memory(memory, stepper.state());
  on_root([&] {
    EntriesToFile entries(*file);
    RunMemory run{stepper.state().time,
                  stepper.previous_dt(),
                  stepper.control().proposed(),
                  stepper.counts().steps,
                  stepper.counts().rejected_newton,
                  stepper.counts().rejected_error,
                  stepper.state().memory_shift,
                  history,
                  files};
    visit(entries, run);
    visit_costs(entries, stepper.scheme().counts(), seconds);
    file->value("case", fingerprint(c));
    file->value(settings_entry, memory_settings(c, stepper));
    file->commit();
  });
}

template <int D, int P>
HistoryMemory read_checkpoint(const std::string& path, const Case& c, Stepper<D, P>& stepper,
                              const HistoryMemory& at_start, WrittenFiles& files, RunSeconds& seconds) {
  const Layout<D>& layout = stepper.scene().layout();
  State state = empty_state(layout);
  const Array previous("previous", state.unknown.extent(0));
  SavedArrays saved{arrays_of(state), {}};
  saved.targets.emplace_back("previous/unknown", previous);
  RunMemory run;
  run.history = at_start;
  SolverCounts counts;
  std::optional<EntriesFromFile> file;
  open_and_read(path, c, layout, file, run, counts, seconds, saved);
  require_same_time(path, run.time);
  saved.put_back(layout);
  state.time = run.time;
  state.memory_shift = run.memory_shift;
  stepper.restore(state, previous, run.previous_dt, run.proposed_dt);
  stepper.counts().steps = run.steps;
  stepper.counts().rejected_newton = run.rejected_newton;
  stepper.counts().rejected_error = run.rejected_error;
  stepper.scheme().counts() = counts;
  files = run.files;
  if (file->says(settings_entry, memory_settings(c, stepper))) {
    MemoryFromFile<D> memory(layout, *file);
    stepper.scheme().visit_memory(memory, stepper.state());
  }
  return run.history;
}

using Steps = Stepper<SOFTWET_DIMENSION, SOFTWET_DEGREE>;
template void write_checkpoint(const std::string&, const Case&, Steps&, const HistoryMemory&, const WrittenFiles&,
                               RunSeconds);
template HistoryMemory read_checkpoint(const std::string&, const Case&, Steps&, const HistoryMemory&, WrittenFiles&,
                                       RunSeconds&);

}  // namespace softwet
