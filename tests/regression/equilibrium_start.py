#!/usr/bin/env python3
"""A scene that starts from its equilibrium: it begins with the load, at rest, and then moves as one that has relaxed by
itself; a scene that cannot come to rest is refused with a sentence; how far droplets moved on the way is reported, and
what merged there is not called one from the start; models that leave something out agree with the full one where they
should.
usage: equilibrium_start.py SOFTWET"""

import pathlib

from _scene import check, check_true, history, record, run, run_file

SCENE = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "load[0].ramp=2", "load[0].force=[0.5,0]", "time.end=20",
         "output.fields.times=[]"]
AT_REST = 'time.start="equilibrium"'


def moved(folder, *settings):
    """@return X_c(t) - X_c(0) at the end, columns"""
    run("tensotaxis_pull_2d", folder, [*SCENE, *settings])
    rows = history(folder)
    start = rows["x_centre"][abs(rows["t"]).argmin()]
    return rows["x_centre"][-1] - start, rows


path, _ = moved("relaxed", "load[0].start=30")
quick, rows = moved("at_rest", "load[0].start=30", AT_REST)
check_true("the computation begins with the load", rows["t"][0] == 0)
check("fastest liquid at the start", rows["speed_max_liquid"][0], 1e-5)
check("path against a scene that has relaxed", abs(quick / path - 1), 0.02)
check("drift of the mass", abs(rows["mass_drift"]).max(), 1e-12)
start = record("at_rest")["start"]
check_true("run.json says how it came to rest", start["steps"] > 3 and 0 <= start["rate_of_change"] < 1e-6, str(start))
steps = record("relaxed")["counts"]["steps"], record("at_rest")["counts"]["steps"] + start["steps"]
check_true("fewer steps than the motion takes", steps[1] < 0.7 * steps[0], f"{steps[1]} instead of {steps[0]}")

# The load is slow against elastic waves: inertia of the solid does nothing. Its strain is a few per cent.
quasi_static, _ = moved("quasi_static", "load[0].start=30", AT_REST, 'substrate.inertia="none"')
check("path without inertia of the solid", abs(quasi_static / quick - 1), 0.02)
small, _ = moved("small_strain", "load[0].start=30", AT_REST, 'substrate.strain="small"')
check("path with small strain", abs(small / quick - 1), 0.3)
check_true("small strain is another model", abs(small / quick - 1) > 1e-4)
message = run("tensotaxis_pull_2d", "too_soft", [*SCENE, "load[0].start=1", AT_REST, "substrate.young=0.005"], code=2)
check_true("what does not come to rest says so", "does not come to rest" in message and "time.start" in message, message)

# Two caps side by side, too steep for their contact angle: they spread, and meet while they come to rest.
pathlib.Path("pair.toml").write_text("""
name = "pair"
domain = { size = [0.5, 0.25], elements = [32, 16] }
fluid = { viscosity = "1/256", capillarity = "1/32", temperature = 0.39, contact_angle = 60 }
time = { end = 0.1, start = "equilibrium" }
[[droplet]]
centre = [0.15, 0]
radius = 0.08
stretch = [1, 1.4]
[[droplet]]
centre = [0.34, 0]
radius = 0.08
stretch = [1, 1.4]
""")
message = run_file("pair.toml", "pair", [], ["--overwrite", "--threads", "1"])
events = record("pair")["events"]
check_true("a merger on the way", events[0] == {"t": 0, "what": "droplet 1 and droplet 2 merged (while the scene came to rest)"},
           str(events))
check_true("is reported", message.count("merged (while the scene came to rest)") == 2, message)
check_true("and how far the droplet moved", "; on the way droplet 1 moved by 0." in message, message)
moved = record("pair")["start"]["moved"]
check_true("run.json has the way of each droplet", 0.05 < moved[0] < 0.2 and moved[1] is None, str(moved))
message = run_file("pair.toml", "overlap", ["droplet[1].centre=[0.25,0]"], ["--overwrite", "--threads", "1"])
check_true("droplets that overlap are one from the start", "are one from the start" in message, message)
