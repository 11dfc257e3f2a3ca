#!/usr/bin/env python3
"""tests/device/emulated.py, which executes kernels of a CUDA build on a processor: this program accepts its small
scenes, and its comparison finds what differs. usage: emulated.py SOFTWET"""

import os
import pathlib
import subprocess
import sys

from _scene import check_true, environment, softwet

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
sys.path.insert(0, str(ROOT / "tests/device"))
import emulated  # noqa: E402

scenes = emulated.make_scenes()
check_true("every case has a small scene", {path.stem for path in (ROOT / "cases").glob("*.toml")} <= set(scenes))
check_true("the selection has both kinds of schemes, solids and graphs",
           {"impact_rigid_2d, full, graph", "impact_soft_2d, full", "tensotaxis_pull_2d, full"}
           <= {name for name, scene in scenes.items() if scene.fast})


def refused(scene):
    """What the program says against a scene; "" where it accepts the scene, or lacks its configuration."""
    words = [softwet, "check", ROOT / f"cases/{scene.case}.toml"]
    for setting in scene.settings:
        words += ["--set", setting]
    done = subprocess.run(words, capture_output=True, text=True, env=environment)
    errors = [line for line in done.stderr.splitlines() if "error:" in line and "not in this build" not in line]
    return "\n".join(errors)


# Each case once, and each kind of setting once.
varied = ("impact_rigid_2d", emulated.PULL)
chosen = {name: scene for name, scene in scenes.items() if name == scene.case or scene.case in varied}
for name, scene in chosen.items():
    problem = refused(scene)
    check_true(f"{name} is accepted", not problem, problem)

rows = [{"t": "0", "energy": "2", "mass_drift": "0", "x_left": "0.5", "ridge_left": "0.5", "newton": "1"},
        {"t": "1", "energy": "4", "mass_drift": "1e-16", "x_left": "0.5", "ridge_left": "0.5", "newton": "2"}]


def changed(**values):
    return [rows[0], {**rows[1], **values}]


inf = float("inf")
compared = {  # found rows, and how often the difference is what is allowed: 1e-12
    "equal rows": (rows, 0),
    "a number": (changed(energy="4.004"), 0.004 / 4 / 1e-12),
    "a place that is searched for": (changed(x_left="0.5000005"), 1e-6 / 1e-10),
    "a ridge": (changed(ridge_left="0.5000005"), 1e-6 / 1e-10),
    "rounding of a drift": (changed(mass_drift="3e-16"), 2e-4),
    "a number of iterations": (changed(newton="3"), 0),
    "a number that is none": (changed(energy="nan"), inf),
    "a column that is empty": (changed(energy=""), inf),
    "a row less": (rows[:1], inf),
    "no rows": ([], inf),
}
for what, (found, expected) in compared.items():
    off, place = emulated.difference(rows, found, 1e-12)
    good = off == expected or abs(off - expected) < 1e-6 * expected
    check_true(f"compared: {what}", good, f"{off}, not {expected}: {place}")

report = pathlib.Path("report.txt")
report.write_text("""kernel a<Tile>
  launches 1
  barrier 0 at line 7 of the PTX: tile.hpp:9: passed 4
  barrier 1 at line 8 of the PTX: : passed 0
  barrier 2 at line 9 of the PTX: : passed 1
kernel other
  barrier 0 at line 7 of the PTX: : passed 4
""")
found = emulated.barriers_of(report, "Tile")
expected = {("a<Tile>", 0): "tile.hpp:9", ("a<Tile>", 2): "number 2 of a<Tile>"}
check_true("barriers that were passed", found == expected, found)
