#!/usr/bin/env python3
"""Probes are columns of history.csv: points, lines and boxes, against the other columns, the wall's table and the
fields.
usage: probes.py SOFTWET"""

import pathlib
import subprocess
import sys

import numpy
from _scene import check, check_true, environment, history, open_output, run_file, softwet, tools

ALOUD = ["--overwrite", "--threads", "1", "--quiet"]
PROBES = """
[[probe]]
name = "all_mass"
quantity = "density"
box = [[0.0, 0.125], [1.0, 0.5]]
operation = "integral"
[[probe]]
name = "rise"
quantity = "displacement_y"
point = [0.25, 0.125]
[[probe]]
name = "highest"
quantity = "displacement_y"
box = [[0.0, 0.125], [1.0, 0.125]]
operation = "max"
[[probe]]
name = "bottom_pressure"
quantity = "cauchy_stress_yy"
box = [[0.0, 0.0], [1.0, 0.0]]
operation = "mean"
[[probe]]
name = "fastest"
quantity = "speed"
box = [[0.0, 0.125], [1.0, 0.5]]
operation = "max"
"""
scene = """
name = "probes"
domain = { size = [1.0, 0.5], elements = [64, 32] }
fluid = { viscosity = 0.01, capillarity = "1/32", temperature = 0.39, contact_angle = 75, wall_law = "energy" }
substrate = { thickness = 0.125, young = 0.7554, poisson = 0.45 }
droplet = [{ centre = [0.45, 0.125], radius = 0.25 }]
boundary = { bottom = "clamped" }
time = { end = 5 }
output.fields.times = [5]
"""
pathlib.Path("probes.toml").write_text(scene + PROBES)
run_file("probes.toml", "probes", [], ALOUD)
rows = history("probes")
check("the density over all of the fluid is its mass", abs(rows["all_mass"] / rows["mass"] - 1).max(), 1e-12)

wall = numpy.genfromtxt("probes/interface.csv", delimiter=",", names=True)
at = abs(wall["x_reference"] - 0.25).argmin()
check("a point of the wall", abs(rows["rise"][-1] - wall["displacement_y"][at]), 1e-14)
check("the highest point of the wall", abs(rows["highest"][-1] - wall["displacement_y"].max()), 1e-4)
# Two contact lines pull: the higher one of their ridges is the highest point of the wall.
check("the ridges", abs(rows["highest"][-1] - numpy.maximum(rows["ridge_left"], rows["ridge_right"])[-1]), 2e-4)
check_true("the dimple lies below", (rows["dimple"][1:] < rows["ridge_left"][1:]).all())
# The wall beside the lines, from the points of its table.
place, angle = wall["x_reference"] + wall["displacement_x"], numpy.degrees(numpy.arctan(numpy.gradient(
    wall["displacement_y"], wall["x_reference"] + wall["displacement_x"])))
for side, way in (("left", 1), ("right", -1)):
    for kind, sign in (("wet", way), ("dry", -way)):
        seen = numpy.interp(rows[f"x_{side}"][-1] + sign * 4 / 32, place, -sign * angle)
        check(f"the wall's angle on the {kind} side, {side}", abs(rows[f"wall_angle_{side}_{kind}"][-1] - seen), 0.05)
    # On a circle of this radius that meets the wall with the apparent angle.
    circle = numpy.degrees(numpy.arccos(numpy.cos(numpy.radians(rows[f"angle_{side}"][-1])) + 4 / 32 / 0.25))
    check(f"the liquid's angle, {side}", abs(rows[f"liquid_angle_{side}"][-1] - circle), 3)
check_true("the fastest fluid", (rows["fastest"] <= rows["speed_max_fluid"] * (1 + 1e-12)).all())
check("the fastest fluid is near its control value", abs(rows["fastest"][-1] / rows["speed_max_fluid"][-1] - 1), 0.5)
# Sideways nothing pushes the scene but its walls; up and down the momentum is what the bottom and the top give.
check_true("momentum along both axes", {"momentum_x", "momentum_y"} <= set(rows))
check_true("probes come last", pathlib.Path("probes/history.csv").read_text().split("\n")[0].endswith(
    "laplace,all_mass,rise,highest,bottom_pressure,fastest"))

