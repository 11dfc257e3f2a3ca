"""Fig. 3: velocity of the droplet against time (A, B) and against its position (C, D) for several Poisson ratios.

Left: the load pulls; right: it pushes. Each folder of a sweep holds one output folder for each Poisson ratio. Thin: the
velocity from step to step; thick: its trend (mean over the time in which the droplet passes an element, since it wavers
from element to element). Curves start when the load stands and the substrate has answered, at t = 20."""

from pathlib import Path
import sys

import softwet
from .._drawing.look import Problem, np
import matplotlib.pyplot as plt

from .journal import SERIES, TIME, WIDTH, letter, trend

START = 20.0
POSITIONS = {"pull": (0.505, 0.51, 0.52, 0.54, 0.56, 0.58, 0.60, 0.62, 0.64),
             "push": (0.495, 0.49, 0.48, 0.47, 0.46, 0.45, 0.44)}  # where velocities are compared
DASHES = ("-", (0, (5, 1.5)), (0, (3, 1.2, 1, 1.2)), (0, (1.2, 1)))


def add_arguments(parser):
    parser.add_argument("--pull", metavar="SWEEP", type=Path, required=True,
                        help="folder of runs of cases/tensotaxis_pull_2d.toml that differ in substrate.poisson")
    parser.add_argument("--push", metavar="SWEEP", type=Path, required=True, help="the same of tensotaxis_push_2d.toml")


class Member:
    """One run: its trend of velocity and position at times spaced evenly."""

    def __init__(self, run):
        self.case, history = run.case, run.history
        if "x_centre" not in history or "substrate" not in self.case:
            raise Problem("has no droplet on a substrate")
        self.poisson = self.case["substrate"]["poisson"]
        self.history = {name: values[history["t"] >= START] for name, values in history.items()}
        if len(self.history["t"]) < 10:
            raise Problem(f"has fewer than ten steps after t = {START:g}")
        self.end = self.history["t"][-1]
        self.at = np.linspace(self.history["t"][0], self.end, 300)
        self.velocity = trend(self.history, "velocity", self.at, self.case)
        self.centre = np.interp(self.at, self.history["t"], self.history["x_centre"])

    def velocity_at(self, position):
        """Trend of the velocity where the droplet passes; NaN where it does not."""
        way = np.sign(self.centre[-1] - self.centre[0])
        order = np.argsort(way * self.centre)
        return np.interp(way * position, way * self.centre[order], self.velocity[order], left=np.nan, right=np.nan)


def members(folder):
    """The runs of a sweep, by falling Poisson ratio; those that cannot be read are named and left out."""
    found = []
    for member in softwet.open_sweep(folder):
        try:
            found.append(Member(member.run))
        except Problem as problem:
            print(f"figures: {member.folder} is left out: {problem}", file=sys.stderr)
    if not found:
        raise Problem(f"{folder} holds no output folder that can be plotted; write it with softwet sweep")
    return sorted(found, key=lambda one: -one.poisson)


def draw_against(axes, runs, abscissa):
    for run, colour, dashes in zip(runs, SERIES, DASHES):
        raw = run.history["t" if abscissa == "t" else "x_centre"]
        axes.plot(raw, 1e4 * run.history["velocity"], color=colour, linewidth=0.5, alpha=0.45)
        axes.plot(run.at if abscissa == "t" else run.centre, 1e4 * run.velocity, color=colour, linestyle=dashes,
                  linewidth=1.5, label=rf"$\nu = {run.poisson:g}$")
    axes.axhline(0, color="0.6", linewidth=0.5, zorder=0)


def numbers(sweeps):
    yield ("way", "poisson", "end", "x_centre_end", "velocity_end", "velocity_extreme", "t_extreme", "largest_shift",
           "mass_drift", *(f"velocity_at_{x:g}" for way in sweeps for x in POSITIONS[way]))
    for way, runs in sweeps.items():
        for run in runs:
            top = np.argmax(np.abs(run.velocity))
            positions = [(w, x) for w in sweeps for x in POSITIONS[w]]
            values = [run.velocity_at(x) if w == way else np.nan for w, x in positions]
            centre = run.history["x_centre"]
            yield (way, f"{run.poisson:g}", f"{run.end:g}", f"{centre[-1]:.5f}", f"{run.velocity[-1]:.2e}",
                   f"{run.velocity[top]:.3e}", f"{run.at[top]:.0f}", f"{np.abs(centre - 0.5).max():.5f}",
                   f"{np.abs(run.history['mass_drift']).max():.1e}",
                   *(f"{v:.3e}" if np.isfinite(v) else "" for v in values))


def draw(options):
    sweeps = {"pull": members(options.pull), "push": members(options.push)}
    figure, axes = plt.subplots(2, 2, figsize=(WIDTH, 5.0), layout="constrained")
    for column, (way, runs) in enumerate(sweeps.items()):
        for row, abscissa in enumerate(("t", "x_centre")):
            draw_against(axes[row, column], runs, abscissa)
            letter(axes[row, column], "ABCD"[2 * row + column])
        axes[0, column].set(title=way, xlabel=TIME, xlim=(0, max(run.end for run in runs)))
        axes[1, column].set(xlabel=r"droplet centre $X_c \;/\; L_0$")
        axes[0, column].legend(loc="upper right" if way == "pull" else "lower right")
    for row in range(2):
        axes[row, 0].set_ylabel(r"velocity $V \;/\; 10^{-4} (ab)^{1/2}$")
    return figure, numbers(sweeps)
