#!/usr/bin/env python3
"""Three dimensions with Schwarz's method: the same bits on any number of processes, also around periodic sides.
usage: space.py SOFTWET"""

import subprocess
import sys

from _ranks import check_same, run
from _scene import softwet

if "3D degree 2" not in subprocess.run([softwet, "info"], capture_output=True, text=True).stdout:
    print("this build has no 3D")
    sys.exit(0)
SCENE = ["domain.elements=[24,12,10]", "fluid.capillarity=0.1", "solver.krylov.preconditioner=schwarz",
         "output.fields.times=[]", "time.max_steps=3"]
PERIODIC = [f"boundary.{side}=periodic" for side in ("left", "right", "front", "back")]

for name, settings, counts in (("needle", SCENE, (2, 3)), ("periodic", [*SCENE, *PERIODIC], (3,))):
    run(1, "fig4_needle_3d_small", f"{name}_1", settings, threads=2)
    for count in counts:
        run(count, "fig4_needle_3d_small", f"{name}_{count}", settings)
        check_same(f"{name}, {count} processes", f"{name}_{count}", f"{name}_1")