# The volume of the liquid follows from the density in the field file.
phases = open_output("probes").record["equilibrium"]
fluid = open_output("probes").fields(5)
low, high = fluid.positions.min(axis=(0, 1)), fluid.positions.max(axis=(0, 1))
step = (high - low) / (400, 1600)
grid = fluid.on_grid(400, 1600, box=(low + step / 2, high - step / 2))  # middles of cells
share = ((grid["density"] - phases["density_vapour"]) / (phases["density_liquid"] - phases["density_vapour"])).clip(0, 1)
liquid = numpy.nansum(share**2 * (3 - 2 * share)) * step.prod()
check("the volume of the liquid", abs(rows["liquid_volume"][-1] / liquid - 1), 1e-3)

# The rest of the run from a checkpoint; probes of a run cannot change.
pathlib.Path("longer.toml").write_text((scene + PROBES).replace("end = 5", "end = 6"))
run_file("longer.toml", "probes", [], ["--resume", "--threads", "1", "--quiet"])
check("the rest of the run", abs(history("probes")["all_mass"] / history("probes")["mass"] - 1).max(), 1e-12)
pathlib.Path("without.toml").write_text(scene.replace("end = 5", "end = 7"))
answer = run_file("without.toml", "probes", [], ["--resume", "--threads", "1", "--quiet"], code=1)
check_true("a resume without the probes is refused", "probe" in answer, answer)

# Explicit schemes, whose rows stand further apart, have them too.
run_file("probes.toml", "explicit", ["time.scheme=kick_drift", "time.end=0.2", "output.fields.times=[]"], ALOUD)
rows = history("explicit")
check("explicit: the mass", abs(rows["all_mass"] / rows["mass"] - 1).max(), 1e-12)

line = subprocess.run([sys.executable, tools / "status", "probes"], capture_output=True, text=True, env=environment).stdout
check_true("status shows ridges and probes", "ridges " in line and "all_mass " in line, line)

# Around an axis of symmetry: a column under its weight sinks alike everywhere, on the axis too.
PROBE = """
[[probe]]
name = "{name}"
quantity = "{quantity}"
box = [[{r}, 0.07], [{r}, 0.29]]
operation = "{operation}"
"""
axial = """
name = "axis"
domain = { coordinates = "axisymmetric", size = [0.4, 0.3], elements = [12, 9] }
substrate = { thickness = 0.3, young = 1.0, poisson = 0.3, strain = "small", gravity = [0.0, -1e-3] }
boundary = { bottom = "slip", right = "slip", top = "free" }
time = { end = 1.0 }
output = { fields = { times = [] } }
"""
for place, r in (("on", 0), ("off", 0.2)):
    for operation in ("mean", "integral", "min", "max"):
        axial += PROBE.format(name=f"{operation}_{place}", quantity="displacement_y", r=r, operation=operation)
pathlib.Path("axis.toml").write_text(axial)
subprocess.run([softwet, "steady", "axis.toml", "--out", "axis", *ALOUD], check=True, env=environment, stdout=subprocess.DEVNULL)
row = {name: values[-1] for name, values in history("axis").items()}
modulus = 0.7 / (1.3 * 0.4)
# u = -w (H y - y^2 / 2) / M, integrated from 0.07 to 0.29
whole = -1e-3 / modulus * (0.3 * (0.29**2 - 0.07**2) / 2 - (0.29**3 - 0.07**3) / 6)
check("mean on the axis", abs(row["mean_on"] / (whole / 0.22) - 1), 1e-6)
check("mean off the axis", abs(row["mean_off"] / (whole / 0.22) - 1), 1e-6)
check("integral on the axis, over a line", abs(row["integral_on"] / whole - 1), 1e-6)
check("integral off the axis, over a face", abs(row["integral_off"] / (2 * numpy.pi * 0.2 * whole) - 1), 1e-6)
check("smallest and largest on the axis", max(abs(row[f"{end}_on"] / row[f"{end}_off"] - 1) for end in ("min", "max")), 1e-6)
