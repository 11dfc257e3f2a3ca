"""Fig. 1 (B): a droplet at rest on a very soft substrate; dimple, ridge, and the angles at the contact line.

a: density and the deformed substrate at the last time. b: the contact line. alpha is the angle between the interface of
the liquid and the deformed wall, read where they meet; the case prescribes it as the static angle. phi is the apparent
angle of history.csv, between the circle through the interface and the horizontal. c: vertical displacement of the wall.
A run of half of the droplet, cut by the side x = 0, is plotted with its mirror image."""

from pathlib import Path

import softwet
from .._drawing.look import Problem, np, refine
from .._drawing.fields import Scene
from matplotlib.patches import Arc, Rectangle
import matplotlib.pyplot as plt

from .journal import BLUE, WIDTH, Y, letter


DARK_RED = "#A01010"
PHI, ALPHA = r"$\varphi = {:.1f}\degree$", r"$\alpha \approx {:.0f}\degree$"
FROM_CENTRE = r"$(x - x_0) \;/\; L_0$"


def add_arguments(parser):
    parser.add_argument("folder", metavar="OUT", type=Path, help="run of cases/fig1b_soft_droplet_2d.toml")


class Rest:
    """The last fields of a run, its wall and its contact line on the right; x counts from the droplet's centre."""

    def __init__(self, folder):
        run = softwet.open(folder)
        self.case = run.case
        if "droplet" not in self.case or "substrate" not in self.case or len(self.case["domain"]["size"]) != 2:
            raise Problem(f"{folder} is not a run of a droplet on a substrate in two dimensions")
        self.time = run.need_times()[-1]
        self.scene = Scene(run, self.time)
        history = run.history
        row = np.argmin(np.abs(history["t"] - self.time))
        self.end = {name: values[row] for name, values in history.items()}
        self.extremes = history["rho_min"].min(), history["rho_max"].max()
        self.wall = run.interface[self.time]
        self.half = self.case["droplet"][0]["centre"][0] == 0
        self.centre = 0.0 if self.half else self.end["x_centre"]
        for block in (self.scene.fluid, self.scene.solid):
            block.x -= self.centre
        self.wall_x = refine(self.wall["x_reference"] + self.wall["displacement_x"]) - self.centre
        self.wall_y = refine(self.wall["displacement_y"])
        if not np.ptp(self.wall_y) > 0:
            raise Problem(f"{folder}: the substrate has not moved by t = {self.time:g}, its last field time")
        self.thickness = self.case["substrate"]["thickness"]
        self.gamma = self.case["fluid"]["capillarity"]
        self.contact = np.array([self.end["x_right"] - self.centre, 0.0])
        self.contact[1] = self.thickness + np.interp(self.contact[0], self.wall_x, self.wall_y)
        self.apparent = self.end["angle_right"]
        if not np.isfinite(self.apparent):
            raise Problem(f"{folder} has no apparent angle at t = {self.time:g}")

    def mirror(self, sign):
        for block in (self.scene.fluid, self.scene.solid):
            block.x *= sign

    def wall_slope(self):
        """Angle of the wall over the horizontal at the contact line, degrees; positive: rising to the right."""
        near = np.abs(self.wall_x - self.contact[0]) < 0.5 * self.gamma
        return np.degrees(np.arctan(np.polyfit(self.wall_x[near], self.wall_y[near], 1)[0]))

    def interface_slope(self, line):
        """Angle in the liquid between the level line where it meets the wall and the horizontal, degrees."""
        x, y = (line - self.contact)[np.hypot(*(line - self.contact).T) < 1.5 * self.gamma].T
        if len(x) < 4:
            raise Problem("the interface has fewer than four points close to the wall")
        slope = np.polynomial.Polynomial.fit(y, x, 2).deriv()(0.0)  # x against y: the interface is steep
        return np.degrees(np.arctan2(1.0, -slope))

    def level_line(self, axes):
        """Points of the line of middle density that ends at the contact line on the right."""
        before = len(axes.collections)
        self.scene.outline(axes, colors="black", linewidths=1.1)
        paths = axes.collections[before].get_paths() if len(axes.collections) > before else []
        points = [path.vertices for path in paths]
        if not points:
            raise Problem("there is no liquid-vapour interface")
        return min(points, key=lambda line: np.hypot(*(line - self.contact).T).min())


# --- panels ----------------------------------------------------------------------------------------------------------
def draw_scene(axes, rest, limit):
    for sign in (-1, 1) if rest.half else (1,):
        rest.mirror(sign)
        fluid = rest.scene.draw_fluid(axes)
        rest.scene.draw_solid(axes, limit)
        line = rest.level_line(axes)
        rest.mirror(sign)
    reach = 1.9 * rest.contact[0]
    axes.set(xlim=(-reach, reach), ylim=(0, rest.thickness + 1.05 * rest.contact[0]), aspect="equal",
             xlabel=FROM_CENTRE, ylabel=Y)
    return fluid, line


