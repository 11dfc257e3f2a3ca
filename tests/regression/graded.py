#!/usr/bin/env python3
"""Graded elements: a scene on them is the scene on equal ones with fewer unknowns, its mass does not depend on the
mesh, its files and its case describe the mesh, runs go on from their checkpoints, and softwet says when a droplet comes
near the end of the fine elements. usage: graded.py SOFTWET"""

import re
import subprocess

import numpy
from _same import check_same
from _scene import PULL, cases, check, check_true, history, open_output, run, softwet

SCENE = [setting for setting in PULL if "elements" not in setting and "capillarity" not in setting]
SCENE += ["domain.elements=[64,32]", "fluid.capillarity=1/32", "droplet[0].radius=0.11", "time.end=6", "output.fields.times=[0,6]"]
EQUAL, GRADED = ["domain.grading.fine=everywhere"], ["domain.grading.fine=box", "domain.grading.box=[[0.26,0.0625],[0.74,0.3]]"]

run("tensotaxis_pull_2d", "equal", SCENE + EQUAL)
run("tensotaxis_pull_2d", "graded", SCENE + GRADED)
equal, graded = history("equal"), history("graded")
fields = {name: open_output(name).fields(6) for name in ("equal", "graded")}
check("elements of the graded mesh over elements of the equal one", fields["graded"]["density"].size / fields["equal"]["density"].size, 0.7)
check("mass at the start, relative", abs(graded["mass"][0] / equal["mass"][0] - 1), 1e-6)
check("mass at the end over that at the start", abs(graded["mass"][-1] / graded["mass"][0] - 1), 1e-13)
moved = equal["x_centre"][-1] - 0.5
check_true("the droplet moves", moved > 1e-4, f"{moved:.2e}")
check("x_centre, difference over the way", abs(graded["x_centre"][-1] - equal["x_centre"][-1]) / moved, 0.002)
check("elastic energy, relative", abs(graded["energy_elastic"][-1] / equal["energy_elastic"][-1] - 1), 0.01)

# Positions of the file are positions of elements: where nothing moves, on the top, they are the reference.
lengths = numpy.diff(fields["graded"].lines[1][::2])
check("shortest element", abs(lengths.min() - 1 / 64), 1e-12)
check_true("elements grow to more than twice that", lengths.max() > 2 / 64)
check("reference positions against positions of the file, on the top",
      numpy.abs(fields["graded"].reference[-1] - fields["graded"].positions[-1]).max(), 1e-12)
places = numpy.stack(numpy.meshgrid(numpy.linspace(0.3, 0.7, 41), numpy.linspace(0.14, 0.29, 31)), axis=-1)
found = {name: fields[name].at(places)["density"] for name in fields}
check("density at the same places", numpy.abs(found["graded"] - found["equal"]).max(), 5e-4)
wall = open_output("graded").interface[6]
check_true("interface.csv has the ends and middles of the elements", len(wall["x_reference"]) == 2 * len(lengths) + 1)

# The resolved case is the same mesh, and a run goes on from its checkpoint to the bit.
run("tensotaxis_pull_2d", "half", SCENE + GRADED + ["time.max_steps=10"])
command = [softwet, "run", "half/case.toml", "--out", "half", "--resume", "--quiet", "--threads", "1", "--set", "time.max_steps=1000000"]
subprocess.run(command, check=True)
check_same("resumed from case.toml", "half", "graded")

# automatic: the box that softwet chooses, and its words.
text = subprocess.run([softwet, "check", str(cases / "tensotaxis_pull_2d.toml"), "--set", "domain.grading.fine=automatic"],
                      capture_output=True, text=True, check=True).stdout
for word in ('grading.fine = "box"', "graded elements", "% of those of the equal mesh"):
    check_true(f"check says: {word}", word in text)

# The pull of the paper is graded by its case. Of equal elements check and the end of a run say what would be left.
check_true("the case of the paper is graded", '"automatic"' in (cases / "tensotaxis_pull_2d.toml").read_text())
NEAR = ["domain.elements=[64,32]", "fluid.capillarity=1/32", "load[0].start=0.1", "load[0].ramp=1", "time.end=0.1",
        "output.fields.times=[]", *EQUAL]
words = [word for setting in NEAR for word in ("--set", setting)]
told = subprocess.run([softwet, "check", str(cases / "tensotaxis_pull_2d.toml"), *words], capture_output=True, text=True, check=True).stdout
for word in ('"automatic" would leave 66 % of them', "sampled scenes of this kind"):
    check_true(f"check of equal elements says: {word}", word in told, told)
LOUD = ("--overwrite", "--threads", "1")
for name, settings, wanted in (("equal_end", [], True), ("graded_end", ["domain.grading.fine=automatic"], False)):
    said = run("tensotaxis_pull_2d", name, [*NEAR, *settings], LOUD)
    check_true(f"{name}: its end says what grading would leave", ('"automatic" would leave 66 %' in said) == wanted, said)
