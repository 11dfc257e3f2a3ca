#!/usr/bin/env python3
"""tools/report writes its page for the kinds of scenes, and its energy budget is the one of history.csv; the ripple of
V; how the pictures of tools/plot show few points, the start's spike and loads. usage: report.py SOFTWET"""

import json
import pathlib
import subprocess
import sys
import types

import numpy
from _scene import PULL, RIGID, cases, check, check_true, environment, record, run, run_file, tools, write_box
from _scene import softwet as softwet_program

try:
    import matplotlib.pyplot as plt
except ImportError:
    sys.exit(print("no matplotlib: no page is made here"))

import softwet  # noqa: E402
from softwet._drawing import history_curves  # noqa: E402
from softwet._drawing.fields import Scene  # noqa: E402
from softwet._drawing.look import axis_names, fraction_of, letter, lift, markers, unit_of  # noqa: E402
from softwet._report import tables  # noqa: E402


def report(folder, *words, code=0):
    result = subprocess.run([sys.executable, str(tools / "report"), folder, *words], capture_output=True, text=True,
                            timeout=900, env=environment)
    check_true(f"report {folder}: exit code {code}", result.returncode == code and "Warning" not in result.stderr,
               result.stderr)
    return result.stderr


def page(folder):
    report(folder)
    pdf, png = (pathlib.Path(folder, f"report.{end}").read_bytes() for end in ("pdf", "png"))
    width, height = (int.from_bytes(png[i:i + 4], "big") for i in (16, 20))
    check_true(f"{folder}: one page of A4", pdf.count(b"/Type /Page ") == 1 and (width, height) == (1240, 1753),
               f"{width} x {height}")


# --- pages -----------------------------------------------------------------------------------------------------------
run("tensotaxis_pull_2d", "pull", [*PULL, "load.ramp=4"])
written = record("pull")
told = {**written, "groups": {"elastocapillary_over_radius": 0.034}, "started": "2026-01-01T00:00:00Z",
        "events": [{"t": 1.0, "what": "a droplet touches a side"}]}
pathlib.Path("pull/run.json").write_text(json.dumps(told))
page("pull")
run("static_droplet_rigid_2d", "rigid", [*RIGID, "time.end=1", "output.fields.times=[]"])
page("rigid")  # no field files
run("solid_layer_2d", "solid", ["domain.elements=[16,4]", "time.max_steps=3", "output.fields.times=[0]"])
page("solid")
write_box("box", height=0.4, elements=[6, 6, 4], capillarity=0.2, angle=90.0, tables="""
[substrate]
thickness = 0.1
young = 0.7554
poisson = 0.45
[[droplet]]
centre = [0.4, 0.4, 0.1]
radius = 0.25
[time]
end = 1.0
max_steps = 1
[output]
fields = { times = [0.0] }
""")
run_file("box.toml", "box")
page("box")
run("tensotaxis_pull_2d", "velocity", [*PULL, "time.max_steps=2", 'output.fields.select=["velocity"]',
                                      "output.fields.times=[-2]"])
page("velocity")  # the files hold no density: the rest is plotted
run("static_droplet_rigid_2d", "still", [*RIGID, "time.end=1", 'output.fields.select=["velocity"]',
                                         "output.fields.times=[0]"])
page("still")
run_file("box.toml", "thin", ['output.fields.select=["velocity"]'])
page("thin")
check_true("no output folder", "nowhere is not an output folder" in report("nowhere", code=1))
pathlib.Path("solid/history.csv").write_text("step,t\n")
check_true("a run without rows", "has no rows yet" in report("solid", code=1))

# --- numbers ---------------------------------------------------------------------------------------------------------
pull = softwet.open("pull")
curves = history_curves.Curves(pull)
budget = tables.Budget(curves)
t, power = curves.t, curves.table["power_load"]
check("work of the loads", abs(budget.work[-1] - numpy.trapz(power, t)), 1e-15)
check("the budget adds up", abs(budget.change - budget.work - budget.stretch + budget.lost - budget.rest).max(), 1e-15)
check_true("groups as run.json lists them", tables.groups(told) == [("elastocapillary over radius", "0.034")] and
           tables.groups({}) == [])


# --- the ripple of the speed -----------------------------------------------------------------------------------------
def rippling(of_run, run_record):
    return [value for key, value in tables.result(of_run, tables.Budget(of_run), run_record) if "ripple" in key]


