#!/usr/bin/env python3
"""Loads that jump or vary fast: the impulse that a body takes up is the impulse of the load, and steps of any length
follow a load that is an expression. usage: jumps.py SOFTWET"""

import pathlib

import numpy
from _scene import check, check_true, history, open_output, run_file
from _same import check_same

# A body that nothing holds, under the same force everywhere: its momentum is the impulse of the load, whatever its
# stiffness.
pathlib.Path("body.toml").write_text("""
name = "body"
domain = { size = [1.0, 0.5], elements = [4, 2] }
substrate = { thickness = 0.5, young = 1.0, poisson = 0.3 }
boundary = { left = "free", right = "free", bottom = "free", top = "free" }
load = [ { box = [[0.0, 0.0], [1.0, 0.5]], force = [0.01, 0.0] } ]
time = { end = 2.0, dt_initial = 0.05, dt_max = 0.05 }
solver = { newton = { rtol = 1e-9 } }
output = { fields = { times = [] } }
""")
FORCE = 0.01 * 0.5  # times the mass of the body


def table(name, rows):
    pathlib.Path(name).write_text("t,value\n" + "".join(f"{t!r},{v!r}\n" for t, v in rows))
    return f"load[0].factor={name}"


LOADS = {  # settings, and the integral of the factor to t = 2
    "from the start": ([], 2.0),
    "a start without a ramp": (["load[0].factor=0.7", "load[0].start=0.37", "time.end=1.63"], 0.7 * 1.63),
    "a gap of 1e-9": ([table("near.csv", [(0, 0), (1, 0), (1 + 1e-9, 1), (2, 1)])], 1.0),
    "a gap of 1e-13": ([table("nearer.csv", [(0, 0), (1, 0), (1 + 1e-13, 1), (2, 1)])], 1.0),
    "a gap of 1e-5": ([table("short.csv", [(0, 0), (1, 0), (1 + 1e-5, 1), (2, 1)])], 1 - 0.5e-5),
    "a gap of 1e-3": ([table("longer.csv", [(0, 0), (1, 0), (1.001, 1), (2, 1)])], 1.0 - 0.0005),
    "up and down": ([table("pulse.csv", [(0, 0), (0.5, 0), (0.5 + 1e-9, 2), (0.8, 2), (0.8 + 1e-9, -1), (2, -1)])], 0.6 - 1.2),
    "an expression": (["load[0].factor=t < 0.7313 ? 0.25 : 1"], 0.25 * 0.7313 + 1.2687),
    "a short ramp": (["load[0].ramp=1e-9"], 2.0),
}
for scheme in ("generalized_alpha", "kick_drift", "ssp_rk3"):
    for name, (settings, integral) in LOADS.items():
        run_file("body.toml", "body", [f"time.scheme={scheme}", *settings])
        momentum = history("body")["momentum_x"][-1] / FORCE
        # A ramp that a step resolves costs what the scheme makes of it: a part of its own impulse.
        check(f"{scheme}, {name}: impulse, relative", abs(momentum / integral - 1), 1e-4 if name == "a gap of 1e-3" else 2e-6)

# A run that was resumed at a jump goes on with the same bits.
for scheme in ("generalized_alpha", "kick_drift"):
    sets = [f"time.scheme={scheme}", *LOADS["up and down"][0]]
    run_file("body.toml", "whole", sets)
    run_file("body.toml", "halves", [*sets, "time.end=0.5"])
    run_file("body.toml", "halves", sets, ["--resume", "--quiet", "--threads", "1"])
    check_same(f"{scheme}: resumed at a jump", "halves", "whole")

# A load of small amplitude whose period is far below the steps that the indicator would allow.
pathlib.Path("shaken.toml").write_text("""
name = "shaken"
domain = { size = [1.0, 0.5], elements = [16, 8] }
substrate = { thickness = 0.5, young = 1.0, poisson = 0.3 }
boundary = { left = "periodic", right = "periodic", bottom = "clamped", top = "free" }
load = [ { box = [[0.0, 0.0], [1.0, 0.5]], force = [0.01, 0.0], factor = "sin(2*pi*t/0.5)" } ]
time = { end = 20.3 }
output = { fields = { times = [] } }
""")
run_file("shaken.toml", "shaken")
run_file("shaken.toml", "fine", ["time.dt_max=0.005", "time.dt_initial=0.005"])
found, fine = history("shaken"), history("fine")
check_true("the reference has steps of its own", fine["dt"].max() < 0.2 * found["dt"].max(), f"{found['dt'].max():.3g}")
check("largest elastic energy, relative", abs(found["energy_elastic"].max() / fine["energy_elastic"].max() - 1), 0.1)
check("largest kinetic energy, relative", abs(found["energy_kinetic"].max() / fine["energy_kinetic"].max() - 1), 0.1)
times = found["t"]
check_true("sixteen steps in a period or more", numpy.diff(times[times > 0.5]).max() < 0.5 / 16, f"{numpy.diff(times).max():.3g}")
