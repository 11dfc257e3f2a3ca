#!/usr/bin/env python3
"""Viscoelastic solids: standing waves and the creep of a column against closed forms, the order of the steps, the
balance of the energy, the same bits after a resume, states of rest, and what is reported and refused.
usage: branches.py SOFTWET"""

import itertools
import math
import pathlib
import subprocess

import numpy
from _same import check_same
from _scene import cases, check, check_true, environment, history, run_file, softwet

YOUNG, POISSON, G1, TAU = 0.7554, 0.45, 0.26, 1.0
SHEAR = YOUNG / (2 * (1 + POISSON))
ALONG = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
BRANCH = f"\n[[substrate.branch]]\nmodulus = {G1}\ntime = {TAU}\n"


def solid(name, size, elements, *, more="", tables=BRANCH, end=2.0, place="point = [0.0, 0.0]", quantity="displacement_x", sides="periodic",
          coordinates="plane"):
    """Writes <name>.toml: a solid alone that slips over its bottom and is free on top, with a probe."""
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
[domain]
size = {list(size)}
elements = {list(elements)}
coordinates = "{coordinates}"
[substrate]
thickness = {size[1]}
young = {YOUNG}
poisson = {POISSON}
strain = "small"
{more}
{tables}
[[probe]]
name = "u"
quantity = "{quantity}"
{place}
[boundary]
left = "{sides}"
right = "{sides}"
bottom = "slip"
top = "free"
[time]
end = {end}
tolerance = 1e9
[solver]
newton = {{ rtol = 1e-10 }}
krylov = {{ rtol = 1e-6 }}
[output]
history = {{ every = 1 }}
fields = {{ times = [] }}
""")
    return f"{name}.toml"


def ask(*words):
    return subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)


def steps(dt):
    return [f"time.dt_initial={dt}", f"time.dt_max={dt}"]


def balance(rows):
    """Largest open part of the balance of the energy, over the energy of the start."""
    lost = 0.5 * (rows["dissipation"][1:] + rows["dissipation"][:-1]) * numpy.diff(rows["t"])
    energy = rows["energy_total"]
    return abs(energy + numpy.append(0, numpy.cumsum(lost)) - energy[0]).max() / abs(energy).max()


# A standing shear wave u_x = A cos(k y), k = 2 pi, that begins at rest with a branch that carries nothing:
# rho s^2 + k^2 (G + G1 s tau / (1 + s tau)) = 0, a = u / (1 + s tau). The mean over half of the height is 2 A/pi.
amplitude, wave = 1e-3, 2 * math.pi
rates = numpy.roots([TAU, 1, wave**2 * (SHEAR + G1) * TAU, wave**2 * SHEAR])
for wanted in (-0.24668667 + 4.49855814j, -0.24668667 - 4.49855814j, -0.50662667):
    check(f"the rate {wanted}", abs(rates - wanted).min(), 1e-8)
parts = numpy.linalg.solve([rates**0, rates, 1 / (1 + rates * TAU)], [1, 0, 1])


def error_of_wave(rows):
    exact = sum(part * numpy.exp(rate * rows["t"]) for part, rate in zip(parts, rates)).real
    return abs(rows["u"] / rows["u"][0] - exact).max()


solid("wave", (0.078125, 0.5), (5, 32), place='box = [[0.0, 0.0], [0.0, 0.25]]\noperation = "mean"', tables=BRANCH + f"\n[[wave]]\nfield = \"displacement_x\"\namplitude = {amplitude}\nmode = [0, 1]\n")
for rho_inf in (0, 0.5, 1):
    errors, open_parts = [], []
    for dt in (0.02, 0.01):
        folder = f"wave_{rho_inf}_{dt}"
        run_file("wave.toml", folder, [f"time.rho_inf={rho_inf}", *steps(dt)])
        rows = history(folder)
        errors.append(error_of_wave(rows))
        open_parts.append(balance(rows))
    print(f"  rho_inf {rho_inf}: errors {errors[0]:.2e}, {errors[1]:.2e}, open part of the balance {open_parts[0]:.2e}, {open_parts[1]:.2e}")
    check(f"rho_inf {rho_inf}: the wave", errors[1], 5e-3)
    check(f"rho_inf {rho_inf}: of second order", errors[1] / errors[0], 0.28)
    check(f"rho_inf {rho_inf}: the balance of the energy at every step", open_parts[1], 3e-3)
    check(f"rho_inf {rho_inf}: it closes with the square of the steps", open_parts[1] / open_parts[0], 0.28)
check_true("a branch takes energy, and its dashpot loses it", rows["energy_branches"].max() > 0.1 * rows["energy_total"][0] > 0
           and rows["dissipation_solid"].max() > 0, str(rows["energy_branches"]))
check("it begins with nothing", rows["energy_branches"][0], 0)

# Explicit steps: of second order, with the error in space of the masses; a branch that is much faster than a step does
# not shorten them.
for mass, most in (("lumped", 1e-2), ("corrected", 2e-3), ("consistent", 2e-3)):
    runs = []
    for dt in (0.002, 0.001, 0.0005):
        folder = f"wave_kick_{mass}_{dt}"
        run_file("wave.toml", folder, ["time.scheme=kick_drift", f"time.mass={mass}", "output.history.every=1", *steps(dt)])
        runs.append(history(folder))
    check(f"kick_drift, {mass}: the wave", error_of_wave(runs[2]), most)
    first, second = (abs(a["u"] - b["u"][::2]).max() for a, b in zip(runs, runs[1:]))
    check(f"kick_drift, {mass}: of second order", second / first, 0.28)
run_file("wave.toml", "wave_fast", ["time.scheme=kick_drift", "substrate.branch.time=1e-5", "output.history.every=1"])
rows = history("wave_fast")
check_true("steps are longer than the time of a branch", rows["dt"].max() > 1e-3, str(rows["dt"]))
check("it hardly feels it", abs(rows["u"] / rows["u"][0] - numpy.cos(wave * math.sqrt(SHEAR) * rows["t"])).max(), 1e-2)

# Finite strains, where points remember the strain: the same wave while it is small. A high wave loses what its dashpots
# say, and explicit steps find the same.
run_file("wave.toml", "wave_finite", ["substrate.strain=finite", *steps(0.01)])
check("finite strains: the wave", error_of_wave(history("wave_finite")), 5e-3)
high = ["substrate.strain=finite", "wave[0].amplitude=0.05", "time.end=1", "output.history.every=1"]
runs = {}
for scheme, sizes in {"generalized_alpha": (0.01, 0.005), "kick_drift": (0.002, 0.001)}.items():
    opened = []
    for dt in sizes:
        words = [f"time.scheme={scheme}", "time.mass=consistent"] if scheme == "kick_drift" else []
        run_file("wave.toml", f"wave_high_{scheme}_{dt}", [*high, *words, *steps(dt)])
        runs[scheme] = history(f"wave_high_{scheme}_{dt}")
        opened.append(balance(runs[scheme]))
    print(f"  a high wave, {scheme}: open part of the balance {opened[0]:.2e}, {opened[1]:.2e}")
    check(f"a high wave, {scheme}: the balance of the energy", opened[1], 3e-3)
    check(f"a high wave, {scheme}: it closes with the square of the steps", opened[1] / opened[0], 0.3)
one, other = (runs[scheme] for scheme in runs)
check("a high wave: explicit steps as implicit ones", abs(numpy.interp(one["t"], other["t"], other["u"]) - one["u"]).max() / one["u"][0], 2e-2)
linear = error_of_wave(other)
check_true("a high wave is no small one", linear > 0.02, f"{linear}")

# The rates themselves, from three values of the wave at equal distances: the wave obeys a difference equation whose
# roots are exp(s d).
run_file("wave.toml", "wave_fine", [*steps(0.0025), "time.end=3"])
values = history("wave_fine")["u"][::80]
rows_of = numpy.array([values[i:i + 3] for i in range(len(values) - 3)])
found = numpy.log(numpy.roots([1, *-numpy.linalg.lstsq(rows_of, values[3:], rcond=None)[0][::-1]]).astype(complex)) / 0.2
for rate in rates:
    check(f"rate {rate:.5f} of the run", abs(found - rate).min() / abs(rate), 2e-3)

# A column creeps under its own weight, without inertia: at once against G + G1, then to its elastic height.
along1 = 4 / 3 * G1
fading = TAU * (ALONG + along1) / ALONG
for coordinates in ("plane", "axisymmetric"):
    solid("column", (0.25, 1.0), (4, 16), more='inertia = "none"\ngravity = [0.0, -0.01]', end=3, place="point = [0.125, 1.0]", quantity="displacement_y",
          sides="slip", coordinates=coordinates)
    errors = []
    run_file("column.toml", f"column_{coordinates}_finite", [*steps(0.025), "substrate.strain=finite", "substrate.gravity=[0,-1e-4]", "solver.newton.atol=1e-13"])
    for dt in (0.05, 0.025):
        folder = f"column_{coordinates}_{dt}"
        run_file("column.toml", folder, steps(dt))
        rows = history(folder)
        height = -rows["u"] / (0.01 / (2 * ALONG))
        exact = 1 - along1 / (ALONG + along1) * numpy.exp(-rows["t"] / fading)
        errors.append(abs(height[1:] - exact[1:]).max())
    for t, wanted in ((0.1, 0.90128173), (1.0, 0.95576986), (3.0, 0.99257194)):
        check(f"column, {coordinates}, t = {t}", abs(numpy.interp(t, rows["t"], height) - wanted), 1e-4)
    check(f"column, {coordinates}: of second order", errors[1] / errors[0], 0.3)
    finite = history(f"column_{coordinates}_finite")
    check(f"column, {coordinates}: finite strains under a small weight", abs(-finite["u"] / (1e-4 / (2 * ALONG)) - height).max(), 1e-4)

# The fit of a power law, and what is said of it.
for exponent, percent in ((0.4, 3.1), (0.55, 0.8), (0.7, 0.6)):
    told = ask("check", "wave.toml", "--set", f"substrate.gel.exponent={exponent}", "--set", "substrate.gel.time=0.3").stdout
    line = [line for line in told.splitlines() if "largest error of its modulus" in line]
    check_true(f"check gives the error for n = {exponent}", line and f" {percent} %" in line[0] and "branch 11" in told, told)

# A gel: many branches, some of them much faster than a step.
run_file("wave.toml", "gel", ["substrate.gel.exponent=0.5", "substrate.gel.time=0.05", "substrate.gel.decades=[-2,1]", *steps(0.02)])
check("a gel: the balance of the energy", balance(history("gel")), 5e-3)

# A resumed run has the same bits.
for scheme, strain in itertools.product(("generalized_alpha", "kick_drift"), ("small", "finite")):
    words = [f"time.scheme={scheme}", f"substrate.strain={strain}", *steps(0.002), "time.end=0.2", "substrate.gel.exponent=0.5", "substrate.gel.time=0.001", "output.history.every=1"]
    whole, resumed = f"whole_{scheme}_{strain}", f"parts_{scheme}_{strain}"
    run_file("wave.toml", whole, words)
    run_file("wave.toml", resumed, [*words, "time.max_steps=17"])
    run_file("wave.toml", resumed, words, ("--resume", "--quiet", "--threads", "1"))
    check_true(f"{scheme}, {strain}: history.csv after a resume",
               pathlib.Path(f"{whole}/history.csv").read_bytes() == pathlib.Path(f"{resumed}/history.csv").read_bytes())
    check_same(f"{scheme}, {strain}, resumed", whole, resumed)

# A droplet: at rest branches carry nothing, then they slow the pull down.
droplet = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "substrate.strain=small", "time.end=3", "output.fields.times=[]",
           "time.start=equilibrium"]
gel = ["substrate.viscosity=0", "substrate.gel.exponent=0.5", "substrate.gel.time=1"]
case = cases / "viscous_layer_pull_2d.toml"
for strain in ("small", "finite"):
    run_file(case, f"droplet_{strain}", [*droplet, *gel, f"substrate.strain={strain}"])
    rows = history(f"droplet_{strain}")
    check(f"{strain} strains: a droplet begins at rest on a gel", max(rows["speed_max_solid"][0], rows["energy_branches"][0]), 1e-12)
    check_true(f"{strain} strains: the pull fills the branches", rows["energy_branches"].max() > 1e-9, str(rows["energy_branches"]))
    check(f"{strain} strains: the mass stays", abs(rows["mass_drift"]).max(), 1e-12)
energies = []
for name, words in (("elastic", ["substrate.viscosity=0"]), ("gel", gel)):
    done = ask("steady", str(case), "--out", f"rest_{name}", "--overwrite", "--threads", "1",
               *[word for setting in droplet[:3] + words for word in ("--set", setting)])
    check_true(f"steady, {name}", done.returncode == 0, done.stdout + done.stderr)
    energies.append(history(f"rest_{name}")["energy_total"][-1])
check("a gel has the state of rest of its elastic part", abs(energies[1] / energies[0] - 1), 1e-9)

# What is refused.
for words, parts in ((["substrate.strain=finite", "substrate.prestretch=[1.2]"], ["substrate.branch[0].modulus", "prestretch"]),
                     (["time.scheme=rkl2"], ["substrate.branch[0].modulus", "generalized_alpha"]),
                     (["substrate.gel.exponent=0.5"], ["substrate.gel.time"])):
    done = ask("check", "wave.toml", *[word for setting in words for word in ("--set", setting)])
    check_true(f"{words} is refused", done.returncode == 1 and all(part in done.stderr for part in parts), done.stderr)
for words, part in ((("explain", "substrate.branch.time"), "fades"), (("explain", "substrate.gel"), "angular frequency"),
                    (("explain", "history.energy_branches"), "dashpot")):
    check_true(" ".join(words), part in ask(*words).stdout, ask(*words).stdout)
