#!/usr/bin/env python3
"""Traction of a droplet at rest on a soft wall (interface.csv): it is in balance with the pressure at the top, with the
stress of the solid (field files), and beside the pressures it is the line force sigma sin(angle).
usage: soft_wall_traction.py SOFTWET"""

import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "regression"))
import _measure  # noqa: E402
from _scene import check, run  # noqa: E402

# Half a droplet: the left side is its plane of symmetry.
GAMMA, LENGTH = 1 / 32, 0.5
run("static_droplet_soft_2d", "out", [
    "domain.size=[0.5,0.5]", "domain.elements=[32,32]", "droplet[0].centre=[0,0.125]", "substrate.young=3",
    f"fluid.capillarity={GAMMA}", "time.end=300", "output.fields.times=300", "solver.newton.rtol=1e-8"])
sigma = GAMMA * _measure.TENSION_OVER_CAPILLARITY
wall, last = _measure.interface("out"), {name: values[-1] for name, values in _measure.history("out").items()}


def integral(values, x):
    """Simpson's rule on each element: exact for quadratic splines of x."""
    return ((x[2::2] - x[:-2:2]) / 6 * (values[:-2:2] + 4 * values[1::2] + values[2::2])).sum()


x = wall["x_reference"]
force = [integral(wall[f"traction_{d}"], x) for d in "xy"]
points, pressure = _measure.fluid_field("out", 0, "pressure")
top = integral(pressure[-1], points[-1, :, 0])
print(f"force on the wall {force[0]:.6f}, {force[1]:.6f}; on the top {top:.6f}; sigma {sigma:.6f}; "
      f"speed {last['speed_max_liquid']:.1e}")
check("the fluid is in balance: vertical forces on wall and top, over sigma", abs(force[1] + top) / sigma, 1e-3)

stress = _measure.field("out", 0, "solid")["first_piola_stress"]
# At the contact line the stress changes within an element or two: its values at points miss that in part.
for name, row, allowed in (("surface", -1, 2e-2), ("bottom", 0, 1e-3)):
    check(f"the solid is in balance: vertical force on the wall and stress at its {name}, over sigma",
          abs(integral(stress[row, :, 1, 1], x) - force[1]) / sigma, allowed)
check("the solid is in balance: horizontal force on the wall and stress at its surface, over sigma",
      abs(integral(stress[-1, :, 0, 1], x) - force[0]) / sigma, 1e-2)

# Inside and outside of the contact line the fluid presses with p on the deformed wall.
line, inside, outside = last["x_right"], -wall["traction_y"][0], -wall["traction_y"][-1]
vertical = force[1] + inside * line + outside * (LENGTH - line)
sine = numpy.sin(numpy.radians(last["angle_right"]))
print(f"line force {vertical:.6f} at x = {line:.4f}, angle {last['angle_right']:.2f}")
check("vertical line force over sigma sin(angle), minus 1", abs(vertical / (sigma * sine) - 1), 0.03)
