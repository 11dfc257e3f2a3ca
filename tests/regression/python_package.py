#!/usr/bin/env python3
"""The Python package softwet on a small pull, a solid alone and a sweep, and its messages; the choice of the
interpreter.
usage: python_package.py SOFTWET"""

import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys

import numpy
from _scene import PULL, cases, check, check_true, environment, run, run_file, tools, write_box
from _scene import softwet as program

import softwet
from softwet.lattice import evaluate, locate
from softwet.sweep import value_of


def refused(name, action, *parts):
    try:
        action()
    except softwet.Problem as problem:
        return check_true(f"refused: {name}", all(part in str(problem) for part in parts), str(problem))
    check_true(f"refused: {name}", False)


# --- interpolation: a bent lattice of quadratic elements, whose fields are polynomials of degree 2 -----------------
y, x = numpy.meshgrid(numpy.linspace(0, 1, 9), numpy.linspace(0, 2, 17), indexing="ij")
index = numpy.random.default_rng(1).uniform(0, [16, 8], (200, 2))
at = index / 8
check("quadratics are met", abs(evaluate(x**2 - x * y, index) - (at[:, 0]**2 - at[:, 0] * at[:, 1])).max(), 1e-12)
check("and their slopes", abs(evaluate(x**2 + y, index, 0) - 2 * at[:, 0] / 8).max(), 1e-12)
around = 2 * x  # a ring of 4 radians: the guess is far off
ring = numpy.stack([(1 + y) * numpy.cos(around), (1 + y) * numpy.sin(around)], axis=-1)
places = evaluate(ring, index)
found = locate(ring, places, numpy.full_like(index, 1.0))
check("places in a bent body", abs(evaluate(ring, found) - places).max(), 1e-9)
outside = locate(ring, numpy.array([[0.0, 0.0], [5.0, 0.0], [1.0, -0.9]]), numpy.zeros((3, 2)))
check_true("outside of it", numpy.isnan(outside).all(), str(outside))
check_true("values of a sweep", list(map(value_of, ("0.3", "1/64", "[0.1,0]", "exact", '"schwarz"'))) ==
           [0.3, 1 / 64, [0.1, 0], "exact", "schwarz"])

# --- a pull ---------------------------------------------------------------------------------------------------------
run("tensotaxis_pull_2d", "pull", PULL)
pull = softwet.open("pull")
check_true("case, record, state", pull.case["substrate"]["young"] == 0.7554 and pull.record["dimension"] == 2 and
           pull.state == "done" and pull.parts == ["fluid", "solid"] and pull.dimension == 2)
last = {name: values[-1] for name, values in pull.history.items()}
check_true("history", last == {**last, **pull.record["last_row"]} and numpy.isnan(pull.history["velocity"][0]))
columns = softwet.columns()
check_true("columns", set(pull.history) <= set(columns) and set(pull.interface[0]) <= set(softwet.columns("interface")) and
           columns["energy_wall"].unit == "a b^2 L0^d" and columns["energy_surface"].needs == "solid" and
           columns["y_centre"].dimension == 3 and columns["mass"].dimension is None)
check_true("times", pull.times == [0.0, 10.0] and list(pull.interface) == [0.0, 10.0])
fluid, solid, wall = pull.fields(10), pull.fields(10.000001, "solid"), pull.interface[10]
check_true("fields and shapes", {"density", "velocity", "pressure"} <= set(fluid) and fluid.shape == (25, 65) and
           fluid["density"].shape == (25, 65) and fluid["velocity"].shape == (25, 65, 2))
check_true("a tensor", solid["cauchy_stress"].shape == (9, 65, 3, 3) and
           solid.at([0.5, 0.06])["cauchy_stress"].shape == (3, 3))
check("the solid is where its displacement has carried it",
      abs(solid.positions - solid.reference - solid["displacement"]).max(), 1e-15)
