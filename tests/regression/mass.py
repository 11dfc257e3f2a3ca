#!/usr/bin/env python3
"""Mass is conserved: to round-off, on a fixed mesh and on a moving one, whatever Newton's
method leaves. usage: mass.py SOFTWET"""

import numpy
from _scene import PULL, RIGID, TIGHT, check, history, run


def drift(folder):
    mass = history(folder)["mass"]
    return numpy.abs(mass / mass[0] - 1).max()


run("static_droplet_rigid_2d", "rigid", RIGID)
check("fixed mesh", drift("rigid"), 1e-13)
run("tensotaxis_pull_2d", "soft", PULL)
check("moving mesh, default tolerances", drift("soft"), 1e-12)
run("tensotaxis_pull_2d", "loose", PULL + ["solver.newton.rtol=0.1"])
check("moving mesh, loose tolerances", drift("loose"), 1e-12)
run("tensotaxis_pull_2d", "tight", PULL + TIGHT)
check("moving mesh, tight tolerances", drift("tight"), 1e-12)
check("the column mass_drift", numpy.abs(history("soft")["mass_drift"]).max(), 1e-12)
