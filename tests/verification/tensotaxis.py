#!/usr/bin/env python3
"""The pull: where the contact lines are at t = 50 (128x64), and the mirrored load (32x16). The whole pull and the push
are in tools/verify. usage: tensotaxis.py SOFTWET"""

import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "regression"))
import _measure  # noqa: E402
from _measure import compare  # noqa: E402
from _scene import PULL, TIGHT, check, run  # noqa: E402

run("tensotaxis_pull_2d", "pull", ["time.end=50", "output.fields.times=[0,50]"])
pull = _measure.history("pull")
compare("X_c at t = 50", pull["x_centre"][-1], _measure.PULL_CENTRE[50], 0.001, relative=False)
check("drift of the mass", numpy.abs(pull["mass_drift"]).max(), 1e-8)
wall = _measure.interface("pull", first=True)["displacement_y"]
compare("ridge before the load", wall.max(), 5.5e-3, 0.5e-3, relative=False)
compare("dimple before the load", wall.min(), -2.75e-3, 0.25e-3, relative=False)
compare("far field before the load", wall[0], -3.5e-4, 0.1e-4, relative=False)

MIRRORED = ["load[0].box=[[0.2,0],[0.3,0.125]]", "load[0].force=[-0.16215,0]"]
run("tensotaxis_pull_2d", "right", PULL + TIGHT)
run("tensotaxis_pull_2d", "left", PULL + TIGHT + MIRRORED)
right, left = _measure.history("right"), _measure.history("left")
check("steps of the mirrored run differ", abs(len(right["t"]) - len(left["t"])), 0)
check("it moves", 1e-4 / (right["x_centre"][-1] - 0.5), 1)
check("X_c + X_c' - 1", numpy.nanmax(numpy.abs(right["x_centre"] + left["x_centre"] - 1)), 1e-9)
check("energies differ by", numpy.abs(right["energy_total"] - left["energy_total"]).max(), 1e-12)
