#include "app/restart.hpp"

#include <sstream>

#include "app/error.hpp"
#include "app/host/case_file.hpp"
#include "model/initial.hpp"
#include "observe/host/checkpoint_file.hpp"

namespace softwet {
namespace {

bool starts_with(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

/// What a resumed run may change.
bool may_change(const std::string& key) {
  if (starts_with(key, "name") || starts_with(key, "output.") || starts_with(key, "solver.")) return true;
  return starts_with(key, "time.") && !starts_with(key, "time.scheme") && !starts_with(key, "time.rho_inf");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string key_of(const std::string& line) { return line.substr(0, line.find(" = ")); }
std::string value_of(const std::string& line) {
  const std::size_t place = line.find(" = ");
  return place == std::string::npos ? line : line.substr(place + 3);
}

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

std::string fingerprint(const Case& c) {
  std::string text, table;
  int entry = 0;
  for (const std::string& line : lines_of(write_case(c))) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '[') {
      const bool repeated = line[1] == '[';
      const std::string name = repeated ? line.substr(2, line.find(']') - 2) : line.substr(1, line.find(']') - 1);
      entry = repeated && starts_with(table, name + "[") ? entry + 1 : 0;
      table = repeated ? name + "[" + std::to_string(entry) + "]." : name + ".";
    } else if (!may_change(table + line)) {
      text += table + line + "\n";
    }
  }
  return text;
}

void check_fingerprint(const std::string& path, const std::string& stored, const Case& c) {
  const std::vector<std::string> then = lines_of(stored), now = lines_of(fingerprint(c));
  const std::string remedy = "; resume with the case of the checkpoint, or start anew in another folder with --out";
  const auto refuse = [&](const std::string& difference) {
    throw Error(Exit::invalid_input, path + ": the checkpoint belongs to another case: " + difference + remedy);
  };
  for (std::size_t i = 0; i < std::max(then.size(), now.size()); ++i) {
    if (i >= now.size()) refuse(key_of(then[i]) + " was " + value_of(then[i]) + " and is missing now");
    if (i >= then.size()) refuse(key_of(now[i]) + " was not set and is " + value_of(now[i]) + " now");
    if (then[i] == now[i]) continue;
    if (key_of(then[i]) != key_of(now[i]))
      refuse("it had " + key_of(then[i]) + " where this one has " + key_of(now[i]));
    refuse(key_of(now[i]) + " was " + value_of(then[i]) + " and is " + value_of(now[i]) + " now");
  }
}

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

template void write_checkpoint<2, 2>(const std::string&, const Case&, Stepper<2, 2>&, const HistoryMemory&);
template HistoryMemory read_checkpoint<2, 2>(const std::string&, const Case&, Stepper<2, 2>&);

}  // namespace softwet