def draw_angle(axes, corner, radius, low, high, text, colour):
    """An arc from the direction `low` to `high` (degrees), and its name outside of it."""
    axes.add_patch(Arc(corner, 2 * radius, 2 * radius, theta1=low, theta2=high, color=colour, linewidth=1.3, zorder=5))
    middle = np.radians(0.5 * (low + high))
    axes.text(*(corner + 1.06 * radius * np.array([np.cos(middle), np.sin(middle)])), text, color=colour, ha="right",
              va="center", fontsize=8)


def ray(axes, corner, degrees, length, **style):
    end = corner + length * np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    axes.plot(*np.transpose([corner, end]), **style)


def draw_corner(axes, rest, limit, line, reach):
    """The contact line: directions point from it into the liquid, to the left."""
    rest.scene.draw_fluid(axes, darkest=3.5)  # pale, for the lines on it
    image = rest.scene.draw_solid(axes, limit)
    axes.plot(*line.T, color="black", linewidth=1.2)
    axes.plot(rest.wall_x, rest.thickness + rest.wall_y, color="0.2", linewidth=0.8)
    slope, local = rest.wall_slope(), rest.interface_slope(line)
    corner = rest.contact
    ray(axes, corner, 180, 1.1 * reach, color="0.3", linestyle=":", linewidth=0.9)
    ray(axes, corner, 180 - rest.apparent, 1.1 * reach, color=DARK_RED, linestyle=(0, (4, 2)))
    ray(axes, corner, 180 + slope, 0.55 * reach, color=BLUE)
    ray(axes, corner, 180 - local, 0.55 * reach, color=BLUE)
    draw_angle(axes, corner, 0.85 * reach, 180 - rest.apparent, 180, PHI.format(rest.apparent), DARK_RED)
    draw_angle(axes, corner, 0.32 * reach, 180 - local, 180 + slope, ALPHA.format(local + slope), BLUE)
    axes.set(xlim=(corner[0] - 1.35 * reach, corner[0] + 0.6 * reach), aspect="equal", xlabel=FROM_CENTRE,
             ylim=(corner[1] - 0.7 * reach, corner[1] + 0.9 * reach))
    return image, local + slope, slope


def draw_wall(axes, rest):
    x, u = rest.wall_x, 1e3 * rest.wall_y
    for sign in (1, -1) if rest.half else (1,):
        axes.plot(sign * x, u, color=BLUE)
    top, low = np.argmax(u), np.argmin(u)
    axes.axhline(0, color="0.6", linewidth=0.5, zorder=0)
    for at, name, align in ((top, "ridge", "bottom"), (low, "dimple", "top")):
        axes.annotate(f"{name} ${u[at]:.2f}$", (x[at], u[at]), (0, 3 if align == "bottom" else -3),
                      textcoords="offset points", ha="center", va=align, fontsize=7.5)
    axes.set(xlabel=FROM_CENTRE, ylabel=r"$u_y \;/\; 10^{-3} L_0$",
             ylim=(u[low] - 0.3 * np.ptp(u), u[top] + 0.3 * np.ptp(u)))


def draw(options):
    rest = Rest(options.folder)
    limit = np.abs(rest.scene.vertical_displacement()).max()
    figure = plt.figure(figsize=(WIDTH, 4.9), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(1.45, 1), height_ratios=(1.6, 1))
    scene, corner, wall = (figure.add_subplot(grid[place]) for place in ((0, 0), (0, 1), (1, slice(None))))
    fluid, line = draw_scene(scene, rest, limit)
    reach = max(6 * rest.gamma, 0.1 * rest.contact[0])
    solid, angle, slope = draw_corner(corner, rest, limit, line, reach)
    low = np.array([corner.get_xlim()[0], corner.get_ylim()[0]])
    scene.add_patch(Rectangle(low, np.ptp(corner.get_xlim()), np.ptp(corner.get_ylim()), fill=False, linewidth=0.8))
    draw_wall(wall, rest)
    wall.set_xlim(-rest.wall_x.max(), rest.wall_x.max())
    for axes, name in ((scene, "a"), (corner, "b"), (wall, "c")):
        letter(axes, name)
    figure.colorbar(fluid, ax=scene, location="bottom", label=r"density $\rho \,/\, b$", aspect=30, shrink=0.7)
    figure.colorbar(solid, ax=corner, location="bottom", aspect=30,
                    label=r"vertical displacement $u_y \,/\, 10^{-3} L_0$")
    return figure, numbers(rest, angle, slope)


def numbers(rest, angle, slope):
    yield ("t", "elements", "capillarity", "ridge", "dimple", "apparent_angle", "angle_at_wall", "static_angle",
           "wall_slope", "contact_line", "rho_min", "rho_max", "rho_min_ever", "rho_max_ever")
    yield (f"{rest.time:g}", "x".join(map(str, rest.case["domain"]["elements"])), f"{rest.gamma:g}",
           f"{rest.wall_y.max():.5f}", f"{rest.wall_y.min():.5f}", f"{rest.apparent:.2f}", f"{angle:.1f}",
           f"{rest.case['fluid']['contact_angle']:g}", f"{slope:.1f}", f"{rest.contact[0]:.5f}",
           f"{rest.end['rho_min']:.4f}", f"{rest.end['rho_max']:.4f}", *(f"{value:.4f}" for value in rest.extremes))