check("its top is the wall of interface.csv", abs(solid["displacement"][-1, :, 1] - wall["displacement_y"]).max(), 1e-12)
check("the fluid stands on it", abs(fluid.positions[0] - solid.positions[-1]).max(), 1e-12)
check("at the points of the file", abs(fluid.at(fluid.positions)["velocity"] - fluid["velocity"]).max(), 1e-12)
check_true("one point", fluid.at([0.5, 0.2])["density"].shape == () and fluid.at([[0.5, 0.2]])["velocity"].shape == (1, 2))
grid = fluid.on_grid(161, 81)
mass = numpy.nansum(grid["density"]) * numpy.prod([axis[1] - axis[0] for axis in grid.axes])
check_true("a grid", grid["density"].shape == (81, 161) and len(grid.axes[0]) == 161 and not grid.inside.all())
check("the mass from the grid", abs(mass / last["mass"] - 1), 0.02)
middle = 0.5 * sum(pull.record["equilibrium"].values())
height = numpy.interp(last["x_right"], fluid.positions[0, :, 0], fluid.positions[0, :, 1])
at_wall = fluid.at([last["x_right"], height + 1e-3])["density"]  # the wall is curved between the points
check("the density at the contact line", abs(at_wall - middle), 0.01)

refused("no such time", lambda: pull.fields(3), "no fields at t = 3; there are: 0, 10")
refused("no such part", lambda: pull.fields(0, "air"), "'air'", "fluid and solid")
refused("no such field", lambda: fluid["temperature"], "no field 'temperature'", "density", "output.fields.select")
refused("no such time of the wall", lambda: pull.interface[3], "t = 3", "0, 10")
refused("no such key", lambda: pull.case["fluid"]["colour"], "pull/case.toml has no 'colour'")
refused("a place without coordinates", lambda: fluid.at([0.1, 0.2, 0.3]), "2 coordinates")
refused("a grid of one axis", lambda: fluid.on_grid(10), "2 numbers")
refused("no output folder", lambda: softwet.open("nowhere"), "nowhere is not an output folder")
refused("no such table of columns", lambda: softwet.columns("walls"), "'walls'", "history, interface, fields")
refused("no table", lambda: softwet.read_table(pathlib.Path("nowhere.csv")), "there is no nowhere.csv")

# What a run that is writing now, and one that was cut, leave.
shutil.rmtree("cut", ignore_errors=True)
shutil.copytree("pull", "cut")
table = pathlib.Path("cut/history.csv")
table.write_text(table.read_text()[:-7])
check_true("a row that is not whole yet", len(softwet.open("cut").history["t"]) == len(pull.history["t"]) - 1)
pathlib.Path("cut/run.json").unlink()
check_true("before run.json", softwet.open("cut").record == {} and softwet.open("cut").state == "died")
pathlib.Path("cut/fields/fluid_0001.hdf").write_bytes(b"")
refused("a cut field file", lambda: softwet.open("cut").fields(10)["density"], "cannot read cut/fields/fluid_0001.hdf")
table.write_text("t,dt\n1,x\n")
refused("a cut table", lambda: softwet.open("cut").history, "cut/history.csv is not a table of numbers")
shutil.rmtree("cut/fields")
refused("no fields", lambda: softwet.open("cut").fields(0), "cut/fields holds no field files", "output.fields")

# --- three dimensions, a rigid wall ---------------------------------------------------------------------------------
write_box("box", height=0.4, elements=[4, 5, 3], capillarity=0.2, angle=90.0, tables="""
[[droplet]]
centre = [0.4, 0.4, 0.0]
radius = 0.25
[time]
end = 1.0
max_steps = 1
[output]
fields = { times = [0.0] }
""")
run_file("box.toml", "box")
box = softwet.open("box").fields(0)
check_true("3D: shapes", box.shape == (7, 11, 9) and box["velocity"].shape == (7, 11, 9, 3))
check("3D: at the points of the file", abs(box.at(box.positions)["density"] - box["density"]).max(), 1e-12)
check("3D: a grid", abs(box.on_grid(9, 11, 7)["density"] - box["density"]).max(), 1e-12)
refused("a part that is not there", lambda: softwet.open("box").fields(0, "solid"), "no part 'solid', only fluid")

# --- a sweep --------------------------------------------------------------------------------------------------------
shutil.rmtree("swept", ignore_errors=True)
subprocess.run([program, "sweep", str(cases / "solid_layer_2d.toml"), "--vary", "substrate.poisson=0.1,0.3", "--vary",
                "load.force=[0.1,0],[-0.1,0]", "--set", "domain.elements=[8,2]", "--set", "time.max_steps=2", "--out",
                "swept"], check=True, capture_output=True, env=environment)
swept = softwet.open_sweep("swept")
check_true("sweep: members and values", len(swept) == 4 and [m.values["substrate.poisson"] for m in swept] ==
           [0.1, 0.1, 0.3, 0.3] and swept[1].values["load.force"] == [-0.1, 0] and swept[3].status == "done")
