#include "run/earlier_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "case/error.hpp"
#include "case/text.hpp"
#include "casefile/case_file.hpp"
#include "field/together.hpp"
#include "io/checkpoint_file.hpp"
#include "io/field_file.hpp"
#include "run/host/earlier_losses.hpp"
#include "scene/earlier_state.hpp"
#include "scene/patch_axes.hpp"

namespace softwet {
namespace {

std::string box_text(const Case& c) {
  std::string text;
  for (const double size : c.domain.size) text += (text.empty() ? "" : " x ") + short_text(size, 6);
  return text;
}

void require_same_box(const Case& now, const Case& then) {
  const auto same = [&](double a, double b) { return std::abs(a - b) <= 1e-9 * now.domain.size.back(); };
  if (now.domain.coordinates != then.domain.coordinates)
    throw Error(Exit::invalid_input, "initial.from = \"" + now.initial->from +
                                         "\": that run has domain.coordinates = \"" + word_of(then.domain.coordinates) +
                                         "\", this case has another value; write the same");
  bool equal = now.dimension() == then.dimension() && same(now.wall_height(), then.wall_height());
  for (int d = 0; d < now.dimension() && equal; ++d) equal = same(now.domain.size[d], then.domain.size[d]);
  if (equal) return;
  throw Error(Exit::invalid_input, "initial.from = \"" + now.initial->from + "\": the box of that run is " +
                                       box_text(then) + " with the wall at " + short_text(then.wall_height(), 6) +
                                       ", this one is " + box_text(now) + " with the wall at " +
                                       short_text(now.wall_height(), 6) +
                                       "; write the same domain.size and substrate.thickness");
}

EarlierState read_state(const std::string& folder, const Case& c) {
  EarlierState state;
  state.has_fluid = c.fluid.has_value();
  state.has_solid = c.substrate.has_value();
  state.solid_elements = solid_elements(c);
  std::size_t row_size = 1;
  for (int d = 0; d < c.dimension(); ++d) {
    state.axis.push_back(axis_of(c, d, c.domain.degree));
    if (d + 1 < c.dimension()) row_size *= state.axis[d].functions();
  }
  const Axis& vertical = state.axis.back();
  const std::size_t rows = vertical.functions(), dimension = c.dimension();
  const std::size_t wall = !state.has_solid ? 0 : state.has_fluid ? vertical.span(state.solid_elements) : rows - 1;
  const CheckpointReader file(folder + "/checkpoint.h5", CheckpointReader::format_of_states);
  state.unknown =
      file.array("state/unknown", row_size * (dimension * rows + (state.has_fluid ? 2 * (rows - wall) : 0)));
  if (state.has_solid) state.displacement = file.array("state/displacement", row_size * dimension * (wall + 1));
  return state;
}

/// Number of the field file of a time. Throws Error (invalid_input) where there is none.
std::size_t number_of_time(const std::string& folder, const std::string& part, double time) {
  const std::vector<double> times = field_file_times(folder + "/fields", part);
  for (std::size_t i = 0; i < times.size(); ++i)
    if (std::abs(times[i] - time) <= 1e-9 * std::max(1.0, std::abs(time))) return i;
  std::string known;
  for (double t : times) known += (known.empty() ? "" : ", ") + short_text(t, 10);
  throw Error(Exit::invalid_input,
              "initial.time = " + short_text(time, 10) + ": " + folder +
                  (known.empty() ? " has no field files; run it with output.fields.times"
                                 : " has field files of the times " + known + "; write one of them"));
}

/// The field file of one material as control values, component by component.
class FieldsOfPart {
 public:
  FieldsOfPart(const std::string& folder, const std::string& part, double time, const std::vector<Axis>& axes, int low,
               int high)
      : path_(folder + "/fields/" + field_file_name(part, number_of_time(folder, part, time))),
        axes_(axes),
        low_(low),
        high_(high) {}

  /// @param components  of the field in the file, of which one is taken
  std::vector<double> component(const std::string& field, int components, int which) const {
    std::vector<double> all = read_field(path_, field);
    std::size_t points_of_row = 1;
    for (std::size_t d = 0; d + 1 < axes_.size(); ++d) points_of_row *= 2 * axes_[d].elements() + 1;
    const std::size_t points = points_of_row * (2 * (high_ - low_) + 1), row = points_of_row * components;
    if (const int joint = axes_.back().joint() - low_; joint > 0 && all.size() == points * components + row)
      all.erase(all.begin() + 2 * joint * row, all.begin() + (2 * joint + 1) * row);  // its points are there twice
    if (all.size() != points * components)
      throw Error(
          Exit::invalid_input,
          path_ + ": does not have the mesh of case.toml; leave out initial.time to begin from the last checkpoint");
    std::vector<double> one;
    for (std::size_t i = which; i < all.size(); i += components) one.push_back(all[i]);
    return control_values_of_samples(axes_, low_, high_, one);
  }

 private:
  std::string path_;
  const std::vector<Axis>& axes_;
  int low_, high_;
};

/// The state at the time of a field file. At the wall both materials have one velocity.
EarlierState read_fields(const std::string& folder, const Case& c, double time) {
  EarlierState state;
  state.has_fluid = c.fluid.has_value();
  state.has_solid = c.substrate.has_value();
  state.solid_elements = solid_elements(c);
  for (int d = 0; d < c.dimension(); ++d) state.axis.push_back(axis_of(c, d, 2));
  const int elements = state.axis.back().elements(), wall = state.has_fluid ? state.solid_elements : elements;
  std::size_t row_size = 1;
  for (int d = 0; d + 1 < c.dimension(); ++d) row_size *= state.axis[d].functions();
  std::optional<FieldsOfPart> fluid, solid;
  if (state.has_fluid) fluid.emplace(folder, "fluid", time, state.axis, state.has_solid ? wall : 0, elements);
  if (state.has_solid) solid.emplace(folder, "solid", time, state.axis, 0, wall);
  const auto append = [](std::vector<double>& to, const std::vector<double>& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  for (int d = 0; d < c.dimension(); ++d) {
    if (solid) append(state.unknown, solid->component("velocity", 3, d));
    if (solid && fluid) state.unknown.resize(state.unknown.size() - row_size);
    if (fluid) append(state.unknown, fluid->component("velocity", 3, d));
  }
  if (fluid) append(state.unknown, fluid->component("density", 1, 0));
  if (fluid) append(state.unknown, fluid->component("chemical_potential", 1, 0));
  for (int d = 0; d < c.dimension() && solid; ++d) append(state.displacement, solid->component("displacement", 3, d));
  return state;
}

}  // namespace

Case with_earlier_run(const Case& given, const std::function<void(const std::string&)>& warn) {
  Case c = given;
  if (!c.initial || c.initial->from.empty()) return c;
  const std::string& folder = c.initial->from;
  together([&] {
    try {
      const Case then = read_scene(folder + "/case.toml");
      require_same_box(c, then);
      const std::vector<double>& time = c.initial->time;
      c.initial->earlier =
          std::make_shared<EarlierState>(time.empty() ? read_state(folder, then) : read_fields(folder, then, time[0]));
      if (!warn) return;
      for (const std::string& sentence : losses_of_earlier(c, then, folder)) warn(sentence);
    } catch (const Error& error) {
      const std::string message = error.what();
      if (message.rfind("initial.", 0) == 0) throw;
      throw Error(error.code(), "initial.from = \"" + folder + "\": " + message);
    }
  });
  return c;
}

}  // namespace softwet
