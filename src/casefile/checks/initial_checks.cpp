// Cross checks of what is there at the start: droplets, films, waves.
#include <cmath>

#include "case/cap.hpp"
#include "casefile/checks/checker.hpp"

namespace softwet {
namespace {

/// How far a droplet reaches from its centre, which is on the wall where it is a cap.
double reach_along(const Checker& check, const Droplet& droplet, std::size_t axis) {
  const double semi_axis = droplet.radius * (droplet.stretch.empty() ? 1.0 : droplet.stretch[axis]);
  if (!sits_on_wall(check.c, droplet)) return semi_axis;
  const double cosine = cap_cosine(check.c, droplet);
  if (axis == check.vertical()) return semi_axis * (1 - cosine);
  return cosine > 0 ? semi_axis * std::sqrt(1 - cosine * cosine) : semi_axis;
}

void check_centre(const Checker& check, std::size_t index) {
  const std::string centre = fmt::format("droplet[{}].centre", index);
  const Droplet& droplet = check.c.droplets[index];
  if (!check.c.fluid) check.refuse(centre, "a droplet lives in a fluid", "add a [fluid] or remove the [[droplet]]");
  check.require_axes(centre, droplet.centre.size(), "write one coordinate for each axis");
  for (std::size_t axis = 0; axis <= check.vertical(); ++axis) {
    const double bottom = axis == check.vertical() ? check.interface() : 0.0, top = check.c.domain.size[axis];
    if (droplet.centre[axis] >= bottom - slack * top && droplet.centre[axis] <= top * (1 + slack)) continue;
    check.refuse(centre, fmt::format("lies outside the fluid, which is [{}, {}] along axis {}", bottom, top, axis),
                 "move the centre; on the interface it becomes a cap");
  }
}

void check_reach(const Checker& check, std::size_t index) {
  const std::string radius = fmt::format("droplet[{}].radius", index);
  const Droplet& droplet = check.c.droplets[index];
  for (std::size_t axis = 0; axis <= check.vertical(); ++axis) {
    if (check.periodic(axis)) continue;
    const bool up = axis == check.vertical();
    const double top = check.c.domain.size[axis], x = droplet.centre[axis];
    const double reach = reach_along(check, droplet, axis);
    // A centre on a slip side is half a droplet: the side is its plane of symmetry. An axis of symmetry is not a side.
    const auto halved = [&](double side, std::size_t end) {
      const bool mirror = check.c.boundary.side[axis][end] == Side::slip;
      return (mirror || (check.c.axisymmetric() && axis + end == 0)) && std::abs(x - side) <= slack * top;
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

void check_droplet(const Checker& check, std::size_t index) {
  const std::string name = fmt::format("droplet[{}]", index);
  check.with({name + ".centre", "fluid", "substrate.thickness"}, [&] { check_centre(check, index); });
  check.with({name + ".stretch"}, [&] {
    if (const std::size_t stretches = check.c.droplets[index].stretch.size(); stretches != 0)
      check.require_axes(name + ".stretch", stretches, "write one factor for each axis, or leave it out for a circle");
  });
  check.with({name + ".velocity"}, [&] {
    if (const std::size_t numbers = check.c.droplets[index].velocity.size(); numbers != 0)
      check.require_axes(name + ".velocity", numbers,
                         "write one number for each axis, or leave it out for a droplet at rest");
  });
  check.with({name + ".centre", name + ".radius", name + ".stretch", "fluid.contact_angle",
              "fluid.wall_stretch_exponent", "fluid.ambient", "substrate.thickness", "boundary"},
             [&] { check_reach(check, index); });
}

void check_film(const Checker& check, std::size_t index) {
  const std::string box = fmt::format("film[{}].box", index);
  const Film& film = check.c.films[index];
  if (!check.c.fluid) check.refuse(box, "a film lives in a fluid", "add a [fluid] or remove the [[film]]");
  for (const Numbers& corner : {film.lower, film.upper})
    check.require_axes(box, corner.size(), "write box = [[lower corner], [upper corner]]");
  for (std::size_t axis = 0; axis < film.lower.size(); ++axis) {
    if (film.lower[axis] >= film.upper[axis])
      check.refuse(box, fmt::format("is empty along axis {}", axis), "the first corner must lie below the second");
    const double bottom = axis == check.vertical() ? check.interface() : 0.0, top = check.c.domain.size[axis];
    if (film.upper[axis] > bottom + slack * top && film.lower[axis] < top * (1 - slack)) continue;
    check.refuse(box,
                 fmt::format("is [{:.6g}, {:.6g}] along axis {}, outside of the fluid, which is [{:.6g}, {:.6g}]",
                             film.lower[axis], film.upper[axis], axis, bottom, top),
                 "move the box so that a part of it lies in the fluid, or remove the [[film]]");
  }
}

void check_field_of_wave(const Checker& check, std::size_t index) {
  const std::string field = fmt::format("wave[{}].field", index);
  const Wave& wave = check.c.waves[index];
  const bool in_solid = is_displacement(wave.field);
  if (in_solid && !check.c.substrate) check.refuse(field, "needs a solid", "add a [substrate] or choose a velocity");
  if (wave.field == WaveField::density && !check.c.fluid) check.refuse(field, "needs a fluid", "add a [fluid]");
  if (axis_of(wave.field) == 2 && check.c.dimension() == 2) {
    check.refuse(field, "exists in 3D only", "the directions of a 2D case are x and y");
  }
}

void check_mode_of_wave(const Checker& check, std::size_t index) {
  const std::string mode = fmt::format("wave[{}].mode", index);
  const Wave& wave = check.c.waves[index];
  check.require_axes(mode, wave.mode.size(), "write the number of half waves along each axis");
  for (std::size_t axis = 0; axis < wave.mode.size(); ++axis) {
    const bool even = std::fmod(wave.mode[axis], 2) == 0;
    if (std::floor(wave.mode[axis]) != wave.mode[axis] || (check.periodic(axis) && !even)) {
      check.refuse(mode,
                   fmt::format("must be a whole{} number along axis {}", check.periodic(axis) ? " even" : "", axis),
                   "the wave has to fit between the sides");
    }
  }
}

void check_given_fields(const Checker& check) {
  if (!check.c.initial) return;
  const Initial& given = *check.c.initial;
  const auto check_vector = [&](const std::string& key, const std::vector<Profile>& list) {
    check.with({key}, [&] {
      if (!list.empty()) check.require_axes(key, list.size(), "write one number or expression for each axis");
    });
  };
  check.with({"initial.density", "fluid"}, [&] {
    if (given.density && !check.c.fluid) check.refuse("initial.density", "needs a fluid", "add a [fluid] or remove it");
  });
  check.with({"initial.velocity", "fluid"}, [&] {
    if (!given.velocity.empty() && !check.c.fluid)
      check.refuse("initial.velocity", "needs a fluid", "add a [fluid], or write [[wave]] for the solid");
  });
  check.with({"initial.displacement", "substrate"}, [&] {
    if (!given.displacement.empty() && !check.c.substrate)
      check.refuse("initial.displacement", "needs a solid", "add a [substrate] or remove it");
  });
  check.with({"initial.time", "initial.from"}, [&] {
    if (given.time.size() > 1) check.refuse("initial.time", "must be one time", "write for example time = 235.0");
    if (!given.time.empty() && given.from.empty())
      check.refuse("initial.time", "belongs to initial.from", "write from = \"out/...\", the folder of an earlier run");
  });
  check_vector("initial.velocity", given.velocity);
  check_vector("initial.displacement", given.displacement);
}

}  // namespace

void check_initial(const Checker& check) {
  check_given_fields(check);
  for (std::size_t i = 0; i < check.c.droplets.size(); ++i) check_droplet(check, i);
  for (std::size_t i = 0; i < check.c.films.size(); ++i)
    check.with({fmt::format("film[{}].box", i), "fluid", "substrate.thickness"}, [&] { check_film(check, i); });
  for (std::size_t i = 0; i < check.c.waves.size(); ++i) {
    check.with({fmt::format("wave[{}].field", i), "fluid", "substrate"}, [&] { check_field_of_wave(check, i); });
    check.with({fmt::format("wave[{}].mode", i), "boundary"}, [&] { check_mode_of_wave(check, i); });
  }
  check.with({"fluid.initial"}, [&] {
    if (!check.c.fluid || check.c.fluid->initial.empty()) return;
    const auto& rho = check.c.fluid->initial;
    if (rho.size() == 2 && rho[0] <= rho[1]) return;
    check.refuse("fluid.initial", "must be 2 increasing numbers, the densities of vapour and liquid",
                 "write for example initial = [0.1, 0.6]");
  });
}

}  // namespace softwet
