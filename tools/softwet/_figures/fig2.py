"""Fig. 2: a droplet pulled (left) and pushed (right) by a load on the substrate; panels A to J.

A, B: before the load; dashed box: where the force acts. C, D: density, and vertical displacement of the solid, at the
last time; dashed arc: the droplet before the load. E, F: streamlines of the fluid while the droplet moves.
G, H: vertical displacement of the interface. I, J: apparent contact angles (dashed) and their trends (mean
over the time in which the droplet passes an element, since the angles waver from element to element)."""

from pathlib import Path

import softwet
from .._drawing.look import Problem, np, refine
from .._drawing.fields import Scene
from matplotlib.colors import ListedColormap, LogNorm
import matplotlib.pyplot as plt

from .journal import BLUE, GREEN, TIME, VERMILION, WIDTH, X, Y, letter, trend

TIMES = {"pull": (235.0, 471.0, 1884.0), "push": (1962.0, 3924.0, 7848.0)}  # the paper's, panels G and H
MOVING = {"pull": 471.0, "push": 1962.0}  # time of panels E and F, not stated in the paper
SPEED = LogNorm(1e-6, 1e-3)
SPEED_COLOURS = ListedColormap(plt.get_cmap("viridis_r")(np.linspace(0.12, 1, 256)))  # without the palest
LEGEND = {"pull": "upper left", "push": "upper right"}  # where the curves of G and H leave room


def add_arguments(parser):
    parser.add_argument("--pull", metavar="OUT", type=Path, required=True, help="run of cases/tensotaxis_pull_2d.toml")
    parser.add_argument("--push", metavar="OUT", type=Path, required=True, help="run of cases/tensotaxis_push_2d.toml")


class Run:
    """An output folder, and the times of its panels."""

    def __init__(self, folder, way):
        self.output, self.way, self.times = softwet.open(folder), way, TIMES[way]
        self.case, self.interface = self.output.case, self.output.interface
        if "load" not in self.case or self.output.dimension != 2:
            raise Problem(f"{folder} is not a run in two dimensions with a load")
        self.history = self.output.history
        self.moving = MOVING[way]
        shown = (self.history["t"] >= 0) & (self.history["t"] <= self.times[-1] * (1 + 1e-9))
        self.loaded = {name: values[shown] for name, values in self.history.items()}

    def scene(self, time):
        return Scene(self.output, time)


# --- panels ----------------------------------------------------------------------------------------------------------
def frame(axes, case):
    width, height = case["domain"]["size"]
    axes.set(xlim=(0, width), ylim=(0, height), aspect="equal", xticks=np.linspace(0, width, 6),
             yticks=np.linspace(0, height, 3))


def draw_start(axes, run):
    start = run.scene(0.0)
    start.draw_fluid(axes)
    start.fill_solid(axes, "0.85")
    start.outline(axes, colors="black", linewidths=1.0)
    start.draw_loads(axes, VERMILION)
    x, y = run.case["domain"]["size"]
    for place, text, colour in (((0.5, 0.36), "liquid", "white"), ((0.5, 0.8), "vapour", "0.2"),
                                ((0.2, 0.125), "soft solid", "0.2")):
        axes.text(place[0] * x, place[1] * y, text, color=colour, ha="center", va="center", fontsize=7)
    box = np.mean(run.case["load"][0]["box"], axis=0)
    axes.text(box[0], 0.36 * y, "force", color=VERMILION, ha="center", fontsize=7)
    axes.set_title(f"{run.way}, $t = 0$")
    frame(axes, run.case)


def draw_density(axes, run, limit):
    start, end = run.scene(0.0), run.scene(run.times[-1])
    images = end.draw_fluid(axes), end.draw_solid(axes, limit)
    end.draw_loads(axes, "0.25")
    start.outline(axes, colors="black", linewidths=0.9, linestyles="dashed")
    axes.set_title(f"$t = {run.times[-1]:g}$")
    frame(axes, run.case)
    return images


def draw_streamlines(axes, run):
    scene = run.scene(run.moving)
    lines = scene.draw_streamlines(axes, colour_speed=(SPEED_COLOURS, SPEED), linewidth=0.7, arrowsize=0.55,
                                   density=1.2)
    scene.fill_solid(axes, "0.85")
    scene.outline(axes, colors="black", linewidths=1.3)
    axes.set_title(f"$t = {run.moving:g}$")
    frame(axes, run.case)
    return lines.lines


