#!/usr/bin/env python3
"""A run stopped and resumed gives the history of one that was not stopped. usage: resume.py SOFTWET"""

import numpy
from _scene import PULL, TIGHT, check, check_true, history, record, run

# The droplet's velocity and momentum are differences of nearly equal numbers; they are compared on their own scale.
run("tensotaxis_pull_2d", "whole", PULL + TIGHT)
run("tensotaxis_pull_2d", "parts", PULL + TIGHT + ["time.max_steps=20"])
run("tensotaxis_pull_2d", "parts", PULL + TIGHT + ["time.max_steps=45"], ["--resume", "--quiet", "--threads", "1"])
before = record("parts")["seconds"]["total"]
run("tensotaxis_pull_2d", "parts", PULL + TIGHT, ["--resume", "--quiet", "--threads", "1"])

whole, parts = history("whole"), history("parts")
counts = record("parts")["counts"]
check_true("run.json counts the whole run", counts["newton"] >= parts["newton"].sum() and counts["krylov"] >= parts["krylov"].sum()
           and counts["preconditioner_builds"] >= 3 and counts["steps"] == parts["step"][-1], str(counts))
seconds = record("parts")["seconds"]
check_true("and its seconds", seconds["total"] > before and seconds["product"] <= seconds["total"], f"{before}, {seconds}")
check_true("same columns", list(whole) == list(parts))
check_true("same steps", numpy.array_equal(whole["step"], parts["step"]), f"{len(parts['step'])} rows")
for name in whole:
    if name in ("newton", "krylov", "mass_drift"):
        continue
    a, b = whole[name], parts[name]
    check_true(f"{name}: same empty cells", numpy.array_equal(numpy.isnan(a), numpy.isnan(b)))
    if numpy.isfinite(a).any():
        scale = max(numpy.nanmax(numpy.abs(a)), 1e-12)
        check(name, numpy.nanmax(numpy.abs(a - b)) / scale, 1e-8)
check_true("interface.csv has both field times",
           len(open("parts/interface.csv").readlines()) == len(open("whole/interface.csv").readlines()))

# A row written only because the run stopped there is no part of the resumed history.
sparse = PULL + TIGHT + ["output.history.every=7"]
run("tensotaxis_pull_2d", "sparse", sparse + ["time.max_steps=20"])
check_true("last row is written", history("sparse")["step"].tolist() == [0, 7, 14, 20])
run("tensotaxis_pull_2d", "sparse", sparse + ["time.max_steps=30"], ["--resume", "--quiet", "--threads", "1"])
rows = history("sparse")
check_true("and dropped on resume", rows["step"].tolist() == [0, 7, 14, 21, 28, 30])
check("velocity over the gap", abs((rows["x_centre"][3] - rows["x_centre"][2]) / (rows["t"][3] - rows["t"][2])
                                   - rows["velocity"][3]), 1e-12)
