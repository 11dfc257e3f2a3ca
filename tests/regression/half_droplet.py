#!/usr/bin/env python3
"""Half a droplet on a slip side is the half of a whole one: contact line, angle, mass, chemical potential.
usage: half_droplet.py SOFTWET"""

import numpy
from _scene import check, check_true, history, run

STEPS = ["fluid.capillarity=1/32", "time.end=0.3", "time.dt_initial=0.001", "time.dt_max=0.05", "time.tolerance=1e3",
         "output.fields.times=[]", "solver.newton.rtol=1e-10", "solver.newton.atol=1e-14"]
HALF = ["domain.size=[0.5,0.5]", "domain.elements=[32,32]"]
run("static_droplet_rigid_2d", "whole", ["domain.elements=[64,32]", "droplet[0].radius=0.25", *STEPS])
run("static_droplet_rigid_2d", "left", ["droplet[0].centre=[0,0]", "droplet[0].radius=0.25", *HALF, *STEPS])
run("static_droplet_rigid_2d", "right", ["droplet[0].centre=[0.5,0]", "droplet[0].radius=0.25", *HALF, *STEPS])
whole, left, right = history("whole"), history("left"), history("right")
check_true("the contact line moves", whole["x_right"].max() - whole["x_right"].min() > 1e-4)
# The halves are mirror images of each other to the tolerance of Newton.
for name, one, other in (("contact line", left["x_right"], 0.5 - right["x_left"]), ("side", left["x_left"], 0.5 - right["x_right"]),
                         ("angle", left["angle_right"], right["angle_left"]), ("mass", left["mass"], right["mass"]),
                         ("laplace", left["laplace"], right["laplace"]), ("energy", left["energy_total"], right["energy_total"])):
    check(f"left and right half, {name}: largest difference", numpy.abs(one - other).max(), 1e-7)
# Against the whole they differ by the mesh: its splines are smooth across the middle, theirs flat there only in
# the limit.
for name, one, other, bound in (("x_right", whole["x_right"] - 0.5, left["x_right"], 1e-4),
                                ("angle_right", whole["angle_right"], left["angle_right"], 0.05),
                                ("mass", whole["mass"] / 2, left["mass"], 1e-4),
                                ("energy", whole["energy_total"] / 2, left["energy_total"], 1e-4)):
    check(f"half and whole, {name}: largest difference", numpy.abs(one - other).max(), bound)
check_true("no angle at the side", numpy.isnan(left["angle_left"]).all() and numpy.isnan(right["angle_right"]).all())
