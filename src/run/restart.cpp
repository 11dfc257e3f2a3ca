#include "run/restart.hpp"

#include <algorithm>
#include <optional>

#include "case/error.hpp"
#include "field/exchange.hpp"
#include "field/together.hpp"
#include "io/checkpoint_file.hpp"
#include "io/number_text.hpp"
#include "model/initial.hpp"
#include "run/host/fingerprint.hpp"
#include "run/host/saved_run.hpp"
#include "solver/direct/host/packed_block.hpp"

namespace softwet {
namespace {

/// What the memory of a scheme fits to: the settings of the solver, and how this program builds preconditioners. The
/// number at the beginning is raised when the schemes visit something else.
std::string memory_settings(const Case& c) {
  return "memory 2, algorithms of a " + std::string(host_algorithms ? "processor" : "device") + ", factors of " +
         std::to_string(sizeof(FactorNumber)) + " bytes\n" + solver_settings(c);
}

/// Writes what a scheme remembers. All processes collect it, and the first one has the file.
template <int D>
class MemoryToFile final : public StepMemory {
 public:
  MemoryToFile(const Layout<D>& layout, std::optional<CheckpointWriter>& file) : layout_(layout), file_(file) {}

  bool restores() const override { return false; }
  void number(const std::string& name, double& value) override {
    on_root([&] { file_->value(SavedMemory::name(name), value); });
  }
  void count(const std::string& name, int& value) override {
    on_root([&] { file_->value(SavedMemory::name(name), value); });
  }
  void vector(const std::string& name, const Array& values) override {
    const std::vector<double> all = to_host_on_root(layout_, values);
    on_root([&] { file_->array(SavedMemory::name(name), all); });
  }
  void vector(const std::string& name, const ArrayOf<float>& values) override {
    const Array wide("checkpoint.wide", values.extent(0));
    convert(wide, values);
    const std::vector<double> all = to_host_on_root(layout_, wide);
    on_root([&] { file_->single_array(SavedMemory::name(name), std::vector<float>(all.begin(), all.end())); });
  }

 private:
  const Layout<D>& layout_;
  std::optional<CheckpointWriter>& file_;
};

/// Puts it back.
template <int D>
class MemoryFromFile final : public StepMemory {
 public:
  MemoryFromFile(const Layout<D>& layout, const SavedMemory& file) : layout_(layout), file_(file) {}

  bool restores() const override { return true; }
  void number(const std::string& name, double& value) override { value = file_.number(name); }
  void count(const std::string& name, int& value) override { value = file_.count(name); }
  void vector(const std::string& name, const Array& values) override {
    Kokkos::deep_copy(values, read(name, values.extent(0)));
  }
  void vector(const std::string& name, const ArrayOf<float>& values) override {
    convert(values, read(name, values.extent(0)));
  }

 private:
  Array read(const std::string& name, std::size_t stored) const {
    const double entries = entries_of_patch(layout_, static_cast<double>(stored));
    return from_patch(layout_, file_.array(name, static_cast<std::size_t>(entries)));
  }

