#!/usr/bin/env python3
"""boundary.foundation_damping: layers that swing on springs and dashpots, with implicit and explicit steps, and their
energy; layers without inertia that creep on them; a state of rest; a run that was stopped goes on to the bit; what is
refused.
usage: foundation_damping.py SOFTWET"""

import pathlib
import subprocess

import numpy
import scipy.optimize
from _same import check_same
from _scene import check, check_true, environment, history, open_output, run_file, softwet

YOUNG, POISSON, HEIGHT = 2000.0, 0.3, 0.125
MODULUS, SHEAR = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))
SPRING, DASHPOT, AWAY = 10.0, 0.5, 0.01


def write(name, boundary, more="", substrate="", time="end = 1.4, rho_inf = 1.0, tolerance = 1e30", elements=(8, 4)):
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = [0.25, {HEIGHT}], elements = {list(elements)} }}
substrate = {{ thickness = {HEIGHT}, young = {YOUNG}, poisson = {POISSON}{substrate} }}
boundary = {{ top = "free", {boundary} }}
time = {{ {time} }}
solver = {{ newton = {{ rtol = 1e-10, atol = 1e-16 }}, krylov = {{ rtol = 1e-4 }} }}
output = {{ fields = {{ times = [] }}, history = {{ every = 1 }} }}
probe = [{{ name = "down", quantity = "displacement_y", point = [0.1, 0.0] }},
         {{ name = "along", quantity = "displacement_x", point = [0.1, 0.0] }}]
{more}
""")
    return f"{name}.toml"


def slowest_rate(modulus, spring, dashpot):
    """s of the slowest wave cosh(q (H - y)) exp(s t) of a column of the modulus on a spring and a dashpot, rho s^2 = M
    q^2: M q sinh(q H) + (kap + c s) cosh(q H) = 0; from the frequency of a rigid column on."""
    def rest(parts):
        s = complex(*parts)
        q = s / numpy.sqrt(modulus)
        value = modulus * q * numpy.sinh(q * HEIGHT) + (spring + dashpot * s) * numpy.cosh(q * HEIGHT)
        return value.real, value.imag
    rigid = numpy.roots([HEIGHT, dashpot, spring])
    start = rigid[numpy.argmax(rigid.imag)] if abs(rigid.imag).max() > 0 else max(rigid.real)
    return complex(*scipy.optimize.fsolve(rest, (start.real, start.imag), xtol=1e-13))


def swings(t, s):
    """Of what is let go at 1 from rest."""
    return numpy.exp(s.real * t) * (numpy.cos(s.imag * t) - s.real / s.imag * numpy.sin(s.imag * t))


def lost(rows, start=0):
    rate, dt = rows["dissipation"], numpy.diff(rows["t"])
    return (0.5 * (rate[1:] + rate[:-1]) * dt)[start:].sum()


# --- layers that are let go, through a free bottom and along a roller. They begin in the shape in which they would
# swing without dashpots,
# cos(q (H - y)) with M q tan(q H) = kap, so that nothing jumps.
def beginning(axis, modulus):
    q = scipy.optimize.brentq(lambda q: modulus * q * numpy.tan(q * HEIGHT) - SPRING, 1e-6, 1.5 / HEIGHT)
    shape = f"{AWAY / numpy.cos(q * HEIGHT)}*cos({q}*(H - y))"
    return f'initial = {{ displacement = {[0, shape] if axis == "y" else [shape, 0]} }}'.replace("'", '"')


LET_GO = {
    "down": ("y", MODULUS, f'bottom = "free", foundation = [{SPRING}, 0.0], foundation_damping = [{DASHPOT}, 0.0]'),
    "along": ("x", SHEAR, 'left = "periodic", right = "periodic", bottom = "slip", '
                          f"foundation = [0.0, {SPRING}], foundation_damping = [0.0, {DASHPOT}]"),
}
for name, (axis, modulus, boundary) in LET_GO.items():
    case = write(name, boundary, beginning(axis, modulus))
    s = slowest_rate(modulus, SPRING, DASHPOT)
    balance = {}
    for scheme, settings in (("implicit", ["time.dt_initial=0.002", "time.dt_max=0.002"]),
                             ("halved", ["time.dt_initial=0.001", "time.dt_max=0.001"]),
                             ("kick_drift", ["time.scheme=kick_drift", "output.history.every=1"]),
                             ("rkl2", ["time.scheme=rkl2", "output.history.every=1"])):
        run_file(case, f"{name}_{scheme}", settings)
        rows = history(f"{name}_{scheme}")
        found, exact = rows[name] / AWAY, swings(rows["t"], s)
        check(f"{name}, {scheme}: displacement of the bottom, rate {s:.3f}, off by the part of the first", abs(found - exact).max(), 2e-3)
        check_true(f"{name}, {scheme}: dissipation_solid is all that is dissipated", (rows["dissipation_solid"] == rows["dissipation"]).all())
        first, last = rows["energy_total"][0], rows["energy_total"][-1]
        check(f"{name}, {scheme}: energy of the springs at the start, off",
              abs(rows["energy_foundation"][0] / (0.5 * SPRING * AWAY**2 * 0.25) - 1), 1e-12)
        balance[scheme] = abs(first - last - lost(rows)) / (first - last)
        check_true(f"{name}, {scheme}: most of the energy is lost", last < 0.05 * first, f"{last / first:.3g}")
        if scheme != "implicit":  # whose error is four times as large as with "halved", see below
            check(f"{name}, {scheme}: what is lost and dissipated differ by the part", balance[scheme], 2e-3)
    check(f"{name}: the same with half the step, over that: second order", balance["halved"] / balance["implicit"], 0.275)

# --- without inertia: the bottom follows u' c + kap u = p under a uniform load p for each area, and creeps without
# springs
FORCE = 0.08
LOAD = f"load = [{{ box = [[0.0, 0.0], [0.25, {HEIGHT}]], force = [0.0, {FORCE}], start = 0.0, ramp = 0.0 }}]"
pressure = FORCE * HEIGHT
for name, spring, exact in (("held", 2.0, lambda t: pressure / 2.0 * (1 - numpy.exp(-2.0 * t / DASHPOT))),
                            ("drifts", 0.0, lambda t: pressure / DASHPOT * t)):
    case = write(name, f'bottom = "free", foundation = [{spring}, 0.0], foundation_damping = [{DASHPOT}, 0.0]', LOAD, ', inertia = "none"')
    run_file(case, name, ["time.dt_initial=0.005", "time.dt_max=0.005"])
    rows = history(name)
    found, wanted = rows["down"], exact(rows["t"])
    # A step of the scheme that begins with the load takes the mean of before and after.
    off = abs((found - found[1]) - (wanted - wanted[1]))[1:].max() / wanted[-1]
    check(f"without inertia, kap = {spring}: displacement of the bottom since the first step, off", off, 1e-3)
done = subprocess.run([softwet, "steady", "held.toml", "--out", "rest", "--overwrite", "--threads", "1"], capture_output=True, text=True,
                      timeout=900, env=environment)
check_true("softwet steady: exit code 0", done.returncode == 0, done.stderr)
check("softwet steady: displacement of the bottom, off", abs(open_output("rest").history["down"][-1] * 2.0 / pressure - 1), 1e-6)

# --- a dashpot of the impedance sqrt(rho_0 M) lets a wave out of the layer
case = write("leaves", f'bottom = "free", foundation_damping = [{MODULUS**0.5}, 0.0]',
             'initial = { displacement = [0, "0.001*(1 + cos(pi*y/H))"] }',
             time=f"end = {3 * HEIGHT / MODULUS**0.5}, dt_initial = 2e-5, dt_max = 2e-5, rho_inf = 1.0, tolerance = 1e30",
             elements=[2, 16])
run_file(case, "leaves")
rows = history("leaves")
check("a wave that leaves: its elastic and kinetic energy at the end, over that at the start", rows["energy_total"][-1] / rows["energy_total"][0], 1e-3)

# --- strong dashpots limit explicit steps, which stay stable; a resumed run
STRONG = write("strong", 'bottom = "free", foundation = [10.0, 3.0], foundation_damping = [60.0, 40.0]',
               'initial = { displacement = ["0.004*sin(4*pi*x)", "0.003*cos(8*pi*x) + 0.002"] }', time='end = 0.2, scheme = "kick_drift"')
run_file(STRONG, "strong")
energy = history("strong")["energy_total"]
check("strong dashpots, explicit steps: largest energy over the first", energy.max() / energy[0], 1.01)
check("strong dashpots, explicit steps: last energy over the first", energy[-1] / energy[0], 0.9)
for scheme in ("kick_drift", "generalized_alpha"):
    run_file(STRONG, f"parts_{scheme}", [f"time.scheme={scheme}", "time.max_steps=20"])
    run_file(STRONG, f"whole_{scheme}", [f"time.scheme={scheme}", "time.max_steps=40"])
    run_file(STRONG, f"parts_{scheme}", [f"time.scheme={scheme}", "time.max_steps=40"], options=("--resume", "--quiet", "--threads", "1"))
    check_same(f"{scheme}: a resumed run", f"parts_{scheme}", f"whole_{scheme}")

# --- what is refused
for boundary, words in (('bottom = "clamped", foundation_damping = [1, 0]', ("boundary.foundation_damping", "dashpots", "clamped", 'bottom = "free"')),
                        ('bottom = "slip", foundation_damping = [1, 2]', ("boundary.foundation_damping", "slip", "[0, 2]")),
                        ('bottom = "free", foundation_damping = [1]', ("boundary.foundation_damping", "2 numbers", "c_n and c_t")),
                        ('bottom = "free", foundation_damping = [-1, 0]', ("boundary.foundation_damping", "[0, inf)"))):
    done = subprocess.run([softwet, "check", write("refused", boundary)], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{boundary}: refused", done.returncode == 1 and all(word in done.stderr for word in words), done.stderr.strip())
