// A checkpoint built from the input, object by object: left out, of another type, of another shape, with other numbers.
//
// Properties: nothing but an Error of bad input comes out, and its message names the file; a run that is accepted has
// the requested sizes, finite numbers, times and counts that are not negative, and a step size above zero. The memory
// of an explicit scheme (its vectors, and the rates that bound its step) and the age of a preconditioner obey the same
// rules.
#include <fuzzer/FuzzedDataProvider.h>
#include <hdf5.h>

#include <cmath>
#include <limits>

#include "casefile/case_file.hpp"
#include "io/hdf5_file.hpp"
#include "property.hpp"
#include "run/host/checkpoint_entries.hpp"
#include "run/host/fingerprint.hpp"

namespace softwet {
namespace {

const Case& small_case() {
  static const Case c = parse_case(initial_case("tensotaxis_pull_2d"), "case.toml", {"domain.elements=[4,4]"});
  return c;
}

using ArraySize = std::pair<std::string, std::size_t>;
const std::vector<ArraySize> arrays{{"state/unknown", 24},
                                    {"state/velocity_rate", 12},
                                    {"state/displacement", 8},
                                    {"state/moment", 6},
                                    {"previous/unknown", 24}};

// What schemes remember: kick_drift, the Runge-Kutta schemes, and Newton's method.
const std::vector<ArraySize> remembered{{"kick_drift/at", 26}, {"kick_drift/pressure", 12}, {"rates/values", 26}};
const char* const remembered_reals[] = {"bound/combined", "bound/held", "newton/built_for"};
const char* const remembered_counts[] = {"bound/known", "wear/times"};
const char* const settings = "settings of a scheme";
const std::string of_scheme = "memory/";

/// With the bodies of the case.
RunMemory at_start() {
  RunMemory run;
  run.proposed_dt = 0.5;
  run.history.bodies = bodies_of(small_case());
  run.history.droplets.resize(run.history.bodies.size());
  return run;
}

double any_number(FuzzedDataProvider& input) {
  const double special[] = {0.0,
                            -0.0,
                            1.0,
                            -1.0,
                            1e308,
                            -1e-308,
                            std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity(),
                            std::nan("")};
  return input.ConsumeBool() ? input.PickValueInArray(special) : input.ConsumeFloatingPoint<double>();
}

hid_t any_type(FuzzedDataProvider& input) {
  const hid_t types[] = {H5T_NATIVE_DOUBLE, H5T_NATIVE_FLOAT, H5T_NATIVE_INT64, H5T_NATIVE_UINT8,
                         H5T_C_S1,          H5T_STD_B64BE,    H5T_STD_REF_OBJ,  H5T_IEEE_F64BE};
  return input.PickValueInArray(types);
}

/// Up to three extents; a large one only where no data is written.
Hdf5Handle any_space(FuzzedDataProvider& input, bool small) {
  if (input.ConsumeBool()) return {H5Screate(input.ConsumeBool() ? H5S_SCALAR : H5S_NULL), H5Sclose};
  hsize_t extent[3];
  const int rank = input.ConsumeIntegralInRange(1, 3);
  for (int i = 0; i < rank; ++i)
    extent[i] = small ? input.ConsumeIntegralInRange<hsize_t>(0, 4) : input.ConsumeIntegral<hsize_t>();
  return {H5Screate_simple(rank, extent, nullptr), H5Sclose};
}

/// A dataset of any type and shape; without data its values are the fill value.
void any_dataset(hid_t file, const std::string& name, FuzzedDataProvider& input) {
  const bool with_data = input.ConsumeBool();
  const Hdf5Handle space = any_space(input, with_data), links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  if (!space.valid()) return;
  H5Pset_create_intermediate_group(links.get(), 1);
  const hid_t type = any_type(input);
  const Hdf5Handle dataset(H5Dcreate2(file, name.c_str(), type, space.get(), links.get(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Dclose);
  if (!dataset.valid() || !with_data) return;
  std::vector<unsigned char> bytes(64 * 16);
  input.ConsumeData(bytes.data(), bytes.size());
  H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
}

void any_attribute(hid_t file, const std::string& group, const std::string& name, FuzzedDataProvider& input) {
  const Hdf5Handle space = any_space(input, true);
  const hid_t type = any_type(input);
  const Hdf5Handle attribute(
      H5Acreate_by_name(file, group.c_str(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (!attribute.valid()) return;
  std::vector<unsigned char> bytes(64 * 16);
  input.ConsumeData(bytes.data(), bytes.size());
  H5Awrite(attribute.get(), type, bytes.data());
}

/// What becomes of one object: most stay as a run would have written them, so that the others are reached.
enum class Fate { usual, number, absent, foreign };

Fate any_fate(FuzzedDataProvider& input) {
  const int draw = input.ConsumeIntegralInRange(0, 15);
  return draw < 12 ? Fate::usual : draw == 12 ? Fate::number : draw == 13 ? Fate::absent : Fate::foreign;
}

void write_array(Hdf5File& file, hid_t id, const std::string& name, std::size_t size, FuzzedDataProvider& input) {
  const Fate fate = any_fate(input);
  if (fate == Fate::absent) return;
  if (fate == Fate::foreign) return any_dataset(id, "/arrays/" + name, input);
  std::vector<double> values(size, 0.5);
  if (fate == Fate::number && input.ConsumeBool()) values.resize(input.ConsumeIntegralInRange(0, 40), 0.5);
  if (fate == Fate::number && !values.empty())
    values[input.ConsumeIntegral<std::uint8_t>() % values.size()] = any_number(input);
  file.write("/arrays/" + name, values, {values.size()}, Hdf5Storage::checksummed);
}

void write_settings(Hdf5File& file, hid_t id, FuzzedDataProvider& input) {
  const std::string place = "/texts/memory/settings";
  const Fate fate = any_fate(input);
  if (fate == Fate::absent) return;
  if (fate == Fate::foreign) return any_dataset(id, place, input);
  const std::string text = fate == Fate::usual ? settings : input.ConsumeRandomLengthString(30);
  file.write(place, std::vector<std::uint8_t>(text.begin(), text.end()), {text.size()});
}

/// Writes what a run visits, entry by entry as the input decides.
class FuzzedEntries final : public RunEntries {
 public:
  FuzzedEntries(Hdf5File& file, hid_t id, FuzzedDataProvider& input) : file_(file), id_(id), input_(input) {}

  bool restores() const override { return false; }
  void number(const std::string& name, double& value) override { attribute(name, value, any_number(input_)); }
  using RunEntries::count;
  void count(const std::string& name, std::int64_t& value) override {
    attribute(name, value, input_.ConsumeIntegral<std::int64_t>());
  }
  void text(const std::string& name, std::string& value) override {
    if (any_fate(input_) == Fate::usual)
      file_.write("/texts/" + name, std::vector<std::uint8_t>(value.begin(), value.end()), {value.size()});
  }
  void numbers(const std::string& name, std::vector<double>& values) override {
    write_array(file_, id_, name, values.size(), input_);
  }
  void list(const std::string& name, std::vector<double>& values) override {
    std::int64_t size = static_cast<std::int64_t>(values.size());
    count(name + "/count", size);
    write_array(file_, id_, name + "/values", values.size(), input_);
  }
  [[noreturn]] void refuse(const std::string& name, const std::string&, const std::string&) const override {
    throw std::logic_error(name);
  }

 private:
  template <class Value>
  void attribute(const std::string& name, const Value& value, const Value& other) {
    const Fate fate = any_fate(input_);
    if (fate == Fate::foreign) any_attribute(id_, "/values", name.c_str(), input_);
    if (fate == Fate::usual) file_.write_attribute("/values", name.c_str(), value);
    if (fate == Fate::number) file_.write_attribute("/values", name.c_str(), other);
  }

  Hdf5File& file_;
  hid_t id_;
  FuzzedDataProvider& input_;
};

void write_file(const std::string& path, FuzzedDataProvider& input) {
  Hdf5File file = Hdf5File::create(path, Hdf5Format::checksummed);
  const hid_t id = file.id();
  const auto attribute = [&](const std::string& group, const char* name, const auto& value, const auto& other) {
    const Fate fate = any_fate(input);
    if (fate == Fate::foreign) any_attribute(id, group, name, input);
    if (fate == Fate::usual) file.write_attribute(group, name, value);
    if (fate == Fate::number) file.write_attribute(group, name, other);
  };
  const std::string format = "softwet checkpoint";
  attribute("/", "format", format, input.ConsumeRandomLengthString(30));
  attribute("/", "format_version", std::int64_t{2}, input.ConsumeIntegral<std::int64_t>());
  file.make_group("/values");
  FuzzedEntries entries(file, id, input);
  RunMemory run = at_start();
  run.history.events = {{0.5, "the droplet vanished"}};
  run.files.field_times = {0.5, 0.5, 0.5};
  visit(entries, run);
  for (const char* name : remembered_reals) attribute("/values", (of_scheme + name).c_str(), 0.5, any_number(input));
  for (const char* name : remembered_counts)
    attribute("/values", (of_scheme + name).c_str(), std::int64_t{3}, input.ConsumeIntegral<std::int64_t>());
  for (const auto& [name, size] : arrays) write_array(file, id, name, size, input);
  for (const auto& [name, size] : remembered) write_array(file, id, of_scheme + name, size, input);
  write_settings(file, id, input);
  const Fate fate = any_fate(input);
  std::string text = fingerprint(small_case());
  if (fate == Fate::number)
    text.replace(input.ConsumeIntegralInRange<std::size_t>(0, text.size()), 3, input.ConsumeRandomLengthString(40));
  if (fate == Fate::foreign) return any_dataset(id, "/texts/case", input);
  if (fate == Fate::absent) return;
  file.write("/texts/case", std::vector<std::uint8_t>(text.begin(), text.end()), {text.size()});
}

void check_arrays(const EntriesFromFile& file) {
  for (const auto& [name, size] : arrays) {
    const std::vector<double> values = file.array(name, size);
    require_property(values.size() == size, "an array has its size", name);
    for (double value : values) require_property(std::isfinite(value), "arrays are finite", name);
  }
}

void check_accepted(const RunMemory& run) {
  require_property(run.time >= 0 && std::isfinite(run.time), "the time is one", std::to_string(run.time));
  require_property(run.previous_dt >= 0 && std::isfinite(run.previous_dt), "the last step is one", "");
  require_property(run.proposed_dt > 0 && std::isfinite(run.proposed_dt), "the next step is one", "");
  require_property(run.steps >= 0 && run.rejected_newton >= 0 && run.rejected_error >= 0 && run.history.step >= 0,
                   "counts are not negative", "");
  require_property(std::isfinite(run.history.mass_start) && run.history.time >= 0, "the history is one", "");
  for (const DropletTrack& track : run.history.droplets)
    require_property(std::isfinite(track.centre[0]), "a droplet has a place", "");
  for (const Body& body : run.history.bodies)
    require_property(std::isfinite(body.place[0]) && (body.touched & ~all_touched) == 0, "a body has a place", "");
  for (const Event& event : run.history.events)
    require_property(std::isfinite(event.time), "an event has a time", event.what);
  for (double t : run.files.field_times) require_property(std::isfinite(t), "a time is one", "");
}

void check_memory(EntriesFromFile& file) {
  if (!file.says("memory/settings", settings)) return;
  for (const char* name : remembered_reals) {
    double value = 0;
    file.number(of_scheme + name, value);
    require_property(std::isfinite(value), "what is remembered is finite", name);
  }
  for (const char* name : remembered_counts) {
    int value = 0;
    file.count(of_scheme + name, value);
    require_property(value >= 0, "what is counted is not negative", name);
  }
  for (const auto& [name, size] : remembered)
    for (double value : file.array(of_scheme + name, size))
      require_property(std::isfinite(value), "what is remembered is finite", name);
}

}  // namespace
}  // namespace softwet

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace softwet;
  static const ScratchFile scratch(".h5");
  FuzzedDataProvider input(data, size);
  write_file(scratch.path(), input);
  only_bad_input(scratch.path(), [&] {
    EntriesFromFile file(scratch.path());
    file.require_case(small_case());
    RunMemory run = at_start();
    visit(file, run);
    check_accepted(run);
    check_arrays(file);
  });
  only_bad_input(scratch.path(), [&] {
    EntriesFromFile file(scratch.path());
    check_memory(file);
  });
  return 0;
}
