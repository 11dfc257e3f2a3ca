// Schema, fourth part: probes and output.
#include "casefile/schema/binding.hpp"
#include "casefile/schema/schema.hpp"
#include "observe/host/field_table.hpp"
#include "observe/host/probe_quantity.hpp"

namespace softwet {
namespace {

std::vector<Key> probe_keys() {
  return {
      {.name = "probe[].name",
       .kind = Kind::text,
       .letters = "_",
       .first = "A-Za-z",
       .required = true,
       .example = "\"ridge_height\"",
       .help = "Name of the column of history.csv. It begins with a letter, and no other column has it.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.probes[i].name; })},
      {.name = "probe[].quantity",
       .kind = Kind::choice,
       .choices = probe_quantities(),
       .required = true,
       .example = "\"displacement_y\"",
       .help = "The recorded quantity: a field of the field files (softwet explain fields), or a component of one.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.probes[i].quantity; })},
      {.name = "probe[].point",
       .kind = Kind::numbers,
       .unit = "L0",
       .lengths = of_axes_or_none(),
       .example = "[0.5, 0.125]",
       .help = "Position in the undeformed domain: in the solid it moves with the material, in the fluid with the "
               "mesh, which follows the wall below it and rests at the top. Write a point or a box.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.probes[i].point; }),
       .default_note = "[], none"},
      {.name = "probe[].box",
       .kind = Kind::box,
       .unit = "L0",
       .lengths = of_axes_or_none(),
       .help = "Lower and upper corner of a box in the undeformed domain. Where both are equal along an axis, it is a "
               "face, a line or a point.",
       .bind = box_of([](Case & c, std::size_t i) -> auto& { return c.probes[i]; }),
       .default_note = "[[], []], none"},
      {.name = "probe[].operation",
       .kind = Kind::choice,
       .choices = words_of(ProbeOperation{}),
       .help =
           "How the quantity is reduced: its value at a point, or its mean, its integral, its largest or smallest "
           "value over a box. Integrals and means are over the undeformed box in the solid and over the deformed one "
           "in the fluid; in axisymmetric scenes over the whole turn, which makes a face of a line and a circle of a "
           "point, but on the axis itself a line stays a line and a point a point. Largest and smallest values are "
           "taken over five points of each element along each axis. At substrate.joint strains and stresses may jump: "
           "a box has the values of its own side, and what lies on the joint has the values from above.",
       .bind = at([](Case & c, std::size_t i) -> auto& { return c.probes[i].operation; })},
  };
}

std::vector<Key> files_keys() {
  return {
      {.name = "output.history.every",
       .kind = Kind::integer,
       .range = {1, 1e9, false, false},
       .help = "A row of history.csv after every so many accepted steps.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.output.history_every; }),
       .default_note = "1; 10 with an explicit time.scheme, whose steps are short and cheap"},
      {.name = "output.history.track",
       .kind = Kind::numbers,
       .range = {-1e30, 1e30, false, false},
       .lengths = {2},
       .help = "Horizontal direction [x, y] along which droplets are followed in 3D: their velocity, contact points "
               "and angles. Only the direction counts, not the length.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.output.track; }),
       .only_in = 3,
       .default_note =
           "the horizontal line along which the loads act: the sum of their forces, where a force that points against "
           "the sum of those before it counts with the opposite sign; [1, 0] without a load"},
      {.name = "output.fields.times",
       .kind = Kind::times,
       .unit = "L0/sqrt(ab)",
       .example = "[0.0, 235.0, 471.0, 1884.0]",
       .help = "Times t, in increasing order, at which the fields and the rows of interface.csv are written. Negative "
               "times lie before the first load. An entry may be a range: \"0:5:11\" means 11 times from 0 to 5.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.output.field_times; })},
      {.name = "output.fields.every",
       .unit = "L0/sqrt(ab)",
       .range = {0, infinity, false, true},
       .help = "Interval of time t between field files, counted from t = 0 up to time.end, beside those of "
               "output.fields.times. 0 means none.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.output.field_every; })},
      {.name = "output.fields.select",
       .kind = Kind::names,
       .choices = field_names(),
       .help = "Names of the fields that the field files hold. Without names they hold all fields.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.output.field_select; })},
      {.name = "output.checkpoint.minutes",
       .unit = "minutes of wall time",
       .range = positive,
       .help = "Wall time between two checkpoints.",
       .bind = at([](Case & c, std::size_t) -> auto& { return c.output.checkpoint_minutes; })},
  };
}

}  // namespace

std::vector<Key> output_keys() {
  std::vector<Key> keys = probe_keys();
  for (Key& key : files_keys()) keys.push_back(std::move(key));
  return keys;
}

}  // namespace softwet
