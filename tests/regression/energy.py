#!/usr/bin/env python3
"""With the wall-energy law on a rigid wall the energy falls at every accepted step. usage: energy.py SOFTWET"""

import numpy
from _scene import RIGID, check, check_true, history, run

for angle in (60, 75, 120):
    run("static_droplet_rigid_2d", f"energy_{angle}",
        RIGID + ["fluid.wall_law=energy", f"fluid.contact_angle={angle}", "solver.newton.rtol=1e-9"])
    rows = history(f"energy_{angle}")
    energy = rows["energy_total"]
    check_true(f"{angle} degrees: something is dissipated", energy[0] - energy[-1] > 1e-5, f"{energy[0] - energy[-1]:.3g}")
    check(f"{angle} degrees: largest rise of the energy", numpy.diff(energy).max(), 1e-15)
    parts = rows["energy_kinetic"] + rows["energy_free"] + rows["energy_wall"] + rows["energy_elastic"]
    check(f"{angle} degrees: the total is the sum of its parts", numpy.abs(parts - energy).max(), 1e-15)
