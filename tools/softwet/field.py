"""Fields of one part of a scene at one time."""

import numpy as np

from .lattice import evaluate, locate
from .problem import Problem

try:
    import h5py
except ImportError as missing:
    raise Problem(f"{missing}; reading fields needs h5py (Debian: apt-get install python3-h5py)") from missing


class Field:
    """The fluid or the solid at one time, on the points of its file: a lattice of three points per element and axis.

    time, part, path  which it is and where it comes from
    shape             points of the lattice: (ny, nx) or (nz, ny, nx)
    lines             reference coordinates of the points along each axis: [y, x] or [z, y, x]
    field[name]       array of shape (*shape) for a scalar, (*shape, dimension) for a vector, (*shape, 3, 3) for a tensor
    list(field)       names of the fields in the file
    positions         (*shape, dimension): where the points are now
    reference         (*shape, dimension): where they are in the undeformed mesh
    rest, moved       the same, and positions - reference, of some rows of the vertical axis"""

    def __init__(self, path, time, part, elements, low, high):
        """@param elements, low, high  equal elements along each axis, x first, and where they begin and end; the file tells
        the ends of graded ones"""
        self.path, self.time, self.part = path, time, part
        self.dimension = len(elements)
        self._kept = {}
        self.lines = [self._line(axis, *equal) for axis, equal in enumerate(zip(elements, low, high))][::-1]
        self.shape = tuple(map(len, self.lines))

    def _line(self, axis, elements, low, high):
        with self._open() as file:
            ends = file.get(f"element_ends_{'xyz'[axis]}")
            if ends is None:
                return np.linspace(low, high, 2 * elements + 1)
            ends = ends[:]
        line = np.empty(2 * len(ends) - 1)
        line[::2], line[1::2] = ends, 0.5 * (ends[:-1] + ends[1:])
        return line

    def __repr__(self):
        return f"<{self.part} at t = {self.time:g}, {' x '.join(map(str, self.shape))} points>"

    def _open(self):
        try:
            return h5py.File(self.path)
        except OSError as error:
            raise Problem(f"cannot read {self.path}: {error}") from error

    def __iter__(self):
        with self._open() as file:
            return iter(list(file["VTKHDF/PointData"]))

    def __contains__(self, name):
        return name in list(self)

    def __getitem__(self, name):
        if name not in self._kept:
            self._kept[name] = self.read(name)
        return self._kept[name]

    def read(self, name, rows=slice(None)):
        """A field, or "Points", without keeping it. @param rows  of the vertical axis, counted from below"""
        row = int(np.prod(self.shape[1:]))
        first, last, _ = rows.indices(self.shape[0])
        with self._open() as file:
            key = f"VTKHDF/{name}" if name == "Points" else f"VTKHDF/PointData/{name}"
            if key not in file:
                there = ", ".join(file.get("VTKHDF/PointData", ())) or "none"
                raise Problem(f"{self.path} has no field '{name}'; there are: {there}; output.fields.select of the case "
                              "chooses them")
            data = file[key]
            if len(data) != self.shape[0] * row:
                raise Problem(f"{self.path} has {len(data)} points, not the {self.shape[0] * row} of case.toml; "
                              "compute the case again with --overwrite")
            try:
                values = data[first * row:last * row]
            except OSError as error:
                raise Problem(f"cannot read {self.path}: {error}") from error
        if values.ndim == 2 and values.shape[1] == 3:  # the file has a third component in the plane too
            values = values[:, :self.dimension]
        elif values.ndim == 2 and values.shape[1] == 9:
            values = values.reshape(-1, 3, 3)
        return values.reshape(last - first, *self.shape[1:], *values.shape[1:])

    @property
    def positions(self):
        return self["Points"]

    @property
    def reference(self):
        return self.rest()

    def rest(self, rows=slice(None)):
        """The reference positions of some rows of the vertical axis."""
        upwards, *across = self.lines
        return np.stack(np.meshgrid(upwards[rows], *across, indexing="ij")[::-1], axis=-1)

    def moved(self, rows=slice(None)):
        """How far the points of some rows of the vertical axis have moved: in the solid its displacement."""
        return self.read("Points", rows) - self.rest(rows)

    def to_pyvista(self, *names):
        """A pyvista.StructuredGrid of the points where they are now, with the fields (all, or those named). Needs pyvista."""
        try:
            import pyvista
        except ImportError as missing:
            raise Problem(f"{missing}; to_pyvista needs pyvista (pip install pyvista)") from missing
        count = int(np.prod(self.shape))
        points = np.zeros((count, 3))
        points[:, :self.dimension] = self.positions.reshape(count, -1)
        grid = pyvista.StructuredGrid()
        grid.points = points
        grid.dimensions = (*self.shape[::-1], 1, 1)[:3]
        for name in names or self:
            values = self[name]
            values = values.reshape(count, -1)
            flat = np.pad(values, ((0, 0), (0, 1))) if values.shape[1] == 2 else values  # a vector has three components there
            grid.point_data[name] = flat[:, 0] if flat.shape[1] == 1 else flat
        return grid

    def at(self, points):
        """The fields at places of the deformed body. @param points  (..., dimension);  @return Sample"""
        points = np.asarray(points, dtype=float)
        if points.ndim == 0 or points.shape[-1] != self.dimension:
            raise Problem(f"points of shape {points.shape}: the last axis must have the {self.dimension} coordinates")
        flat = points.reshape(-1, self.dimension)
        guess = np.stack([np.interp(flat[:, d], line, np.arange(len(line)))
                          for d, line in enumerate(reversed(self.lines))], axis=-1)
        return Sample(self, points, locate(self.positions, flat, guess))

    def on_grid(self, *counts, box=None):
        """The fields on a uniform grid, nan outside of the deformed body.
        @param counts  points along x, y (and z)
        @param box     (low corner, high corner); without it the box around the body
        @return Sample of shape (ny, nx) or (nz, ny, nx), with the coordinates in .axes = (x, y[, z])"""
        if len(counts) != self.dimension or min(counts) < 2:
            raise Problem(f"on_grid{counts}: give {self.dimension} numbers of points, each 2 or more")
        axes = tuple(range(self.dimension))
        low, high = box or (self.positions.min(axis=axes), self.positions.max(axis=axes))
        lines = [np.linspace(*ends) for ends in zip(low, high, counts)]
        sample = self.at(np.stack(np.meshgrid(*lines[::-1], indexing="ij")[::-1], axis=-1))
        sample.axes = tuple(lines)
        return sample


class Sample:
    """Fields at chosen points: sample[name] is an array of the shape of the points, nan outside of the body.

    positions  the points;  axes  of a grid: its coordinates;  inside  whether each point is in the body"""

    def __init__(self, field, positions, index):
        self.field, self.positions, self.axes, self._index = field, positions, None, index
        self.inside = ~np.isnan(index).any(axis=-1).reshape(positions.shape[:-1])

    def __getitem__(self, name):
        lattice, inside = self.field[name], self.inside.ravel()
        values = np.full((len(inside), *lattice.shape[self.field.dimension:]), np.nan)
        values[inside] = evaluate(lattice, self._index[inside])
        return values.reshape((*self.positions.shape[:-1], *values.shape[1:]))
