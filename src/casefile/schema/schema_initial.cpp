// Schema, second part: the state a run starts from.
#include "casefile/schema/binding.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {

std::vector<Key> initial_keys() {
  return {
      {.name = "droplet[].centre",
       .kind = Kind::numbers,
       .unit = "L0",
       .lengths = of_axes(),
       .required = true,
       .example = "[0.5, 0.125]",
       .source = "[?] on the interface: a cap cut at the contact angle",
       .help = "Centre of the circle or sphere. A centre on the wall makes it a cap that meets the wall at the contact "
               "angle (nearly so with stretch). A centre on a slip side makes it half a droplet.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.droplets[i].centre; })},
      {.name = "droplet[].radius",
       .unit = "L0",
       .range = positive,
       .required = true,
       .example = "0.155",
       .source = "[?]",
       .help = "Radius of the circle or sphere.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.droplets[i].radius; })},
      {.name = "droplet[].stretch",
       .kind = Kind::numbers,
       .range = positive,
       .lengths = of_axes_or_none(),
       .help = "Semi-axes over the radius: an ellipse instead of a circle.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.droplets[i].stretch; }),
       .default_note = "[], 1 along each axis"},
      {.name = "droplet[].velocity",
       .kind = Kind::numbers,
       .unit = "sqrt(ab)",
       .lengths = of_axes_or_none(),
       .help = "Velocity of the droplet at the start. It falls to 0 across the interface of the droplet.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.droplets[i].velocity; }),
       .default_note = "[], at rest"},
      {.name = "film[].box",
       .kind = Kind::box,
       .unit = "L0",
       .lengths = of_axes(),
       .required = true,
       .example = "[[0.0, 0.125], [1.0, 0.2]]",
       .help =
           "Lower and upper corner of the box of liquid. Where a face of the box lies on a side of the fluid or beyond "
           "it, the liquid touches that side.",
       .bind = box_of([](Case & c, std::size_t i) -> auto& { return c.films[i]; })},
      {.name = "wave[].field",
       .kind = Kind::choice,
       .choices = words_of(WaveField{}),
       .required = true,
       .example = "\"velocity_x\"",
       .help = "Field the wave is added to; the displacement belongs to the solid.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.waves[i].field; })},
      {.name = "wave[].amplitude",
       .required = true,
       .example = "1e-3",
       .help =
           "Amplitude of the wave, in the unit of the field. The wave is the product of cos(mode pi x / L) over the "
           "axes; along its own direction a velocity or displacement has sin where mode is not 0.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.waves[i].amplitude; })},
      {.name = "wave[].mode",
       .kind = Kind::numbers,
       .range = {0, infinity, false, true},
       .lengths = of_axes(),
       .required = true,
       .example = "[1, 0]",
       .help = "Half waves over each axis of the domain; even on a periodic one. Zeros are a uniform value.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.waves[i].mode; })},
      {.name = "initial.from",
       .kind = Kind::text,
       .help = "Output folder of an earlier run, relative to the folder in which softwet is started: its last "
               "checkpoint, or its field files of initial.time, give density, "
               "velocity and displacement at the start. Its mesh, its materials, loads and sides may differ; its "
               "box and the thickness of "
               "its solid must be the same. The other keys of [initial] take precedence.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.initial->from; }),
       .default_note = "\"\", none"},
      {.name = "initial.time",
       .kind = Kind::times,
       .unit = "L0/sqrt(ab)",
       .lengths = {0, 1},
       .help = "Time t of the earlier run at which this one begins: one of those of its field files "
               "(output.fields.times), which must have all fields. They are exact for degree 2.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.initial->time; }),
       .default_note = "[], its last checkpoint"},
      {.name = "initial.density",
       .kind = Kind::profile,
       .unit = "b",
       .range = {0, 0.999, true, false},
       .help = "Density of the fluid at the start. The control value at a point is the value there.",
       .reason = "1 is the density at which the molecules are packed",
       .bind = profile_at([](Case & c, std::size_t) -> auto& { return c.initial->density; }),
       .default_note = "\"\", from droplets and films",
       .support = Support::fluid},
      {.name = "initial.velocity",
       .kind = Kind::profiles,
       .unit = "sqrt(ab)",
       .lengths = of_axes_or_none(),
       .help = "Velocity of the fluid at the start, one number for each axis. A side that holds the fluid sets its "
               "part to 0, and "
               "a solid and its wall begin at rest.",
       .bind = profile_at([](Case & c, std::size_t) -> auto& { return c.initial->velocity; }),
       .default_note = "[], from droplets",
       .support = Support::fluid},
      {.name = "initial.displacement",
       .kind = Kind::profiles,
       .unit = "L0",
       .lengths = of_axes_or_none(),
       .help = "Displacement of the solid at the start, one number for each axis. A side that holds the solid sets its "
               "part to 0.",
       .bind = profile_at([](Case & c, std::size_t) -> auto& { return c.initial->displacement; }),
       .default_note = "[], undeformed",
       .support = Support::solid},
  };
}

}  // namespace softwet