check_true("sweep: their runs", all(m.run.case["substrate"]["poisson"] == m.values["substrate.poisson"] and
                                    len(m.run.history["t"]) == 3 for m in swept))
check_true("a folder of output folders", [m.name for m in softwet.open_sweep(".")] == ["box", "cut", "pull"])
told = subprocess.run([program, "status", "swept"], capture_output=True, text=True, env=environment)
check_true("status of a sweep", told.returncode == 0 and told.stdout.count(": stopped") == 4, told.stdout + told.stderr)
refused("no sweep", lambda: softwet.open_sweep("pull"), "pull holds no output folder")

# --- the examples of the documentation, in their order --------------------------------------------------------------
shutil.rmtree("out", ignore_errors=True)
pathlib.Path("out").mkdir()
for name, target in (("example", "pull"), ("example_sweep", "swept")):
    pathlib.Path("out", name).symlink_to(pathlib.Path(target).resolve())
page = (tools.parent / "docs" / "reading_results.md").read_text()
result = subprocess.run([sys.executable, "-W", "error", "-c", "\n".join(re.findall(r"```python\n(.*?)```", page, re.DOTALL))],
                        capture_output=True, text=True, env={**environment, "PYTHONPATH": str(tools)})
check_true("docs/reading_results.md", result.returncode == 0 and "no fields at t = 7" in result.stdout,
           result.stdout + result.stderr)

pathlib.Path("swept/sweep.json").write_text(json.dumps({"vary": ["a=1"]}))
refused("a cut sweep", lambda: softwet.open_sweep("swept"), "cannot read the sweep swept", "--table")

# --- the choice of the interpreter ----------------------------------------------------------------------------------
shutil.rmtree("bare", ignore_errors=True)
pathlib.Path("bare").mkdir()
bare = pathlib.Path("bare/python3")  # a python3 that finds no packages
bare.write_text(f'#!/bin/sh\nexec {sys.executable} -S "$@"\n')
bare.chmod(0o755)
changed = {name: value for name, value in environment.items() if name != "SOFTWET_PYTHON"}


def plot(**changes):
    return subprocess.run([str(bare), str(tools / "plot"), "pull", "--interface", "--out", "wall.png"], text=True,
                          capture_output=True, timeout=900, env={**changed, **changes})


if importlib.util.find_spec("matplotlib"):
    result = plot(SOFTWET_PYTHON=sys.executable)
    check_true("a tool goes on in SOFTWET_PYTHON", result.returncode == 0, result.stderr)
result = plot(SOFTWET_PYTHON=str(bare.resolve()))
check_true("SOFTWET_PYTHON without the modules", result.returncode == 1 and "numpy" in result.stderr and
           result.stderr.count("\n") == 1 and "SOFTWET_PYTHON" in result.stderr, result.stderr)
result = plot(SOFTWET_PYTHON="/nowhere/python3")
check_true("SOFTWET_PYTHON that is none", result.returncode == 1 and "'/nowhere/python3' does not start" in result.stderr,
           result.stderr)
pathlib.Path("bare/some/numpy").mkdir(parents=True)  # a python3 with some packages
pathlib.Path("bare/some/h5py").mkdir()
pathlib.Path("bare/some/matplotlib").mkdir()
for tool, package, remedy in (("tradeoff", "pandas", "apt-get install python3-pandas"), ("figures3d", "pyvista", "pip install pyvista")):
    result = subprocess.run([str(bare), str(tools / tool), "pull"], text=True, capture_output=True,
                            env={**changed, "SOFTWET_PYTHON": str(bare.resolve()), "PYTHONPATH": "bare/some"})
    check_true(f"{tool} without {package}", result.returncode == 1 and result.stderr.count("\n") == 1 and package in result.stderr and
               "h5py" not in result.stderr and remedy in result.stderr, result.stderr)
rooms = [f"softwet.{room}.{path.stem}" for room in ("_tools", "_store", "_terminal")
         for path in (tools / "softwet" / room).glob("[!_]*.py")]
result = subprocess.run([str(bare), "-c", f"import {', '.join(rooms)}"], capture_output=True, text=True,
                        env={**changed, "PYTHONPATH": str(tools)})
check_true("the package needs no others before arrays are asked for", result.returncode == 0 and len(rooms) > 6, result.stderr)
result = subprocess.run([str(bare), str(tools / "status"), "pull"], capture_output=True, text=True, env=changed)
check_true("status needs no packages", result.returncode == 0 and "pull: done" in result.stdout, result.stderr)
