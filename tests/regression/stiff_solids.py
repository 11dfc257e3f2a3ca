#!/usr/bin/env python3
"""Explicit steps of solids alone: nothing feeds the energy of stiff ones, a bound that falls without end stops a run, a
viscous solid creeps with its speed, and the number of steps is foreseen. usage: stiff_solids.py SOFTWET"""

import pathlib

from _same import check_same
from _scene import check, check_true, history, record, run_file

ALOUD = ("--overwrite", "--threads", "1")


def write(name, solid, time, bend):
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = [1.0, 0.25], elements = [24, 8] }}
substrate = {{ thickness = 0.25, young = 1.0, {solid} }}
boundary = {{ left = "periodic", right = "periodic", bottom = "clamped", top = "free" }}
time = {{ {time} }}
output = {{ fields = {{ times = [] }}, history = {{ every = 1 }} }}
initial = {{ displacement = ["{bend}*sin(2*pi*x/Lx)*y/H", "{bend}*0.8*cos(2*pi*2*x/Lx)*y/H"] }}
""")
    return f"{name}.toml"


def told(folder):
    return [event for event in record(folder)["events"] if "energy" in event["what"]]


# The bound of these steps swings by a percent, and steps that follow it feed the shortest waves: to 342 times the first
# energy.
FIBRES = write("fibres", "poisson = 0.3, fibre = { stiffness = 300.0, angle = 80.0 }",
               'end = 4.0, scheme = "kick_drift", max_steps = 3000', 0.001)
TENSION = write("tension", 'poisson = 0.49, material = "neo_hookean", surface_tension = 1.0',
                'end = 40.0, scheme = "kick_drift", max_steps = 3000', 0.01)
for name, case in (("fibres", FIBRES), ("tension", TENSION)):
    run_file(case, name)
    energy, steps = history(name)["energy_total"], history(name)["dt"][2:-1]
    check(f"{name}: largest energy over the first", energy.max() / energy[0], 1.05)
    check_true(f"{name}: no event about the energy", not told(name), str(told(name)))
    check(f"{name}: longest step over the shortest", steps.max() / steps.min(), 1.25)

# What the steps remember is in a checkpoint.
run_file(TENSION, "parts", ["time.max_steps=130"])
run_file(TENSION, "parts", options=("--resume", "--quiet", "--threads", "1"))
check_same("a resumed run", "parts", "tension")

# Steps beyond the limit of stability feed it, and that is reported.
run_file(FIBRES, "wild", ["time.safety=1.3", "time.tolerance=1e30"], code=2)
energy = history("wild")["energy_total"]
check_true("wild: the energy rises", energy.max() > 1.5 * energy[0], f"to {energy.max() / energy[0]:.3g} of the first")
check_true("wild: it is reported once", len(told("wild")) == 1 and "though nothing fed it" in told("wild")[0]["what"], str(told("wild")))
check_true("wild: with a remedy", "time.safety" in told("wild")[0]["what"], str(told("wild")))

# A solid that is turned inside out at a point has no stable step.
SQUEEZED = write("squeezed", 'poisson = 0.45, material = "neo_hookean"',
                 'end = 40.0, scheme = "kick_drift", mass = "lumped", max_steps = 8000', 0.05)
said = run_file(SQUEEZED, "squeezed", options=ALOUD, code=2)
check_true("squeezed: the sentence names time.dt_min and its value", "time.dt_min = 1e-08" in said, said.strip())
check_true("squeezed: what limits the step, and where", "elasticity limits it, at the place (" in said, said.strip())
check_true("squeezed: a remedy", "generalized_alpha" in said, said.strip())
check("squeezed: steps below the smallest one", (history("squeezed")["dt"][1:] < 1e-8).sum(), 0)
said = run_file(FIBRES, "short", ["time.dt_min=1e-3", "time.dt_initial=1e-3"], options=ALOUD, code=2)
check_true("a bound that is only short: a smaller time.dt_min is a remedy", "time.dt_min = 0.001 (default 1e-08)" in said, said.strip())

# kick_drift takes steps that viscosity bounds, and is exact there.
VISCOUS = write("viscous", "poisson = 0.45, viscosity = 2.0, bulk_viscosity = 1.0", "end = 0.3", 0.001)
for mass in ("corrected", "lumped"):
    ends = {}
    for name, words in (("kick_drift", []), ("rkl2", []), ("rkl2_half", ["time.safety=0.45"]), ("rkl2_quarter", ["time.safety=0.225"])):
        run_file(VISCOUS, name, [f"time.scheme={name.removesuffix('_half').removesuffix('_quarter')}", f"time.mass={mass}", *words])
        ends[name] = history(name)
    for column, most in (("energy_elastic", 0.02), ("energy_kinetic", 0.04)):
        fine = ends["kick_drift"][column][-1]
        errors = [abs(ends[name][column][-1] / fine - 1) for name in ("rkl2", "rkl2_half", "rkl2_quarter")]
        check(f"rkl2, {mass} masses: {column} at the end, relative to kick_drift", errors[0], most)
        check("rkl2: the same with half the step, over that", errors[1] / errors[0], 0.4)
        check("rkl2: and with a quarter, over that with half: second order", errors[2] / errors[1], 0.3)
check_true("rkl2 takes few steps", len(ends["rkl2"]["t"]) < 0.02 * len(ends["kick_drift"]["t"]))

# Foreseen, and taken while nothing is bent much.
for name, solid in (("fibre", "fibre = { stiffness = 3000.0, angle = 80.0 }"), ("face", "surface_tension = 20.0"),
                    ("elastic_face", "surface_modulus = [8.0, 6.0]"),
                    ("viscosity", "viscosity = 0.2")):
    case = write(f"foreseen_{name}", f"poisson = 0.3, {solid}", 'end = 0.3, scheme = "automatic"', 1e-6)
    said = run_file(case, f"foreseen_{name}", options=ALOUD)
    foreseen = float(said.split("about ")[1].split(" explicit steps")[0])
    run_file(case, f"taken_{name}", ["time.scheme=kick_drift"])
    taken = record(f"taken_{name}")["counts"]["steps"]
    check(f"{name}: steps foreseen, {foreseen:g}, over those taken, {taken}, less 1", abs(foreseen / taken - 1), 0.06)
