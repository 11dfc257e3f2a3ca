#!/usr/bin/env python3
"""The solid alone under a horizontal load: height difference of its far sides against linear theory.
usage: solid_layer.py SOFTWET"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "regression"))
import _measure  # noqa: E402
from _measure import compare  # noqa: E402
from _scene import run  # noqa: E402

# Far from the load, which the formula asks for: in the case itself the load is 1.6 thicknesses from the right side, and
# its end effect is 1.8 %.
run("solid_layer_2d", "layer", ["load[0].box=[[0.45,0],[0.55,0.125]]", "load[0].force=[0.016215,0]"])
wall = _measure.interface("layer")
found = wall["displacement_y"][-1] - wall["displacement_y"][0]
compare("height difference", found, 0.45 * 1.45 * 0.016215 * 0.1 * 0.125 / 0.7554, 0.002)
