// Cross checks of a resolved case.
#include "app/host/case_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "app/cap.hpp"
#include "app/error.hpp"
#include "app/host/field_times.hpp"
#include "app/host/memory.hpp"
#include "observe/host/field_table.hpp"

namespace softwet {
namespace {

constexpr double slack = 1e-9;  ///< lengths closer than this (relative to the domain) are equal

/// A resolved case together with the places of its keys, for messages.
struct Checker {
  const Case& c;
  const Document& document;

  [[noreturn]] void refuse(const std::string& key, const std::string& problem, const std::string& remedy) const {
    const auto found = document.entries.find(key);
    if (found != document.entries.end()) reject(found->second.place, key, found->second.text, problem, remedy);
    const auto table = document.table_place.find(key.substr(0, key.find('.')));
    reject(table == document.table_place.end() ? document.place : table->second, key, "", problem, remedy);
  }
  std::size_t vertical() const { return c.domain.size.size() - 1; }
  double height() const { return c.domain.size.back(); }
  double element_height() const { return height() / c.domain.elements.back(); }
  double interface() const { return c.substrate ? c.substrate->thickness : 0.0; }
  bool periodic(std::size_t axis) const { return c.boundary.side[axis][0] == Side::periodic; }
};

void check_name(const Checker& check) {
  const std::string& name = check.c.name;
  const bool plain = std::all_of(name.begin(), name.end(), [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_' || letter == '-' || letter == '.';
  });
  if (plain && !name.empty() && name.front() != '.') return;
  check.refuse("name", "must be letters, digits, '_', '-' or '.'", "it names the output folder, for example droplet_1");
}

void check_domain(const Checker& check) {
  const Domain& domain = check.c.domain;
  if (domain.size.size() != 2 && domain.size.size() != 3) {
    check.refuse("domain.size", "must be 2 numbers (2D) or 3 (3D)", "write for example size = [1.0, 0.5]");
  }
  if (domain.elements.size() != domain.size.size()) {
    check.refuse("domain.elements", fmt::format("must be {} numbers, as many as domain.size", domain.size.size()),
                 "write one number of elements for each axis");
  }
  if (constexpr double most = std::numeric_limits<int>::max(); most_unknowns(check.c) > most) {
    check.refuse("domain.elements",
                 fmt::format("asks for {:.3g} unknowns, softwet numbers {:.0f}", most_unknowns(check.c), most),
                 "take fewer elements");
  }
}

const std::string& side_name(std::size_t axis, std::size_t end, std::size_t vertical) {
  static const std::string names[3][2] = {
      {"boundary.left", "boundary.right"}, {"boundary.front", "boundary.back"}, {"boundary.bottom", "boundary.top"}};
  return names[axis == vertical ? 2 : axis][end];
}

void check_boundary(const Checker& check) {
  const std::size_t vertical = check.vertical();
  if (check.c.dimension() == 2) {
    for (const char* key : {"boundary.front", "boundary.back"}) {
      if (check.document.entries.count(key)) check.refuse(key, "exists in 3D only", "remove it from this 2D case");
    }
  }
  for (std::size_t axis = 0; axis <= vertical; ++axis) {
    const auto& [low, high] = check.c.boundary.side[axis];
    for (std::size_t end : {0, 1}) {
      const bool touches_fluid = check.c.fluid && (axis != vertical || end == 1 || !check.c.substrate);
      if (touches_fluid && check.c.boundary.side[axis][end] == Side::free)
        check.refuse(side_name(axis, end, vertical), "a side of the fluid cannot be free: it is closed to mass",
                     "write slip or no_slip");
    }
    if (low != Side::periodic && high != Side::periodic) continue;
    const std::string &low_name = side_name(axis, 0, vertical), &high_name = side_name(axis, 1, vertical);
    if (low != high) {
      const bool low_is = low == Side::periodic;
      check.refuse(low_is ? low_name : high_name, "a periodic side needs a periodic partner",
                   fmt::format("write {} = \"periodic\" too", low_is ? high_name : low_name));
    }
    if (axis == vertical && check.c.substrate) {
      check.refuse(high_name, "the vertical axis cannot be periodic with a substrate",
                   "write no_slip for the top and slip for the bottom");
    }
    const int least = 2 * check.c.domain.degree + 1;
    if (check.c.domain.elements[axis] < least) {
      check.refuse("domain.elements", fmt::format("a periodic axis needs {} elements or more", least),
                   fmt::format("axis {} has {}", axis, check.c.domain.elements[axis]));
    }
  }
}

void check_substrate(const Checker& check) {
  const double thickness = check.c.substrate->thickness, height = check.height(), row = check.element_height();
  if (!check.c.fluid) {
    if (std::abs(thickness - height) <= slack * height) return;
    check.refuse("substrate.thickness", "must equal the domain height: without a [fluid] the domain is the solid alone",
                 fmt::format("write thickness = {} or add a [fluid]", height));
  }
  if (thickness >= height * (1 - slack)) {
    check.refuse("substrate.thickness", fmt::format("must be in (0, {}), below the domain height", height),
                 "leave room for the fluid, or remove [fluid] for a solid alone");
  }
  const double rows = thickness / row;
  if (std::abs(rows - std::round(rows)) * row <= slack * height && std::round(rows) >= 1) return;
  const double below = std::max(1.0, std::floor(rows)) * row, above = std::max(1.0, std::ceil(rows)) * row;
  const std::string choice =
      below == above ? fmt::format("{:.10g}", below) : fmt::format("{:.10g} or {:.10g}", below, above);
  check.refuse("substrate.thickness", fmt::format("must be a multiple of the element height {:.10g}", row),
               fmt::format("write thickness = {}, or change domain.elements", choice));
}

void check_load(const Checker& check, std::size_t index) {
  const std::string box = fmt::format("load[{}].box", index), force = fmt::format("load[{}].force", index);
  const Load& load = check.c.loads[index];
  if (!check.c.substrate) check.refuse(box, "a load acts on the solid", "add a [substrate] or remove the [[load]]");
  const std::size_t dimension = check.c.domain.size.size();
  const std::string numbers = fmt::format("{} numbers, as many as domain.size", dimension);
  if (load.lower.size() != dimension || load.upper.size() != dimension) {
    check.refuse(box, "each corner must be " + numbers, "write box = [[lower corner], [upper corner]]");
  }
  if (load.force.size() != dimension) {
    check.refuse(force, "must be " + numbers, "write one component for each axis, the last is vertical");
  }
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    const double top = axis == check.vertical() ? check.c.substrate->thickness : check.c.domain.size[axis];
    if (load.lower[axis] >= load.upper[axis]) {
      check.refuse(box, fmt::format("is empty along axis {}", axis), "the first corner must lie below the second");
    }
    if (load.lower[axis] < -slack * top || load.upper[axis] > top * (1 + slack)) {
      check.refuse(box, fmt::format("lies outside the solid, which is [0, {}] along axis {}", top, axis),
                   "move or shrink the box");
    }
  }
}

/// How far a droplet reaches from its centre, which is on the wall where it is a cap.
double reach_along(const Checker& check, const Droplet& droplet, std::size_t axis) {
  const double semi_axis = droplet.radius * (droplet.stretch.empty() ? 1.0 : droplet.stretch[axis]);
  if (!sits_on_wall(check.c, droplet)) return semi_axis;
  const double cosine = cap_cosine(*check.c.fluid);
  if (axis == check.vertical()) return semi_axis * (1 - cosine);
  return cosine > 0 ? semi_axis * std::sqrt(1 - cosine * cosine) : semi_axis;
}

void check_droplet(const Checker& check, std::size_t index) {
  const std::string centre = fmt::format("droplet[{}].centre", index),
                    radius = fmt::format("droplet[{}].radius", index);
  const Droplet& droplet = check.c.droplets[index];
  if (!check.c.fluid) check.refuse(centre, "a droplet lives in a fluid", "add a [fluid] or remove the [[droplet]]");
  if (droplet.centre.size() != check.c.domain.size.size()) {
    check.refuse(centre, fmt::format("must be {} numbers, as many as domain.size", check.c.domain.size.size()),
                 "write one coordinate for each axis");
  }
  const std::size_t stretches = droplet.stretch.size();
  if (stretches != 0 && stretches != check.c.domain.size.size()) {
    check.refuse(fmt::format("droplet[{}].stretch", index),
                 fmt::format("must be {} numbers, as many as domain.size", check.c.domain.size.size()),
                 "write one factor for each axis, or leave it out for a circle");
  }
  for (std::size_t axis = 0; axis <= check.vertical(); ++axis) {
    const bool up = axis == check.vertical();
    const double bottom = up ? check.interface() : 0.0, top = check.c.domain.size[axis], x = droplet.centre[axis];
    if (x < bottom - slack * top || x > top * (1 + slack)) {
      check.refuse(centre, fmt::format("lies outside the fluid, which is [{}, {}] along axis {}", bottom, top, axis),
                   "move the centre; on the interface it becomes a cap");
    }
    if (check.periodic(axis)) continue;
    const double reach = reach_along(check, droplet, axis);
    // A centre on a slip side is half a droplet: the side is its plane of symmetry.
    const auto halved = [&](double side, std::size_t end) {
      return check.c.boundary.side[axis][end] == Side::slip && std::abs(x - side) <= slack * top;
    };
    const bool out_below = !up && x - reach < -slack * top && !halved(0, 0);
    if (!out_below && (x + reach <= top * (1 + slack) || halved(top, 1))) continue;
    const std::string& side = side_name(axis, out_below ? 0 : 1, check.vertical());
    const double room = (out_below ? x : top - x) * droplet.radius / reach;
    const std::string smaller = room > slack * top ? fmt::format("write a radius of at most {:.6g}, ", room) : "";
    check.refuse(radius, fmt::format("the droplet crosses the {} side of the domain", side.substr(side.find('.') + 1)),
                 smaller + "move the centre (on a slip side it is half a droplet), or make the side periodic");
  }
}

void check_film(const Checker& check, std::size_t index) {
  const std::string box = fmt::format("film[{}].box", index);
  const Film& film = check.c.films[index];
  if (!check.c.fluid) check.refuse(box, "a film lives in a fluid", "add a [fluid] or remove the [[film]]");
  const std::size_t dimension = check.c.domain.size.size();
  if (film.lower.size() != dimension || film.upper.size() != dimension) {
    check.refuse(box, fmt::format("each corner must be {} numbers, as many as domain.size", dimension),
                 "write box = [[lower corner], [upper corner]]");
  }
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (film.lower[axis] < film.upper[axis]) continue;
    check.refuse(box, fmt::format("is empty along axis {}", axis), "the first corner must lie below the second");
  }
}

