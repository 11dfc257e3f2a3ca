#!/usr/bin/env python3
"""fluid.wall_stretch_exponent: droplets on walls that are stretched, before the scene or by loads, have the effective
contact angle cos = a^-beta cos(alpha); the energy of a droplet that is pulled is balanced; explicit steps agree with
implicit ones; a run that was stopped goes on to the bit; what check says and refuses.
usage: wall_stretch_exponent.py SOFTWET"""

import os
import pathlib
import subprocess
import sys

import numpy
from _same import check_same
from _scene import TIGHT, cases, check, check_true, environment, history, open_output, run, softwet

sys.path.insert(0, str(pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tests" / "verification"))
import _measure  # noqa: E402

ALPHA, BETA = 60.0, 0.8


def call(words, code=0):
    done = subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{' '.join(words[:2])}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stdout + done.stderr


def sets(settings):
    return [word for setting in settings for word in ("--set", setting)]


# Half a droplet on a layer; the left side is its plane of symmetry, or the axis.
def write(name, young, more="", length=0.6, thickness=0.1):
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = [{length}, 0.4], elements = [{round(80 * length)}, 32] }}
fluid = {{ viscosity = 0.02, capillarity = "1/32", temperature = 0.39, contact_angle = {ALPHA}, wall_law = "energy" }}
substrate = {{ thickness = {thickness}, young = {young}, poisson = 0.3, material = "neo_hookean" }}
boundary = {{ bottom = "slip", top = "no_slip" }}
time = {{ end = 100.0 }}
output = {{ fields = {{ times = [100.0] }} }}
droplet = [{{ centre = [0.0, {thickness}], radius = 0.25 }}]
{more}
""")
    return f"{name}.toml"


def rest(case, folder, *settings):
    call(["steady", case, "--out", folder, "--overwrite", "--threads", "1", *sets(settings)])
    rows = history(folder)
    return rows["x_right"][-1], rows["angle_right"][-1]


def effective(ratio, beta=BETA):
    return numpy.degrees(numpy.arccos(ratio**-beta * numpy.cos(numpy.radians(ALPHA))))


# --- stretched before: the layer hardly gives way, and the droplet has the effective angle
stiff = write("stiff", 50.0)
for name, ratio, stretched in (("flat", 1.2, ["substrate.prestretch=[1.2]"]), ("shortened", 0.8, ["substrate.prestretch=[0.8]"]),
                               ("round", 1.1**2, ["domain.coordinates=axisymmetric", "substrate.prestretch=[1.1]"])):
    found = rest(stiff, f"{name}_found", f"fluid.wall_stretch_exponent={BETA}", *stretched)
    expected = rest(stiff, f"{name}_expected", f"fluid.contact_angle={effective(ratio):.15g}", *stretched)
    plain = rest(stiff, f"{name}_plain", *stretched)
    effect = [abs(p - e) for p, e in zip(plain, expected)]
    check_true(f"{name}: what the exponent changes", effect[0] > 0.005 and effect[1] > 3, f"{effect[0]:.4f} L0, {effect[1]:.2f} degrees")
    for what, f, e, scale in zip(("contact point", "angle"), found, expected, effect):
        check(f"{name}: {what} {f:.5f}, with the effective angle {effective(ratio):.2f} degrees {e:.5f}: off, over what the exponent changes",
              abs(f - e) / scale, 5e-3)

# --- stretched by a load: the layer between the plane of symmetry and the box has one stretch
pulled = write("pulled", 20.0, "load = [{ box = [[0.35, 0.0], [0.4, 0.05]], force = [140.0, 0.0], start = 0.0, ramp = 0.0 }]",
               length=1.0, thickness=0.05)
found = rest(pulled, "pulled_found", f"fluid.wall_stretch_exponent={BETA}")
walls = open_output("pulled_found").interface
wall = walls[max(walls)]
x, u = wall["x_reference"], wall["displacement_x"]
inside = x <= 0.3
ratio = 1 + numpy.interp(0.3, x, u) / 0.3
check_true("pulled: the wall below the droplet is stretched", 1.1 < ratio < 1.4, f"{ratio:.4f}")
check("pulled: by one ratio, off", abs(u[inside] - (ratio - 1) * x[inside]).max() / (0.3 * (ratio - 1)), 0.02)


def cap(angle):
    """Area of a cap over the square of its radius."""
    return numpy.radians(angle) - 0.5 * numpy.sin(2 * numpy.radians(angle))


# A cap of another angle at the start has to have the same liquid.
radius = 0.25 * (cap(ALPHA) / cap(effective(ratio)))**0.5
expected = rest(pulled, "pulled_expected", f"fluid.contact_angle={effective(ratio):.15g}", f"droplet.radius={radius:.15g}")
plain = rest(pulled, "pulled_plain")
for what, f, e, p in zip(("contact point", "angle"), found, expected, plain):
    check(f"pulled: {what} {f:.5f}, with the effective angle {e:.5f}, without the exponent {p:.5f}: off, over what the exponent changes",
          abs(f - e) / abs(p - e), 0.03)

# --- the energy of a droplet that is pulled: what is open falls with the square of the step
PULL = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.wall_law=energy", "fluid.traction=blended",
        "substrate.surface_tension=0.03", "substrate.density=400", "substrate.young=0.0018885",
        "load[0].force=[0.000405375,0]", "load[0].start=2", "load[0].ramp=4", "time.end=4", "output.fields.times=[0,4]",
        "time.tolerance=1e3", "fluid.wall_stretch_exponent=0.6", *TIGHT]
for tension in ("none", "acts"):
    parts = []
    for dt in (0.025, 0.0125):
        folder = f"balance_{tension}_{dt}"
        run("tensotaxis_pull_2d", folder, [*PULL, f"fluid.wall_tension={tension}", f"time.dt_initial={dt}", f"time.dt_max={dt}"])
        parts.append(_measure.balance_error(folder, 0, 4))
    check(f"{tension}: open at half the step over that at the whole one", parts[1] / parts[0], 0.275)
    check(f"{tension}: open, as a part of what is dissipated", parts[1], 0.02)
    stretch = abs(history(folder)["wall_stretch"]).max()
    check_true(f"{tension}: wall_stretch", (stretch == 0) == (tension == "acts"), f"{stretch:.3g}")

# --- explicit steps, and runs that go on
FAST = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.wall_law=energy", "fluid.wall_tension=acts", "substrate.surface_tension=0.03",
        "substrate.young=0.3", "load[0].start=0", "load[0].ramp=0.1", "time.end=0.4", "output.fields.times=[]", "output.history.every=1"]
ends = {}
for scheme in ("generalized_alpha", "kick_drift"):
    for beta in (0, 1):
        name = f"{scheme}_{beta}"
        run("tensotaxis_pull_2d", name, [*FAST, f"time.scheme={scheme}", f"fluid.wall_stretch_exponent={beta}", "domain.quadrature=full",
                                         "time.dt_initial=0.001", "time.dt_max=0.002"])
        ends[scheme, beta] = history(name)["energy_wall"][-1]
change = {scheme: ends[scheme, 1] - ends[scheme, 0] for scheme in ("generalized_alpha", "kick_drift")}
check_true("what the exponent changes of the wall energy", abs(change["generalized_alpha"]) > 1e-8, f"{change['generalized_alpha']:.3g}")
check("the same with explicit steps, off", abs(change["kick_drift"] / change["generalized_alpha"] - 1), 0.02)
for scheme in ("generalized_alpha", "kick_drift"):
    settings = [*FAST, f"time.scheme={scheme}", "fluid.wall_stretch_exponent=0.5"]
    run("tensotaxis_pull_2d", f"parts_{scheme}", [*settings, "time.max_steps=7"])
    run("tensotaxis_pull_2d", f"whole_{scheme}", [*settings, "time.max_steps=14"])
    run("tensotaxis_pull_2d", f"parts_{scheme}", [*settings, "time.max_steps=14"], options=("--resume", "--quiet", "--threads", "1"))
    check_same(f"{scheme}: a resumed run", f"parts_{scheme}", f"whole_{scheme}")

# --- words
told = call(["check", stiff, *sets(["substrate.prestretch=[1.2]", f"fluid.wall_stretch_exponent={BETA}"])])
check_true("check: the effective angle", f"{effective(1.2):.5g} degrees" in told and f"{effective(1.32):.5g} degrees" in told, told)
BEYOND = ["substrate.prestretch=[0.5]", "fluid.wall_stretch_exponent=1", "fluid.contact_angle=50"]
REPELLED = ["droplet.radius=0.15", "fluid.contact_angle=120", "fluid.wall_stretch_exponent=0.5", "fluid.wall_tension=acts", "substrate.surface_tension=0.1"]
for case, settings, words in (
        (stiff, ["fluid.wall_stretch_exponent=1.5"], ["fluid.wall_stretch_exponent", "1.5", "[0, 1]"]),
        (stiff, ["fluid.wall_stretch_exponent=0.5", "fluid.wall_law=gradient"], ["fluid.wall_stretch_exponent", 'wall_law = "energy"']),
        (stiff, BEYOND, ["fluid.wall_stretch_exponent", "1.286", "complete wetting", "below 0.6376"]),
        (stiff, REPELLED, ["fluid.wall_stretch_exponent = 0.5", "substrate.surface_modulus"]),
        (str(cases / "static_droplet_rigid_2d.toml"), ["fluid.wall_law=energy", "fluid.wall_stretch_exponent=0.5"],
         ["fluid.wall_stretch_exponent", "needs a solid"])):
    told = call(["check", case, *sets(settings)], code=1)
    check_true(f"{settings}: refused", all(word in told for word in words), told)
