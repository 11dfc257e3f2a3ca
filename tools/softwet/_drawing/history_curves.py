"""Curves of history.csv: contact lines, velocity, angles, mass, energies, time step; used by tools/plot and
tools/report."""

import itertools
import math

import matplotlib.pyplot as plt
import numpy as np

from softwet.units import OF_THE_CASE

from .look import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, TIME, Problem, is_axisymmetric, letter, markers, with_unit

SPIKE = 0.02  # the part of the time shown that counts as its start
COLOURS = {"kinetic": GREY, "free": BLUE, "wall": GREEN, "elastic": RED, "surface": ORANGE, "gravity": PURPLE, "total": "black"}
FURTHER = ("tab:cyan", "tab:pink", "tab:olive", "tab:brown")  # energies without a colour of their own


class Curves:
    """The rows of a run that are shown. @param start  first time; None: 0, the start of the load, if two rows follow it
    @param least  rows that are needed: two make a curve, and a state of rest has one
    @param units  in which they are shown; start is in them, and reference in those of the case"""

    def __init__(self, run, start=None, reference=None, least=2, units=OF_THE_CASE):
        table, self.units = units.shown(run.history), units
        if start is None:
            start = 0.0 if (table["t"] >= -1e-9).sum() > 1 else -math.inf
        shown = table["t"] >= start - 1e-9
        if shown.sum() < least:
            if len(shown) < least:
                raise Problem("history.csv has one row, as a state of rest or a start has, and a curve needs two")
            raise Problem(f"history.csv has fewer than two rows from t = {start:g} on; its last is t = "
                          f"{table['t'][-1]:g}")
        self.table = {name: values[shown] for name, values in table.items()}
        self.t, self.flat, self.reference = self.table["t"], run.dimension == 2, units.shown(reference or {})
        self.of_integrals = 2 if self.flat and not is_axisymmetric(run.case) else 3  # d in the unit of an integral
        self.droplets = [name.removeprefix("x_centre") for name in table if name.startswith("x_centre")]
        if not self.flat:
            self.add_track(run.case)

    def add_track(self, case):
        """3D: the place of each droplet along the track, which counts from the middle of the domain."""
        size, track = np.array(case["domain"]["size"]) * self.units.of("x_centre")[1], np.array(case["output"]["history"]["track"])
        track = track / np.hypot(*track)
        for suffix in self.droplets:
            self.table["track_centre" + suffix] = sum(
                (self.table[f"{name}_centre{suffix}"] - 0.5 * size[d]) * track[d] for d, name in enumerate("xy"))

    def label(self, text, column, dimension=2):
        """What is shown, and the unit of its column. @param dimension  d of the unit"""
        return with_unit(text, column, dimension, self.units)

    @property
    def time(self):
        """The label of the time."""
        return self.label("$t$", "t") if self.units.named else TIME

    def settled(self):
        """Which rows are behind the first instants, in which the start rings off."""
        return self.t > self.t[0] + SPIKE * (self.t[-1] - self.t[0])

    def any_number(self, name):
        """Whether the column, or the one of a further droplet, has a value in the rows shown; a ridge on a rigid wall
        is none."""
        found = [values for column, values in self.table.items() if column.startswith(name)]
        return any((np.nan_to_num(values) != 0 if name == "ridge_" else np.isfinite(values)).any() for values in found)

    def line(self, ax, name, **style):
        """The curve of a column; none where it has no values, as for a droplet on an axis of symmetry."""
        values = self.table.get(name, np.array([np.nan]))
        if np.isfinite(values).any():
            ax.plot(self.t, values, **(markers(np.isfinite(values).sum()) | style))

    @property
    def ends(self):
        """Names of the ends of a droplet, with their colours."""
        return zip(("left", "right") if self.flat else ("rear", "front"), (BLUE, RED))

    def compare(self, ax, name):
        if name in self.reference:
            ax.plot(self.reference["t"], self.reference[name], "o", color="black", markerfacecolor="white",
                    markersize=5, label="independent solver")

    def panels(self):
        """The panels that the run has numbers for, in their order."""
        known = {position: ("x_left", "x_right", "x_centre"), velocity: ("velocity",), angles: ("angle_",), ridges: ("ridge_",),
                 mass: ("mass_drift",)}
        return [*(panel for panel, names in known.items() if any(map(self.any_number, names))), energies, step]


def position(ax, curves):
    rear, front, centre = ("x_left", "x_right", "x_centre") if curves.flat else ("track_rear", "track_front",
                                                                               "track_centre")
    for suffix in curves.droplets:
        curves.line(ax, front + suffix, color=GREY, linewidth=0.9, label="contact lines")
        curves.line(ax, rear + suffix, color=GREY, linewidth=0.9)
        curves.line(ax, centre + suffix, color=BLUE, label="midpoint $X_c$" if curves.flat else "centroid $X_c$")
    curves.compare(ax, "x_centre")
    ax.set(ylabel=curves.label("position" if curves.flat else "place on the track", centre if curves.flat else rear),
           title="contact lines and their midpoint" if curves.flat else "contact points and centroid")
    make_room(ax)


