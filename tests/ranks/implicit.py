#!/usr/bin/env python3
"""Generalized-alpha gives the same bits on any number of processes: pulled on a soft solid, at a rigid wall, around a
periodic side, with blended traction, in the solid alone, and with splines of degree 3 where the build has them.
usage: implicit.py SOFTWET"""

from _ranks import check_same, has_configuration, run

SOFT = ["domain.elements=[44,16]", "fluid.capillarity=1/16", "load[0].start=2", "load[0].ramp=1"]
GRADED = ["domain.elements=[64,32]", "fluid.capillarity=1/32", "load[0].start=2", "load[0].ramp=1",
          "domain.grading.fine=box", "domain.grading.box=[[0.28,0.0625],[0.72,0.3]]"]
SCENES = {
    "pull": ("tensotaxis_pull_2d", [*SOFT, "time.end=4", "output.fields.times=[0,4]"], (2, 3, 4)),
    "double": ("tensotaxis_pull_2d", [*SOFT, "time.max_steps=8", "solver.precision=double"], (3,)),
    "rest": ("tensotaxis_pull_2d", [*SOFT, "time.start=equilibrium", "time.max_steps=4"], (2,)),
    "graded": ("tensotaxis_pull_2d", [*GRADED, "time.end=4", "output.fields.times=[0,4]"], (2, 3, 4)),
    "graded around": ("tensotaxis_pull_2d", [*GRADED, "time.max_steps=8", "boundary.left=periodic",
                                             "boundary.right=periodic"], (2, 3)),
    "periodic": ("tensotaxis_pull_2d", [*SOFT, "time.end=2", "output.fields.times=[2]", "boundary.left=periodic",
                                        "boundary.right=periodic"], (2, 4)),
    "blended": ("tensotaxis_pull_2d", [*SOFT, "time.max_steps=8", "fluid.traction=blended", "boundary.left=periodic",
                                       "boundary.right=periodic"], (2, 3)),
    "rigid": ("static_droplet_rigid_2d", ["domain.elements=[44,16]", "fluid.capillarity=1/16", "time.max_steps=12"],
              (2, 3)),
    "sticking": ("sticking_droplet_2d", ["domain.elements=[44,22]", "fluid.capillarity=1/32", "fluid.line_friction=0.01",
                                         "time.max_steps=12"], (2, 3)),
    "solid": ("solid_layer_2d", ["time.max_steps=12"], (2,)),
}

if has_configuration("2D degree 3"):
    CUBIC = ["domain.degree=3", *SOFT, "time.max_steps=6"]
    SCENES["cubic"] = ("tensotaxis_pull_2d", [*CUBIC, "output.fields.times=[0]"], (2, 3))
    SCENES["cubic around"] = ("tensotaxis_pull_2d", [*CUBIC, "boundary.left=periodic", "boundary.right=periodic"], (3,))

for name, (case, settings, counts) in SCENES.items():
    run(1, case, f"{name}_1", settings)
    for count in counts:
        run(count, case, f"{name}_{count}", settings)
        check_same(f"{name}, {count} processes", f"{name}_{count}", f"{name}_1")
run(2, "tensotaxis_pull_2d", "pull_2x2", SCENES["pull"][1], threads=2)
check_same("pull, 2 processes with 2 threads", "pull_2x2", "pull_1")
