"""The output folder of a run in three dimensions as arrays: lines of the wall, and profiles of the surface.

Lengths are in units of L0, times in L0/sqrt(ab)."""

import contourpy  # a part of matplotlib
import numpy as np

import softwet
from .look import Problem
from softwet.lattice import evaluate


class Output:
    """An output folder of a 3D run with a substrate."""

    def __init__(self, folder):
        self.run = softwet.open(folder)
        self.case = self.run.case
        self.size = np.array(self.case["domain"]["size"], dtype=float)
        if len(self.size) != 3:
            raise Problem(f"{folder} is a 2D run: tools/plot draws its fields and its history")
        if "substrate" not in self.case:
            raise Problem(f"{folder} is a 3D run without a [substrate]: tools/plot draws its history, "
                          "ParaView its fields")
        self.times = self.run.need_times()
        self.wall = float(self.case["substrate"]["thickness"])
        self.middle = self.middle_density()
        track = np.array(self.case["output"]["history"]["track"], dtype=float)
        self.track = track / np.hypot(*track)

    def middle_density(self):
        """Where droplets end: halfway between the phases in equilibrium."""
        if "fluid" not in self.case:
            return None
        try:
            phases = self.run.record["equilibrium"]
            return 0.5 * (phases["density_vapour"] + phases["density_liquid"])
        except KeyError as error:
            raise Problem(f"{self.run.folder / 'run.json'} has no equilibrium densities ({error!r}); "
                          "resume the run with this version of softwet") from error

    def contact_lines(self, time):
        """Lines of the wall where the droplets end, places (n, 2) in the plane of the wall."""
        if self.middle is None:
            return []
        fluid, lowest = self.run.fields(time, "fluid"), slice(0, 1)
        x, y, _ = np.moveaxis(fluid.read("Points", lowest)[0], -1, 0)
        return contourpy.contour_generator(x, y, fluid.read("density", lowest)[0]).lines(self.middle)

    def carried(self, time, points, magnify=1.0):
        """Where reference points (n, 3) of the solid are at a time, with the vertical displacement magnified."""
        solid = self.run.fields(time, "solid")
        return points + evaluate(solid.moved(), indices(solid.lines[::-1], points)) * [1, 1, magnify]

    def on_wall(self, time, places, magnify=1.0):
        """Points of the deformed surface above places (n, 2)."""
        rest = np.pad(places, ((0, 0), (0, 1)), constant_values=self.wall)
        for _ in range(20):  # the displacement is small and smooth: the error shrinks by its slope each time
            rest[:, :2] += places - self.carried(time, rest)[:, :2]
            rest[:, :2] = np.clip(rest[:, :2], 0, self.size[:2])
        return self.carried(time, rest, magnify)


def indices(lines, places):
    """Fractional indices (n, k) of places (n, k) among the points of k lines; elements may be graded."""
    return np.stack([np.interp(places[:, d], line, np.arange(len(line))) for d, line in enumerate(lines)], axis=-1)


# --- the profile -----------------------------------------------------------------------------------------------------
def track_line(output, count=800):
    """The line along the track through the middle of the domain: distances from the middle, and places (n, 2)."""
    middle = 0.5 * output.size[:2]
    reach = min(middle[d] / abs(output.track[d]) for d in (0, 1) if abs(output.track[d]) > 1e-12)
    s = np.linspace(-reach, reach, count)
    return s, np.clip(middle + s[:, None] * output.track, 0, output.size[:2])


def profile(output, time):
    """Where points of the track's line are now along it, and their vertical displacement."""
    s, places = track_line(output)
    rest = np.pad(places, ((0, 0), (0, 1)), constant_values=output.wall)
    displacement = output.carried(time, rest) - rest
    return s + displacement[:, :2] @ output.track, displacement[:, 2]
