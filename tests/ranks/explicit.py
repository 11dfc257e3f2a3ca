#!/usr/bin/env python3
"""An explicit scheme gives the same bits on any number of processes. usage: explicit.py SOFTWET"""

from _ranks import check_same, run

SCENE = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "load[0].start=0.05",
         "load[0].ramp=0.02", "load[0].force=[2,0]", "time.end=0.03", "output.fields.times=[0,0.03]",
         "time.scheme=ssp_rk3", "time.mass=lumped"]

run(1, "tensotaxis_pull_2d", "explicit_1", SCENE)
for count in (2, 3, 4):
    run(count, "tensotaxis_pull_2d", f"explicit_{count}", SCENE)
    check_same(f"{count} processes", f"explicit_{count}", "explicit_1")
run(2, "tensotaxis_pull_2d", "explicit_2x2", SCENE, threads=2)
check_same("2 processes with 2 threads", "explicit_2x2", "explicit_1")
