#!/usr/bin/env python3
"""The table [laboratory]: keys that follow from quantities, what is refused, the same run as that of its numbers, and results in um,
ms and kPa. usage: laboratory.py SOFTWET"""

import json
import math
import pathlib
import shutil
import subprocess
import sys
import tomllib

from _scene import check, check_true, environment, softwet, tools
from softwet import open as open_output

SIGMA, LIQUID = 0.2532027493, 0.8666990997  # at temperature 0.39: surface tension over capillarity, and density (test_groups)
DROP = """name = "drop"

[laboratory]
length = "50 um"
surface_tension = "72 dyn/cm"
density = "1 g/ml"
viscosity = "10 cP"
capillarity = "6.25µm"
radius = "0.05 mm"
thickness = "25 um"
young = "3 kPa"
solid_density = "1100 kg/m^3"
solid_surface_tension = "50 mN/m"
solid_viscosity = "0.5 Pa s"

[domain]
coordinates = "axisymmetric"
size = [2.0, 1.75]
elements = [32, 28]

[fluid]
temperature = 0.39
contact_angle = 90
wall_law = "energy"
wall_tension = "acts"

[substrate]
poisson = 0.45
material = "neo_hookean"

[[droplet]]
centre = [0.0, 0.5]

[boundary]
bottom = "clamped"

[time]
end = 10
"""


def call(*words, code=0):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{' '.join(map(str, words[1:]))[:100]}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stdout, done.stderr


def resolved(*words):
    return tomllib.loads(call(softwet, "check", "--resolved", *words)[0])


def run(case, folder, *words):
    shutil.rmtree(folder, ignore_errors=True)
    return call(softwet, "run", case, "--out", folder, "--threads", "1", "--quiet", "--set", "time.max_steps=3", "--set",
                "output.fields.times=[0,0.02]", *words)


def tool(name, *words, code=0):
    return call(sys.executable, tools / name, *words, code=code)


pathlib.Path("drop.toml").write_text(DROP)

# --- the numbers that follow, worked here: L0 = 50 um, g = 1/8, b = 1000/0.8667, a b^2 = sigma/(0.2532 g L0)
case = resolved("drop.toml")
fluid, solid, length, b = case["fluid"], case["substrate"], 50e-6, 1000 / LIQUID
stress = 0.072 / (SIGMA * 0.125 * length)
speed = math.sqrt(stress / b)
for name, found, value in (
        ("fluid.capillarity", fluid["capillarity"], 0.125), ("droplet.radius", case["droplet"][0]["radius"], 1),
        ("substrate.thickness", solid["thickness"], 0.5), ("substrate.density", solid["density"], 1100 / b),
        ("substrate.young", solid["young"], 3000 / stress / (1100 / b)),
        ("fluid.viscosity", fluid["viscosity"], 0.01 / (length * b * speed)),
        ("substrate.viscosity", solid["viscosity"], 0.5 / (length * b * speed)),
        ("substrate.surface_tension", solid["surface_tension"], 0.05 / (stress * length)),
        ("Upsilon/E is 16.67 um", solid["surface_tension"] / (solid["density"] * solid["young"]) * 50, 50 / 3),
        ("sigma/E is 24 um", SIGMA * 0.125 / (solid["density"] * solid["young"]) * 50, 24)):
    check(name, abs(found / value - 1), 1e-9)
shown = call(softwet, "check", "drop.toml")[0]
for part in ("in the laboratory", "0.125 is 6.25 um", "is 3 kPa", "is 50 mN/m", "is 10 mPa.s", "is 1100 kg/m3", "[2, 1.75] is [100, 87.5] um"):
    check_true(f"check shows both: {part}", part in shown, shown)