  const Layout<D>& layout_;
  const SavedMemory& file_;
};

/// The arrays of a state under the names they have in the file.
std::vector<std::pair<std::string, Array>> arrays_of(const State& s) {
  return {{"state/unknown", s.unknown},
          {"state/velocity_rate", s.velocity_rate},
          {"state/displacement", s.displacement},
          {"state/displacement_rate", s.displacement_rate},
          {"state/moment", s.moment},
          {"state/moment_rate", s.moment_rate}};
}

/// Visits what a run has cost, in the order of the file.
template <class Visit>
void each_cost(SolverCounts& k, RunSeconds& s, const Visit& visit) {
  for (long* count : {&k.newton, &k.krylov, &k.residuals, &k.products, &k.builds, &k.applications}) visit(*count);
  for (double* seconds : {&k.residual_seconds, &k.product_seconds, &k.build_seconds, &k.apply_seconds,
                          &k.krylov_seconds, &s.setup, &s.observers, &s.output, &s.total})
    visit(*seconds);
}

std::vector<double> costs(SolverCounts& k, RunSeconds& s) {
  std::vector<double> numbers;
  each_cost(k, s, [&](auto cost) { numbers.push_back(static_cast<double>(cost)); });
  return numbers;
}

/// What the balance of the energy remembers, in the order of the file.
std::vector<double> numbers_of(const EnergyBalance& e) {
  const EnergyState& s = e.last;
  return {double(e.begun), double(e.told), e.rise, e.lost, e.fed, s.time, s.energy, s.size, s.kinetic, s.fed, s.lost};
}

EnergyBalance balance_of(const std::vector<double>& n, double moving) {
  if (n.size() != energy_numbers) return {};  // of an older program
  return {n[0] != 0, n[1] != 0, {n[5], n[6], n[7], n[8], n[9], n[10]}, n[2], n[3], n[4], moving};
}

template <int D, int P>
void write_values(CheckpointWriter& file, const Case& c, Stepper<D, P>& stepper, const HistoryMemory& history,
                  const WrittenFiles& files, RunSeconds seconds) {
  file.value("case", fingerprint(c));
  file.value("time", stepper.state().time);
  file.value("previous/dt", stepper.previous_dt());
  file.value("step_control/proposed", stepper.control().proposed());
  file.value("steps/accepted", std::int64_t(stepper.counts().steps));
  file.value("steps/rejected_newton", std::int64_t(stepper.counts().rejected_newton));
  file.value("steps/rejected_error", std::int64_t(stepper.counts().rejected_error));
  file.value("history/step", std::int64_t(history.step));
  file.value("history/time", history.time);
  file.value("history/mass_start", history.mass_start);
  std::vector<double> droplets;
  for (const DropletTrack& track : history.droplets) {
    droplets.insert(droplets.end(), track.centre.begin(), track.centre.begin() + D - 1);
    droplets.insert(droplets.end(), {track.on_wall ? 1.0 : 0.0, track.merged ? 1.0 : 0.0});
  }
  file.array("history/droplets", droplets);
  file.array("history/energy", numbers_of(history.energy));
  file.value("history/largest_kinetic_energy", history.energy.moving);
  write_watch(history.bodies, history.events, file);
  write_files(files, file);
  file.value(SavedMemory::settings, memory_settings(c));
  file.value("run/started", seconds.started);
  file.array("costs", costs(stepper.scheme().counts(), seconds));
  file.commit();
}

/// All processes read the file, and have to find the same state in it.
SavedRun read_together(const std::string& path, const Case& c, const std::vector<ArraySize>& sizes) {
  SavedRun saved;
  together([&] { saved = read_saved_run(path, c, sizes); });
  const double time = ranks::of_root(saved.time);
  together([&] {
    if (saved.time != time)
      throw Error(Exit::machine_failed, path + ": this process reads the state of time " + number_text(saved.time) +
                                            ", the first one that of " + number_text(time) +
                                            "; put the output folder where all machines see the same files");
  });
  return saved;
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
    const std::vector<double> values = to_host_on_root(stepper.model().layout(), entry.second);
    on_root([&] { file->array(entry.first, values); });
  }
  MemoryToFile<D> memory(stepper.model().layout(), file);
  stepper.scheme().visit_memory(memory, stepper.state());
  on_root([&] { write_values(*file, c, stepper, history, files, seconds); });
}

template <int D, int P>
HistoryMemory read_checkpoint(const std::string& path, const Case& c, Stepper<D, P>& stepper, WrittenFiles& files,
                              RunSeconds& seconds) {
  const Layout<D>& layout = stepper.model().layout();
  State state = empty_state(layout);
  const Array previous("previous", state.unknown.extent(0));
  auto targets = arrays_of(state);
  targets.emplace_back("previous/unknown", previous);
  std::vector<ArraySize> sizes;
  for (const auto& [name, array] : targets)
    sizes.emplace_back(name, static_cast<std::size_t>(entries_of_patch(layout, static_cast<double>(array.extent(0)))));
  SolverCounts& counts = stepper.scheme().counts();
  sizes.emplace_back("costs", costs(counts, seconds).size());
  const SavedRun saved = read_together(path, c, sizes);
  auto cost = saved.arrays.back().begin();
  each_cost(counts, seconds, [&](auto& number) { number = static_cast<std::decay_t<decltype(number)>>(*cost++); });
  state.time = saved.time;
  for (std::size_t i = 0; i < targets.size(); ++i)
    Kokkos::deep_copy(targets[i].second, from_patch(layout, saved.arrays[i]));
  stepper.restore(state, previous, saved.previous_dt, saved.proposed_dt);
  stepper.counts().steps = saved.steps;
  stepper.counts().rejected_newton = saved.rejected_newton;
  stepper.counts().rejected_error = saved.rejected_error;
  if (saved.started) seconds.started = *saved.started;
  files = saved.files;
  if (const SavedMemory memory(path); memory.fits(memory_settings(c))) {
    MemoryFromFile<D> visit(layout, memory);
    stepper.scheme().visit_memory(visit, stepper.state());
  }
  HistoryMemory history{saved.history_step,
                        saved.history_time,
                        saved.mass_start,
                        {},
                        saved.bodies,
                        saved.events,
                        balance_of(saved.energy, saved.largest_kinetic_energy)};
  for (const std::vector<double>& saved_track : saved.droplets) {
    DropletTrack track{{}, saved_track[D - 1] != 0, saved_track[D] != 0};
    std::copy_n(saved_track.begin(), D - 1, track.centre.begin());
    history.droplets.push_back(track);
  }
  return history;
}

using Steps = Stepper<SOFTWET_DIMENSION, SOFTWET_DEGREE>;
template void write_checkpoint(const std::string&, const Case&, Steps&, const HistoryMemory&, const WrittenFiles&,
                               RunSeconds);
template HistoryMemory read_checkpoint(const std::string&, const Case&, Steps&, WrittenFiles&, RunSeconds&);

}  // namespace softwet
