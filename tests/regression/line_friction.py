#!/usr/bin/env python3
"""Contact lines that stick. A droplet that a force pulls along a rigid wall creeps as foreseen below the force that its
hysteresis holds, and slides above it; line friction takes mu_f U^2 for each line; the energy falls at every step, by
what is dissipated; a resumed run has the same bits, also on a soft wall; a state of rest has the static angle; what
cannot be computed is refused.
usage: line_friction.py SOFTWET"""

import pathlib
import subprocess

import numpy
from _same import check_same
from _scene import cases, check, check_true, environment, history, run_file, softwet

SIGMA, VAPOUR = 0.25320 / 32, 0.001352289800692532  # of temperature 0.39 and capillarity 1/32: tests/oracle/wall_energy.py
RANGE = numpy.cos(numpy.radians([65.0, 85.0]))
HELD = SIGMA * (RANGE[0] - RANGE[1])
SINE = numpy.sqrt(1 - RANGE.mean() ** 2)
CREEP = 1e-3
SIZE = (1.6, 0.4)

pathlib.Path("tilted.toml").write_text(f"""
name = "tilted"
[domain]
size = [{SIZE[0]}, {SIZE[1]}]
elements = [80, 20]
[fluid]
viscosity = "1/256"
capillarity = "1/32"
temperature = 0.39
wall_law = "energy"
creep_speed = {CREEP}
[[droplet]]
centre = [0.5, 0.0]
radius = 0.25
[boundary]
bottom = "no_slip"
[time]
end = 6
""")
STICKY = ["fluid.contact_angle_range=[65,85]"]


def tilted(folder, force, *settings):
    run_file("tilted.toml", folder, [f"fluid.gravity=[{force},0]", *settings])
    return history(folder)


def speed(rows, since):
    """Of the droplet from a time on, by its middle."""
    late = rows["t"] >= since
    return numpy.polyfit(rows["t"][late], rows["x_centre"][late], 1)[0]


def falls(name, rows):
    """The energy falls at every step, by what is dissipated. The first step begins without a rate of the density."""
    energy, lost = rows["energy_total"], rows["dissipation"]
    drop, taken = -numpy.diff(energy), 0.5 * (lost[1:] + lost[:-1]) * numpy.diff(rows["t"])
    check(f"{name}: largest rise of the energy", -drop.min(), 1e-15)
    check(f"{name}: what a step loses and dissipates differ by the share of all that is lost", abs(drop - taken)[1:].max() / drop.sum(), 2e-3)
    check(f"{name}: all steps together", abs(taken.sum() / drop.sum() - 1), 0.03)
    part = rows["dissipation_wall"]
    check_true(f"{name}: the wall takes a part of it", (part[1:] > 0).all() and (part <= lost).all())
    check_true(f"{name}: most of it at the end", part[-1] > 0.8 * lost[-1], f"{part[-1] / lost[-1]:.2f}")


# The force that a droplet holds, from its mass above the vapour's.
mass = tilted("first", 0, *STICKY, "time.max_steps=1")["mass"][0] - VAPOUR * SIZE[0] * SIZE[1]
critical = HELD / mass
print(f"a droplet of the mass {mass:.4f} holds a force of {critical:.4f} per unit mass")

for share, error in ((0.3, 0.1), (0.8, 0.2)):  # x / sqrt(1 - x^2) is the law of a line whose density has one slope
    rows = tilted(f"held_{share}", share * critical, *STICKY, "time.tolerance=1e-4", "time.dt_initial=1e-4")
    found, foreseen = speed(rows, 3) / CREEP, share / numpy.sqrt(1 - share ** 2) / SINE
    check(f"at {share} of that force it creeps, {found:.3f} for {foreseen:.3f}", abs(found / foreseen - 1), error)
    falls(f"at {share}", rows)

# Far above the creep the speed grows with the force that the lines do not hold.
shares, speeds = (1.15, 1.3), []
for share in shares:
    speeds.append(speed(tilted(f"slides_{share}", share * critical, *STICKY, "fluid.creep_speed=1e-4", "time.end=10"), 6))
loose = numpy.polyfit(speeds, shares, 1)[1]
check(f"it comes loose at {loose:.4f} of that force, by speeds of {speeds[0]:.2e} and {speeds[1]:.2e}", abs(loose - 1), 0.03)

# The force on a droplet that slides is what the viscosity takes, in proportion to the speed, and mu_f U for each of its
# two lines.
needs, ANGLE = [], "fluid.contact_angle=75.23311039"
for friction in (0, 0.1):
    rows = tilted(f"friction_{friction}", 0.01, ANGLE, f"fluid.line_friction={friction}", "time.end=10")
    needs.append(mass * 0.01 / 2 / speed(rows, 6))
check(f"line friction 0.1 is found as {needs[1] - needs[0]:.4f}", abs((needs[1] - needs[0]) / 0.1 - 1), 0.1)

# A run that is stopped and goes on; on a soft wall too.
SOFT = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.wall_law=energy", "load[0].start=0.5", "load[0].ramp=0.5",
        "fluid.contact_angle_range=[65,85]", "fluid.contact_angle=75.23311039142881", "fluid.line_friction=0.02",
        "output.fields.times=[]"]
RESUME = ["--resume", "--quiet", "--threads", "1"]
for name, case, settings in (("rigid", "tilted.toml", [*STICKY, "fluid.gravity=[0.02,0]", "fluid.line_friction=0.01"]),
                             ("soft", cases / "tensotaxis_pull_2d.toml", SOFT)):
    run_file(case, f"{name}_whole", [*settings, "time.max_steps=16"])
    run_file(case, f"{name}_parts", [*settings, "time.max_steps=7"])
    run_file(case, f"{name}_parts", [*settings, "time.max_steps=16"], RESUME)
    check_same(f"{name}, resumed", f"{name}_parts", f"{name}_whole")

# A state of rest has no rates: its angle is the static one.
for name, settings in (("sticky", STICKY), ("plain", [ANGLE])):
    result = subprocess.run([softwet, "steady", "tilted.toml", "--out", f"rest_{name}", "--overwrite", "--quiet", "--threads", "1",
                             *(word for setting in settings for word in ("--set", setting))],
                            capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{name}: comes to rest", result.returncode == 0, result.stderr)
widths = [history(f"rest_{name}")["x_right"][-1] - history(f"rest_{name}")["x_left"][-1] for name in ("sticky", "plain")]
check("with hysteresis the droplet is as wide at rest as without it", abs(widths[0] - widths[1]), 1e-6)

# What cannot be computed.
for settings, parts in ((["fluid.contact_angle_range=[85,65]"], ["contact_angle_range", "write [65, 85]"]),
                        ([*STICKY, "fluid.contact_angle=75"], ["contact_angle = 75", "contradicts", "75.2331"]),
                        ([*STICKY, "time.scheme=kick_drift"], ["contact_angle_range", "generalized_alpha"]),
                        (["fluid.line_friction=1", "fluid.wall_law=gradient"], ["line_friction", "wall_law = \"energy\""]),
                        (["fluid.line_friction=1", "fluid.contact_angle=60 + x"], ["line_friction", "whole wall"])):
    message = run_file("tilted.toml", "refused", settings, code=1)
    check_true(f"{settings} is refused", all(part in message for part in parts), message)
