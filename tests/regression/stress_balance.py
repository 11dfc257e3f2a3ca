#!/usr/bin/env python3
"""The stress that is written is the one that acts: it carries the load above it, whatever the law, the rate, the
quadrature and the branches of the solid, in 2D, (r, z) and 3D; and a stretched layer on which nothing acts is at rest.
usage: stress_balance.py SOFTWET"""

import itertools
import pathlib
import subprocess

import numpy
from _scene import check, check_true, environment, history, softwet
from softwet import open as open_output

HEIGHT, LOADED, FORCE = 0.25, 0.125, 0.02  # a body force on the upper half of a column
BOXES = {  # domain, box of the load, force, a point below it, stress upright, the whole solid
    "2d": ("size = [0.5, 0.25], elements = [6, 8]", f"[[0.0, {LOADED}], [0.5, {HEIGHT}]]", f"[0.0, {-FORCE}]", "[0.2, 0.05]", "yy", "[[0.0, 0.0], [0.5, 0.25]]"),
    "rz": ('size = [0.5, 0.25], elements = [16, 8], coordinates = "axisymmetric"', f"[[0.0, {LOADED}], [0.5, {HEIGHT}]]",
           f"[0.0, {-FORCE}]", "[0.2, 0.05]", "yy", "[[0.0, 0.0], [0.5, 0.25]]"),
    "3d": ("size = [0.5, 0.5, 0.25], elements = [3, 3, 8]", f"[[0.0, 0.0, {LOADED}], [0.5, 0.5, {HEIGHT}]]", f"[0.0, 0.0, {-FORCE}]",
           "[0.2, 0.3, 0.05]", "zz", "[[0.0, 0.0, 0.0], [0.5, 0.5, 0.25]]"),
}


def compute(name, text, command="run"):
    path = pathlib.Path(f"{name}.toml")
    path.write_text(text)
    done = subprocess.run([softwet, command, str(path), "--out", name, "--overwrite", "--quiet", "--threads", "1"], capture_output=True,
                          text=True, env=environment)
    check_true(f"{name}: exit code 0", done.returncode == 0, done.stdout + done.stderr)
    return history(name)


def column(box, solid, poisson):
    domain, where, force, point, upright, whole = BOXES[box]
    sides = 'front = "slip", back = "slip", ' if box == "3d" else ""
    return f"""
name = "column"
domain = {{ {domain} }}
substrate = {{ thickness = {HEIGHT}, young = 1.0, poisson = {poisson}, inertia = "none", {solid} }}
boundary = {{ left = "slip", right = "slip", {sides}bottom = "slip", top = "free" }}
load = [ {{ box = {where}, force = {force} }} ]
time = {{ end = 0.4 }}
solver = {{ newton = {{ rtol = 1e-10, atol = 1e-14 }} }}
output = {{ fields = {{ times = [0.4] }} }}
probe = [ {{ name = "stress", quantity = "first_piola_stress_{upright}", point = {point} }},
          {{ name = "mean", quantity = "first_piola_stress_{upright}", operation = "mean", box = {whole} }} ]
"""


