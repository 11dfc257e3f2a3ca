#!/usr/bin/env python3
"""Stiff parts of a solid: the reading of a needle keeps its digits up to the stiffness that is refused, and the remedy
that is named reads the load; fibres and faces beyond what linear solves hold get a warning, springs of a foundation
need none. usage: stiff_parts.py SOFTWET"""

import pathlib
import re
import subprocess

from _scene import check, check_true, environment, history, softwet

FREE = 'left = "free", right = "free", bottom = "slip", top = "free"'
CLAMPED = 'left = "free", right = "free", bottom = "clamped", top = "free"'
PULL = "load = [ { box = [[0.3, 0.0], [0.5, 0.25]], force = [0.02, 0.0] } ]"
PRESS = "load = [ { box = [[0.3, 0.15], [0.5, 0.25]], force = [0.0, -0.02] } ]"


def block(name, sides, forces, solid=""):
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = [0.5, 0.25], elements = [10, 5] }}
substrate = {{ thickness = 0.25, young = 1.0, poisson = 0.3, strain = "small"{solid} }}
boundary = {{ {sides} }}
{forces}
time = {{ end = 1.0 }}
output = {{ fields = {{ times = [] }} }}
[[probe]]
name = "tip"
quantity = "displacement_y"
point = [0.4, 0.25]
""")


def ask(command, name, code=0, options=("--quiet", "--threads", "1", "--overwrite")):
    words = [*options, "--out", name] if command != "check" else []
    done = subprocess.run([softwet, command, f"{name}.toml", *words], capture_output=True, text=True, env=environment)
    check_true(f"{name}: exit code {code}", done.returncode == code, f"{done.returncode}: {done.stdout}{done.stderr}")
    return done.stderr


def held(stiffness, place):
    needle = f"needle = [ {{ box = [[0.0, 0.0], [0.05, 0.25]], stiffness = {stiffness}, path = [{place}, 0.0] }} ]\n"
    block("held", FREE, needle + PULL)


# A needle that stands holds the block against a load of 0.001, wherever it stands. Half of the last digit of a
# displacement is at most 1.11e-16 of it; k times that in the volume of the box may be lost, beside 1e-6 by the search
# for rest.
LOAD, VOLUME = 0.001, 0.05 * 0.25


def reading_error():
    return abs(history("held")["needle_force_x"][-1] / -LOAD - 1)


for place, largest in ((0.01, 1.8e13), (-0.01, 1.8e13), (5.0, 1.8e12)):
    for stiffness in (1e8, 0.99 * largest) if place < 1 else ():  # a search for rest does not find one ten blocks away
        held(stiffness, place)
        ask("steady", "held")
        check(f"at {place}, stiffness {stiffness:.2g}: reading over the load, less 1", reading_error(),
              1.11e-16 * stiffness * abs(place) * VOLUME / LOAD + 1e-6)
    for stiffness in (1.1 * largest, 1e14, 1e17, 1e25):
        held(stiffness, place)
        said = ask("check", "held", 1)
        check_true(f"at {place}, stiffness {stiffness:.2g} is refused with key, value, range and remedy",
                   all(part in said for part in ("needle[0].stiffness = ", f"(0, {largest:.2g}]", "write for example")), said)
    if place > 1:
        continue
    held(re.search(r"write for example (\S+?),? ", said + " ")[1], place)
    ask("steady", "held")
    check(f"at {place}, the remedy: reading over the load, less 1", reading_error(), 1e-5)

# Fibres and faces: a warning before results are wrong, and none where they are right.
ends = {}
for name, solid, key in (("fibre_1e6", ", fibre = { stiffness = 1e6, angle = 30.0 }", None),
                         ("fibre_2e6", ", fibre = { stiffness = 2e6, angle = 30.0 }", None),
                         ("fibre_1e7", ", fibre = { stiffness = 1e7, angle = 30.0 }", "substrate.fibre.stiffness = 1e+07"),
                         ("fibre_1e10", ", fibre = { stiffness = 1e10, angle = 30.0 }", "substrate.fibre.stiffness = 1e+10"),
                         ("face_5e4", ", surface_modulus = [5e4, 5e4]", None), ("face_1e5", ", surface_modulus = [1e5, 1e5]", None),
                         ("face_1e6", ", surface_modulus = [1e6, 1e6]", "substrate.surface_modulus = [1e+06, 1e+06]"),
                         ("face_1e12", ", surface_modulus = [0, 1e12]", "substrate.surface_modulus = [0, 1e+12]")):
    block(name, CLAMPED, PRESS, solid)
    said = ask("check", name)
    check_true(f"{name}: {'a' if key else 'no'} warning of its stiffness", f"{key} makes" in said if key else "times as stiff" not in said, said)
    if key is None:
        ask("steady", name)
        ends[name] = history(name)["energy_elastic"][-1]
check("fibres twice as stiff: elastic energy, relative", abs(ends["fibre_2e6"] / ends["fibre_1e6"] - 1), 1e-4)
check("a face twice as stiff: elastic energy, relative", abs(ends["face_1e5"] / ends["face_5e4"] - 1), 1e-3)

# Springs of a foundation that hardly yield any more hold the same, however stiff they are.
for stiffness in ("1e8", "1e17", "1e25"):
    block("springs", f'left = "slip", right = "slip", bottom = "free", top = "free", foundation = [{stiffness}, {stiffness}]', PRESS)
    check_true(f"springs {stiffness}: no warning", "times as stiff" not in ask("check", "springs"))
    ask("steady", "springs")
    ends[stiffness] = history("springs")["tip"][-1]
for stiffness in ("1e17", "1e25"):
    check(f"springs {stiffness}: the tip goes as far as with 1e8", abs(ends[stiffness] / ends["1e8"] - 1), 1e-5)