# --- what the command line changes
half = resolved("drop.toml", "--set", "fluid.capillarity=0.0625")
check("half the width: half the modulus", abs(half["substrate"]["young"] / solid["young"] - 0.5), 1e-12)
check("and its root of the viscosity", abs(half["fluid"]["viscosity"] / fluid["viscosity"] - 0.5 ** 0.5), 1e-12)
check("half of it as a quantity", abs(resolved("drop.toml", "--set", "laboratory.capillarity=3.125um")["substrate"]["young"] /
                                      half["substrate"]["young"] - 1), 1e-9)
stiff = resolved("drop.toml", "--set", "laboratory.young=6 kPa")
check("another modulus", abs(stiff["substrate"]["young"] / solid["young"] - 2), 1e-12)
check_true("a key wins over a quantity of the file", resolved("drop.toml", "--set", "substrate.young=0.5")["substrate"]["young"] == 0.5)

# --- what is refused: place, key, value, what is allowed and what to do
for name, old, new, parts in (
        ("no unit", '"3 kPa"', '"3"', ("wrong.toml:11: laboratory.young = 3", "kPa, MPa, GPa, Pa", 'write for example young = "3 kPa"')),
        ("another quantity", '"3 kPa"', '"3 mm"', ("laboratory.young = 3 mm", "this is a length")),
        ("an unknown unit", '"25 um"', '"25 inch"', ("laboratory.thickness = 25 inch", "nm, um, mm, cm, m")),
        ("no quantity", '"25 um"', '"0 um"', ("laboratory.thickness = 0 um", "above 0")),
        ("a number", '"3 kPa"', "3.0", ("laboratory.young = 3", "must be text", "3 kPa")),
        ("given twice", "poisson = 0.45", "poisson = 0.45\nyoung = 1.0",
         ("substrate.young = 1", "follows from laboratory.young", "keep one of the two", "wrong.toml:11")),
        ("a density twice", "poisson = 0.45", "poisson = 0.45\ndensity = 1.0", ("substrate.density = 1", "laboratory.solid_density")),
        ("no length", 'length = "50 um"\n', "", ("laboratory.length", "is missing", "1 mm")),
        ("no width", 'capillarity = "6.25µm"\n', "", ("laboratory.capillarity", "is missing", "10 um")),
        ("a wrong name", "young =", "yuong =", ("laboratory.yuong", "laboratory.young")),
        ("no droplet", "[[droplet]]\ncentre = [0.0, 0.5]\n", "", ("laboratory.radius", "droplet[].radius", "[[droplet]]")),
        ("too thick", '"25 um"', '"25 mm"', ("substrate.thickness = 500, from laboratory.thickness = ", "wrong.toml:10")),
        ("a wet tension that Young's law gives", 'solid_viscosity = "0.5 Pa s"', 'wet_surface_tension = "60 mN/m"',
         ("substrate.surface_tension_wet", "from laboratory.wet_surface_tension", "wrong.toml:14"))):
    check_true(f"there is {old}", old in DROP)
    pathlib.Path("wrong.toml").write_text(DROP.replace(old, new, 1))
    said = call(softwet, "check", "wrong.toml", code=1)[1]
    check_true(f"refused: {name}", all(part in said for part in parts), said)
said = call(softwet, "check", "drop.toml", "--set", "laboratory.young=6kPa", "--set", "substrate.young=1", code=1)[1]
check_true("both on the command line", "keep one of the two" in said, said)

# --- the same run as that of its numbers, to the bit
told = run("drop.toml", "run")[1]
numbers = call(softwet, "check", "--resolved", "drop.toml")[0]
pathlib.Path("twin.toml").write_text(numbers[:numbers.index("[laboratory]")])
run("twin.toml", "twin")
check_true("history.csv, to the bit", pathlib.Path("run/history.csv").read_bytes() == pathlib.Path("twin/history.csv").read_bytes())
check_true("the twin has no units", not pathlib.Path("twin/units.json").exists())
run("run/case.toml", "again")
check_true("the resolved case has its units", pathlib.Path("again/units.json").read_bytes() == pathlib.Path("run/units.json").read_bytes())

