"""The numbers of a run or a state of rest that are followed to zero width.

A column is `ridge`, `centre` or `angle`, or a column of history.csv. Behind @ stands where it is read: a time in the
units of the case, `max` or `min` over t >= 0; without it the last row counts. Values come in the units of the case that
was given, whatever the units of the narrower interface are."""

import difflib
import math

import numpy as np

from .._tools.messages import fail
from .._tradeoff.measures import interpolate
from softwet import columns
from softwet.units import OF_THE_CASE, chosen_units
from .keys import power_of_a

OWN = {"ridge": "L0", "centre": "L0", "angle": "degrees"}  # and their units
MOTION = ("velocity", "x_centre", "x_left", "x_right", "y_centre")
LIKE = {"ridge": "dimple", "centre": "dimple", "angle": "angle_right"}  # columns of history.csv with the same units
AT_REST, IN_MOTION = ["ridge", "centre", "angle"], ["ridge", "angle", "x_centre", "velocity@max"]


class Column:
    """One column of --columns. name, place  what stands before and behind the @;  asked  of --units
    units  of its values, which are known with the first run"""

    def __init__(self, text, at_rest, asked=None):
        self.text, self.at_rest, self.asked, self.units = text, at_rest, asked, OF_THE_CASE
        self.name, at, self.place = text.partition("@")
        if at and self.place not in ("max", "min"):
            self.place = time_of(text, self.place)
        if at and at_rest:
            fail(f"--columns {text}: a state of rest has one row; give --run to compute the motion, or {self.name} alone")
        if self.name not in OWN and self.name not in columns() and self.name not in probe_like(self.name):
            near = difflib.get_close_matches(self.name, [*OWN, *columns()], 1, 0)[0]
            fail(f"--columns {text}: there is no column '{self.name}'; did you mean '{near}'?")

    @property
    def shown(self):
        """The unit of its values."""
        return self.units.of(LIKE.get(self.name, self.name))[0] or self.unit

    @property
    def unit(self):
        return OWN.get(self.name) or columns()[self.name].unit

    @property
    def moves(self):
        """Whether it follows the motion of a contact line."""
        return not self.at_rest and self.name in MOTION and self.place != 0

    def value(self, run, ratio):
        """@param ratio  the width of the run over the width of the case
        @return  the number in units of the laboratory, or else of the case at the width that it gives; nan where the
        run has none, as a droplet that is lower than its interface is wide has no angle"""
        series = SERIES.get(self.name, history_column)(run, self.name)
        if series is None or not np.isfinite(series[1]).any():
            return math.nan
        self.units = chosen_units(run.folder, self.asked)
        if self.units.named:  # each width has its own scales
            return self.read(*series, ratio) * self.units.of(LIKE.get(self.name, self.name))[1]
        return self.read(*series, ratio) * ratio ** -power_of_a(self.unit)

    def read(self, times, values, ratio):
        good = np.isfinite(values)
        times, values = times[good], values[good]
        if self.place == "":
            return float(values[-1])
        if isinstance(self.place, str):
            chosen = values[times >= 0]
            return float(getattr(np, self.place)(chosen)) if len(chosen) else math.nan
        at = self.place * ratio ** -0.5
        if not times[0] <= at <= times[-1] * (1 + 1e-9):
            fail(f"--columns {self.text}: the run lasts from {times[0] * ratio ** 0.5:g} to {times[-1] * ratio ** 0.5:g} in units of "
                 "the case; give a time in between")
        return float(interpolate(np.array([min(at, times[-1])]), times, values)[0])


def time_of(text, place):
    try:
        return float(place)
    except ValueError:
        fail(f"--columns {text}: behind @ stands a time, max or min, for example {text.partition('@')[0]}@300")


def probe_like(name):
    """Further droplets have the columns of the first one with a number."""
    first, _, number = name.rpartition("_")
    return [name] if number.isdigit() and first in columns() else []


def history_column(run, name):
    return (run.history["t"], run.history[name]) if name in run.history else None


def mean_of(run, names):
    """The mean of the columns that have values: the two sides of a droplet."""
    there = [run.history[name] for name in names if name in run.history and np.isfinite(run.history[name]).any()]
    return (run.history["t"], np.mean(there, axis=0)) if there else None


def ridge(run, _):
    """The height of the ridge beside the contact line, without the squeeze of the whole layer by the vapour."""
    found = mean_of(run, ("ridge_right", "ridge_left") if run.dimension == 2 else ("ridge_front", "ridge_rear"))
    return found and (found[0], found[1] - squeeze(run))


def angle(run, _):
    """The angle at which the circle through the surface of the droplet meets the contact line."""
    return mean_of(run, ("angle_right", "angle_left") if run.dimension == 2 else ("angle_front", "angle_rear"))


def centre(run, _):
    """The rise of the wall below the middle of the droplet, without the squeeze. An even polynomial through points from
    two elements to a fifth of the droplet gives the value there: on the axis of symmetry itself selective integration
    leaves a spike."""
    if run.dimension != 2 or "substrate" not in run.case:
        return None
    times, heights = [], []
    for time in run.times:
        wall = run.interface[time]
        row = int(np.abs(run.history["t"] - time).argmin())
        middle, half = middle_of(run, row)
        spacing = run.case["domain"]["size"][0] / run.case["domain"]["elements"][0]
        away = np.abs(wall["x_reference"] + wall["displacement_x"] - middle)
        reach = max(0.2 * half, 6 * spacing)
        chosen = (away >= 2 * spacing * (1 - 1e-6)) & (away <= reach)
        fit = np.polyfit(away[chosen] ** 2, wall["displacement_y"][chosen], 2)
        times.append(time)
        heights.append(fit[-1] - squeeze(run))
    return np.array(times), np.array(heights)


def middle_of(run, row):
    """The middle of the first droplet and half its contact width: a droplet that a side of the domain cuts has its
    middle there."""
    left, right = run.history["x_left"][row], run.history["x_right"][row]
    length, edge = run.case["domain"]["size"][0], 1e-9 * run.case["domain"]["size"][0]
    if abs(left) < edge:
        return 0.0, right
    if abs(right - length) < edge:
        return length, length - left
    return (left + right) / 2, (right - left) / 2


def squeeze(run):
    """By how much the pressure of the vapour lowers the whole layer; below 0. It grows as the width falls, since the
    layer keeps its modulus while that pressure is a number of the equation of state. 0 where the stiffness varies, and
    without field files."""
    case = run.case
    if not {"fluid", "substrate"} <= set(case) or isinstance(case["substrate"]["young"], str) or not run.times:
        return 0.0
    fluid = run.fields(run.times[-1])
    vapour = np.asarray(fluid["density"]) < 2 * run.record["equilibrium"]["density_vapour"]
    pressure = float(np.median(np.asarray(fluid["pressure"])[vapour])) if vapour.any() else 0.0
    solid = case["substrate"]
    young, nu = solid["density"] * solid["young"], solid["poisson"]
    return -pressure * solid["thickness"] * (1 + nu) * (1 - 2 * nu) / ((1 - nu) * young)


SERIES = {"ridge": ridge, "centre": centre, "angle": angle}