warning = subprocess.run([softwet, "check", str(cases / "tensotaxis_pull_2d.toml"), "--set", "domain.grading.fine=box", "--set",
                          "domain.grading.box=[[0.34,0.1],[0.66,0.3]]"], capture_output=True, text=True, check=True).stderr
check_true("check warns of a box that ends in the interface", "domain.grading" in warning, warning)

# A droplet that flies out of the box is an event; explicit steps, and a periodic side.
FLIGHT = ["domain.elements=[48,24]", "fluid.capillarity=1/24", "droplet[0].centre=[0.3,0.25]", "droplet[0].radius=0.12",
          "droplet[0].velocity=[0.4,0.0]", "boundary.left=periodic", "boundary.right=periodic", "time.end=0.5", "output.fields.times=[]",
          "domain.grading.box=[[0.05,0.0],[0.57,0.625]]"]
for scheme in ("generalized_alpha", "kick_drift"):
    run("impact_rigid_2d", scheme, [*FLIGHT, f"time.scheme={scheme}"])
    flight, log = history(scheme), open_output(scheme).record
    check(f"{scheme}: mass, relative", abs(flight["mass"][-1] / flight["mass"][0] - 1), 1e-12)
    check_true(f"{scheme}: event", "end of the fine elements, towards the right side" in str(log["events"]), log["events"])
check("momentum of both schemes", abs(history("kick_drift")["momentum_x"][-1] / history("generalized_alpha")["momentum_x"][-1] - 1), 0.02)

# A run goes on behind that event.
for scheme in ("generalized_alpha", "kick_drift"):
    subprocess.run([softwet, "run", f"{scheme}/case.toml", "--out", scheme, "--resume", "--quiet", "--threads", "1", "--set", "time.end=0.52"],
                   check=True)
    check(f"{scheme}: resumed after the event to its end", abs(history(scheme)["t"][-1] - 0.52), 1e-12)

# A droplet on the seam of a periodic axis is the one in the middle: it stays where it is, on a box that reaches around
# the seam.
SEAM = ["boundary.left=periodic", "boundary.right=periodic", "domain.elements=[64,32]", "fluid.capillarity=1/32", "output.fields.times=[0]",
        "time.end=20"]
rows = {}
for name, centre, box in (("middle", 0.5, "[[0.2,0],[0.8,0.3]]"), ("seam", 0, "[[-0.3,0],[0.3,0.3]]"), ("beyond", 0, "[[0.7,0],[1.3,0.3]]")):
    run("static_droplet_rigid_2d", name, [*SEAM, f"droplet[0].centre=[{centre},0]", f"domain.grading.box={box}"])
    rows[name] = history(name)
    lengths = numpy.diff(open_output(name).fields(0).lines[1][::2])
    check(f"{name}: ratio of neighbours, across the seam too", numpy.abs(numpy.log(lengths / numpy.roll(lengths, 1))).max() / numpy.log(1.3), 1 + 1e-9)
    check_true(f"{name}: it is graded", len(lengths) < 0.9 * 64)
    check_true(f"{name}: no event", not open_output(name).record.get("events"), open_output(name).record.get("events"))
check("the droplet on the seam stays", abs(numpy.remainder(rows["seam"]["x_centre"] + 0.5, 1) - 0.5).max(), 1e-5)
check("the same box by another name", abs(rows["seam"]["x_centre"] - rows["beyond"]["x_centre"]).max(), 1e-15)
check("its energy is as with the droplet in the middle", abs(rows["seam"]["energy_total"][-1] / rows["middle"]["energy_total"][-1] - 1), 1e-4)

# On a box that ends in the droplet the mesh drives it, by nearly one short element here. The warning names a box on
# which it stays.
CUT = [*SEAM, "droplet[0].centre=[0,0]"]
warning = run("static_droplet_rigid_2d", "cut", [*CUT, "domain.grading.box=[[0,0],[0.3,0.3]]"])
named = re.search(r"write a larger box, \[(\S+), (\S+)\] along this axis, which may reach around the ends", warning)
check_true("a box that ends on the seam, in the droplet: the warning names another one", named, warning)
driven = numpy.abs(numpy.remainder(history("cut")["x_centre"] + 0.5, 1) - 0.5).max()
check_true("the mesh drives the droplet, as the warning says", 0.3 / 64 < driven < 2 / 64 and "one or two" in warning, f"{driven:.4f}")
warning = run("static_droplet_rigid_2d", "named", [*CUT, f"domain.grading.box=[[{named[1]},0],[{named[2]},0.3]]"])
check("on the box that it names the droplet stays", numpy.abs(numpy.remainder(history("named")["x_centre"] + 0.5, 1) - 0.5).max(), 1e-5)
check_true("of that box there is no warning", "fine elements" not in warning, warning)
