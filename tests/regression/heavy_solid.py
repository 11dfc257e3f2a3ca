#!/usr/bin/env python3
"""Explicit schemes beside a solid that is many times heavier than the fluid: a droplet at rest stays at rest, for each
kind of mass. Masses of neighbours that differ much must not turn the damping of the shortest waves into growth.
usage: heavy_solid.py SOFTWET"""

from _scene import check, history, record, run

SCENE = ["domain.elements=[16,8]", "fluid.capillarity=1/8", "fluid.temperature=0.7", "time.end=0.3", "output.fields.times=[]",
         "output.history.every=1"]
for density in (1, 10, 100):
    for mass in ("corrected", "lumped"):
        name = f"{mass}_{density}"
        run("static_droplet_soft_2d", name, [*SCENE, "time.scheme=kick_drift", f"time.mass={mass}", f"substrate.density={density}"])
        rows = history(name)
        # The start is near to rest: what it sets free is a small part of the free energy.
        check(f"{name}: largest kinetic energy", abs(rows["energy_kinetic"]).max(), 1e-3)
        check(f"{name}: refused steps", record(name)["counts"]["rejected_by_newton"], 0)
