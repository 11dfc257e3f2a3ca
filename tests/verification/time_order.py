#!/usr/bin/env python3
"""Order of the time scheme on the moving droplet: the pull goes on from one state with steps of 8, 4, 2 and 1.
usage: time_order.py SOFTWET"""

import pathlib
import shutil
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "regression"))
import _measure  # noqa: E402
from _scene import check, run  # noqa: E402

SCENE = ["domain.elements=[64,32]", "fluid.capillarity=1/32", "output.fields.times=[0]", "domain.grading.fine=everywhere"]
run("tensotaxis_pull_2d", "start", SCENE + ["time.end=200"])
centre, energy = [], []
for dt in (8, 4, 2, 1):
    shutil.rmtree(f"dt_{dt}", ignore_errors=True)
    shutil.copytree("start", f"dt_{dt}")
    run("tensotaxis_pull_2d", f"dt_{dt}",
        SCENE + ["time.end=280", f"time.dt_max={dt}", "time.tolerance=1e3", "solver.newton.rtol=1e-9",
                 "solver.krylov.rtol=1e-3"], ("--resume", "--quiet", "--threads", "1"))
    rows = _measure.history(f"dt_{dt}")
    centre.append(rows["x_centre"][-1])
    energy.append(rows["energy_elastic"][-1])
for name, values in (("X_c", centre), ("elastic energy", energy)):
    change = numpy.diff(values)
    print(f"{name} at t = 280: {values}")
    for ratio in change[1:] / change[:-1]:
        check(f"{name}: change of the next halving over this one, minus 1/4", abs(ratio - 0.25), 0.05)