check_true("a droplet that is driven along two elements to the capillarity",
           rippling(curves, written) == ["about 1.3 %; 1.2 times the elements halve it"], str(rippling(curves, written)))
check_true("one that rests", rippling(history_curves.Curves(softwet.open("rigid")), record("rigid")) == [])


def checked(case, *settings):
    sets = [word for setting in settings for word in ("--set", setting)]
    told = subprocess.run([softwet_program, "check", str(cases / f"{case}.toml"), *sets], capture_output=True, text=True, timeout=900,
                          env=environment)
    check_true(f"check {case} {' '.join(settings)}", told.returncode == 0, told.stderr)
    return [line.split()[1] for line in told.stdout.splitlines() if line.strip().startswith("speed_ripple")]


check_true("check of the pull", checked("tensotaxis_pull_2d") == ["0.013"])
check_true("on shorter elements", checked("tensotaxis_pull_2d", "domain.elements=[160,80]") == ["0.005325"])
check_true("where it is small", checked("tensotaxis_pull_2d", "domain.elements=[256,128]") == [])
for case in ("static_droplet_soft_2d", "sessile_soft_axisymmetric", "solid_layer_2d"):
    check_true("where nothing drives a droplet", checked(case) == [], case)

# --- how pictures show things ----------------------------------------------------------------------------------------
check_true("few points are marked, many are not", markers(24) and not markers(25))
case = {"load": [{"start": 10.0, "ramp": 4.0}, {"start": 12.0, "ramp": 0.0}]}  # the first one starts at t = 0
check_true("the part of a load that acts", [fraction_of(case["load"][0], case, t) for t in (-1, 0, 1, 4, 9)] ==
           [0, 0, 0.25, 1, 1] and [fraction_of(case["load"][1], case, t) for t in (1, 2, 3)] == [0, 1, 1])


def arrows(time):
    axes = plt.figure().subplots()
    Scene(pull, time).draw_loads(axes)
    return len(axes.texts)


check_true("an arrow only while the load acts", (arrows(0), arrows(10)) == (0, 1))
figure, axes = plt.subplots()
curves.table["velocity"] = numpy.where(t <= t[0] + 0.01 * numpy.ptp(t), 1.0, 1e-3 * numpy.sin(t))
history_curves.velocity(axes, curves)
check("the start's spike does not set the scale", axes.get_ylim()[1], 2e-3)
check_true("but is reported", "1.0e+00 at the start" in axes.get_title(loc="right"))
for name, unit in (("pull", "$a b^2 L_0^2$"), ("box", "$a b^2 L_0^3$")):
    check_true(f"{name}: unit of the energy", history_curves.energy_label(history_curves.Curves(softwet.open(name), -1.0)) ==
               f"energy / {unit}")
check_true("units of labels", [unit_of("t"), unit_of("velocity"), unit_of("angle_left"), unit_of("newton"),
                               unit_of("power_load", 3)] ==
           [r"$L_0\,(ab)^{-1/2}$", "$(ab)^{1/2}$", "degrees", "", r"$a b^2 (ab)^{1/2} L_0^2$"])
letters = [axes.get_title(loc="left")[:3] for axes in history_curves.draw_curves(pull).axes if axes.get_visible()]
check_true("letters on the panels", letters == [f"({c})" for c in "abcdefgh"[:len(letters)]] and len(letters) == 6, str(letters))
figure, axes = plt.subplots()
axes.set_title("t = 1", loc="left")
axes.set_title("a long title", loc="right")
letter(axes, 5)
check_true("a letter stands before the titles, in one line", axes.get_title(loc="left") == "(f)  t = 1  a long title" and
           not axes.get_title(loc="right"))
pdf = pathlib.Path("pull/report.pdf").read_bytes()
check_true("letters of a PDF are letters", b"/CIDFontType2" in pdf and b"/Type3" not in pdf)
about_axis = {"domain": {"coordinates": "axisymmetric", "size": [1.0, 0.5]}}
check_true("names of axes", [axis_names(case) for case in (about_axis, pull.case)] == ["rz", "xy"] and "u_z" in lift(about_axis))

# An axis of symmetry: a droplet has one end, no midpoint and no velocity.
blank, some = numpy.full(5, numpy.nan), numpy.linspace(0.1, 0.2, 5)
table = {"step": numpy.arange(5.0), "t": numpy.arange(5.0), "dt": numpy.ones(5), **{name: blank for name in (
    "x_left", "x_centre", "velocity", "angle_left", "ridge_left", "mass_drift")}, "x_right": some, "angle_right": 100 * some,
    "ridge_right": some, "dimple": -some, **{name: some for name in ("energy_total", "power_load", "wall_stretch", "dissipation")}}
