#!/usr/bin/env python3
"""Runs of two processes that are killed again and again, and resumed with one, two or three, give the tables and fields
of one that was not disturbed, in every bit. usage: kills.py SOFTWET"""

import pathlib
import sys

from _ranks import check_same, check_true, record, run, start

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "regression"))
from _kills import first_process, with_kills  # noqa: E402

PULL = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "load[0].start=2", "load[0].ramp=1", "time.dt_max=0.1",
        "output.fields.times=[0,1]", "time.end=1.5"]
FAST = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "load[0].start=0.05",
        "load[0].ramp=0.02", "load[0].force=[2,0]", "time.end=0.03", "output.fields.times=[0]", "output.history.every=1"]
AROUND = ["boundary.left=periodic", "boundary.right=periodic"]


def disturbed(name, settings, kills):
    run(1, "tensotaxis_pull_2d", name, settings)
    steps, folder = record(name)["counts"]["steps"], f"{name}_killed"

    def begin(number, more, options):
        return start((2, 3, 2, 1)[number % 4], "tensotaxis_pull_2d", folder, [*settings, *more], [*options, "--quiet"])

    killed = with_kills(begin, folder, steps, kills, victim=lambda: first_process(folder))
    check_true(f"{name}: {steps} steps, stopped {kills} times, of which killed", killed > 0, str(killed))
    check_same(name, folder, name)


disturbed("pull", PULL, 8)
disturbed("pull_around", [*PULL, *AROUND], 4)
disturbed("kick_drift", [*FAST, "time.scheme=kick_drift"], 4)
disturbed("around", [*FAST, *AROUND, "time.scheme=rkl2", "time.mass=lumped", "time.end=0.01"], 4)
