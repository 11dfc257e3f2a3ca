#!/usr/bin/env python3
"""Pictures of a run in three dimensions: surfaces and profiles belong to the run. usage: figures3d.py SOFTWET"""

import importlib.util
import itertools
import os
import pathlib
import subprocess
import sys

import numpy
from _scene import check, check_true, run_file, tools, write_box

try:
    import matplotlib.pyplot
except ImportError:
    print("no matplotlib, no pictures: nothing to test")
    sys.exit(0)

from softwet._drawing import output3d, scene3d  # noqa: E402

# --- a small coupled run ---------------------------------------------------------------------------------------------
TABLES = """
[substrate]
thickness = 0.1
young = 0.7554
poisson = 0.45
[[droplet]]
centre = [0.4, 0.4, 0.1]
radius = 0.3
[[load]]
box = [[0.3, 0.3, 0.0], [0.5, 0.5, 0.1]]
force = [1.0, 1.0, 0.0]
[time]
end = 0.1
[output]
fields = { times = [0.0, 0.1] }
"""
# Elements that grow from the first corner, so that indices are no multiples of places.
GRADED = """
[domain.grading]
fine = "box"
box = [[0.0, 0.0, 0.0], [0.2, 0.2, 0.4]]
coarsest = 2
ratio = 2
"""


def compute(name, elements, tables):
    """The run, its profile and its scene, after these are compared with the tables of the run."""
    write_box(name, height=0.4, elements=elements, capillarity=0.15, angle=75.0, tables=tables)
    run_file(f"{name}.toml", name)
    output = output3d.Output(name)
    check(f"{name}: the track is the line of the load", abs(output.track - 0.5 ** 0.5).max(), 1e-15)
    s, lift = output3d.profile(output, 0.1)
    check_true(f"{name}: the surface has moved", abs(lift).max() > 1e-6)

    # Points of the diagonal in interface.csv: there the profile has to have their values.
    wall = output.run.interface[0.1]
    on = wall["x_reference"] == wall["y_reference"]
    check_true(f"{name}: interface.csv has the diagonal", on.sum() == len(output.run.fields(0.1, "solid").lines[-1]))
    place = sum(wall[f"{d}_reference"][on] - 0.4 + wall[f"displacement_{d}"][on] for d in "xy") / 2 ** 0.5
    known = wall["displacement_z"][on]
    check(f"{name}: profile and interface.csv agree", abs(numpy.interp(place, s, lift) - known).max(), 1e-3 * abs(lift).max())

    # The contact line of the picture against the contact points of history.csv, and a box against points of the
    # surface.
    line = numpy.concatenate(output.contact_lines(0.1)) - 0.4
    along, across = (line[:, 0] + line[:, 1]) / 2 ** 0.5, (line[:, 0] - line[:, 1]) / 2 ** 0.5
    order = numpy.argsort(across[along > 0])
    front = numpy.interp(0, across[along > 0][order], along[along > 0][order])
    check(f"{name}: contact line and track_front agree", abs(front - output.run.history["track_front"][-1]), 1e-3)
    corner = numpy.stack([wall[f"{d}_reference"][on] for d in "xy"] + [0 * known + 0.1], axis=-1)
    moved = corner + numpy.stack([wall[f"displacement_{d}"][on] for d in "xyz"], axis=-1)
    check(f"{name}: points are carried", abs(output.carried(0.1, corner) - moved).max(), 2e-2 * abs(lift).max())
    check(f"{name}: the wall below a place", abs(output.on_wall(0.1, moved[:, :2]) - moved).max(), 2e-2 * abs(lift).max())
    return output


output = compute("small", [8, 8, 4], TABLES)
compute("graded", [16, 16, 8], TABLES + GRADED)


if importlib.util.find_spec("pyvista") is None:
    sys.exit(print("no pyvista, no pictures in 3D: python3 -m pip install pyvista") or 0)


def figures3d(*options):
    return subprocess.run([sys.executable, str(tools / "figures3d"), "small", *options], capture_output=True, text=True)


result = figures3d("--out", "small.png")
check_true("the picture is there", result.returncode == 0 and pathlib.Path("small.png").stat().st_size > 10000,
           result.stderr)
# A surface lies where the lines of matplotlib have it: the flat top of the substrate at rest fills the polygon of its
# corners.
view = scene3d.View(output.track)
axes = matplotlib.pyplot.figure().subplots()
view.render(axes, scene3d.Scene(output, 0.0, 1.0, view).mesh("solid", "displacement"), 1, color="white")
image, (left, right, low, high) = axes.images[0].get_array(), axes.images[0].get_extent()
seen = numpy.argwhere(image[..., 3] > 127)
ends = numpy.array([[left + (seen[:, 1].min()) / image.shape[1] * (right - left), left + (seen[:, 1].max() + 1) / image.shape[1] * (right - left)],
                    [high - (seen[:, 0].max() + 1) / image.shape[0] * (high - low), high - seen[:, 0].min() / image.shape[0] * (high - low)]])
corners = view.flat(numpy.array(list(itertools.product((0, 0.8), (0, 0.8), (0, 0.1)))))
check("a rendered surface is to scale and in place", abs(ends.T - [corners.min(axis=0), corners.max(axis=0)]).max(), 3e-3)
output.case["load"][0]["force"] = [0.0, 0.0, 0.0]
axes = matplotlib.pyplot.figure().subplots()
scene = scene3d.Scene(output, 0.1, 1.0, scene3d.View(output.track))
scene.draw_loads(axes)
check_true("a load without force: its box, no arrow", len(axes.lines) == 12 and not axes.texts)


def refused(message, *options):
    result = figures3d(*options)
    good = result.returncode == 1 and message in result.stderr and result.stderr.count("\n") == 1
    check_true(f"refused: {message}", good, result.stderr)


refused("no fields at t = 7", "--scenes", "7")
refused("a picture has 1 to 8", "--scenes", *9 * ["0"])
refused("--magnify nan: must be a number in [0, 1e+06]", "--magnify", "nan")
os.remove("small/fields/solid.hdf.series")
refused("there is no small/fields/solid.hdf.series")
