#!/usr/bin/env python3
"""With the wall-energy law on a rigid wall the energy falls at every accepted step, and nothing is reported about it.
Where steps that are too long let it rise, that is reported once. usage: energy.py SOFTWET"""

import pathlib

import numpy
from _scene import RIGID, check, check_true, history, record, run, run_file


def told(folder):
    return [event for event in record(folder)["events"] if "energy" in event["what"]]


for angle in (60, 75, 120):
    run("static_droplet_rigid_2d", f"energy_{angle}",
        RIGID + ["fluid.wall_law=energy", f"fluid.contact_angle={angle}", "solver.newton.rtol=1e-9"])
    rows = history(f"energy_{angle}")
    energy = rows["energy_total"]
    check_true(f"{angle} degrees: something is dissipated", energy[0] - energy[-1] > 1e-5, f"{energy[0] - energy[-1]:.3g}")
    check(f"{angle} degrees: largest rise of the energy", numpy.diff(energy).max(), 1e-15)
    parts = rows["energy_kinetic"] + rows["energy_free"] + rows["energy_wall"] + rows["energy_elastic"]
    check(f"{angle} degrees: the total is the sum of its parts", numpy.abs(parts - energy).max(), 1e-15)
    check_true(f"{angle} degrees: no event about the energy", not told(f"energy_{angle}"))

# An impact with steps that are far too long and hardly solved for: a linear solve to a tenth each.
COARSE = ["domain.elements=[24,15]", "fluid.capillarity=1/18", "time.scheme=generalized_alpha", "time.end=1", "output.fields.times=[]"]
WILD = [*COARSE, "solver.newton.atol=1", "time.tolerance=1e30", "time.dt_initial=0.2", "time.dt_max=0.2"]
ALOUD = ["--overwrite", "--threads", "1"]
message = run("impact_rigid_2d", "wild", WILD, ALOUD)
rows, events = history("wild"), told("wild")
check_true("wild: the energy rises", numpy.diff(rows["energy_total"]).max() > 1e-5, f"by {numpy.diff(rows['energy_total']).max():.1e}")
check_true("wild: it is reported once in run.json", len(events) == 1 and "though nothing fed it" in events[0]["what"], str(events))
check_true("wild: with a remedy", "time.tolerance" in events[0]["what"])
check_true("wild: on stderr and in the closing line", message.count(events[0]["what"]) == 2, message)
run("impact_rigid_2d", "tame", COARSE)
check_true("tame: with the default steps nothing is reported", not told("tame"), str(told("tame")))

# What was reported before a stop is known after it, and not reported again.
run("impact_rigid_2d", "parts", [*WILD, "time.max_steps=3"])
run("impact_rigid_2d", "parts", WILD, ["--resume", "--quiet", "--threads", "1"])
check_true("a resumed run says the same", told("parts") == events, str(told("parts")))

# A wave in a solid alone trades kinetic for elastic energy. With lumped masses the energy of the table swings by what
# it differs from that which steps keep: nothing is reported for that, and no step is refused.
pathlib.Path("wave.toml").write_text("""
name = "wave"
domain = { size = [1.1, 0.7], elements = [11, 7] }
substrate = { thickness = 0.7, young = 2.3, poisson = 0.22, material = "neo_hookean" }
wave = [{ field = "displacement_x", amplitude = 0.02, mode = [2, 1] }]
boundary = { left = "slip", right = "slip", bottom = "slip", top = "slip" }
time = { mass = "lumped", end = 4 }
output = { history = { every = 1 } }
""")
for scheme in ("kick_drift", "rkl2", "ssp_rk3"):
    run_file("wave.toml", f"wave_{scheme}", [f"time.scheme={scheme}"])
    check_true(f"wave, {scheme}: no event about the energy", not told(f"wave_{scheme}"), str(told(f"wave_{scheme}")))
    check(f"wave, {scheme}: refused steps", record(f"wave_{scheme}")["counts"]["rejected_by_newton"], 0)
