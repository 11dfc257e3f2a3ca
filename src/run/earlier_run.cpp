#include "run/earlier_run.hpp"

#include <cmath>

#include "case/error.hpp"
#include "case/text.hpp"
#include "casefile/case_file.hpp"
#include "field/together.hpp"
#include "io/checkpoint_file.hpp"
#include "model/earlier_state.hpp"
#include "model/patch_axes.hpp"

namespace softwet {
namespace {

double height_of_wall(const Case& c) { return c.substrate ? c.substrate->thickness : 0; }

std::string box_text(const Case& c) {
  std::string text;
  for (const double size : c.domain.size) text += (text.empty() ? "" : " x ") + short_text(size, 6);
  return text;
}

void require_same_box(const Case& now, const Case& then) {
  const auto same = [&](double a, double b) { return std::abs(a - b) <= 1e-9 * now.domain.size.back(); };
  if (now.domain.coordinates != then.domain.coordinates)
    throw Error(Exit::invalid_input, "initial.from = \"" + now.initial->from +
                                         "\": that run has domain.coordinates = \"" +
                                         words_of(Coordinates{})[static_cast<int>(then.domain.coordinates)] +
                                         "\", this case has another value; write the same");
  bool equal = now.dimension() == then.dimension() && same(height_of_wall(now), height_of_wall(then));
  for (int d = 0; d < now.dimension() && equal; ++d) equal = same(now.domain.size[d], then.domain.size[d]);
  if (equal) return;
  throw Error(Exit::invalid_input, "initial.from = \"" + now.initial->from + "\": the box of that run is " +
                                       box_text(then) + " with the wall at " + short_text(height_of_wall(then), 6) +
                                       ", this one is " + box_text(now) + " with the wall at " +
                                       short_text(height_of_wall(now), 6) +
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
  const CheckpointReader file(folder + "/checkpoint.h5");
  state.unknown =
      file.array("state/unknown", row_size * (dimension * rows + (state.has_fluid ? 2 * (rows - wall) : 0)));
  if (state.has_solid) state.displacement = file.array("state/displacement", row_size * dimension * (wall + 1));
  return state;
}

}  // namespace

Case with_earlier_run(const Case& given) {
  Case c = given;
  if (!c.initial || c.initial->from.empty()) return c;
  const std::string& folder = c.initial->from;
  together([&] {
    try {
      const Case then = read_case(folder + "/case.toml");
      require_same_box(c, then);
      c.initial->earlier = std::make_shared<EarlierState>(read_state(folder, then));
    } catch (const Error& error) {
      const std::string message = error.what();
      if (message.rfind("initial.from", 0) == 0) throw;
      throw Error(error.code(), "initial.from = \"" + folder + "\": " + message);
    }
  });
  return c;
}

}  // namespace softwet
