#!/usr/bin/env python3
"""Explicit schemes give the same bits on any number of processes, with corrected, lumped and consistent masses.
usage: explicit.py SOFTWET"""

from _ranks import check_same, run

SCENE = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "load[0].start=0.05",
         "load[0].ramp=0.02", "load[0].force=[2,0]", "output.fields.times=[0,0.03]", "output.history.every=1"]
AROUND = ["boundary.left=periodic", "boundary.right=periodic"]
RUNS = {
    "lumped": ([*SCENE, "time.scheme=ssp_rk3", "time.mass=lumped", "time.end=0.03"], (2, 3, 4)),
    "consistent": ([*SCENE, "time.scheme=ssp_rk3", "time.mass=consistent", "load[0].start=0.01", "time.end=0.002"], (3,)),
    "around": ([*SCENE, *AROUND, "time.scheme=ssp_rk3", "time.mass=consistent", "load[0].start=0.01", "time.end=0.002"], (2,)),
    "rkl2": ([*SCENE, "time.scheme=rkl2", "time.end=0.03"], (3,)),
    "kick_drift": ([*SCENE, "time.scheme=kick_drift", "time.end=0.03"], (2, 3, 4)),
    "kick_drift_around": ([*SCENE, *AROUND, "time.scheme=kick_drift", "time.end=0.01"], (2,)),
}

for name, (settings, counts) in RUNS.items():
    run(1, "tensotaxis_pull_2d", f"{name}_1", settings)
    for count in counts:
        run(count, "tensotaxis_pull_2d", f"{name}_{count}", settings)
        check_same(f"{name}, {count} processes", f"{name}_{count}", f"{name}_1")
run(2, "tensotaxis_pull_2d", "lumped_2x2", RUNS["lumped"][0], threads=2)
check_same("lumped, 2 processes with 2 threads", "lumped_2x2", "lumped_1")
