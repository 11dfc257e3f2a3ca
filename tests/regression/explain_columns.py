#!/usr/bin/env python3
"""`softwet explain` answers for every column that a run writes. usage: explain_columns.py SOFTWET"""

import csv
import json
import re
import subprocess

from _scene import RIGID, check_true, run, run_file, softwet, write_box


def header(folder, table):
    with open(f"{folder}/{table}.csv", newline="") as file:
        return next(csv.reader(file))


def explained(folder, dimension):
    for table in ("history", "interface"):
        known = {column["name"]: column for column in columns[table]["columns"]}
        for name in header(folder, table):
            column = known.get(re.sub(r"_\d+$", "", name), {})
            check_true(f"{folder}: {table}.{name} is in explain --json", "unit" in column and "meaning" in column
                       and column.get("dimension", dimension) == dimension, str(column))
            result = subprocess.run([softwet, "explain", f"{table}.{name}"], capture_output=True, text=True)
            good = result.returncode == 0 and f"in {table}.csv, " in result.stdout
            check_true(f"{folder}: {table}.{name} is explained", good, result.stderr)


columns = json.loads(subprocess.run([softwet, "explain", "--json"], capture_output=True, text=True, check=True).stdout)
few = ["time.max_steps=2", "output.fields.times=[0]"]
run("static_droplet_rigid_2d", "plane", [s for s in RIGID if "fields" not in s] + few)
explained("plane", 2)
write_box("space", 0.4, [8, 8, 4], 0.1, 75, """
[[droplet]]
centre = [0.2, 0.2, 0.0]
radius = 0.15
[[droplet]]
centre = [0.6, 0.6, 0.0]
radius = 0.15
[time]
end = 1.0
""")
run_file("space.toml", "space", few)
explained("space", 3)

# Keys by the ends of their names, and by the words of their meanings.
for words, parts in (("wall_law", ["fluid.wall_law\n", "one of"]), ("stiffness", ["substrate.fibre.stiffness ", "needle[].stiffness "]),
                     ("Surface tension", ["substrate.surface_tension ", "substrate.surface_tension_wet "])):
    result = subprocess.run([softwet, "explain", words], capture_output=True, text=True)
    check_true(f"explain {words}", result.returncode == 0 and all(part in result.stdout for part in parts), result.stdout + result.stderr)
result = subprocess.run([softwet, "explain", "no such words"], capture_output=True, text=True)
check_true("explain: words that no key has", result.returncode == 1 and "no such words" in result.stderr, result.stderr)
