#!/usr/bin/env python3
"""About an axis, states that start from another state have both contact lines: `steady --along`, `initial.from`, and a
run that is resumed after it. usage: axis_from_state.py SOFTWET"""

import pathlib
import shutil
import subprocess

from _scene import cases, check, check_true, environment, history, run, softwet

SCENE = ["domain.elements=[32,32]", "fluid.capillarity=1/32", "output.fields.times=[]"]
RUN = [*SCENE, "substrate.young=1", "time.tolerance=1e-2"]


def has_both_sides(name, folder):
    rows = history(folder)
    for side in ("left", "right"):
        check_true(f"{name}: x_{side} and angle_{side} are numbers", rows[f"x_{side}"][-1] == rows[f"x_{side}"][-1]
                   and rows[f"angle_{side}"][-1] == rows[f"angle_{side}"][-1])
    check_true(f"{name}: the droplet has a width", rows["x_right"][-1] > 0.05)
    check(f"{name}: x_left = -x_right, x_centre = 0", abs(rows["x_left"] + rows["x_right"]).max() + abs(rows["x_centre"]).max(), 0)
    check(f"{name}: angles of both sides", abs(rows["angle_left"] - rows["angle_right"]).max(), 0)


def along():
    sets = [word for setting in SCENE for word in ("--set", setting)]
    subprocess.run([softwet, "steady", str(cases / "sessile_soft_axisymmetric.toml"), "--out", "along", "--threads", "1", *sets,
                    "--along", "substrate.young=2,1"], check=True, capture_output=True, env=environment)
    folders = sorted(path.parent for path in pathlib.Path("along").glob("*/history.csv"))
    check_true("two states along a key", len(folders) == 2)
    for folder in folders:
        has_both_sides(f"steady --along, {folder.name}", folder)


def from_a_state():
    run("sessile_soft_axisymmetric", "first", [*RUN, "time.end=0.5"])
    has_both_sides("a run from its own start", "first")
    run("sessile_soft_axisymmetric", "second", [*RUN, "time.end=0.2", "initial.from=first"])
    has_both_sides("initial.from", "second")
    run("sessile_soft_axisymmetric", "second", [*RUN, "time.end=0.4", "initial.from=first"],
        options=("--resume", "--quiet", "--threads", "1"))
    has_both_sides("resumed after initial.from", "second")


for folder in ("along", "first", "second"):
    shutil.rmtree(folder, ignore_errors=True)
along()
from_a_state()
