#!/usr/bin/env python3
"""`softwet units`: quantities as people write them, and the case that --case writes. usage: units_case.py SOFTWET"""

import math
import pathlib
import subprocess
import tomllib

from _scene import check, check_true, environment, softwet

SIGMA, LIQUID = 0.2532027493, 0.8666990997  # at temperature 0.39: surface tension over capillarity, and density (test_groups)
LIQUID_OF = {"--radius": "500um", "--surface-tension": "72mN/m", "--density": "1000kg/m3", "--viscosity": "1mPa.s"}
SCENE = ["--radius", "50um", "--thickness", "25 um", "--young", "3kPa", "--poisson", "0.49", "--surface-tension", "72mN/m", "--density",
         "1000kg/m3", "--viscosity", "10mPa.s", "--solid-surface-tension", "50mN/m"]


def call(*words, code=0):
    done = subprocess.run([softwet, *map(str, words)], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{' '.join(map(str, words))[-100:]}: exit code {code}", done.returncode == code, done.stderr)
    return done.stdout, done.stderr


def units(changes):
    wanted = {**LIQUID_OF, **changes}
    if "--diameter" in changes:
        wanted.pop("--radius")
    return call("units", *(word for pair in wanted.items() for word in pair))[0]


def written(name, *words):
    """The resolved case of a file that is written here, and what check warns of."""
    return written_scene(name, *SCENE, *words)


def written_scene(name, *words):
    pathlib.Path(name).unlink(missing_ok=True)
    call("units", *words, "--case", name)
    return tomllib.loads(call("check", "--resolved", name)[0]), call("check", name)[1]


# --- quantities as people write them are the same quantities
plain = units({})
for option, text in (("--radius", "500 µm"), ("--radius", "500 μm"), ("--radius", "0.5 mm"), ("--diameter", "1mm"),
                     ("--surface-tension", "72 dyn/cm"), ("--density", "1 g/ml"), ("--density", "1000 kg/m^3"), ("--density", "1000 kg/m³"),
                     ("--viscosity", "1 cP"), ("--viscosity", "0.01 P"), ("--viscosity", "1 mPa s"), ("--viscosity", "1 mPa·s"),
                     ("--capillarity", "50um")):
    check_true(f"{option} {text}: the same", units({option: text}) == plain)
said = call("units", *SCENE, "--diameter", "1mm", code=1)[1]
check_true("radius and diameter", "radius" in said and "diameter" in said, said)

# --- a case that check accepts without a warning
case, warned = written("drop.toml")
check_true("no warning", not warned, warned)
fluid, solid = case["fluid"], case["substrate"]
check_true("the model of a gel", (case["domain"]["coordinates"], fluid["wall_law"], fluid["wall_tension"], solid["material"],
           solid["volume_quadrature"], case["boundary"]["bottom"]) == ("axisymmetric", "energy", "acts", "neo_hookean", "selective", "clamped"))
length = 50e-6
stress = 0.072 / (SIGMA * fluid["capillarity"] * length)
for name, found, value in (("modulus", solid["density"] * solid["young"] * stress, 3000), ("thickness", solid["thickness"] * length, 25e-6),
                           ("tension", solid["surface_tension"] * stress * length, 0.05),
                           ("radius", case["droplet"][0]["radius"] * length, 50e-6),
                           ("viscosity", fluid["viscosity"] * length * (stress * 1000 / LIQUID) ** 0.5, 0.01),
                           ("density", solid["density"] * 1000 / LIQUID, 1000)):
    check(f"{name}: that of the laboratory", abs(found / value - 1), 2e-6)
width = 2 * fluid["capillarity"] * length
check("the width is no more than a quarter of the layer", width, 25e-6 / 4 * (1 + 1e-6))
check("two elements to half of it", abs(case["domain"]["size"][0] / case["domain"]["elements"][0] / fluid["capillarity"] - 0.5), 1e-6)
text = pathlib.Path("drop.toml").read_text()
check_true("the file has the quantities", all(part in text for part in ('"3 kPa"', '"50 mN/m"', '"25 um"', '"10 mPa.s"')), text)
check_true("about 40 lines", len(text.splitlines()) < 50, text)

# --- other scenes that check accepts without a warning
WATER = ("--surface-tension", "72mN/m", "--density", "1000kg/m3", "--viscosity", "1mPa.s")
GEL = ("--young", "3kPa", "--poisson", "0.49", "--solid-surface-tension", "50mN/m")
for name, scene in (("1 mm of water on 100 um of gel", (*WATER, "--diameter", "1mm", "--thickness", "100um", *GEL)),
                    ("0.2 mm on 50 um", (*WATER, "--radius", "100um", "--thickness", "50um", *GEL)),
                    ("glycerol on silicone", ("--radius", "178.4um", "--surface-tension", "46mN/m", "--density", "1260kg/m3",
                                              "--viscosity", "1.2Pa.s", "--young", "3kPa", "--poisson", "0.49", "--thickness", "50um",
                                              "--solid-surface-tension", "31mN/m", "--wet-surface-tension", "36mN/m")),
                    ("a rigid wall", (*WATER, "--radius", "500um", "--contact-angle", "70"))):
    for more in ((), ("--2d",)):
        warned = written_scene("scene.toml", *scene, *more)[1]
        check_true(f"no warning: {name} {' '.join(more)}", not warned, warned)
warned = written_scene("scene.toml", *WATER, "--radius", "20um", "--thickness", "20um", *GEL)[1]
check_true("a droplet that is too small for the gel", "inside out" in warned, warned)

# --- other cases
plane = written("plane.toml", "--2d", "--contact-angle", "80")[0]
check_true("2D, with its angle", plane["domain"]["coordinates"] == "plane" and plane["fluid"]["contact_angle"] == 80, str(plane["domain"]))
paper = written("paper.toml", "--like", "paper")[0]
check_true("as in the paper", (paper["fluid"]["wall_law"], paper["substrate"]["material"]) == ("gradient", "saint_venant_kirchhoff"))
young = written("young.toml", "--wet-surface-tension", "55mN/m")[0]
check("Young's law: cos = -5/72", abs(young["fluid"]["contact_angle"] - math.degrees(math.acos(-5 / 72))), 1e-4)
asked = written("asked.toml", "--capillarity", "4um")[0]
check("a width that is asked for, but for a whole number of elements", abs(asked["fluid"]["capillarity"] * length / 4e-6 - 1), 0.25)

# --- refusals
said = call("units", *SCENE, "--case", "drop.toml", code=1)[1]
check_true("a file that is there stays", "drop.toml" in said and "another name" in said, said)
check_true("as it is", pathlib.Path("drop.toml").read_text() == text)
pathlib.Path("no.toml").unlink(missing_ok=True)
said = call("units", *SCENE, "--wet-surface-tension", "55mN/m", "--contact-angle", "80", "--case", "no.toml", code=1)[1]
check_true("an angle against Young's law", "Young's law" in said, said)
said = call("units", *SCENE, "--like", "mine", "--case", "no.toml", code=1)[1]
check_true("another model", "paper" in said, said)
check_true("nothing is written", not pathlib.Path("no.toml").exists())
