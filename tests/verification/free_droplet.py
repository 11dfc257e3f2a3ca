#!/usr/bin/env python3
"""A free droplet: densities inside and outside and the pressure jump against the exact radial solution of the same mass
in the same area. usage: free_droplet.py SOFTWET"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "regression"))
import _measure  # noqa: E402
from _measure import compare, radial_droplet  # noqa: E402
from _scene import run  # noqa: E402

for (dimension, radius), known in {(2, 0.10): (0.87454040, 0.00204483, 0.04044886),
                                   (2, 0.15): (0.87199616, 0.00177476, 0.02661551),
                                   (3, 0.15): (0.87694492, 0.00235407, 0.05420046)}.items():
    mass = radial_droplet.sharp_mass(radius, dimension=dimension)
    inside, outside, _, _ = radial_droplet.solve(1 / 64, mass, dimension=dimension)
    jump = radial_droplet.pressure(0.39, inside) - radial_droplet.pressure(0.39, outside)
    for name, found, value in zip(("rho_in", "rho_out", "jump"), (inside, outside, jump), known):
        compare(f"radial solution, {dimension}D, {radius}: {name}", found, value, 1e-5)

run("free_droplet_2d", "free")
last = {name: values[-1] for name, values in _measure.history("free").items()}
inside, outside, mu, _ = radial_droplet.solve(1 / 64, last["mass"], volume=1.0)
points, density = _measure.fluid_field("free", 1)
middle, corner = density[density.shape[0] // 2, density.shape[1] // 2], density[0, 0]
compare("rho_in", middle, inside, 0.005)
compare("rho_out", corner, outside, 0.005)
compare("mu - mu_sat", last["laplace"], mu - _measure.POTENTIAL, 0.005)
pressure = radial_droplet.pressure
compare("pressure jump", pressure(0.39, middle) - pressure(0.39, corner),
        pressure(0.39, inside) - pressure(0.39, outside), 0.005)
