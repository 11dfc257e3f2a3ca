#!/usr/bin/env python3
"""`softwet units` against the scales of the paper, computed here with scipy alone; wrong quantities are refused.
usage: units.py SOFTWET"""

import math
import subprocess
import sys
import tomllib

from scipy.integrate import quad
from scipy.optimize import fsolve

THETA, GAMMA = 0.7, 0.02
REAL = {"--radius": "100um", "--length": "1mm", "--surface-tension": "72mN/m", "--density": "1 g/cm3",
        "--viscosity": "10mPa.s", "--young": "3kPa", "--poisson": "0.49", "--solid-density": "1100kg/m3",
        "--thickness": "0.2mm", "--temperature": str(THETA), "--capillarity": "1/50"}
WRONG = [("--radius", "100", "nm, um, mm"), ("--radius", "-1mm", "above 0"), ("--young", "3bar", "kPa"),
         ("--surface-tension", "72e-3", "mN/m"), ("--poisson", "0.5", "(-1, 0.5)"), ("--temperature", "1.2", "[0.3, 1)"),
         ("--capillarity", "0,02", "(0, inf)")]


def command(softwet, options):
    words = [word for pair in options.items() for word in pair]
    return subprocess.run([softwet, "units", *words], capture_output=True, text=True, timeout=900)


def coexistence(theta):
    """Densities of vapour and liquid, and the surface tension over gamma."""
    f = 8 / 27 * theta
    energy = lambda r: f * r * math.log(r / (1 - r)) - r * r
    slope = lambda r: f * (math.log(r / (1 - r)) + 1 / (1 - r)) - 2 * r
    pressure = lambda r: r * slope(r) - energy(r)
    vapour, liquid = fsolve(lambda x: [slope(x[0]) - slope(x[1]), pressure(x[0]) - pressure(x[1])], [0.045, 0.71],
                            xtol=1e-13)
    excess = lambda r: max(0.0, energy(r) - slope(liquid) * r + pressure(liquid))
    return liquid, quad(lambda r: math.sqrt(2 * excess(r)), vapour, liquid, epsabs=1e-12)[0]


def expected():
    liquid, tension = coexistence(THETA)
    b = 1000 / liquid
    stress = 0.072 / (GAMMA * tension * 1e-3)  # a b^2
    velocity = math.sqrt(stress / b)
    return {"viscosity": 0.010 / (1e-3 * b * velocity), "capillarity": GAMMA, "temperature": THETA, "thickness": 0.2,
            "density": 1100 / b, "young": 3000 / stress / (1100 / b), "poisson": 0.49, "radius": 0.1}


def main():
    softwet, failures = sys.argv[1], []
    result = command(softwet, REAL)
    if result.returncode != 0:
        sys.exit(f"units: exit code {result.returncode}: {result.stderr}")
    found = dict(line.split(" = ") for line in result.stdout.splitlines() if line.count(" = ") == 1)
    for key, value in expected().items():
        good = key in found and abs(float(found[key]) - value) <= 1e-6 * value
        print(f"{'ok' if good else 'FAIL':4}  {key} = {found.get(key)}, expected {value:.7g}")
        failures += [] if good else [key]
    solid = {"--solid-surface-tension": "31mN/m", "--wet-surface-tension": "0.02 N/m", "--solid-viscosity": "20Pa.s"}
    result = command(softwet, {**REAL, **solid})
    table = tomllib.loads(result.stdout[result.stdout.index("[fluid]"):])
    tension = 0.072 / (GAMMA * coexistence(THETA)[1])
    for key, value in (("surface_tension", 0.031 / tension), ("surface_tension_wet", 0.02 / tension),
                       ("viscosity", 20 / 0.010 * expected()["viscosity"])):
        good = abs(table["substrate"][key] - value) <= 1e-6 * value
        print(f"{'ok' if good else 'FAIL':4}  substrate.{key} = {table['substrate'][key]}, expected {value:.7g}")
        failures += [] if good else [key]
    for option in solid:
        result = command(softwet, {name: text for name, text in {**REAL, option: solid[option]}.items() if name != "--young"})
        good = result.returncode == 1 and "--young" in result.stderr
        print(f"{'ok' if good else 'FAIL':4}  {option} without a solid: {result.stderr.strip()}")
        failures += [] if good else [option]
    for option, text, part in WRONG:
        result = command(softwet, {**REAL, option: text})
        good = result.returncode == 1 and part in result.stderr and len(result.stderr.splitlines()) == 1
        print(f"{'ok' if good else 'FAIL':4}  {option} {text}: {result.stderr.strip()}")
        failures += [] if good else [f"{option} {text}"]
    sys.exit(f"units: {failures}" if failures else 0)


main()
