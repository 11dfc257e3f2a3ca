#include "run/host/saved_run.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "case/error.hpp"
#include "io/checkpoint_file.hpp"
#include "run/host/fingerprint.hpp"

namespace softwet {

/// Reads by name and refuses what no run of softwet writes.
class SavedEntries {
 public:
  explicit SavedEntries(const std::string& path) : path_(path), file_(path) {}

  bool has(const std::string& name) const { return file_.has(name); }
  std::string text(const std::string& name) const { return file_.text(name); }

  double number(const std::string& name) const {
    const double value = file_.number(name);
    if (!std::isfinite(value)) refuse(name, fmt::format("is {}", value), "a finite number");
    return value;
  }
  double not_negative(const std::string& name) const {
    const double value = number(name);
    if (value < 0) refuse(name, fmt::format("is {}", value), "a number in [0, inf)");
    return value;
  }
  double positive(const std::string& name) const {
    const double value = number(name);
    if (value <= 0) refuse(name, fmt::format("is {}", value), "a number in (0, inf)");
    return value;
  }
  std::int64_t count(const std::string& name) const {
    const std::int64_t value = file_.integer(name);
    if (value < 0) refuse(name, fmt::format("is {}", value), "a count, 0 or more");
    return value;
  }
  std::vector<double> array(const std::string& name, std::size_t size) const {
    std::vector<double> values = file_.array(name, size);
    for (std::size_t i = 0; i < size; ++i)
      if (!std::isfinite(values[i])) refuse(name, fmt::format("has {} at entry {}", values[i], i), "finite numbers");
    return values;
  }

  [[noreturn]] void refuse(const std::string& name, const std::string& found, const std::string& needed) const {
    throw Error(Exit::invalid_input,
                fmt::format("{}: '{}' {} where a checkpoint holds {}; put back the checkpoint.h5 that this case wrote, "
                            "or start anew without --resume",
                            path_, name, found, needed));
  }

 private:
  std::string path_;
  CheckpointReader file_;
};

namespace {

constexpr std::size_t body_numbers = 8;
const std::string body_array = "history/bodies", event_times = "history/event_times", event_texts = "history/events";

void read_bodies(const SavedEntries& file, const Case& c, SavedRun& run) {
  const std::vector<double> numbers = file.array(body_array, body_numbers * bodies_of(c).size());
  for (auto n = numbers.begin(); n != numbers.end(); n += body_numbers) {
    if (!(n[3] >= 0 && n[3] <= all_touched) || (static_cast<unsigned>(n[3]) & ~all_touched) != 0)
      file.refuse(body_array, fmt::format("has the sides {}", n[3]),
                  fmt::format("a sum of bits of {} for the sides and ends that a body has reached", all_touched));
    run.bodies.push_back({{n[0], n[1], n[2]}, static_cast<unsigned>(n[3]), n[4] != 0, n[5] != 0, n[6] != 0, n[7] != 0});
  }
}

void read_events(const SavedEntries& file, SavedRun& run) {
  std::istringstream lines(file.text(event_texts));
  for (std::string what; std::getline(lines, what);) run.events.push_back({0, what});
  const std::vector<double> times = file.array(event_times, run.events.size());
  for (std::size_t i = 0; i < times.size(); ++i) run.events[i].time = times[i];
}

const std::string history_table = "files/history", interface_table = "files/interface";
const std::string field_count = "files/fields", times_of_fields = "files/field_times";

void write_mark(const std::string& name, const TableMark& mark, CheckpointWriter& file) {
  file.value(name + "/bytes", mark.bytes);
  file.value(name + "/rows", mark.rows);
  file.value(name + "/checksum", std::int64_t{mark.checksum});
}

std::optional<TableMark> read_mark(const SavedEntries& file, const std::string& name) {
  if (!file.has(name + "/bytes")) return std::nullopt;
  return TableMark{file.count(name + "/bytes"), file.count(name + "/rows"),
                   static_cast<std::uint32_t>(file.count(name + "/checksum"))};
}

WrittenFiles read_files(const SavedEntries& file) {
  WrittenFiles files{read_mark(file, history_table), read_mark(file, interface_table), {}};
  if (file.has(field_count))
    files.field_times = file.array(times_of_fields, static_cast<std::size_t>(file.count(field_count)));
  return files;
}

}  // namespace

void write_files(const WrittenFiles& files, CheckpointWriter& file) {
  write_mark(history_table, files.history.value(), file);
  write_mark(interface_table, files.interface.value(), file);
  file.value(field_count, static_cast<std::int64_t>(files.field_times.value().size()));
  file.array(times_of_fields, files.field_times.value());
}

void write_watch(const std::vector<Body>& bodies, const std::vector<Event>& events, CheckpointWriter& file) {
  std::vector<double> numbers, times;
  for (const Body& b : bodies)
    for (double n : {b.place[0], b.place[1], b.place[2], double(b.touched), double(b.seen), double(b.on_wall),
                     double(b.left_wall), double(b.gone)})
      numbers.push_back(n);
  std::string texts;
  for (const Event& event : events) {
    times.push_back(event.time);
    texts += event.what + "\n";
  }
  file.array(body_array, numbers);
  file.array(event_times, times);
  file.value(event_texts, texts);
}

SavedRun read_saved_run(const std::string& path, const Case& c, const std::vector<ArraySize>& arrays) {
  const SavedEntries file(path);
  check_fingerprint(path, file.text("case"), c);
  SavedRun run;
  run.time = file.not_negative("time");
  for (const auto& [name, size] : arrays) run.arrays.push_back(file.array(name, size));
  run.previous_dt = file.not_negative("previous/dt");
  run.proposed_dt = file.positive("step_control/proposed");
  run.steps = file.count("steps/accepted");
  run.rejected_newton = file.count("steps/rejected_newton");
  run.rejected_error = file.count("steps/rejected_error");
  run.history_step = file.count("history/step");
  run.history_time = file.not_negative("history/time");
  run.mass_start = file.number("history/mass_start");
  const std::size_t numbers = static_cast<std::size_t>(c.dimension()) + 1;
  const std::vector<double> droplets = file.array("history/droplets", numbers * bodies_of(c).size());
  for (auto first = droplets.begin(); first != droplets.end(); first += numbers)
    run.droplets.emplace_back(first, first + numbers);
  if (file.has(body_array)) read_bodies(file, c, run);
  if (file.has(event_texts)) read_events(file, run);
  if (file.has("history/energy")) run.energy = file.array("history/energy", energy_numbers);
  if (file.has("history/largest_kinetic_energy"))
    run.largest_kinetic_energy = file.not_negative("history/largest_kinetic_energy");
  if (file.has("run/started")) run.started = file.number("run/started");
  run.files = read_files(file);
  return run;
}

SavedMemory::SavedMemory(const std::string& path) : file_(std::make_unique<SavedEntries>(path)) {}
SavedMemory::~SavedMemory() = default;

bool SavedMemory::fits(const std::string& settings_now) const {
  return file_->has(settings) && file_->text(settings) == settings_now;
}

double SavedMemory::number(const std::string& entry) const { return file_->number(name(entry)); }

int SavedMemory::count(const std::string& entry) const {
  const std::int64_t value = file_->count(name(entry));
  if (value > std::numeric_limits<int>::max())
    file_->refuse(name(entry), fmt::format("is {}", value), "a smaller count");
  return static_cast<int>(value);
}

std::vector<double> SavedMemory::array(const std::string& entry, std::size_t size) const {
  return file_->array(name(entry), size);
}

}  // namespace softwet
