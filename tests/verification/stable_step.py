#!/usr/bin/env python3
"""The largest stable step of the explicit schemes, found by bisection, against the limit that the program measures.
usage: stable_step.py SOFTWET [--full]     --full adds two finer meshes and consistent masses

A droplet on a rigid wall at the temperature 0.85, with the wall law that has an energy: on a rigid wall the total energy
may only fall. From a state after 100 short steps the run goes on for 150 steps of time.safety times the measured limit.
They are stable where all are done, none is refused, and the total energy rises in none. The answer is the largest such
time.safety. Above 1 the measured limit is on the safe side. With rkl2 and imex it is so by half, for the viscosity damps what
the rest alone would let grow."""

import pathlib
import shutil
import subprocess
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "regression"))
from _scene import check_true, command, environment, history, record, run  # noqa: E402

BEFORE, AFTER = 100, 150
SCENE = ["fluid.temperature=0.85", "fluid.capillarity=1/32", 'fluid.wall_law="energy"', "droplet[0].radius=0.2",
         "time.end=1000", "time.tolerance=1e30", "time.dt_max=1", "output.fields.times=[]"]
FULL = "--full" in sys.argv
MESHES = [(32, 16), (64, 32), (128, 64)] if FULL else [(32, 16)]
OPTIONS = ("--quiet", "--threads", "1")
LOW, HIGH, CLOSE = 0.5, 3.0, 0.05


def settings(mesh, scheme, mass, steps):
    return SCENE + [f"domain.elements=[{mesh[0]},{mesh[1]}]", f"time.scheme={scheme}", f"time.mass={mass}",
                    f"time.max_steps={steps}"]


def stable(start, mesh, scheme, mass, safety):
    """@return whether the steps are stable, and their middle size"""
    folder = f"{start}_tried"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(start, folder)
    words = command("static_droplet_rigid_2d", folder,
                    settings(mesh, scheme, mass, BEFORE + AFTER) + [f"time.safety={safety:.4g}"], ("--resume", *OPTIONS))
    result = subprocess.run(words, capture_output=True, text=True, timeout=800, env=environment)
    if result.returncode == 1:
        sys.exit(f"{words}\n{result.stderr}")
    rows = history(folder)
    after = rows["step"] > BEFORE
    counts = record(folder)["counts"]
    calm = result.returncode == 0 and counts["rejected_by_newton"] == 0
    rises = numpy.diff(rows["energy_total"][rows["step"] >= BEFORE]).max() > 0
    return calm and not rises, numpy.median(rows["dt"][after]) if after.any() else 0.0


def largest(mesh, scheme, mass):
    """@return the largest stable safety and the step that belongs to it"""
    start = f"{scheme}_{mass}_{mesh[0]}"
    run("static_droplet_rigid_2d", start, settings(mesh, scheme, mass, BEFORE) + ["time.safety=0.5"],
        ("--overwrite", *OPTIONS))
    low, high = LOW, HIGH
    calm, step = stable(start, mesh, scheme, mass, low)
    check_true(f"{start}: stable at {low} of the measured limit", calm)
    while high / low > 1 + CLOSE:
        middle = (low * high)**0.5
        calm, dt = stable(start, mesh, scheme, mass, middle)
        low, high, step = (middle, high, dt) if calm else (low, middle, step)
    return low, step


steps = {}
for scheme in ("ssp_rk3", "rkl2", "imex"):
    for mass in ("lumped", "consistent") if FULL else ("lumped",):
        for mesh in MESHES:
            found, steps[scheme, mass, mesh] = largest(mesh, scheme, mass)
            check_true(f"{scheme}, {mass}, {mesh[0]} x {mesh[1]}: stable up to {found:.2f} of the measured limit, steps of "
                       f"{steps[scheme, mass, mesh]:.3g}; asked: the default 0.9 is stable, and no more than 2 is",
                       0.9 <= found <= 2)
        ratios = [steps[scheme, mass, a] / steps[scheme, mass, b] for a, b in zip(MESHES, MESHES[1:])]
        check_true(f"{scheme}, {mass}: steps shrink with the mesh between h and h^2", all(1.8 < r < 4.5 for r in ratios),
                   str([f"{r:.2f}" for r in ratios]))
