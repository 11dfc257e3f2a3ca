"""The output folder of a run in three dimensions as arrays: fields on lattices, level sets, profiles of the surface.

A lattice has three points per element and axis, or finer; splines of degree 2 are quadratic between the three. Lengths
are in units of L0, times in L0/sqrt(ab).
"""

import numpy as np

import softwet
from .look import Problem
from softwet.lattice import evaluate, quadratic


# --- reading ---------------------------------------------------------------------------------------------------------
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
        self.fine = max(2, -(-160 // max(self.case["domain"]["elements"])))  # intervals of an element in a picture
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

    def positions(self, part, time, magnify, rows=slice(None)):
        """Positions with the vertical displacement magnified, `fine` intervals per element."""
        field = self.run.fields(time, part)
        return refine(field.rest(rows) + field.moved(rows) * [1, 1, magnify], self.fine)

    def lines(self, part, time, rows=slice(None)):
        """Reference coordinates along z, y and x of the same points."""
        upwards, *across = self.run.fields(time, part).lines
        return [refine(line, self.fine, axes=1) for line in (upwards[rows], *across)]


def refine(values, intervals, axes=3):
    """A lattice [z][y][x](...) of three points per element and axis with so many intervals per element."""
    for axis in range(axes) if intervals != 2 else ():
        points = values.shape[axis]
        low, weight, _ = quadratic(points, np.linspace(0, points - 1, (points - 1) // 2 * intervals + 1))
        shape = [-1 if d == axis else 1 for d in range(values.ndim)]
        values = sum(weight[:, a].reshape(shape) * values.take(low + a, axis) for a in range(3))
    return values


# --- lattices --------------------------------------------------------------------------------------------------------
def on_lattice(values, index):
    """Values [y][x](...) at fractional indices (n, 2) = (x, y), bilinear."""
    low = np.clip(np.floor(index).astype(int), 0, [values.shape[1] - 2, values.shape[0] - 2])
    i, j = low.T
    s, t = ((index - low).T).reshape(2, -1, *(1,) * (values.ndim - 2))
    return ((1 - s) * (1 - t) * values[j, i] + s * (1 - t) * values[j, i + 1] + (1 - s) * t * values[j + 1, i]
            + s * t * values[j + 1, i + 1])


def indices(lines, places):
    """Fractional indices (n, k) of places (n, k) among the points of k lines; elements may be graded."""
    return np.stack([np.interp(places[:, d], line, np.arange(len(line))) for d, line in enumerate(lines)], axis=-1)


# The six tetrahedra of a cell around its diagonal from corner 0 to corner 7; corner = x + 2 y + 4 z.
TETRAHEDRA = np.array([[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]])


def level_set(field, level, *carried):
    """Triangles of {field = level} on a lattice [z][y][x]: arrays (n, 3, k) of each carried lattice [z][y][x][k]."""
    above = field >= level
    count = sum(above[z:z - 1 or None, y:y - 1 or None, x:x - 1 or None].astype(np.int8)
                for z in (0, 1) for y in (0, 1) for x in (0, 1))
    k, j, i = np.nonzero((count > 0) & (count < 8))
    _, ny, nx = field.shape
    corner = np.stack([((k + (c >> 2)) * ny + j + (c >> 1 & 1)) * nx + i + (c & 1) for c in range(8)], axis=1)
    four = corner[:, TETRAHEDRA].reshape(-1, 4)
    value = field.ravel()[four] - level
    # Corners above the level first, so that a tetrahedron is cut in one of three ways.
    order = np.argsort(-value, axis=1)
    four, value = np.take_along_axis(four, order, axis=1), np.take_along_axis(value, order, axis=1)
    inside = (value >= 0).sum(axis=1)
    edges = []
    for number, triangles in ((1, [((0, 1), (0, 2), (0, 3))]), (3, [((0, 3), (1, 3), (2, 3))]),
                              (2, [((0, 2), (0, 3), (1, 2)), ((0, 3), (1, 3), (1, 2))])):
        here = inside == number
        for triangle in triangles:
            edges.append(np.stack([four[here][:, edge] for edge in triangle], axis=1))
    ends = np.concatenate(edges)  # (n, 3, 2): the lattice points of the cut edges
    a, b = np.moveaxis(field.ravel()[ends] - level, 2, 0)
    share = (a / np.where(a == b, 1, a - b))[..., None]
    surfaces = []
    for lattice in carried:
        flat = lattice.reshape(-1, lattice.shape[-1])
        surfaces.append(flat[ends[..., 0]] * (1 - share) + flat[ends[..., 1]] * share)
    return surfaces


def quads(points):
    """The cells of a lattice (m, n, k) as corners (cells, 4, k)."""
    cells = np.stack([points[:-1, :-1], points[:-1, 1:], points[1:, 1:], points[1:, :-1]], axis=2)
    return cells.reshape(-1, 4, points.shape[-1])


def box_edges(low, high):
    corners = [np.where([c & 1, c & 2, c & 4], high, low) for c in range(8)]
    return [(corners[a], corners[a | bit]) for a in range(8) for bit in (1, 2, 4) if not a & bit]


# --- the profile -----------------------------------------------------------------------------------------------------
def track_line(output, count=800):
    """The line along the track through the middle of the domain: distances from the middle, and places (n, 2)."""
    middle = 0.5 * output.size[:2]
    reach = min(middle[d] / abs(output.track[d]) for d in (0, 1) if abs(output.track[d]) > 1e-12)
    s = np.linspace(-reach, reach, count)
    return s, np.clip(middle + s[:, None] * output.track, 0, output.size[:2])


def profile(output, time):
    """Where points of the track's line are now along it, and their vertical displacement."""
    solid = output.run.fields(time, "solid")
    _, *across = solid.lines
    s, places = track_line(output)
    displacement = evaluate(solid.moved(slice(-1, None))[0], indices(across[::-1], places))
    return s + displacement[:, :2] @ output.track, displacement[:, 2]
