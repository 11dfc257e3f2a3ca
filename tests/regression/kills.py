#!/usr/bin/env python3
"""Runs that are killed again and again, and resumed with other numbers of threads, give the tables and fields of runs
that were not disturbed, in every bit. usage: kills.py SOFTWET"""

import subprocess

from _kills import with_kills
from _same import check_same
from _scene import PULL, cases, check_true, command_of_file, environment, record, run

SMOOTH = [*PULL, "time.dt_max=0.1", "output.fields.times=[0,0.5,1,2.5]", "time.end=2.5"]
FAST = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "load[0].start=0.1",
        "load[0].ramp=0.1", "load[0].force=[2,0]", "time.end=0.2", "output.fields.times=[0,0.05]", "output.history.every=1"]


def disturbed(name, case, settings, kills):
    run(case, name, settings)
    steps = record(name)["counts"]["steps"]

    def begin(number, more, options):
        words = command_of_file(cases / f"{case}.toml", f"{name}_killed", [*settings, *more],
                                [*options, "--quiet", "--threads", str(1 + number % 3)])
        return subprocess.Popen(words, stderr=subprocess.PIPE, text=True, env=environment)

    killed = with_kills(begin, f"{name}_killed", steps, kills)
    check_true(f"{name}: {steps} steps, stopped {kills} times, of which killed", killed > 0, str(killed))
    check_same(name, f"{name}_killed", name)


disturbed("pull", "tensotaxis_pull_2d", SMOOTH, 20)
disturbed("seldom", "tensotaxis_pull_2d", [*SMOOTH, "output.history.every=7", "solver.precision=double"], 4)
disturbed("schwarz", "static_droplet_rigid_2d",
          ["domain.elements=[32,16]", "fluid.capillarity=1/16", "time.end=4", "output.fields.times=[0,4]",
           "time.dt_max=0.2", "solver.krylov.preconditioner=schwarz", "boundary.left=periodic", "boundary.right=periodic"], 4)
for scheme, mass in (("kick_drift", "corrected"), ("kick_drift", "consistent"), ("rkl2", "corrected"), ("rkl2", "lumped"),
                     ("ssp_rk3", "lumped"), ("ssp_rk3", "consistent")):
    disturbed(f"{scheme}_{mass}", "tensotaxis_pull_2d", [*FAST, f"time.scheme={scheme}", f"time.mass={mass}"], 4)
