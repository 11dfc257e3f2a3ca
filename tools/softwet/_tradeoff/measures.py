"""How far a run is from a reference: the measures of `softwet tradeoff`.

Each measure is a function of two runs (softwet.Run), the run and the reference, and gives one number, or nan where the
scene has no such thing. Its docstring is what the results say about it. Series are compared for
t >= 0, the start of the load, up to the earlier of the two ends, at the times of the run's own rows: there the
reference, which has shorter steps, is interpolated. [0, T] below is this interval."""

import numpy as np

from .shapes import contour, densities, sample_wall
from softwet import Problem

STILL = 1e-9  # a droplet that moves less, over the width of the domain, does not move but for rounding


def interpolate(at, x, y):
    """Values at places `at` of a curve through (x, y): cubic, with the slopes of parabolas through three neighbours."""
    if len(x) < 3:
        return np.interp(at, x, y)
    h, rise = np.diff(x), np.diff(y) / np.diff(x)
    inner = (h[1:] * rise[:-1] + h[:-1] * rise[1:]) / (h[1:] + h[:-1])
    slope = np.concatenate([[2 * rise[0] - inner[0]], inner, [2 * rise[-1] - inner[-1]]])
    i = np.clip(np.searchsorted(x, at) - 1, 0, len(x) - 2)
    s, step = (at - x[i]) / h[i], h[i]
    return (y[i] * (1 + 2 * s) * (1 - s) ** 2 + y[i + 1] * s ** 2 * (3 - 2 * s)
            + step * (slope[i] * s * (1 - s) ** 2 - slope[i + 1] * s ** 2 * (1 - s)))


def series(run, name):
    """(t, values) of a column of history.csv for t >= 0, with a value at 0 where the run begins before; None where
    there are fewer than four values."""
    if name not in run.history:
        return None
    t, values = run.history["t"], run.history[name]
    good = np.isfinite(values)
    t, values = t[good], values[good]
    if (t >= 0).sum() < 4:
        return None
    if t[0] < 0 and not (t == 0).any():
        at = np.searchsorted(t, 0)
        t, values = np.insert(t, at, 0.0), np.insert(values, at, interpolate(np.zeros(1), t, values)[0])
    return t[t >= 0], values[t >= 0]


def pair(run, reference, name):
    """(t, values of the run, values of the reference at the same times) of a column; None where one has none."""
    mine, theirs = series(run, name), series(reference, name)
    if mine is None or theirs is None:
        return None
    (t, values), (x, y) = mine, theirs
    shared = (t >= x[0]) & (t <= x[-1])
    return (t[shared], values[shared], interpolate(t[shared], x, y)) if shared.sum() >= 2 else None


def change_error(run, reference, name):
    """max |dv - dv_ref| / (max dv_ref - min dv_ref), where dv = v(t) - v(0); nan where nothing changes."""
    found = pair(run, reference, name)
    if found is None:
        return np.nan
    _, mine, theirs = found
    whole = series(reference, name)[1]
    span = whole.max() - whole.min()
    return np.abs((mine - mine[0]) - (theirs - theirs[0])).max() / span if span > 0 else np.nan


def moves(reference):
    """How far the droplet goes along x, with its sign; 0 where there is no droplet or where it stays."""
    found = series(reference, "x_centre")
    if found is None:
        return 0.0
    x = found[1]
    span = np.ptp(x)
    return np.copysign(span, x[-1] - x[0]) if span > STILL * reference.case["domain"]["size"][0] else 0.0


def path(run, reference):
    """Path of the droplet: max |dX - dX_ref| over [0, T] with dX = X_c(t) - X_c(0), divided by the range of X_c,ref;
    in %."""
    return 100 * change_error(run, reference, "x_centre") if moves(reference) else np.nan


def peak(run, reference):
    """Peak speed: |max |V| - max |V_ref|| / max |V_ref| over t >= 0, V being the column velocity; in %."""
    mine, theirs = series(run, "velocity"), series(reference, "velocity")
    if mine is None or theirs is None or not moves(reference):
        return np.nan
    top = np.abs(theirs[1]).max()
    return 100 * abs(np.abs(mine[1]).max() - top) / top


