"""The wall under the droplet of Style et al. 2013, from output folders of style_2013_axisymmetric, in micrometres: a table and
a picture, for docs/axisymmetric.md.    usage: docs/style_2013.py PICTURE OUT... """

import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tools"))
import matplotlib.pyplot as plt  # noqa: E402

import softwet  # noqa: E402
from softwet._drawing.look import BLUE, GREEN, RED, STYLE  # noqa: E402

MICROMETRES = 500.0  # a length of 1


def wall_of(folder):
    """Width of the interface g, contact radius, place of the wall and its height."""
    run = softwet.open(folder)
    wall = run.interface[run.times[-1]]
    place = (wall["x_reference"] + wall["displacement_x"]) * MICROMETRES
    return (run.case["fluid"]["capillarity"] * MICROMETRES, run.history["x_right"][-1] * MICROMETRES, place,
            wall["displacement_y"] * MICROMETRES, run.history["angle_right"][-1])


plt.rcParams.update(STYLE)
figure, (whole, near) = plt.subplots(1, 2, figsize=(8, 2.8), layout="constrained")
print("| g | ridge | middle of the droplet | lowest below it | outside | contact radius | opening | apparent angle |\n" + "|---" * 8 + "|")
for folder, colour in zip(sys.argv[2:], (GREEN, BLUE, RED)):
    g, contact, place, height, angle = wall_of(folder)
    slopes = (height[1:] - height[:-1]) / (place[1:] - place[:-1])
    opening = 180 - math.degrees(math.atan(slopes.max()) - math.atan(slopes.min()))
    print(f"| {g:g} | {height.max():.2f} | {height[0]:.2f} | {height.min():.2f} | {height[place > contact + 15].min():.2f} | {contact:.1f} | "
          f"{opening:.0f} degrees | {angle:.1f} |")
    whole.plot(place, height, color=colour, label=f"g = {g:g} µm")
    near.plot(place - contact, height, color=colour)
near.set_xlim(-25, 25)
near.set_aspect("equal")
whole.set(xlabel="distance from the axis / µm", ylabel="height of the wall / µm")
near.set(xlabel="distance from the contact line / µm", title="to scale")
whole.legend(frameon=False)
figure.savefig(sys.argv[1], dpi=90)