void check_wave(const Checker& check, std::size_t index) {
  const std::string field = fmt::format("wave[{}].field", index), mode = fmt::format("wave[{}].mode", index);
  const Wave& wave = check.c.waves[index];
  const bool in_solid = wave.field.rfind("displacement", 0) == 0;
  if (in_solid && !check.c.substrate) check.refuse(field, "needs a solid", "add a [substrate] or choose a velocity");
  if (wave.field == "density" && !check.c.fluid) check.refuse(field, "needs a fluid", "add a [fluid]");
  if (wave.field.back() == 'z' && check.c.dimension() == 2) {
    check.refuse(field, "exists in 3D only", "the directions of a 2D case are x and y");
  }
  if (wave.mode.size() != check.c.domain.size.size()) {
    check.refuse(mode, fmt::format("must be {} numbers, as many as domain.size", check.c.domain.size.size()),
                 "write the number of half waves along each axis");
  }
  for (std::size_t axis = 0; axis < wave.mode.size(); ++axis) {
    const bool even = std::fmod(wave.mode[axis], 2) == 0;
    if (std::floor(wave.mode[axis]) != wave.mode[axis] || (check.periodic(axis) && !even)) {
      check.refuse(mode,
                   fmt::format("must be a whole{} number along axis {}", check.periodic(axis) ? " even" : "", axis),
                   "the wave has to fit between the sides");
    }
  }
}

