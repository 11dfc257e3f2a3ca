#!/usr/bin/env python3
"""A run stopped and resumed gives the bits of one that was not stopped. usage: resume.py SOFTWET"""

import shutil

import h5py
from _same import check_same
from _scene import PULL, check, check_true, history, record, run

RESUME = ["--resume", "--quiet", "--threads", "1"]

run("tensotaxis_pull_2d", "whole", PULL)
run("tensotaxis_pull_2d", "parts", [*PULL, "time.max_steps=20"])
shutil.rmtree("other", ignore_errors=True)
shutil.copytree("parts", "other")
run("tensotaxis_pull_2d", "parts", [*PULL, "time.max_steps=45"], ["--resume", "--quiet", "--threads", "2"])
before = record("parts")["seconds"]["total"]
run("tensotaxis_pull_2d", "parts", PULL, RESUME)
check_same("a resumed run", "parts", "whole")
seconds = record("parts")["seconds"]
check_true("seconds count the whole run", seconds["total"] > before and seconds["product"] <= seconds["total"], f"{before}, {seconds}")

# Without what the scheme remembered, the preconditioner is built anew.
with h5py.File("other/checkpoint.h5", "r+") as file:
    for group in ("arrays", "texts"):
        del file[group]["memory"]
    for name in [name for name in file["values"].attrs if name.startswith("memory/")]:
        del file["values"].attrs[name]
    file["values"].attrs["run/started"] = -86400.0
run("tensotaxis_pull_2d", "other", PULL, RESUME)
check_true("a run that began before 1970 goes on", record("other")["started"] == "1969-12-31T00:00:00Z", record("other")["started"])
check("up to the tolerance of the solver", abs(history("other")["x_centre"][-1] / history("whole")["x_centre"][-1] - 1), 1e-4)
kept = (history("other")["step"] <= 20).sum()
check_true("its rows are kept", open("other/history.csv").readlines()[:kept + 1] == open("whole/history.csv").readlines()[:kept + 1])

# Another solver begins with a preconditioner of its own.
run("tensotaxis_pull_2d", "parts", [*PULL, "time.end=11", "solver.newton.rtol=1e-5"], RESUME)
check_true("a resumed run may change the solver", history("parts")["t"][-1] > history("whole")["t"][-1])

# A row written only because the run stopped there is no part of the resumed history.
sparse = PULL + ["output.history.every=7"]
run("tensotaxis_pull_2d", "sparse", sparse + ["time.max_steps=20"])
check_true("last row is written", history("sparse")["step"].tolist() == [0, 7, 14, 20])
run("tensotaxis_pull_2d", "sparse", sparse + ["time.max_steps=30"], ["--resume", "--quiet", "--threads", "1"])
rows = history("sparse")
check_true("and dropped on resume", rows["step"].tolist() == [0, 7, 14, 21, 28, 30])
check("velocity over the gap", abs((rows["x_centre"][3] - rows["x_centre"][2]) / (rows["t"][3] - rows["t"][2])
                                   - rows["velocity"][3]), 1e-12)