# The work of the stress in the displacement w = height is the work of the load: exact for every law, rate and
# quadrature, at each time. With full quadrature the stress below the load is the load at each point; means over
# elements leave some of what varies above.
MEAN = -FORCE * (HEIGHT**2 - LOADED**2) / 2 / HEIGHT
LAWS = {"small": 'strain = "small"', "svk": 'material = "saint_venant_kirchhoff"', "neo": 'material = "neo_hookean"'}
RATES = {"viscous": "viscosity = 0.3, bulk_viscosity = 0.2", "branches": "viscosity = 0.1, branch = [ { modulus = 0.5, time = 0.1 }, { modulus = 0.3, time = 1.0 } ]"}
QUADRATURES = {"full": 'volume_quadrature = "full"', "selective": 'volume_quadrature = "selective"'}
for box, (law, words), (rate, more), (quadrature, which) in itertools.product(BOXES, LAWS.items(), RATES.items(), QUADRATURES.items()):
    if box == "3d" and (law, rate) not in (("small", "branches"), ("neo", "branches"), ("svk", "viscous")):
        continue
    name = f"{box}_{law}_{rate}_{quadrature}"
    rows = compute(name, column(box, f"{words}, {more}, {which}", 0.45))
    # The equations hold within a step, and rows are written at its end: under finite strains that differs by the error
    # of a step.
    exact = 1e-6 if law == "small" else 1e-4
    right, allowed = -FORCE * (HEIGHT - LOADED), exact if quadrature == "full" else 5e-3
    check(f"{name}: mean stress, off", numpy.abs(rows["mean"][1:] / MEAN - 1).max(), exact)
    check(f"{name}: stress over the load above, off", numpy.abs(rows["stress"][1:] / right - 1).max(), allowed)
    solid = open_output(name).fields(0.4, "solid")
    field = solid["first_piola_stress"]
    up = {"2d": 1, "rz": 1, "3d": 2}[box]
    low = field[: field.shape[0] // 3, ..., up, up]
    if box == "rz" and quadrature == "selective":  # at its ends the plain means along r pull upright (docs/theory.md)
        low = low[:, low.shape[1] // 3 : -low.shape[1] // 3]
    check(f"{name}: stress of the field file below the load", abs(low / right - 1).max(), allowed)

# Where strains vary, the stress that selective integration has is the one of a fine mesh, up to what the mesh leaves
# out.
COMPRESSED = f"""
name = "compressed"
domain = {{ size = [1.0, 0.25], elements = [16, 8] }}
substrate = {{ thickness = 0.25, young = 1.0, poisson = 0.4995, strain = "small", volume_quadrature = "selective" }}
boundary = {{ left = "slip", right = "slip", bottom = "clamped", top = "free" }}
load = [ {{ box = [[0.0, 0.1875], [0.25, 0.25]], force = [0.0, -0.1] }} ]
time = {{ end = 1.0 }}
output = {{ fields = {{ times = [] }} }}
probe = [ {{ name = "a", quantity = "cauchy_stress_yy", point = [0.05, 0.04] }},
          {{ name = "b", quantity = "cauchy_stress_yy", point = [0.22, 0.07] }},
          {{ name = "c", quantity = "cauchy_stress_yy", point = [0.31, 0.15] }} ]
"""
fine = compute("compressed_fine", COMPRESSED.replace("[16, 8]", "[128, 64]"), "steady")
errors = []
for elements in ("[16, 8]", "[64, 32]"):
    rows = compute("compressed", COMPRESSED.replace("[16, 8]", elements), "steady")
    errors.append(max(abs(rows[p][-1] - fine[p][-1]) for p in "abc") / abs(fine["a"][-1]))
check("selective: stress on 16 x 8 elements, off", errors[0], 0.1)
check("selective: and on 64 x 32", errors[1], 0.025)

# A stretched layer on which nothing acts is at rest with either quadrature: uniform and graded elements, a stiffness
# that varies upright, a joint, springs below.
REST = f"""
name = "rest"
domain = {{ DOMAIN }}
substrate = {{ thickness = {HEIGHT}, poisson = 0.49, material = "neo_hookean", volume_quadrature = "selective", SOLID }}
boundary = {{ left = "slip", right = "slip", SIDES bottom = "clamped", top = "free" }}
time = {{ end = 2.0 }}
output = {{ fields = {{ times = [] }} }}
probe = [ {{ name = "up", quantity = "displacement_UP", operation = "max", box = BOX }},
          {{ name = "down", quantity = "displacement_UP", operation = "min", box = BOX }} ]
"""
PLANE = "[[0.0, 0.0], [0.5, 0.25]]"
DOMAINS = {
    "2d": ("size = [0.5, 0.25], elements = [16, 10]", "", "y", PLANE, "prestretch = [1.2]"),
    "graded": ('size = [0.5, 0.25], elements = [16, 10], grading = { box = [[0.1, 0.15], [0.2, 0.25]], coarsest = 3 }', "", "y", PLANE, "prestretch = [1.2]"),
    "rz": ('size = [0.5, 0.25], elements = [16, 10], coordinates = "axisymmetric"', "", "y", PLANE, "prestretch = [1.2]"),
    "3d": ("size = [0.5, 0.5, 0.25], elements = [4, 3, 4]", 'front = "slip", back = "slip", ', "z", "[[0.0, 0.0, 0.0], [0.5, 0.5, 0.25]]",
           "prestretch = [1.2, 0.9]"),
}
for name, (domain, sides, up, box, stretch) in DOMAINS.items():
    for kind, young in {"uniform": "young = 1.0", "varies": f'young = "1 + 40*{up}"',
                        "joint": f'young = "{up} < 0.125 ? 9 : 1", joint = 0.125'}.items():
        if name == "graded":  # the end of a row
            young = young.replace("0.125", "0.1207760121")
        text = REST.replace("DOMAIN", domain).replace("SIDES", sides).replace("UP", up).replace("BOX", box)
        rows = compute(f"rest_{name}_{kind}", text.replace("SOLID", f"{stretch}, {young}"), "steady")
        check(f"{name}, {kind}: largest displacement", max(abs(rows["up"][-1]), abs(rows["down"][-1])), 1e-12)
        check(f"{name}, {kind}: energy", abs(rows["energy_total"][-1]), 1e-12)