void check_initial(const Checker& check) {
  for (std::size_t i = 0; i < check.c.droplets.size(); ++i) check_droplet(check, i);
  for (std::size_t i = 0; i < check.c.films.size(); ++i) check_film(check, i);
  for (std::size_t i = 0; i < check.c.waves.size(); ++i) check_wave(check, i);
  if (!check.c.fluid || check.c.fluid->initial.empty()) return;
  const auto& rho = check.c.fluid->initial;
  if (rho.size() == 2 && rho[0] <= rho[1]) return;
  check.refuse("fluid.initial", "must be 2 increasing numbers, the densities of vapour and liquid",
               "write for example initial = [0.1, 0.6]");
}

void check_time(const Checker& check) {
  const TimeControl& time = check.c.time;
  if (time.dt_min > time.dt_initial) {
    check.refuse("time.dt_initial", fmt::format("must be at least time.dt_min = {}", time.dt_min), "lower dt_min");
  }
  if (time.dt_initial > time.dt_max) {
    check.refuse(check.document.entries.count("time.dt_initial") ? "time.dt_initial" : "time.dt_max",
                 fmt::format("dt_initial = {} must be at most dt_max = {}", time.dt_initial, time.dt_max),
                 "lower dt_initial or raise dt_max");
  }
}

/// A field of a material that the case does not have cannot be written.
void check_field_names(const Checker& check) {
  for (const std::string& name : check.c.output.field_select) {
    const FieldInfo& field = field_info(name);
    if ((field.in_fluid && check.c.fluid) || (field.in_solid && check.c.substrate)) continue;
    check.refuse("output.fields.select",
                 fmt::format("{} is a field of the {}", name, field.in_solid ? "solid" : "fluid"),
                 fmt::format("add a [{}] or leave the name out", field.in_solid ? "substrate" : "fluid"));
  }
}

