"""Walls, densities and interfaces of two runs at the same places, whatever their meshes."""

import numpy as np

from softwet.lattice import evaluate

PLANE, SPACE = (193, 97), (49, 49, 33)  # points of the common lattice along x, (y,) and the vertical
ALONG = {2: (401,), 3: (101, 101)}  # points of the common wall


def sample_wall(run, time):
    """Displacement (n, D) of the wall at a field time, on uniform points of the undeformed wall."""
    rows = run.interface[time]
    lines = [np.unique(rows[f"{axis}_reference"]) for axis in "xy"[:run.dimension - 1]]
    names = [f"displacement_{axis}" for axis in "xyz"[:run.dimension]]
    lattice = np.stack([rows[name] for name in names], axis=-1).reshape(*map(len, reversed(lines)), run.dimension)
    places = [np.interp(np.linspace(line[0], line[-1], n), line, np.arange(len(line)))
              for line, n in zip(lines, ALONG[run.dimension])]
    return evaluate(lattice, np.stack(np.meshgrid(*places, indexing="ij"), axis=-1).reshape(-1, len(places)))


def grid_of(reference, time):
    """(points, density) of the reference on a uniform grid over its fluid at a field time; nan outside of its deformed
    body. Kept with the run."""
    kept = reference.__dict__.setdefault("_tradeoff_grids", {})
    if time not in kept:
        sample = reference.fields(time).on_grid(*(PLANE if reference.dimension == 2 else SPACE))
        kept[time] = sample.positions, sample["density"]
    return kept[time]


def densities(run, reference, time):
    """(points, density of the run, density of the reference) on the grid of the reference. Kept with the run."""
    points, theirs = grid_of(reference, time)
    kept = run.__dict__.setdefault("_tradeoff_densities", {})
    if time not in kept:
        kept[time] = run.fields(time).at(points)["density"]
    return points, kept[time], theirs


def contour(points, values, level):
    """Places (n, D) where lines of the grid cross values = level, and the unit normals there. Between two points of
    the grid the values are taken as linear.
    @param points  (..., D) of a uniform grid, x first in its last axis and last in its shape"""
    dimension = points.shape[-1]
    steps = [points[(1,) * dimension][d] - points[(0,) * dimension][d] for d in range(dimension)]
    slope = np.stack([np.gradient(values, step, axis=dimension - 1 - d) for d, step in enumerate(steps)], axis=-1)
    places, normals = [], []
    for axis in range(dimension):
        low, high = (tuple(piece if d == axis else slice(None) for d in range(dimension))
                     for piece in (slice(None, -1), slice(1, None)))
        a, b = values[low], values[high]
        crossed = (a - level) * (b - level) < 0  # nan is none
        part = ((level - a[crossed]) / (b[crossed] - a[crossed]))[:, None]
        places.append(points[low][crossed] * (1 - part) + points[high][crossed] * part)
        normals.append(slope[low][crossed] * (1 - part) + slope[high][crossed] * part)
    places, normals = np.concatenate(places), np.concatenate(normals)
    good = np.isfinite(normals).all(axis=-1)
    return places[good], normals[good] / np.linalg.norm(normals[good], axis=-1, keepdims=True)
