#!/usr/bin/env python3
"""A droplet across a periodic side is the droplet in the middle, moved. usage: periodic_seam.py SOFTWET"""

import numpy
from _scene import RIGID, TIGHT, check, check_true, history, run

# Steps of one size: the error that would choose them counts what is copied across the seam twice.
PERIODIC = ["boundary.left=periodic", "boundary.right=periodic", "droplet[0].radius=0.25", "fluid.capillarity=1/32",
            "domain.elements=[64,32]", "time.max_steps=6", "time.dt_initial=0.01", "time.dt_max=0.01", "time.tolerance=1e3"]


def of_droplet_at(x):
    run("static_droplet_rigid_2d", f"at_{x}", RIGID + TIGHT + PERIODIC + [f"droplet[0].centre=[{x},0]"])
    return history(f"at_{x}")


middle = of_droplet_at(0.5)
for x in (0, 0.0625, 0.9375):
    moved = of_droplet_at(x)
    check(f"x = {x}: centre", numpy.abs(numpy.remainder(moved["x_centre"] - x + 0.5, 1) - 0.5).max(), 1e-7)
    check_true("it lies inside the domain", ((moved["x_centre"] >= 0) & (moved["x_centre"] <= 1)).all())
    for name in ("x_left", "x_right"):
        reach = (moved[name] - moved["x_centre"]) - (middle[name] - middle["x_centre"])
        check(f"x = {x}: {name} from the centre", numpy.abs(reach).max(), 1e-7)
    for name in ("angle_left", "angle_right"):
        check_true(f"{name} exists", numpy.isfinite(moved[name]).all())
        check(f"x = {x}: {name}", numpy.abs(moved[name] - middle[name]).max(), 1e-3)
    check(f"x = {x}: velocity", numpy.nanmax(numpy.abs(moved["velocity"] - middle["velocity"])), 1e-6)