void check_field_times(const Checker& check) {
  const OutputControl& output = check.c.output;
  const auto& times = output.field_times;
  const double multiples = count_of_multiples(check.c), room = most_field_files - static_cast<double>(times.size());
  if (room < 0) {
    check.refuse("output.fields.times",
                 fmt::format("has {} times, at most {} are possible", times.size(), most_field_files),
                 "leave some out");
  }
  if (multiples > room) {
    check.refuse("output.fields.every",
                 fmt::format("asks for {:.3g} field files up to time.end = {}, at most {} are possible", multiples,
                             check.c.time.end, most_field_files),
                 fmt::format("write every = {:.3g} or more", 1.01 * check.c.time.end / std::max(room - 1, 1.0)));
  }
  if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end()) {
    check.refuse("output.fields.times", "must increase", "sort the times and remove repeated ones");
  }
  if (!times.empty() && times.front() < -check.c.clock_zero()) {
    check.refuse("output.fields.times",
                 fmt::format("must be at least {}, the start of the computation", -check.c.clock_zero()),
                 "zero is the start of the first load");
  }
}

void check_track(const Checker& check) {
  const std::string key = "output.history.track";
  if (!check.document.entries.count(key)) return;
  if (check.c.dimension() == 2) check.refuse(key, "exists in 3D only", "remove it: in 2D the track is the x axis");
  const std::vector<double>& track = check.c.output.track;
  if (track.size() == 2 && std::hypot(track[0], track[1]) > 0) return;
  check.refuse(key, "must be 2 numbers, not both 0", "write a horizontal direction, for example track = [1, 1]");
}

}  // namespace

void check_case(const Case& c, const Document& document) {
  const Checker check{c, document};
  if (!c.fluid && !c.substrate) {
    throw Error(Exit::invalid_input,
                fmt::format("{}: there is neither [fluid] nor [substrate]; add the table of at least "
                            "one material, see 'softwet explain fluid'",
                            document.place));
  }
  check_name(check);
  check_domain(check);
  check_boundary(check);
  if (c.substrate) check_substrate(check);
  for (std::size_t i = 0; i < c.loads.size(); ++i) check_load(check, i);
  check_initial(check);
  check_time(check);
  check_field_times(check);
  check_field_names(check);
  check_track(check);
}

}  // namespace softwet