def draw_interface(axes, run):
    for time, colour, dashes in zip(run.times, (BLUE, GREEN, VERMILION), ("-", (0, (5, 1.5)), (0, (1.5, 1)))):
        wall = run.interface[time]
        axes.plot(refine(wall["x_reference"] + wall["displacement_x"]), 1e3 * refine(wall["displacement_y"]),
                  color=colour, linestyle=dashes, label=f"$t = {time:g}$")
    axes.axhline(0, color="0.6", linewidth=0.5, zorder=0)
    axes.set(xlim=(0, run.case["domain"]["size"][0]), xlabel=X)
    axes.legend(loc=LEGEND[run.way], handlelength=2.4)


def draw_angles(axes, run):
    t = run.loaded["t"]
    at = np.linspace(0, t[-1], 200)
    for side, colour in (("left", BLUE), ("right", VERMILION)):
        axes.plot(t, run.loaded[f"angle_{side}"], color=colour, linestyle=(0, (2, 1.5)), linewidth=0.8)
        axes.plot(at, trend(run.loaded, f"angle_{side}", at, run.case), color=colour, label=f"{side} contact line")
    axes.set(xlim=(0, t[-1]), xlabel=TIME)
    axes.legend(loc="best")


# --- numbers ---------------------------------------------------------------------------------------------------------
def linear_step(case):
    """Height of the far side that is compressed over the one that is stretched, nu (1 + nu) f A / E, along +x."""
    solid, load = case["substrate"], case["load"][0]
    low, high = np.array(load["box"])
    area, force = np.prod(high - low), np.array(load["force"])[0]
    return solid["poisson"] * (1 + solid["poisson"]) * force * area / solid["young"]


def numbers(runs):
    yield ("run", "t", "x_centre", "velocity", "angle_left", "angle_right", "ridge_left", "ridge_right", "dimple",
           "far_left", "far_right", "far_step", "linear_step", "ratio")
    for way, run in runs.items():
        for time in (0.0, *run.times):
            wall = run.interface[time]
            x, u = wall["x_reference"], wall["displacement_y"]
            at = lambda name: np.interp(time, run.history["t"], run.history[name])  # noqa: E731
            centre = at("x_centre")
            step = linear_step(run.case) if time > 0 else 0.0
            yield (way, f"{time:g}", f"{centre:.4f}", f"{at('velocity'):.2e}", f"{at('angle_left'):.2f}",
                   f"{at('angle_right'):.2f}", f"{u[x < centre].max():.3e}", f"{u[x > centre].max():.3e}",
                   f"{u.min():.3e}", f"{u[0]:.3e}", f"{u[-1]:.3e}", f"{u[-1] - u[0]:.4e}", f"{step:.4e}",
                   f"{(u[-1] - u[0]) / step:.3f}" if step else "")


def draw(options):
    runs = {"pull": Run(options.pull, "pull"), "push": Run(options.push, "push")}
    figure, axes = plt.subplots(5, 2, figsize=(WIDTH, 8.6), layout="constrained",
                                gridspec_kw={"height_ratios": (1, 1, 1, 0.95, 0.95)})
    limit = max(np.abs(run.scene(time).vertical_displacement()).max() for run in runs.values() for time in run.times)
    for column, run in enumerate(runs.values()):
        panel = axes[:, column]
        draw_start(panel[0], run)
        fluid, solid = draw_density(panel[1], run, limit)
        lines = draw_streamlines(panel[2], run)
        draw_interface(panel[3], run)
        draw_angles(panel[4], run)
        for row in range(5):
            letter(panel[row], "ABCDEFGHIJ"[2 * row + column])
    for row in range(3):
        axes[row, 0].set_ylabel(Y)
        for ax in axes[row]:
            ax.tick_params(labelbottom=row == 2)
    axes[3, 0].set_ylabel(r"$u_y \;/\; 10^{-3} L_0$")
    axes[4, 0].set_ylabel("apparent angle / degrees")
    figure.colorbar(fluid, ax=axes[0], label=r"density $\rho \,/\, b$", aspect=12, pad=0.01)
    figure.colorbar(solid, ax=axes[1], label=r"$u_y \,/\, 10^{-3} L_0$", aspect=12, pad=0.01)
    figure.colorbar(lines, ax=axes[2], label=r"speed $/\, (ab)^{1/2}$", aspect=12, pad=0.01, extend="both")
    return figure, numbers(runs)
