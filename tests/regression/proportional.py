#!/usr/bin/env python3
"""The displacement of a linear solid is proportional to its load, over ten decades of the load, however stiff other
parts are: in `run`, in `steady`, and from `start = "equilibrium"`. usage: proportional.py SOFTWET"""

import pathlib
import subprocess

from _scene import check, check_true, environment, history, record, softwet

HEIGHT, LAYER, POISSON = 0.25, 0.125, 0.3
LAME = POISSON / ((1 + POISSON) * (1 - 2 * POISSON)) + 1 / (1 + POISSON)  # lambda + 2 G at E = 1


def label(number):
    return f"{number:.0e}".replace("+", "")


def scene(name, solid, bottom, weight):
    path = pathlib.Path(f"{name}.toml")
    path.write_text(f"""
name = "{name}"
domain = {{ size = [0.5, {HEIGHT}], elements = [10, 8] }}
substrate = {{ thickness = {HEIGHT}, poisson = {POISSON}, strain = "small", gravity = [0.0, {-weight!r}], {solid} }}
boundary = {{ left = "slip", right = "slip", top = "free", bottom = {bottom} }}
time = {{ end = 60.0 }}
output = {{ fields = {{ times = [] }} }}
[[probe]]
name = "top"
quantity = "displacement_y"
point = [0.2, {HEIGHT}]
""")
    return path


def top(folder, path, command, *settings):
    sets = [word for setting in settings for word in ("--set", setting)]
    done = subprocess.run([softwet, command, str(path), "--out", folder, "--overwrite", "--quiet", "--threads", "1", *sets],
                          capture_output=True, text=True, env=environment)
    check_true(f"{folder}: exit code 0", done.returncode == 0, done.stdout + done.stderr)
    return history(folder)["top"][-1]


def three_ways(name, path, right, tolerance):
    check(f"{name}: run", abs(top(name, path, "run") / right - 1), tolerance)
    check(f"{name}: steady", abs(top(name, path, "steady") / right - 1), 1e-6)
    start = top(name, path, "run", 'time.start="equilibrium"', "time.end=5.0")
    check(f"{name}: from equilibrium", abs(start / right - 1), 1e-6)


SLIP = '"slip"'
# What is above carries onto each height: of one column, and of a soft layer on a stiff one.
ONE_COLUMN = HEIGHT**2 / (2 * LAME)
for contrast in (1e2, 1e6, 1e8):
    soft, stiff = LAYER**2 / (2 * LAME), 1.5 * LAYER**2 / (LAME * contrast)
    for weight in (1e-2, 1e-7, 1e-12):
        name = f"layers_{label(contrast)}_{label(weight)}"
        path = scene(name, f'young = "y < {LAYER} ? {contrast:g} : 1", joint = {LAYER}, viscosity = 0.1', SLIP, weight)
        three_ways(name, path, -weight * (soft + stiff), 1e-3)

# Parts that are stiff, and do not carry the weight.
for name, solid, bottom in (("fibre", "fibre = { stiffness = 1e10 }", SLIP), ("faces", "surface_modulus = [1e10, 1e10]", SLIP),
                            ("bulk_viscosity", "bulk_viscosity = 1e10", SLIP), ("foundation", "density = 1.0", '"free", foundation = [1e14, 1e14]')):
    for weight in (1e-2, 1e-7):
        path = scene(f"{name}_{label(weight)}", f"young = 1.0, {solid}", bottom, weight)
        check(f"{name}, {weight:g}: steady", abs(top(f"{name}_{label(weight)}", path, "steady") / (-weight * ONE_COLUMN) - 1), 1e-6)

    if name in ("fibre", "faces"):
        path = scene(f"{name}_run", f"young = 1.0, viscosity = 0.1, {solid}", bottom, 1e-7)
        check(f"{name}: run", abs(top(f"{name}_run", path, "run") / (-1e-7 * ONE_COLUMN) - 1), 1e-3)

# Nearly incompressible.
for poisson in (0.499, 0.49999):
    shear = 1 / (2 * (1 + poisson))
    modulus = 2 * shear * (1 - poisson) / (1 - 2 * poisson)
    for weight in (1e-2, 1e-7):
        name = f"nu_{poisson}_{label(weight)}"
        path = scene(name, "young = 1.0, viscosity = 0.1", SLIP, weight)
        path.write_text(path.read_text().replace(f"poisson = {POISSON}", f"poisson = {poisson}"))
        three_ways(name, path, -weight * HEIGHT**2 / (2 * modulus), 1e-3)

# A solid that rests under its load stays there at little cost.
folder = "layers_1e06_1e-02"
counts = record(folder)["counts"]
check("at rest: iterations of Newton's method for each step", counts["newton"] / counts["steps"], 1)