# --- results in these units
laboratory, plain = open_output("run"), open_output("twin")
table, rows = laboratory.in_units(), laboratory.history
time = length / speed
check_true("units", [table.unit[name] for name in ("t", "x_right", "speed_max_fluid", "energy_total", "liquid_volume", "angle_right")] ==
           ["ms", "um", "mm/s", "nJ", "nl", ""], str(table.unit))
for name, factor in (("x_right", 50), ("t", 1e3 * time), ("speed_max_fluid", 1e3 * speed), ("energy_total", 1e9 * stress * length ** 3),
                     ("liquid_volume", 1e12 * length ** 3), ("angle_right", 1)):
    check(f"{name} of the table", abs(table[name][-1] / rows[name][-1] / factor - 1), 1e-9)
wall = laboratory.in_units(laboratory.interface[0.0], "interface")
check("traction in kPa", abs(wall["traction_y"] / laboratory.interface[0.0]["traction_y"] - stress / 1e3).max() / stress, 1e-9)
try:
    plain.in_units()
    check_true("a run without a table", False)
except Exception as problem:  # noqa: BLE001
    check_true("a run without a table", "[laboratory]" in str(problem), str(problem))
place = f"to {rows['x_right'][-1] * 50:.5g} um"
status = tool("status", "run")[0]
check_true("status", place in status and f"of {10 * time * 1e3:.6g} ms" in status, status)
check_true("status of numbers", " um" not in tool("status", "run", "--units", "dimensionless")[0])
check_true("units that are not there", "[laboratory]" in tool("status", "twin", "--units", "laboratory", code=1)[1])
watch = tool("watch", "run", "--once")[0]
check_true("watch", "contact lines and centre, um" in watch and "ms" in watch and place in watch, watch)
check_true("watch of numbers", "contact lines and centre\n" in "\n".join(line.rstrip() for line in tool(
    "watch", "run", "--once", "--units", "dimensionless")[0].replace("velocity of the droplet", "\n").splitlines()))
told = call(softwet, "run", "drop.toml", "--out", "loud", "--overwrite", "--threads", "1", "--set", "time.max_steps=3")[1]
check_true("the end of a run", place in told and "nJ" in told, told)
told = call(softwet, "run", "drop.toml", "--out", "loud", "--overwrite", "--threads", "1", "--set", "time.max_steps=3", "--units",
            "dimensionless")[1]
check_true("the end of a run in numbers", "L0" in told and " um" not in told, told)
said = call(softwet, "run", "drop.toml", "--units", "inch", code=1)[1]
check_true("units that there are", "--units = inch: must be laboratory or dimensionless" in said, said)
pathlib.Path("loud/units.json").write_text("{")
check_true("a file that is cut", "units.json" in tool("status", "loud", code=1)[1])
call(softwet, "run", "twin.toml", "--out", "loud", "--overwrite", "--threads", "1", "--quiet", "--set", "time.max_steps=1")
check_true("an old file goes", not pathlib.Path("loud/units.json").exists())
check_true("scales of the file", abs(json.loads(pathlib.Path("run/units.json").read_text())["one_unit_in_si"]["time"] / time - 1) < 1e-9)
try:
    import matplotlib  # noqa: F401
except ImportError:
    sys.exit("laboratory: no matplotlib, so no pictures were tested")
tool("plot", "run", "--history", "--out", "curves.svg")
drawn = pathlib.Path("curves.svg").read_text()
check_true("curves", "µm" in drawn and "/ ms" in drawn and "mm/s" in drawn, "")
tool("plot", "run", "--history", "--out", "numbers.svg", "--units", "dimensionless")
check_true("curves of numbers", "µm" not in pathlib.Path("numbers.svg").read_text())
tool("plot", "run", "--interface", "--out", "wall.svg")
check_true("the wall", "µm" in pathlib.Path("wall.svg").read_text())
tool("report", "run", "--out", "page")
tool("report", "run", "--out", "page", "--units", "dimensionless")
