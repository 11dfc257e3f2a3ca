"""Interpolation on lattices of three points per element and axis, quadratic over each three as splines of degree 2 are.

A lattice is an array [z][y][x](...) or [y][x](...); an index counts its points, x first, and may be a fraction."""

import itertools

import numpy as np


def quadratic(points, at):
    """Weights on a line of `points` points at the places `at`, counted in intervals.
    @return first of the three points (n), weights (n, 3), their slopes per interval (n, 3)"""
    low = 2 * np.clip(np.floor(at / 2).astype(int), 0, (points - 1) // 2 - 1)
    s = at - low
    weight = np.stack([0.5 * (s - 1) * (s - 2), s * (2 - s), 0.5 * s * (s - 1)], axis=-1)
    slope = np.stack([s - 1.5, 2 - 2 * s, s - 0.5], axis=-1)
    return low, weight, slope


def evaluate(lattice, index, slope_of=None):
    """Values (n, ...) of the lattice at indices (n, D).
    @param slope_of  an axis (0: x): the slope per interval along it instead of the value"""
    dimension = index.shape[-1]
    shape = lattice.shape[dimension - 1::-1]  # x first
    lines = [quadratic(shape[d], index[:, d]) for d in range(dimension)]
    result = 0.0
    for corner in itertools.product(range(3), repeat=dimension):
        weight = 1.0
        for d, (_, value, slope) in enumerate(lines):
            weight = weight * (slope if d == slope_of else value)[:, corner[d]]
        place = tuple(lines[d][0] + corner[d] for d in reversed(range(dimension)))
        values = lattice[place]
        result = result + weight.reshape(-1, *(1,) * (values.ndim - 1)) * values
    return result


def solve(matrices, right):
    """Solutions (n, D) of n small systems; the shortest ones where a matrix is singular."""
    try:
        return np.linalg.solve(matrices, right[..., None])[..., 0]
    except np.linalg.LinAlgError:
        return np.einsum("nij,nj->ni", np.linalg.pinv(matrices), right)


def newton(positions, points, index):
    """Indices (n, D) where the lattice of positions has the points (n, D); nan where the iteration finds none
    inside."""
    top = np.array(positions.shape[-2::-1]) - 1.0
    index, done = index.copy(), np.zeros(len(index), dtype=bool)
    for _ in range(40):
        active = np.nonzero(~done)[0]
        if not len(active):
            break
        here = index[active]
        rest = points[active] - evaluate(positions, here)
        slope = np.stack([evaluate(positions, here, d) for d in range(len(top))], axis=-1)
        step = np.clip(solve(slope, rest), -4, 4)
        index[active] = np.clip(here + step, -1, top + 1)
        done[active] = np.abs(step).max(axis=-1) < 1e-9
    inside = done & ((index >= -1e-6) & (index <= top + 1e-6)).all(axis=-1)
    return np.where(inside[:, None], np.clip(index, 0, top), np.nan)


def nearest_corner(positions, points):
    """Index of the corner of an element that is nearest to each point."""
    dimension = points.shape[-1]
    corners = positions[(slice(None, None, 2),) * dimension]
    flat = corners.reshape(-1, dimension)
    size = max(1, 4_000_000 // len(flat))
    found = np.concatenate([((points[i:i + size, None] - flat) ** 2).sum(axis=-1).argmin(axis=-1)
                            for i in range(0, len(points), size)])
    return 2.0 * np.stack(np.unravel_index(found, corners.shape[:-1])[::-1], axis=-1)


def locate(positions, points, guess):
    """Indices (n, D) of the points (n, D) in a lattice of positions [..](D); nan for points outside of it.
    @param guess  indices to begin with"""
    axes = tuple(range(positions.ndim - 1))
    low, high = positions.min(axis=axes), positions.max(axis=axes)
    margin = 1e-9 * (high - low)
    near = ((points >= low - margin) & (points <= high + margin)).all(axis=-1)
    index = np.full(points.shape, np.nan)
    index[near] = newton(positions, points[near], guess[near])
    lost = near & np.isnan(index).any(axis=-1)  # far from the guess, or outside of a bent shape
    if lost.any():
        index[lost] = newton(positions, points[lost], nearest_corner(positions, points[lost]))
    return index
