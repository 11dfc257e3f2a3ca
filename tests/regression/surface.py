#!/usr/bin/env python3
"""Droplets on a wall that is a surface: columns, symmetry, a track of choice, resume. usage: surface.py SOFTWET"""

import numpy
from _scene import TIGHT, check, check_true, history, run_file, write_box

# Two droplets of one size on the diagonal of a small box with a rigid wall, on a coarse mesh.
write_box("pair", height=0.2, elements=[16, 16, 4], capillarity=0.08, angle=90.0, tables="""
[[droplet]]
centre = [0.22, 0.22, 0.0]
radius = 0.16
[[droplet]]
centre = [0.58, 0.58, 0.0]
radius = 0.16
[time]
end = 0.2
[output]
history = { track = [1, 1] }
""")

run_file("pair.toml", "whole", TIGHT + ["time.max_steps=6"])
run_file("pair.toml", "parts", TIGHT + ["time.max_steps=3"])
run_file("pair.toml", "parts", TIGHT + ["time.max_steps=6"], ["--resume", "--quiet", "--threads", "1"])
whole, parts = history("whole"), history("parts")
for name in ("contact_area", "x_centre", "y_centre", "track_rear", "track_front"):
    for suffix in ("", "_2"):
        a, b = whole[name + suffix], parts[name + suffix]
        check_true(f"{name}{suffix} is there in every row", numpy.isfinite(a).all())
        check(f"{name}{suffix} resumed", numpy.abs(a - b).max(), 1e-9)
check_true("velocities from the second row on, also behind the gap",
           numpy.isnan(whole["velocity"][0]) and numpy.isfinite(parts["velocity"][1:]).all())
check("velocity resumed", numpy.abs(whole["velocity"] - parts["velocity"])[1:].max(), 1e-6)

a = 0.16
check("area of the first row, a disc, relative", abs(whole["contact_area"][0] / (numpy.pi * a * a) - 1), 0.05)
check("each droplet is symmetric about the track", numpy.abs(whole["x_centre"] - whole["y_centre"]).max(), 1e-9)
check("the pair is symmetric about the middle", numpy.abs(whole["track_front"] + whole["track_rear_2"]).max(), 1e-9)
check("velocity is the centroid's along the track",
      numpy.abs(numpy.diff(whole["x_centre"]) * 2 ** 0.5 / numpy.diff(whole["t"]) - whole["velocity"][1:]).max(), 1e-9)

run_file("pair.toml", "across", TIGHT + ["time.max_steps=1", "output.history.track=[1, -1]"])
across = history("across")
check("across the track both droplets lie in the middle", abs(across["track_front"][0] + across["track_rear"][0]), 1e-9)
