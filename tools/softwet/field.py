"""Fields of one part of a scene at one time."""

import copy

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
    lines             reference coordinates of the points along each axis: [y, x] or [z, y, x] field[name]       array
    of shape (*shape) for a scalar, (*shape, dimension) for a vector, (*shape, 3, 3) for a tensor
    sides             [field]; where the solid has a joint two such fields, of the points below and above it. Strains
    and
                      stresses may jump there, and field[name] has the values from above
    list(field)       names of the fields in the file
    positions         (*shape, dimension): where the points are now
    reference         (*shape, dimension): where they are in the undeformed mesh
    rest, moved       the same, and positions - reference, of some rows of the vertical axis"""

    def __init__(self, path, time, part, elements, low, high):
        """@param elements, low, high  equal elements along each axis, x first, and where they begin and end; the file
        gives the ends of graded ones"""
        self.path, self.time, self.part = path, time, part
        self.dimension = len(elements)
        self.lines = [self._line(axis, *equal) for axis, equal in enumerate(zip(elements, low, high))][::-1]
        self._divide()

    def _divide(self):
        """Which rows of points of the file belong to the lattice: the file has the rows of a joint twice, from below
        and above."""
        with self._open() as file:
            joint = 2 * int(file.attrs.get("rows_below_joint", [0])[0])
        upwards, *across = self.lines
        rows = np.arange(len(upwards) + (joint > 0))
        self._points = len(rows)
        self._take(self.lines, np.delete(rows, joint) if joint else rows)
        if joint:
            self._halves = copy.copy(self), copy.copy(self)
            self._halves[0]._take([upwards[:joint + 1], *across], rows[:joint + 1])
            self._halves[1]._take([upwards[joint:], *across], rows[joint + 1:])

    def _take(self, lines, rows):
        self.lines, self._rows, self.shape = lines, rows, tuple(map(len, lines))
        self._halves, self._kept = (), {}

    @property
    def sides(self):
        return list(self._halves) or [self]

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
        chosen = self._rows[rows]
        first, last = (chosen[0], chosen[-1] + 1) if len(chosen) else (0, 0)
        with self._open() as file:
            key = f"VTKHDF/{name}" if name == "Points" else f"VTKHDF/PointData/{name}"
            if key not in file:
                there = ", ".join(file.get("VTKHDF/PointData", ())) or "none"
                raise Problem(f"{self.path} has no field '{name}'; there are: {there}; output.fields.select of the case "
                              "chooses them")
            data = file[key]
            if len(data) != self._points * row:
                raise Problem(f"{self.path} has {len(data)} points, not the {self._points * row} of case.toml; "
                              "compute the case again with --overwrite")
            try:
                values = data[first * row:last * row]
            except OSError as error:
                raise Problem(f"cannot read {self.path}: {error}") from error
        if values.ndim == 2 and values.shape[1] == 3:  # the file has a third component in 2D too
            values = values[:, :self.dimension]
        elif values.ndim == 2 and values.shape[1] == 9:
            values = values.reshape(-1, 3, 3)
        values = values.reshape(last - first, *self.shape[1:], *values.shape[1:])
        return values if len(chosen) == len(values) else values[chosen - first]

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
        """A pyvista.StructuredGrid of the points where they are now, with the fields (all, or those named). Those of a
        joint are there twice, with the values of both sides. Needs pyvista."""
        try:
            import pyvista
        except ImportError as missing:
            raise Problem(f"{missing}; to_pyvista needs pyvista (pip install pyvista)") from missing
        upwards, *across = self.shape
        shape = (upwards + len(self.sides) - 1, *across)
        count = int(np.prod(shape))
        points = np.zeros((count, 3))
        points[:, :self.dimension] = self._of_both_sides("Points").reshape(count, -1)
        grid = pyvista.StructuredGrid()
        grid.points = points
        grid.dimensions = (*shape[::-1], 1, 1)[:3]
        for name in names or self:
            values = self._of_both_sides(name)
            values = values.reshape(count, -1)
            flat = np.pad(values, ((0, 0), (0, 1))) if values.shape[1] == 2 else values  # a vector has three components there
            grid.point_data[name] = flat[:, 0] if flat.shape[1] == 1 else flat
        return grid

    def _of_both_sides(self, name):
        return np.concatenate([side[name] for side in self.sides])

    def at(self, points):
        """The fields at places of the deformed body, at a joint those from above. @param points  (..., dimension);
        @return Sample"""
        points = np.asarray(points, dtype=float)
        if points.ndim == 0 or points.shape[-1] != self.dimension:
            raise Problem(f"points of shape {points.shape}: the last axis must have the {self.dimension} coordinates")
        flat = points.reshape(-1, self.dimension)
        found, indices = np.zeros(len(flat), dtype=bool), []
        for side in reversed(self.sides):
            index = np.full(flat.shape, np.nan)
            index[~found] = side._locate(flat[~found])
            found |= ~np.isnan(index).any(axis=-1)
            indices.append((side, index))
        return Sample(self, points, indices)

    def _locate(self, flat):
        guess = np.stack([np.interp(flat[:, d], line, np.arange(len(line)))
                          for d, line in enumerate(reversed(self.lines))], axis=-1)
        return locate(self.positions, flat, guess)

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

    def __init__(self, field, positions, indices):
        """@param indices  of the points in the lattice of each side of the field, nan where they are not in it"""
        self.field, self.positions, self.axes, self._indices = field, positions, None, indices
        self.inside = sum(self._within(index) for _, index in indices).astype(bool).reshape(positions.shape[:-1])

    @staticmethod
    def _within(index):
        return ~np.isnan(index).any(axis=-1)

    def __getitem__(self, name):
        values = None
        for side, index in self._indices:
            lattice, within = side[name], self._within(index)
            if values is None:
                values = np.full((len(index), *lattice.shape[self.field.dimension:]), np.nan)
            values[within] = evaluate(lattice, index[within])
        return values.reshape((*self.positions.shape[:-1], *values.shape[1:]))
