"""A scene costs what it holds: unknowns, memory and terms.

A rigid wall has no displacement, and a solid alone has no density and no chemical potential. What a scene does not have
is neither stored nor computed. The three scenes have 128 x 64 elements of fluid, 128 x 16 of solid, and 128 x 48 of fluid
on 128 x 16 of solid. The numbers come from `softwet check` and `softwet bench`."""

import re

MINUTES = {"quick": 0.05, "full": 2}
EXPLICIT = "asks what a scene costs, by the counts of the implicit scheme"
EQUAL = ("--set", "domain.grading.fine=everywhere")
SCENES = {"static_droplet_rigid_2d": (True, False), "solid_layer_2d": (False, True), "tensotaxis_pull_2d": (True, True)}


def number(pattern, text):
    found = re.search(pattern, text, re.M)
    return found.group(1) if found else "0"


def study(lab):
    rows = []
    for case, (fluid, solid) in SCENES.items():
        check = lab.ask("check", case, *EQUAL)
        part = check[check.index("\nunknowns"):check.index("\nmemory")]
        terms = [line.split("  ")[1] for line in check[check.index("\nterms"):check.index("\nunknowns")].splitlines()
                 if line.startswith("  ")]
        scalars = int(number(r"^  density +(\d+)", part)) + int(number(r"^  chemical_potential +(\d+)", part))
        displacement = int(number(r"^  displacement \(eliminated\) +(\d+)", part))
        lab.expect(f"{case}: density", "stored" if fluid else "none", scalars, (scalars > 0) == fluid)
        lab.expect(f"{case}: displacement", "stored" if solid else "none", displacement, (displacement > 0) == solid)
        memory = sum(float(number(rf"^  {name} +([\d.]+) MiB", check)) for name in ("state and history", "stage"))
        row = [case, number(r"^  solved +(\d+)", part), number(r"^  velocity +(\d+)", part), scalars, displacement,
               f"{memory:.1f} MiB"]
        if not lab.quick:
            bench = lab.ask("bench", case, *EQUAL, "--threads", "1")
            row += [number(r"^residual +([\d.]+) ms", bench), number(r"^product, exact +([\d.]+) ms", bench)]
        rows.append([*row, ", ".join(terms)])
    times = () if lab.quick else ("residual, ms", "product, ms")
    lab.table(("scene", "solved unknowns", "velocity", "density + mu", "displacement", "state and stage", *times, "terms"), rows)