def angle(run, reference, front):
    """Root mean square over [0, T] of the difference of one apparent contact angle."""
    side = ("right", "left") if (moves(reference) >= 0) == front else ("left", "right")
    names = (f"angle_{side[0]}", "angle_front" if front else "angle_rear")  # in 2D, in 3D
    found = next(filter(None, (pair(run, reference, name) for name in names)), None)
    if found is None:
        return np.nan
    t, mine, theirs = found
    squares = (mine - theirs) ** 2
    return float(np.sqrt(((squares[1:] + squares[:-1]) / 2 * np.diff(t)).sum() / (t[-1] - t[0])))


def advancing(run, reference):
    """Advancing contact angle: root mean square over [0, T] of its difference; in degrees. It is the
    right one where X_c,ref grows or rests."""
    return angle(run, reference, True)


def receding(run, reference):
    """Receding contact angle: root mean square over [0, T] of its difference; in degrees. It is the other one."""
    return angle(run, reference, False)


def energy(run, reference):
    """Energy: max |dE - dE_ref| over [0, T] with dE = energy_total(t) - energy_total(0), divided by the range of E_ref;
    in %."""
    return 100 * change_error(run, reference, "energy_total")


def drift(run, reference):
    """Mass drift of the run itself: max |mass_drift| over all rows; a number, not compared with the reference."""
    values = run.history.get("mass_drift", np.array([]))
    values = values[np.isfinite(values)]
    return float(np.abs(values).max()) if len(values) else np.nan


def wall(run, reference):
    """Wall profile: L2 norm of u - u_ref along the undeformed wall, divided by the largest L2 norm of u_ref; in %,
    worst field time."""
    try:
        times = [t for t in run.interface if any(abs(t - s) < 1e-6 * max(1, abs(s)) for s in reference.interface)]
    except Problem:
        return np.nan
    theirs = [sample_wall(reference, t) for t in times]
    scale = max((np.sqrt((u ** 2).sum(axis=-1).mean()) for u in theirs), default=0)
    if not scale:
        return np.nan
    return 100 * max(np.sqrt(((sample_wall(run, t) - u) ** 2).sum(axis=-1).mean()) for t, u in zip(times, theirs)) / scale


def common_times(run, reference):
    """Field times that both have; none without a fluid."""
    if "fluid" not in reference.parts:
        return []
    return [t for t in run.times if any(abs(t - s) < 1e-6 * max(1, abs(s)) for s in reference.times)]


def density(run, reference):
    """Density: L2 norm of rho - rho_ref over the fluid, divided by the norm of rho_ref; in %, worst field time."""
    errors = []
    for t in common_times(run, reference):
        _, mine, theirs = densities(run, reference, t)
        both = np.isfinite(mine) & np.isfinite(theirs)
        errors.append(np.sqrt(((mine - theirs)[both] ** 2).sum() / (theirs[both] ** 2).sum()))
    return 100 * max(errors, default=np.nan)


def interface(run, reference):
    """Interface: mean distance, along the normals of the reference, of the surface where rho = (rho_l + rho_v)/2;
    in L0, worst field time."""
    errors = []
    for t in common_times(run, reference):
        points, mine, theirs = densities(run, reference, t)
        level = sum(reference.record["equilibrium"][f"density_{phase}"] for phase in ("liquid", "vapour")) / 2
        places, normals = contour(points, theirs, level)
        others, _ = contour(points, mine, level)
        if not len(places) or not len(others):
            continue
        nearest = np.array([((others - place) ** 2).sum(axis=-1).argmin() for place in places])
        errors.append(np.abs(((others[nearest] - places) * normals).sum(axis=-1)).mean())
    return max(errors, default=np.nan)


MEASURES = {"path": path, "peak": peak, "advancing": advancing, "receding": receding, "wall": wall, "density": density,
            "interface": interface, "energy": energy, "drift": drift}
UNITS = {"path": "%", "peak": "%", "advancing": "deg", "receding": "deg", "wall": "%", "density": "%", "interface": "L0",
         "energy": "%", "drift": ""}
OWN = {"drift"}  # measures of the run alone


def about(name):
    """What the results say about a measure."""
    return " ".join(MEASURES[name].__doc__.split())


def measure(run, reference):
    """{measure: number} of the measures that the two runs have; one whose files are missing or cannot be read is left
    out."""
    values = {}
    for name, function in MEASURES.items():
        try:
            values[name] = float(function(run, reference))
        except Problem:
            continue
    return {name: value for name, value in values.items() if not np.isnan(value)}