half = history_curves.Curves(types.SimpleNamespace(history=table, dimension=2, case=about_axis))
check_true("curves about an axis", [panel.__name__ for panel in half.panels()] == ["position", "angles", "ridges", "energies", "step"])
found = dict(tables.result(half, tables.Budget(half), {}))
check_true("and the results", found["droplet: ridges"] == "0.2" and found["droplet: angles"] == "20.00 degrees" and
           "droplet: place" not in found, str(found))
history_curves.ridges(axes, half)
check_true("ridge and dimple have a curve", [line.get_label() for line in axes.lines] == ["right", "dimple"])

# The close-up lies around the contact line at the right, where it is worth it.
scene = Scene(pull, 10)
figure, axes = plt.subplots()
axes.set(xlim=(0, 1), ylim=(0, 0.5))
check_true("no close-up of an interface that is wide", scene.close_up(axes) is None)
scene.case["fluid"]["capillarity"] = 1 / 64
inset = scene.close_up(axes)
check("a close-up around the contact line", abs(numpy.mean(inset.get_xlim()) - pull.history["x_right"][-1]), 0.01)
check("of eight capillarities", abs(numpy.ptp(inset.get_xlim()) - 1 / 8), 1e-12)

# --- states of rest: of one command, and of a branch ----------------------------------------------------------------
REST = ["domain.elements=[32,16]", "fluid.capillarity=1/16"]


def steady(case, folder, settings, *words, code=0):
    sets = [word for setting in settings for word in ("--set", setting)]
    done = subprocess.run([softwet_program, "steady", str(cases / f"{case}.toml"), "--out", folder, "--overwrite", "--threads", "1",
                           "--quiet", *sets, *words], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"steady {folder}: exit code {code}", done.returncode == code, done.stderr)


def tell(tool, *words, code=0):
    done = subprocess.run([sys.executable, str(tools / tool), *words], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{tool} {' '.join(words)}: exit code {code}", done.returncode == code, done.stderr)
    return done.stdout + done.stderr


steady("static_droplet_rigid_2d", "at_rest", REST)
page("at_rest")
steady("solid_layer_2d", "solid_at_rest", ["domain.elements=[16,4]", "output.fields.times=[]"])
page("solid_at_rest")
steady("static_droplet_soft_2d", "branch", REST, "--along", "substrate.young=1,0.8")
for member in ("branch/young=1", "branch/young=0.8"):
    page(member)
steady("static_droplet_soft_2d", "no_rest", [*REST, "substrate.young=0.001"], code=2)
page("no_rest")
curves = history_curves.Curves(softwet.open("branch/young=0.8"), least=1)
row = {name: values[-1] for name, values in softwet.open("branch/young=0.8").history.items()}
told = dict(tables.result(curves, tables.Budget(curves), record("branch/young=0.8")))
check_true("the numbers of the state", told["droplet: ridges"] == f"{row['ridge_left']:.4g} and {row['ridge_right']:.4g}" and
           told[f"{history_curves.energy_label(curves)}: total"] == f"{row['energy_total']:.4e}", str(told))
found = record("branch/young=0.8")["rest"]
told = tables.rest(record("branch/young=0.8"))
check_true("how it was found, and the rates of disturbances", dict(told)["end"] == "at rest" and
           [value for name, value in told if name == "rate of a disturbance"] == [f"{rate:.4g}" for rate in
                                                                                found["stability"]["growth_rates"]], str(told))
check_true("its cost", dict(tables.cost(record("branch/young=0.8")))["steps; rejected"] == f"{found['steps']}; {found['rejected']}")
for tool in ("report", "plot", "watch"):
    check_true(f"{tool} of a branch names a state", "branch/young=0.8" in tell(tool, "branch", code=1))
check_true("curves of a state", "one row" in tell("plot", "branch/young=1", "--history", code=1))
lines = tell("status", "branch", "at_rest").splitlines()
check_true("status of a branch", [line.partition(": ")[0] for line in lines] == ["branch/young=0.8", "branch/young=1", "at_rest"] and
           all(": done, at rest, " in line and "growth rate" in line and "of 300" not in line for line in lines), str(lines))
check_true("watch of a state", "a state of rest has one row" in tell("watch", "at_rest"))
