// A checkpoint built from the input, object by object: left out, of another type, of another shape, with other numbers.
//
// Properties: nothing but an Error of bad input comes out, and its message names the file; a run that is accepted has
// the sizes asked for, finite numbers, times and counts that are not negative, and a step size above zero. The same holds for
// what an explicit scheme remembers (its vectors, and the rates that bound its step) and for a preconditioner's age.
#include <fuzzer/FuzzedDataProvider.h>
#include <hdf5.h>

#include <cmath>
#include <limits>

#include "casefile/case_file.hpp"
#include "io/hdf5_file.hpp"
#include "property.hpp"
#include "run/host/fingerprint.hpp"
#include "run/host/saved_run.hpp"

namespace softwet {
namespace {

const Case& small_case() {
  static const Case c = parse_case(initial_case("tensotaxis_pull_2d"), "case.toml", {"domain.elements=[4,4]"});
  return c;
}

const std::vector<ArraySize> arrays{{"state/unknown", 24},
                                    {"state/velocity_rate", 12},
                                    {"state/displacement", 8},
                                    {"state/moment", 6},
                                    {"previous/unknown", 24}};
const char* const reals[] = {"time",         "previous/dt",        "step_control/proposed",
                             "history/time", "history/mass_start", "run/started"};
const char* const counts[] = {"steps/accepted",      "steps/rejected_newton", "steps/rejected_error",   "history/step",
                              "files/history/bytes", "files/history/rows",    "files/history/checksum", "files/fields"};

// What schemes remember: kick_drift, the Runge-Kutta schemes, and Newton's method.
const std::vector<ArraySize> remembered{{"kick_drift/at", 26}, {"kick_drift/pressure", 12}, {"rates/values", 26}};
const char* const remembered_reals[] = {"bound/combined", "bound/held", "newton/built_for"};
const char* const remembered_counts[] = {"bound/known", "wear/times"};
const char* const settings = "settings of a scheme";

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
  const std::string place = std::string("/texts/") + SavedMemory::settings;
  const Fate fate = any_fate(input);
  if (fate == Fate::absent) return;
  if (fate == Fate::foreign) return any_dataset(id, place, input);
  const std::string text = fate == Fate::usual ? settings : input.ConsumeRandomLengthString(30);
  file.write(place, std::vector<std::uint8_t>(text.begin(), text.end()), {text.size()});
}

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
  attribute("/", "format_version", std::int64_t{1}, input.ConsumeIntegral<std::int64_t>());
  file.make_group("/values");
  for (const char* name : reals) attribute("/values", name, 0.5, any_number(input));
  for (const char* name : counts) attribute("/values", name, std::int64_t{3}, input.ConsumeIntegral<std::int64_t>());
  for (const char* name : remembered_reals)
    attribute("/values", SavedMemory::name(name).c_str(), 0.5, any_number(input));
  for (const char* name : remembered_counts)
    attribute("/values", SavedMemory::name(name).c_str(), std::int64_t{3}, input.ConsumeIntegral<std::int64_t>());
  for (const auto& [name, size] : arrays) write_array(file, id, name, size, input);
  for (const auto& [name, size] : remembered) write_array(file, id, SavedMemory::name(name), size, input);
  write_settings(file, id, input);
  write_array(file, id, "history/droplets", 3 * small_case().droplets.size(), input);
  write_array(file, id, "history/bodies", 8 * small_case().droplets.size(), input);
  write_array(file, id, "history/event_times", 1, input);
  write_array(file, id, "files/field_times", 3, input);
  if (any_fate(input) == Fate::usual) {
    const std::string events = "the droplet vanished\n";
    file.write("/texts/history/events", std::vector<std::uint8_t>(events.begin(), events.end()), {events.size()});
  }
  const Fate fate = any_fate(input);
  std::string text = fingerprint(small_case());
  if (fate == Fate::number)
    text.replace(input.ConsumeIntegralInRange<std::size_t>(0, text.size()), 3, input.ConsumeRandomLengthString(40));
  if (fate == Fate::foreign) return any_dataset(id, "/texts/case", input);
  if (fate == Fate::absent) return;
  file.write("/texts/case", std::vector<std::uint8_t>(text.begin(), text.end()), {text.size()});
}

void check_accepted(const SavedRun& run) {
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    require_property(run.arrays[i].size() == arrays[i].second, "an array has its size", arrays[i].first);
    for (double value : run.arrays[i]) require_property(std::isfinite(value), "arrays are finite", arrays[i].first);
  }
  require_property(run.time >= 0 && std::isfinite(run.time), "the time is one", std::to_string(run.time));
  require_property(run.previous_dt >= 0 && std::isfinite(run.previous_dt), "the last step is one", "");
  require_property(run.proposed_dt > 0 && std::isfinite(run.proposed_dt), "the next step is one", "");
  require_property(run.steps >= 0 && run.rejected_newton >= 0 && run.rejected_error >= 0 && run.history_step >= 0,
                   "counts are not negative", "");
  require_property(std::isfinite(run.mass_start) && run.history_time >= 0, "the history is one", "");
  for (const auto& droplet : run.droplets) require_property(std::isfinite(droplet[0]), "a droplet has a place", "");
  for (const Body& body : run.bodies)
    require_property(std::isfinite(body.place[0]) && body.touched < 64, "a body has a place", "");
  for (const Event& event : run.events) require_property(std::isfinite(event.time), "an event has a time", event.what);
  require_property(std::isfinite(run.started.value_or(0)), "the start is a time", "");
  for (double t : run.files.field_times.value_or(std::vector<double>()))
    require_property(std::isfinite(t), "a time is one", "");
}

void check_memory(const SavedMemory& memory) {
  if (!memory.fits(settings)) return;
  for (const char* name : remembered_reals)
    require_property(std::isfinite(memory.number(name)), "what is remembered is finite", name);
  for (const char* name : remembered_counts)
    require_property(memory.count(name) >= 0, "what is counted is not negative", name);
  for (const auto& [name, size] : remembered) {
    const std::vector<double> values = memory.array(name, size);
    require_property(values.size() == size, "what is remembered has its size", name);
    for (double value : values) require_property(std::isfinite(value), "what is remembered is finite", name);
  }
}

}  // namespace
}  // namespace softwet

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace softwet;
  static const ScratchFile scratch(".h5");
  FuzzedDataProvider input(data, size);
  write_file(scratch.path(), input);
  only_bad_input(scratch.path(), [&] { check_accepted(read_saved_run(scratch.path(), small_case(), arrays)); });
  only_bad_input(scratch.path(), [&] { check_memory(SavedMemory(scratch.path())); });
  return 0;
}
