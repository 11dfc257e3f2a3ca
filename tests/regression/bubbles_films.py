#!/usr/bin/env python3
"""Bubbles and films have contact lines as droplets have: columns of history.csv, angles in the liquid, velocities,
events.
usage: bubbles_films.py SOFTWET"""

import pathlib

import numpy
from _scene import check, check_true, history, record, run_file

ALOUD = ["--overwrite", "--threads", "1"]


def write(name, fluid, tables, viscosity="1/256"):
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = [0.5, 0.5], elements = [32, 32] }}
fluid = {{ viscosity = "{viscosity}", capillarity = "1/32", temperature = 0.39, wall_law = "energy", {fluid} }}
output.fields.times = []
{tables}
""")


# Half a bubble on its plane of symmetry, as the study "angle" has half a droplet.
write("bubble", 'contact_angle = 60, ambient = "liquid"',
      'time = { end = 1, start = "equilibrium" }\ndroplet = [{ centre = [0, 0], radius = 0.2 }]')
run_file("bubble.toml", "bubble", [], ALOUD)
rows = history("bubble")
check("bubble: angle in the liquid", abs(rows["angle_right"][-1] - 60), 1.5)
check_true("bubble: it ends at its plane of symmetry", (rows["x_left"] == 0).all() and numpy.isnan(rows["angle_left"]).all())
# The cap inside has 120 degrees: its foot is R sin(60) wide on either side.
check("bubble: foot", abs(rows["x_right"][-1] - 0.2 * numpy.sin(numpy.radians(60))), 0.01)
check_true("bubble: velocity", numpy.isfinite(rows["velocity"][1:]).all() and abs(rows["velocity"][-1]) < 1e-4)
check_true("bubble: no event", record("bubble")["events"] == [], str(record("bubble")["events"]))

# A film that ends on the wall draws itself together to a cap of its own area.
write("film", "contact_angle = 90", 'time = { end = 1, start = "equilibrium" }\nfilm = [{ box = [[0.1, -1], [0.4, 0.1]] }]')
message = run_file("film.toml", "film", [], ALOUD)
rows = history("film")
radius = numpy.sqrt(2 * 0.3 * 0.1 / numpy.pi)
check("film: half of its foot", abs(0.5 * (rows["x_right"][-1] - rows["x_left"][-1]) - radius), 0.01)
check("film: it stays in the middle", abs(rows["x_centre"][-1] - 0.25), 1e-4)
for side in ("left", "right"):
    check(f"film: angle_{side}", abs(rows[f"angle_{side}"][-1] - 90), 1.5)
check_true("film: velocity", abs(rows["velocity"][-1]) < 1e-4)
check_true("film: how far it moved", "; on the way the film moved by" in message, message)
check_true("film: no droplet, no column of its pressure", "laplace" not in rows)

# Droplets first, then films: one from side to side, which a droplet above it is so near that they merge, and one on the
# top.
write("both", "contact_angle = 90", """time = { end = 1 }
droplet = [{ centre = [0.2, 0.21], radius = 0.08 }]
film = [{ box = [[-1, -1], [2, 0.08]] }, { box = [[0.35, 0.42], [2, 2]] }]""", viscosity="1/20")
run_file("both.toml", "both", [], ALOUD)
rows, events = history("both"), [event["what"] for event in record("both")["events"]]
check_true("both: a droplet in the air has no contact line", numpy.isnan(rows["x_left"][0]))
check_true("both: a film from side to side", rows["x_left_2"][0] == 0 and rows["x_right_2"][0] == 0.5)
check_true("both: it has no angle there", numpy.isnan(rows["angle_left_2"]).all())
check_true("both: a film on the top has no contact line on the wall", numpy.isnan(rows["x_left_3"][0]))
check_true("both: the droplet and the film merge", events == ["the droplet and film 1 merged"], str(events))
