#!/usr/bin/env python3
"""Three dimensions with Schwarz's method: the same bits on any number of processes, with parts of different widths,
with coarse levels that are cut and others that are not, and around periodic sides. usage: space.py SOFTWET"""

import sys

from _ranks import check_same, has_configuration, run

if not has_configuration("3D degree 2"):
    sys.exit(0)
SCENE = ["domain.elements=[24,12,10]", "fluid.capillarity=0.1", "output.fields.times=[]", "time.max_steps=3"]
PERIODIC = [f"boundary.{side}=periodic" for side in ("left", "right", "front", "back")]
FIG4 = ["output.fields.times=[]", "time.max_steps=1"]  # a coarse level of 26 000 unknowns, in parts of 6, 6 and 8 elements
AROUND = [*FIG4, *PERIODIC, "domain.elements=[32,24,20]"]
RUNS = {
    "needle": (SCENE, (2, 3)),
    "graded": ([*SCENE, "domain.elements=[40,20,10]", "domain.grading.box=[[0.05,0.2,0.0],[0.45,0.6,0.4]]"], (2, 3)),
    "periodic": ([*SCENE, *PERIODIC], (3,)),
    "fig4": (FIG4, (3,)),
    "around": (AROUND, (2,)),
}

for name, (settings, counts) in RUNS.items():
    run(1, "fig4_needle_3d_small", f"{name}_1", settings, threads=2)
    for count in counts:
        run(count, "fig4_needle_3d_small", f"{name}_{count}", settings)
        check_same(f"{name}, {count} processes", f"{name}_{count}", f"{name}_1")
