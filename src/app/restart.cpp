#include "app/restart.hpp"

#include "app/host/fingerprint.hpp"
#include "model/initial.hpp"
#include "observe/host/checkpoint_file.hpp"

namespace softwet {
namespace {

/// The arrays of a state under the names they have in the file.
std::vector<std::pair<std::string, Array>> arrays_of(const State& s) {
  return {{"state/unknown", s.unknown},
          {"state/velocity_rate", s.velocity_rate},
          {"state/displacement", s.displacement},
          {"state/displacement_rate", s.displacement_rate},
          {"state/moment", s.moment},
          {"state/moment_rate", s.moment_rate}};
}

void read_array(const CheckpointReader& file, const std::string& name, const Array& target) {
  Kokkos::deep_copy(target, to_device<Array>(file.array(name, target.extent(0))));
}

}  // namespace

template <int D, int P>
void write_checkpoint(const std::string& path, const Case& c, Stepper<D, P>& stepper, const HistoryMemory& history) {
  CheckpointWriter file(path);
  file.value("case", fingerprint(c));
  file.value("time", stepper.state().time);
  for (const auto& [name, array] : arrays_of(stepper.state())) file.array(name, to_host(array));
  file.array("previous/unknown", to_host(stepper.previous()));
  file.value("previous/dt", stepper.previous_dt());
  file.value("step_control/proposed", stepper.control().proposed());
  file.value("steps/accepted", std::int64_t(stepper.counts().steps));
  file.value("steps/rejected_newton", std::int64_t(stepper.counts().rejected_newton));
  file.value("steps/rejected_error", std::int64_t(stepper.counts().rejected_error));
  file.value("history/step", std::int64_t(history.step));
  file.value("history/time", history.time);
  file.value("history/mass_start", history.mass_start);
  std::vector<double> droplets;
  for (const DropletTrack& track : history.droplets)
    droplets.insert(droplets.end(), {track.centre, track.on_wall ? 1.0 : 0.0, track.merged ? 1.0 : 0.0});
  file.array("history/droplets", droplets);
  file.commit();
}

template <int D, int P>
HistoryMemory read_checkpoint(const std::string& path, const Case& c, Stepper<D, P>& stepper) {
  const CheckpointReader file(path);
  check_fingerprint(path, file.text("case"), c);
  State state = empty_state(stepper.integrator().model().layout());
  state.time = file.number("time");
  for (const auto& [name, array] : arrays_of(state)) read_array(file, name, array);
  const Array previous("previous", state.unknown.extent(0));
  read_array(file, "previous/unknown", previous);
  stepper.restore(state, previous, file.number("previous/dt"), file.number("step_control/proposed"));
  stepper.counts().steps = file.integer("steps/accepted");
  stepper.counts().rejected_newton = file.integer("steps/rejected_newton");
  stepper.counts().rejected_error = file.integer("steps/rejected_error");
  HistoryMemory history;
  history.step = file.integer("history/step");
  history.time = file.number("history/time");
  history.mass_start = file.number("history/mass_start");
  const std::vector<double> droplets = file.array("history/droplets", 3 * c.droplets.size());
  for (std::size_t k = 0; k < c.droplets.size(); ++k)
    history.droplets.push_back({droplets[3 * k], droplets[3 * k + 1] != 0, droplets[3 * k + 2] != 0});
  return history;
}

using Steps = Stepper<SOFTWET_DIMENSION, SOFTWET_DEGREE>;
template void write_checkpoint(const std::string&, const Case&, Steps&, const HistoryMemory&);
template HistoryMemory read_checkpoint(const std::string&, const Case&, Steps&);

}  // namespace softwet