def make_room(ax):
    """For the legend, above the curves."""
    low, high = ax.get_ylim()
    ax.set_ylim(low, high + 0.45 * (high - low))


def velocity(ax, curves):
    for suffix in curves.droplets:
        curves.line(ax, "velocity" + suffix, color=BLUE, label="$V = dX_c/dt$")
    curves.compare(ax, "velocity")
    ax.set(ylabel=curves.label("$V$", "velocity"), title="droplet velocity")
    cut_spike(ax, curves)


def cut_spike(ax, curves):
    """Velocities of the first instants, in which the start rings off, do not set the scale of the others."""
    columns = [curves.table["velocity" + suffix] for suffix in curves.droplets]
    later = curves.settled()
    rest = np.concatenate([[0.0], *(values[later & np.isfinite(values)] for values in columns)])
    rest = np.concatenate([rest, curves.reference.get("velocity", [])])
    early = np.concatenate([values[~later & np.isfinite(values)] for values in columns])
    if len(rest) < 2 or not len(early) or not np.ptp(rest) > 0:
        return
    if np.abs(early).max() > 1.5 * np.abs(rest).max():
        margin = 0.12 * np.ptp(rest)
        ax.set_ylim(rest.min() - margin, rest.max() + 2 * margin)
        peak = early[np.abs(early).argmax()]
        ax.set_title(f"{ax.get_title(loc='right')}, {peak:.1e} at the start", loc="right")


def angles(ax, curves):
    for suffix in curves.droplets:
        for side, colour in curves.ends:
            curves.line(ax, f"angle_{side}{suffix}", color=colour, label=side)
    ax.set(ylabel=curves.label("angle", "angle_left" if curves.flat else "angle_rear"), title="apparent contact angles")


def ridges(ax, curves):
    for suffix in curves.droplets:
        for side, colour in curves.ends:
            curves.line(ax, f"ridge_{side}{suffix}", color=colour, label=side)
        curves.line(ax, f"dimple{suffix}", color=GREY, label="dimple")
    ax.set(ylabel=curves.label("height", "ridge_left" if curves.flat else "ridge_rear"), title="ridges of the wall")
    make_room(ax)


def energy_label(curves):
    return curves.label("energy", "energy_total", curves.of_integrals)


def energies(ax, curves):
    """All columns energy_*, the total last."""
    further = itertools.cycle(FURTHER)
    for name in sorted((name for name in curves.table if name.startswith("energy_")), key="energy_total".__eq__):
        values, label = curves.table[name], name.removeprefix("energy_").replace("_", " ")
        if np.isfinite(values).all() and np.ptp(values) > 0:
            ax.plot(curves.t, values - values[0], color=COLOURS.get(label) or next(further), label=label,
                    **markers(len(values)))
    ax.set(ylabel=energy_label(curves), title=f"energies, change since $t = {curves.t[0]:.4g}$")
    make_room(ax)


def mass(ax, curves):
    curves.line(ax, "mass_drift", color=BLUE)
    ax.set(ylabel=r"$m(t)/m_0 - 1$", title="relative drift of the total mass")


def step(ax, curves):
    positive = curves.table["dt"] > 0
    ax.semilogy(curves.t[positive], curves.table["dt"][positive], color=BLUE, **markers(positive.sum()))
    ax.set(ylabel=curves.label(r"$\Delta t$", "dt"), title="time step")


def finish(ax, curves, number):
    """Label of the time, legend, letter."""
    ax.set_xlabel(curves.time)
    ax.margins(x=0.02)
    handles, labels = ax.get_legend_handles_labels()
    unique = dict(zip(labels, handles))  # several droplets share their labels
    if unique:
        ax.legend(unique.values(), unique.keys(), frameon=False, loc="best", ncol=2 if len(unique) > 3 else 1)
    letter(ax, number)


def draw_curves(run, start=None, reference=None, units=OF_THE_CASE):
    """A figure of all panels. @param reference  columns to compare with, by name"""
    curves = Curves(run, start, reference, units=units)
    panels = curves.panels()
    rows = math.ceil(len(panels) / 2)
    figure, axes = plt.subplots(rows, 2, squeeze=False, layout="constrained", figsize=(8.2, 2.35 * rows))
    for number, (ax, panel) in enumerate(zip(axes.flat, panels)):
        panel(ax, curves)
        finish(ax, curves, number)
    for ax in axes.flat[len(panels):]:
        ax.set_visible(False)
    return figure
