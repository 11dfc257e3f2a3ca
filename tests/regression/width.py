#!/usr/bin/env python3
"""`softwet check` warns of an interface that is wider than the lengths over which a solid bends at a contact line.
usage: width.py SOFTWET"""

import pathlib
import subprocess

from _scene import check_true, softwet

GEL = """name = "gel"
[domain]
size = [0.5, 0.4]
elements = [20, 16]
[fluid]
viscosity = 0.01
capillarity = 0.05
temperature = 0.39
contact_angle = 60.0
wall_law = "energy"
wall_tension = "acts"
[substrate]
thickness = 0.1
young = 0.6
poisson = 0.45
material = "neo_hookean"
surface_tension = 0.0088
[[droplet]]
centre = [0.0, 0.1]
radius = 0.25
[time]
end = 1.0
"""
pathlib.Path("gel.toml").write_text(GEL)


def call(*words):
    done = subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900)
    check_true(" ".join(words), done.returncode == 0, done.stderr)
    return done.stdout, done.stderr


# --- check: Upsilon/E is 0.0147, sigma/E 0.0211, a quarter of the layer 0.025
wide = call("check", "gel.toml")[1]
check_true("an interface that is too wide", "Upsilon/E" in wide and "20 to 50 %" in wide and "softwet converge" in wide, wide)
mesh = ["--set", "domain.elements=[200,160]"]
narrow = call("check", "gel.toml", *mesh, "--set", "fluid.capillarity=0.007", "--set", "substrate.young=0.084", "--set",
              "substrate.surface_tension=0.001232")[1]
check_true("one that is not", "softwet converge" not in narrow, narrow)
thin = call("check", "gel.toml", *mesh, "--set", "fluid.capillarity=0.0125", "--set", "substrate.thickness=0.05", "--set",
            "substrate.young=0.1", "--set", "droplet[0].centre=[0,0.05]")[1]
check_true("a thin layer", "a quarter of the layer" in thin and "softwet converge" in thin, thin)
without = call("check", "gel.toml", "--set", "substrate.surface_tension=0", "--set", "fluid.wall_tension=none")[1]
check_true("a solid without tension", "has no limit" in without and "substrate.surface_tension" in without, without)
