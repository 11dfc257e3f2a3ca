#!/usr/bin/env python3
"""tools/figures draws Figs. 1 (B), 2 and 3 from small runs, from any folder, and its tables hold what the outputs hold.
tools/plot draws a load of force 0, other fields and sections in 3D, and names the file where a folder is not whole.
usage: figures.py SOFTWET"""

import csv
import pathlib
import shutil
import subprocess
import sys

import numpy
from _scene import check, check_true, history, run, run_file, tools, write_box

try:
    import matplotlib  # noqa: F401
except ImportError:
    sys.exit(print("no matplotlib: no figure is made here"))

TOOL = tools / "figures"
SMALL = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.viscosity=1/64", "substrate.young=2"]
TIMES = {"pull": "[0,235,471,1884]", "push": "[0,1962,3924,7848]"}


def figures(words, code=0):
    result = subprocess.run([sys.executable, str(TOOL), *map(str, words)], capture_output=True, text=True, cwd="/",
                            timeout=900)
    check_true(f"figures {words[0]}: exit code {code}", result.returncode == code, result.stderr)
    return result.stderr


def drawn(words, name):
    """Draws into NAME.png and returns the rows of NAME.csv."""
    picture = pathlib.Path(name + ".png").resolve()
    picture.unlink(missing_ok=True)
    figures([*words, "--out", picture])
    check_true(f"{name}: is a picture", picture.read_bytes().startswith(b"\x89PNG"))
    with open(picture.with_suffix(".csv"), newline="") as file:
        return list(csv.DictReader(file))


here = {}
for way, times in TIMES.items():
    here[way] = pathlib.Path(f"sweep_{way}/substrate.poisson=0.45").resolve()
    run(f"tensotaxis_{way}_2d", here[way], SMALL + [f"output.fields.times={times}"])
    run(f"tensotaxis_{way}_2d", here[way].parent / "substrate.poisson=0.2",
        SMALL + ["substrate.poisson=0.2", "output.fields.times=[]", "time.end=200"])
REST = ["fluid.capillarity=1/32", "fluid.viscosity=1/64", "substrate.young=2"]
run("fig1b_soft_droplet_2d", "fig1b", REST + ["domain.elements=[64,32]", "time.end=40", "output.fields.times=[0,40]"])
run("fig1b_soft_droplet_2d", "half", REST + ["domain.size=[0.5,0.5]", "domain.elements=[32,32]", "time.end=1",
                                             "droplet[0].centre=[0,0.125]", "output.fields.times=[1]"])

rows = drawn(["fig2", "--pull", here["pull"], "--push", here["push"]], "fig2")
last = next(row for row in rows if row["run"] == "pull" and row["t"] == "1884")
check("fig2: |X_c - x_centre of history.csv|", abs(float(last["x_centre"]) - history(here["pull"])["x_centre"][-1]), 5e-5)
check("fig2: far sides against the linear estimate",
      max(abs(float(row["ratio"]) - 1) for row in rows if row["ratio"]), 0.1)

rows = drawn(["fig3", "--pull", here["pull"].parent, "--push", here["push"].parent], "fig3")
check_true("fig3: falling Poisson ratio", [row["poisson"] for row in rows] == ["0.45", "0.2"] * 2)
data = history(here["push"])
value = float(rows[2]["velocity_at_0.495"])
there = data["t"] > 20
at = numpy.interp(-0.495, -data["x_centre"][there], data["velocity"][there])
check("fig3: velocity at 0.495 against the step that passes there", abs(value / at - 1), 0.1)

for name in ("fig1b", "half"):
    row = drawn(["fig1b", pathlib.Path(name).resolve()], f"{name}_figure")[0]
    check(f"{name}: |apparent angle - the one of history.csv|",
          abs(float(row["apparent_angle"]) - history(name)["angle_right"][-1]), 0.006)
    if name == "fig1b":  # at rest; the angle is read from the level line close to the wall
        check("fig1b: |angle at the wall - static angle|, degrees", abs(float(row["angle_at_wall"]) - 75), 5)

message = figures(["fig1b", pathlib.Path("nothing").resolve(), "--out", "/nowhere/a.png"], code=1)
check_true("a folder that is none: one line that says so", "is not an output folder" in message and
           message.count("\n") == 1, message)


def plot(*words):
    return subprocess.run([sys.executable, str(TOOL.with_name("plot")), *words], capture_output=True, text=True,
                          timeout=900)


run("tensotaxis_pull_2d", "still", SMALL + ["load.force=[0,0]", "time.end=0.01", "output.fields.times=[0,0.01]"])
result = plot("still", "--field", "--out", "still.png")
check_true("plot: a load of force 0", result.returncode == 0 and "Warning" not in result.stderr, result.stderr)
for words in (["--show", "pressure"], ["--show", "velocity_x", "--columns", "2"]):
    result = plot("still", "--field", *words, "--out", "shown.png")
    check_true(f"plot {' '.join(words)}", result.returncode == 0, result.stderr)
for words in (["--last"], ["--field", "0.01"]):
    check_true(f"plot {words[0]}", plot("still", *words, "--out", f"still{words[0]}.png").returncode == 0)
check_true("the last state alone", pathlib.Path("still--last.png").read_bytes() == pathlib.Path("still--field.png").read_bytes())
write_box("space", 0.4, [8, 8, 4], 0.1, 75, "[[droplet]]\ncentre = [0.4, 0.4, 0.0]\nradius = 0.3\n[time]\nend = 0.01\n"
          "[output]\nfields = { times = [0.0] }")
run_file("space.toml", "space")
result = plot("space", "--field", "--out", "space.png")
check_true("plot: a section of a run in three dimensions", result.returncode == 0, result.stderr)


def cut(name, length):
    """Leaves the beginning of a file of the folder `broken`, which is `still` again."""
    shutil.rmtree("broken", ignore_errors=True)
    shutil.copytree("still", "broken")
    path = pathlib.Path("broken") / name
    path.write_bytes(path.read_bytes()[:length])


def plot_refuses(part, *words):
    result = plot("broken", *words)
    check_true(f"plot refuses: {part}", result.returncode == 1 and part in result.stderr and
               result.stderr.count("\n") == 1, result.stderr)


domain = pathlib.Path("still/case.toml").read_text().index("[domain]")
cut("case.toml", domain)
plot_refuses("case.toml has no 'domain'", "--field")
cut("case.toml", domain + 3)
plot_refuses("cannot read broken/case.toml", "--field")
cut("fields/solid.hdf.series", 60)
plot_refuses("cannot read broken/fields/solid.hdf.series", "--field")
pathlib.Path("points.csv").write_text("time,x_centre\n1,0.5\n")
cut("case.toml", None)
plot_refuses("points.csv has no column t", "--history", "--reference", "points.csv")
plot_refuses("velocity is not a scalar; give a component of it", "--field", "--show", "velocity")
plot_refuses("has no field 'warmth'", "--field", "--show", "warmth")
plot_refuses("--columns 0: must be a number in [1, 100]", "--columns", "0")
plot_refuses("--magnify nan: must be a number in [0, 1e+06]", "--magnify", "nan")
