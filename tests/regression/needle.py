#!/usr/bin/env python3
"""Needles: what they read against closed forms, the balance of the energy, steps at the points of their paths, the same
bits after a resume, and what is refused. usage: needle.py SOFTWET"""

import math
import pathlib
import subprocess

import numpy
from _same import check_same
from _scene import cases, check, check_true, environment, history, run_file, softwet

YOUNG, POISSON, HEIGHT = 0.8, 0.3, 0.25
SHEAR = YOUNG / (2 * (1 + POISSON))
ALONG = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))


def layer(name, *, size=0.5, elements=(8, 8), sides="periodic", bottom="clamped", coordinates="plane", path=(0, 0),
          stiffness=40.0, box=None, end=2.0, more=""):
    """Writes <name>.toml: a solid alone whose top is free, with a needle in all of it or in a box."""
    box = box or [[0.0, 0.0], [size, HEIGHT]]
    listed = ", ".join(f'"{part}"' if isinstance(part, str) else f"{part}" for part in path)
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
[domain]
size = [{size}, {HEIGHT}]
elements = {list(elements)}
coordinates = "{coordinates}"
[substrate]
thickness = {HEIGHT}
density = 2.0
young = {YOUNG / 2}
poisson = {POISSON}
strain = "small"
[[needle]]
box = {box}
stiffness = {stiffness}
path = [{listed}]
[boundary]
left = "{'slip' if coordinates == 'axisymmetric' else sides}"
right = "{sides}"
bottom = "{bottom}"
top = "free"
[time]
end = {end}
rho_inf = 1.0
tolerance = 1e9
[output]
history = {{ every = 1 }}
fields = {{ times = [] }}
{more}""")
    return f"{name}.toml"


def ask(*words):
    return subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)


def steady(path, folder, code=0):
    done = ask("steady", path, "--out", folder, "--overwrite", "--threads", "1")
    check_true(f"{folder}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stderr if code else {name: column[-1] for name, column in history(folder).items()}


# A layer that slips over its bottom swings as a whole after a jump of its needle: force k V U cos(w t), w = sqrt(k /
# rho_0).
jump, stiffness = 0.01, 40.0
volume, frequency = 0.5 * HEIGHT, math.sqrt(stiffness / 2)
layer("swing", bottom="slip", path=(jump, 0))
for scheme, mass in (("generalized_alpha", "corrected"), ("kick_drift", "corrected"), ("kick_drift", "lumped"),
                     ("kick_drift", "consistent"), ("ssp_rk3", "lumped"), ("rkl2", "lumped")):
    errors = []
    for dt in (0.008, 0.004):
        folder = f"swing_{scheme}_{mass}_{dt}"
        run_file("swing.toml", folder, [f"time.scheme={scheme}", f"time.mass={mass}", f"time.dt_max={dt}", f"time.dt_initial={dt}"])
        rows = history(folder)
        wanted = stiffness * volume * jump * numpy.cos(frequency * rows["t"])
        errors.append(abs(rows["needle_force_x"] - wanted).max() / (stiffness * volume * jump))
        check(f"{folder}: no force across", abs(rows["needle_force_y"]).max(), 1e-12)
    check(f"{scheme}, {mass}: the reading", errors[1], 5e-3)
    check(f"{scheme}, {mass}: of second order or better, or at round-off", errors[1] / errors[0], 0.28)
    energy = rows["energy_total"]
    check(f"{scheme}, {mass}: energy that is there stays", numpy.ptp(energy) / energy[0], 2e-3)
    check_true(f"{scheme}, {mass}: a needle that stands still has no power", not rows["power_needle"].any())

# A clamped layer under springs of the stiffness k in all of it: G u'' = -k (U - u), so that it is sheared by the force
# U L sqrt(k G) tanh(H sqrt(k/G)); about an axis of symmetry and upwards with lambda + 2 mu in place of G. Springs at
# control values are the forces of another place by parts of an element: an error that falls with h^2.
for name, path, modulus, area, settings in (("shear", (jump, 0), SHEAR, 0.5, {}), ("lift", (0, jump), ALONG, 0.5, {}),
                                            ("lift_round", (0, jump), ALONG, math.pi * 0.25,
                                             {"coordinates": "axisymmetric", "sides": "slip"})):
    errors = []
    for rows_up in (16, 32):
        found = steady(layer(f"{name}_{rows_up}", elements=(8, rows_up), path=path, **settings), f"{name}_{rows_up}")
        wave = math.sqrt(stiffness / modulus)
        wanted = jump * area * math.sqrt(stiffness * modulus) * math.tanh(HEIGHT * wave)
        errors.append(abs(found["needle_force_y" if path[1] else "needle_force_x"] / wanted - 1))
        print(f"  {name}, {rows_up} rows: the reading differs by {errors[-1]:.2e} from {wanted:.8g}")
    check(f"{name}: the reading at rest", errors[1], 2e-3)
    check(f"{name}: its error falls with the square of the rows", errors[1] / errors[0], 0.28)

# A rigid needle in the upper half of a clamped layer: what is below is sheared by U over its height, less the part of
# an element at its end that the needle holds too.
for rows_up in (8, 32):
    h = HEIGHT / rows_up
    found = steady(layer(f"rigid_{rows_up}", elements=(8, rows_up), path=(jump, 0), stiffness=1e3 * YOUNG / h**2,
                         box=[[0.0, HEIGHT / 2], [0.5, HEIGHT]]), f"rigid_{rows_up}")
    height = SHEAR * jump * 0.5 / found["needle_force_x"]
    print(f"  rigid, {rows_up} rows: the free height is shorter by {(HEIGHT / 2 - height) / h:.3f} elements")
    check_true(f"rigid, {rows_up} rows: it holds a little more than its box",
               0.2 < (HEIGHT / 2 - height) / h < 0.4, f"{(HEIGHT / 2 - height) / h}")

# A needle that moves: its work is what the energy gains, the better the shorter the steps are.
layer("moved", path=("0.01*(1 - cos(3*t))", "0.004*sin(2*t)"), stiffness=400.0, box=[[0.1, 0.125], [0.3, 0.25]], sides="slip")
for scheme, mass in (("generalized_alpha", "corrected"), ("kick_drift", "consistent"), ("ssp_rk3", "consistent")):
    open_parts = []
    for dt in (0.006, 0.003):
        folder = f"moved_{scheme}_{dt}"
        run_file("moved.toml", folder, [f"time.scheme={scheme}", f"time.mass={mass}", f"time.dt_max={dt}", f"time.dt_initial={dt}"])
        rows = history(folder)
        work = numpy.append(0, numpy.cumsum(0.5 * (rows["power_needle"][1:] + rows["power_needle"][:-1]) * numpy.diff(rows["t"])))
        open_parts.append(abs(rows["energy_total"] - rows["energy_total"][0] - work).max() / numpy.ptp(rows["energy_total"]))
    print(f"  {scheme}: open part of the balance {open_parts[0]:.2e}, {open_parts[1]:.2e}")
    check(f"{scheme}: the balance of the energy at every step", open_parts[1], 2e-3)
    check(f"{scheme}: it closes with the square of the steps", open_parts[1] / open_parts[0], 0.35)
    check_true(f"{scheme}: no event reports that energy rose",
               "the energy rose" not in pathlib.Path(folder, "run.json").read_text())

# Steps end at the points of a table; a jump feeds the springs at once, and no event reports that energy rose.
pathlib.Path("places.csv").write_text("t,value\n0.3,0\n0.7,0.01\n1.1,0.01\n1.1000000001,0.02\n1.6,0\n")
layer("table", path=("places.csv", 0), box=[[0.1, 0.125], [0.3, 0.25]], sides="slip", stiffness=400.0)
for scheme in ("generalized_alpha", "kick_drift"):
    run_file("table.toml", f"table_{scheme}", [f"time.scheme={scheme}", "time.dt_max=0.03"])
    times = history(f"table_{scheme}")["t"]
    for moment in (0.3, 0.7, 1.1, 1.6):
        check(f"{scheme}: a step ends at t = {moment}", abs(times - moment).min(), 1e-9)
    text = pathlib.Path(f"table_{scheme}", "run.json").read_text()
    check_true(f"{scheme}: no event reports that energy rose", "the energy rose" not in text)

# A resumed run has the same bits.
for scheme in ("generalized_alpha", "kick_drift"):
    words = [f"time.scheme={scheme}", "time.dt_max=0.03"]
    run_file("moved.toml", f"whole_{scheme}", words)
    run_file("moved.toml", f"parts_{scheme}", [*words, "time.max_steps=17"])
    run_file("moved.toml", f"parts_{scheme}", words, ("--resume", "--quiet", "--threads", "1"))
    for part in ("history.csv",):
        check_true(f"{scheme}: {part} after a resume",
                   pathlib.Path(f"whole_{scheme}", part).read_bytes() == pathlib.Path(f"parts_{scheme}", part).read_bytes())
    check_same(f"{scheme}, resumed", f"whole_{scheme}", f"parts_{scheme}")

# A scene of a droplet: it starts in equilibrium with the needle where it stands, and is plotted.
droplet = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "needle.stiffness=1e5", "time.end=3", "output.fields.times=[]"]
run_file(cases / "pulled_needle_2d.toml", "droplet", droplet)
rows = history("droplet")
check("it begins at rest", max(rows["speed_max_solid"][0], rows["power_needle"][0]), 1e-9)
check_true("the needle reads what draws it", rows["needle_force_x"][-1] > 1.1 * rows["needle_force_x"][0] > 0, str(rows["needle_force_x"]))
check("the mass stays", abs(rows["mass_drift"]).max(), 1e-12)
run_file(cases / "pulled_needle_2d.toml", "droplet_fast", [*droplet, "time.scheme=kick_drift", "time.end=0.2", "output.history.every=1"])
fast = history("droplet_fast")
check("an explicit run of it reads the same", abs(fast["needle_force_x"][-1] / numpy.interp(0.2, rows["t"], rows["needle_force_x"]) - 1), 0.1)

# What is refused, and what is reported.
said = steady("moved.toml", "moving", code=1)
check_true("steady refuses a needle that moves", "needle[0].path varies in time" in said and "'needle[0].path=[0.1,0]'" in said, said)
told = ask("check", "moved.toml").stdout
check_true("check mentions it", "needles" in told and "needle[0].path, x" in told and "from t = 0 on" in told, told)
for words, part in ((("explain", "needle.stiffness"), "100 E/h^2"), (("explain", "history.power_needle"), "power_load"),
                    (("explain", "history.needle_force_x"), "reading")):
    check_true(f"{' '.join(words)}", part in ask(*words).stdout, ask(*words).stdout)
