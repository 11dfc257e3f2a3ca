#!/usr/bin/env python3
"""`softwet converge`: the keys that follow a width, both fits, numbers whose limit is known, the store of the widths,
refusals.
usage: converge.py SOFTWET"""

import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

import numpy as np

from _scene import cases, check, check_true, environment, open_output, record, softwet
from softwet._converge.fits import limit
from softwet._converge.keys import Rescaling, power_of_a, units_of_keys
from softwet._converge.measures import Column

TOOL = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tools" / "converge"
RIGID = """name = "cap"
[domain]
size = [0.5, 0.4]
elements = [10, 8]
[fluid]
viscosity = 0.01
capillarity = 0.05
temperature = 0.39
contact_angle = 80.0
wall_law = "energy"
[[droplet]]
centre = [0.0, 0.0]
radius = 0.25
[time]
end = 1.0
[output]
fields = { times = [0.0, 1.0] }
"""
SOLID = """wall_tension = "acts"
[substrate]
thickness = 0.1
young = 0.6
poisson = 0.49
material = "neo_hookean"
surface_tension = 0.0088
"""


def converge(case, folder, *words, code=0):
    """@return what was said on stdout and on stderr"""
    command = [sys.executable, TOOL, "--softwet", softwet, case, "--out", folder, "--threads", 1, *words]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=1700, env=environment)
    check_true(f"{case} {' '.join(map(str, words))}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stdout, done.stderr


def table(folder):
    with open(pathlib.Path(folder) / "converge.csv", newline="") as file:
        return {row["column"]: row for row in csv.DictReader(file)}


for folder in ("cap", "moves", "other"):
    shutil.rmtree(folder, ignore_errors=True)
pathlib.Path("cap.toml").write_text(RIGID)
pathlib.Path("gel.toml").write_text(RIGID.replace("[[droplet]]", SOLID + "[[droplet]]").replace("centre = [0.0, 0.0]", "centre = [0.0, 0.1]"))

# --- fits: what each of them holds exactly comes out exactly, and the value lies between both
g = np.array([1.0, 0.5, 0.25])
for name, values, taken in (("1, g, g^2", 3 - g + 2 * g ** 2, "powers"), ("1, g, g log g", 3 - g + 2 * g * np.log(g), "logarithm")):
    found = limit(g, values)
    check(f"{name}: its constant", abs(getattr(found, taken)[0] - 3), 1e-12)
    check("which the error bar contains", abs(found.value - 3), found.bar * (1 + 1e-9))
check("a straight line: both fits agree", abs(limit(g, 3 - g).value - 3), 1e-12)
coarser = np.array([2.0, *g])
check("the three finest widths count", abs(limit(coarser, [99, *(3 - g)]).value - 3), 1e-12)

found = limit(g, [7.0, 7.001, 7.003])
check("a number that hardly depends on the width: the finest value counts", abs(found.value - 7.003), 1e-12)
check_true("with a per cent", abs(found.bar - 0.01 * 7.003) < 1e-12, str(found))

# --- units: the power of a, by hand
for unit, power in (("L0", 0), ("b", 0), ("a b^2", 1), ("a b^2 L0", 1), ("rho_0^s ab", 1), ("sqrt(ab)", 0.5), ("L0/sqrt(ab)", -0.5),
                    ("L0 b sqrt(ab)", 0.5), ("ab/L0", 1), ("b sqrt(ab)", 0.5), ("hours of wall time", 0), ("degrees", 0), ("theta_c", 0)):
    check_true(f"{unit}: a to the power {power}", power_of_a(unit) == power)
units = units_of_keys(softwet)
check_true("the reference has the units", (units["fluid.viscosity"], units["load.start"], units["substrate.branch.time"]) ==
           ("L0 b sqrt(ab)", "L0/sqrt(ab)", "L0/sqrt(ab)"), str(units))
told = tomllib.loads(subprocess.run([softwet, "check", "--resolved", cases / "tensotaxis_pull_2d.toml", "--set", 'substrate.young="1 + x"',
                                     "--set", 'load[0].factor="sin(t)"'], capture_output=True, text=True, check=True).stdout)
half = Rescaling(units, 0.25).settings(told)
for key, value in (("fluid.capillarity", "0.00390625"), ("fluid.viscosity", "0.001953125"), ("time.end", "3768.0"),
                   ("substrate.young", '"(1 + x)*0.25"'), ("load[0].factor", '"sin((t*0.5))"')):
    check_true(f"a quarter of the width: {key}", half.get(key) == value, str(half.get(key)))
check_true("lengths stay", not any("radius" in key or "thickness" in key or key == "domain.size" for key in half), str(half))

# --- a cap on a rigid wall: Young's angle, and the geometry of its volume
said, warned = converge("cap.toml", "cap", "--columns", "angle,x_right,laplace")
check_true("the place of a droplet at rest has a limit", "drag" not in warned, warned)
rows = table("cap")
check("the angle at zero width: 80 degrees", abs(float(rows["angle"]["zero"]) - 80), 0.15)
check("in its error bar", abs(float(rows["angle"]["zero"]) - 80), float(rows["angle"]["bar"]))
foot = 0.25 * np.sin(np.radians(80))
check("the contact point at zero width", abs(float(rows["x_right"]["zero"]) - foot), max(float(rows["x_right"]["bar"]), 0.004 * foot))
check_true("the table is printed", "zero width" in said and "+-" in said, said)
check_true("and plotted", pathlib.Path("cap/converge.png").is_file())
names = ["g=0.05", "g=0.025", "g=0.0125"]
groups = [record(pathlib.Path("cap", name))["groups"] for name in names]
check("the Ohnesorge number is the same at all widths", np.ptp([group["ohnesorge"] for group in groups]), 1e-9)
check_true("the widths halve", [group["radius_over_capillarity"] for group in groups] == [5, 10, 20], str(groups))

# --- the same command again computes nothing, and a further width is added
before = {name: (pathlib.Path("cap", name, "run.json")).stat().st_mtime_ns for name in names}
said = converge("cap.toml", "cap", "--columns", "angle")[0]
after = {name: (pathlib.Path("cap", name, "run.json")).stat().st_mtime_ns for name in names}
check_true("again: nothing is computed", before == after and "started" not in said, said)
said = converge("cap.toml", "cap", "--set", "fluid.contact_angle=70", code=1)[1]
check_true("another setting is refused there", "holds other widths" in said and "contact_angle=70" in said, said)

# --- a case with a narrow interface begins with a wider one
said = converge("cap.toml", "other", "--set", "fluid.capillarity=0.00625", "--set", "domain.elements=[160,128]", "--dry-run")[0]
check_true("two doublings, the case, and no more", re.findall(r"g=(\S+):", said) == ["0.025", "0.0125", "0.00625"], said)
check_true("no key without effect", "creep_speed" not in said and "fluid.viscosity" in said, said)
check_true("two elements to each", "domain.elements=[40, 32]" in said and "domain.elements=[160, 128]" in said, said)

# --- a motion: its times follow the width
said = converge("cap.toml", "moves", "--run", "--set", "fluid.contact_angle=70", "--set", "time.end=0.2", "--set", "output.fields.times=[]",
                "--columns", "x_right@0,x_right@0.2")[1]
check_true("a motion has no limit", "--columns x_right@0.2: the viscous drag" in said and "x_right@0:" not in said, said)
ends = [record(pathlib.Path("moves", name))["stop"]["t"] for name in names]
check("the run ends at the same time in seconds", max(abs(end / (0.2 * 2 ** (k / 2)) - 1) for k, end in enumerate(ends)), 1e-9)
rows = table("moves")
check("the start is the cap of its radius", abs(float(rows["x_right@0"]["zero"]) - 0.25 * np.sin(np.radians(70))), 0.004)

# --- a layer: the pressure of the vapour, beside a flat interface and what the curved one adds, is taken off
sets = ["--set", "fluid.contact_angle=90", "--set", "substrate.surface_tension=0.02", "--set", "domain.elements=[40,32]"]
subprocess.run([softwet, "steady", "gel.toml", "--out", "gel", "--overwrite", "--quiet", "--threads", "1", *sets], check=True,
               capture_output=True, env=environment)
gel = open_output("gel")
stiffness = 0.6 * (1 - 0.49) / ((1 + 0.49) * (1 - 2 * 0.49))  # lambda + 2 G
pressure = 1.5465e-4 + 0.00135229 * gel.history["laplace"][-1]  # the equation of state at temperature 0.39, by hand
squeeze = 0.1 * pressure / stiffness
ridge, centre = (Column(name, True).value(gel, 1.0) for name in ("ridge", "centre"))
check("the ridge without the squeeze", abs(ridge - gel.history["ridge_right"][-1] - squeeze), 0.01 * squeeze)
wall = gel.interface[gel.times[-1]]
check("the centre of the half droplet", abs(centre - squeeze - wall["displacement_y"][0]), 0.01 * abs(centre))
half = Column("ridge", True).value(gel, 0.5)
check("a length has no scale a", abs(half - ridge), 1e-15)
speed = Column("speed_max_fluid", True)
check("a speed has its root", abs(speed.value(gel, 0.25) - 2 * speed.value(gel, 1.0)), 1e-12 * speed.value(gel, 1.0))

# --- refusals
said = converge("gel.toml", "refused", "--set", "substrate.surface_tension=0", code=1)[1]
check_true("no surface tension of the solid, no limit", "there is no limit" in said and "substrate.surface_tension" in said, said)
said = converge("gel.toml", "refused", "--set", "substrate.surface_tension=0.004", "--set", "fluid.contact_angle=90", code=1)[1]
check_true("no triangle, no limit", "Neumann's triangle does not exist" in said, said)
said = converge("cap.toml", "refused", "--columns", "rigde", code=1)[1]
check_true("a column that is none", "did you mean 'ridge'" in said, said)
said = converge("cap.toml", "refused", "--columns", "angle@3", code=1)[1]
check_true("a time of a state of rest", "--run" in said, said)
check_true("nothing is written", not pathlib.Path("refused").exists())
