"""The scene of a case before it is computed: materials, droplets, loads, probes, sides, given fields, and the mesh
where it is graded.

What is plotted is the state that the program writes with `softwet check CASE --scene DIR`: the case with its defaults,
the fields of the first state, and the values of expressions and tables. In two dimensions it is one picture. In three
dimensions it is the vertical section through the largest droplet, seen from the front, and the wall, seen from
above."""

import json
import tempfile
from pathlib import Path

import numpy as np
from matplotlib.patches import Rectangle

import softwet
from .look import GREEN, GREY, RED, matplotlib
from softwet import program

SHADES = {"fluid.contact_angle": "RdYlBu", "substrate.young": "YlOrBr"}
SYMBOLS = {"fluid.contact_angle": r"contact angle / degrees", "substrate.young": r"$E \;/\; (\rho_0^s\, a b)$"}
FLAT = 0.25  # height over width of a scene whose scales of colours lie below it
LINES = 64  # most lines of a mesh along an axis; of a finer one some are left out


class FirstState:
    """The first state of a case, as the program wrote it into a folder.

    run       the folder as a softwet.Run;  case  the resolved case
    samples   the profiles that vary in space: {key: (axes, values (z, y, x))}"""

    def __init__(self, folder):
        self.run = softwet.open(folder)
        self.case = self.run.case
        self.time = self.run.need_times()[0]
        told = json.loads((Path(folder) / "profiles.json").read_text())["profiles"]
        self.samples = {one["key"]: (one["axes"], np.reshape(one["values"], [len(axis) for axis in one["axes"][::-1]]))
                        for one in told}
        self.size = np.array(self.case["domain"]["size"], dtype=float)
        self.wall = self.case["substrate"]["thickness"] if "substrate" in self.case else 0.0

    def fields(self, part):
        return self.run.fields(self.time, part)

    @property
    def is_graded(self):
        """Whether some element is longer than another one along the same axis."""
        return any(np.ptp(np.diff(lines)) > 1e-6 * lines[-1] for lines in self.mesh_lines())

    def mesh_lines(self):
        """Positions of the ends of the elements along each axis."""
        parts = [self.fields(part).reference for part in self.run.parts]

        def along(d, points):
            index = [0] * len(self.size)
            index[len(self.size) - 1 - d] = slice(None, None, 2)
            return points[tuple(index)][:, d]

        across = [along(d, parts[0]) for d in range(len(self.size) - 1)]
        return [*across, np.unique(np.round(np.concatenate([along(len(self.size) - 1, part) for part in parts]), 12))]

    def middle(self):
        """A place in the plane of the wall: the centre of the largest droplet, else of the domain."""
        droplets = self.case.get("droplet", [])
        if not droplets:
            return self.size[:-1] / 2
        return np.array(max(droplets, key=lambda droplet: droplet["radius"])["centre"][:-1], dtype=float)


def with_first_state(case, sets, draw):
    """Lets the program write the first state of a case, and gives it to `draw` while it is there.
    @param case  path of a case file;  @param sets  words --set KEY=VALUE;  @return what draw returns; raises
    softwet.Failure"""
    with tempfile.TemporaryDirectory(prefix="softwet_scene_") as folder:
        program.ask("check", str(case), *sets, "--scene", folder)
        return draw(FirstState(folder))


# --- a plane: the section, or all of a scene in two dimensions -----------------------------------------------------
class Plane:
    """A plane of a scene: the axes that lie in it, and the index of the layer of each part across."""

    def __init__(self, state, axes):
        self.state, self.axes = state, axes
        self.width, self.height = state.size[[0, -1]]

    def layer(self, field):
        """The points of a part that are nearest to the plane, as an index of its arrays."""
        if field.dimension == 2:
            return (slice(None), slice(None))
        rest = field.reference[0, :, 0, 1]
        return (slice(None), int(np.argmin(abs(rest - self.state.middle()[1]))))

    def draw_fluid(self):
        field = self.state.fields("fluid")
        layer = self.layer(field)
        x, y = (field.positions[layer][..., d] for d in (0, -1))
        density = field["density"][layer]
        image = self.axes.pcolormesh(x, y, density, cmap="Blues", vmin=0, vmax=1, shading="gouraud", rasterized=True)
        low, high = density.min(), density.max()
        if high > 2 * low:
            self.axes.contour(x, y, density, levels=[0.5 * (low + high)], colors="black", linewidths=1.0)
        return image

    def draw_solid(self):
        """In grey, or in the colours of Young's modulus where it varies."""
        field = self.state.fields("solid")
        layer = self.layer(field)
        x, y = (field.positions[layer][..., d] for d in (0, -1))
        found = self.state.samples.get("substrate.young")
        if found is None:
            edge = [np.concatenate([v[0], v[1:, -1], v[-1, -2::-1], v[-2::-1, 0]]) for v in (x, y)]
            self.axes.fill(*edge, facecolor="0.88", edgecolor="none")
            image = None
        else:
            (sx, sy, sz), values = found
            plane = values[0] if len(self.state.size) == 2 else values[:, int(np.argmin(abs(np.array(sy) -
                                                                                               self.state.middle()[1])))]
            image = self.axes.pcolormesh(sx, sy if len(self.state.size) == 2 else sz, plane, cmap=SHADES["substrate.young"],
                                         shading="gouraud", rasterized=True)
        self.axes.plot(x[-1], y[-1], color="0.2", linewidth=0.9)
        return image

    def draw_pattern(self):
        """The contact angle along the wall, where it varies: a coloured line."""
        found = self.state.samples.get("fluid.contact_angle")
        if found is None:
            return None
        (x, y, _), values = found
        row = values[0, 0] if len(self.state.size) == 2 else values[0, int(np.argmin(abs(np.array(y) - self.state.middle()[1])))]
        height = np.full(len(x), self.state.wall)
        points = np.stack([x, height], axis=-1)
        line = matplotlib.collections.LineCollection(np.stack([points[:-1], points[1:]], axis=1), linewidths=4,
                                                     cmap=SHADES["fluid.contact_angle"], zorder=3)
        line.set_array(0.5 * (row[1:] + row[:-1]))
        return self.axes.add_collection(line)

    def draw_mesh(self):
        if not self.state.is_graded:
            return
        lines = self.state.mesh_lines()
        for draw, axis in ((self.axes.axvline, 0), (self.axes.axhline, -1)):
            every = -(-len(lines[axis]) // LINES)
            for place in lines[axis][::every]:
                draw(place, color="0.45", linewidth=0.25, zorder=1.5)

    def draw_loads(self):
        for number, load in enumerate(self.state.case.get("load", [])):
            low, high = np.array(load["box"], dtype=float)[:, [0, -1]]
            draw_load(self.axes, low, high, np.array(load["force"], dtype=float)[[0, -1]], self.width, number)
        for number, needle in enumerate(self.state.case.get("needle", [])):
            draw_needle(self.axes, *np.array(needle["box"], dtype=float)[:, [0, -1]], number)

    def draw_probes(self):
        """Points, lines and boxes of the probes, with their names. In 3D they are seen from the front."""
        for probe in self.state.case.get("probe", []):
            low, high = np.array(probe["box"] if probe["box"][0] else [probe["point"]] * 2, dtype=float)[:, [0, -1]]
            draw_probe(self.axes, low, high, probe["name"])

    def draw_given(self):
        """Directions of gravity, as words in the corner: they hold everywhere."""
        told = [f"{name}.gravity = {self.state.case[name]['gravity']}" for name in ("fluid", "substrate")
                if name in self.state.case and any(self.state.case[name]["gravity"])]
        self.axes.text(0.99, 0.97, "\n".join(told), transform=self.axes.transAxes, ha="right", va="top", color=GREEN,
                       fontsize=7)

    def draw(self):
        """@return the images that need a scale of colours: {label: image}"""
        images = {}
        if "fluid" in self.state.run.parts:
            images[r"density $\rho \;/\; b$"] = self.draw_fluid()
        if "solid" in self.state.run.parts:
            images[SYMBOLS["substrate.young"]] = self.draw_solid()
        if "fluid" in self.state.run.parts:
            images[SYMBOLS["fluid.contact_angle"]] = self.draw_pattern()
        self.draw_mesh()
        self.draw_loads()
        self.draw_probes()
        self.draw_given()
        frame(self.axes, self.width, self.height, self.state.case["boundary"], ("left", "right", "bottom", "top"))
        return {label: image for label, image in images.items() if image is not None}


def draw_probe(axes, low, high, name):
    """A box, a line, or a cross at a point."""
    mark = {"marker": "+", "markersize": 7} if (low == high).all() else {}
    x, y = (low[0], high[0], high[0], low[0], low[0]), (low[1], low[1], high[1], high[1], low[1])
    axes.plot(x, y, color=GREEN, linewidth=1, zorder=5, **mark)
    axes.annotate(name, high, (3, 3), textcoords="offset points", color=GREEN, fontsize=7, zorder=5)


def draw_load(axes, low, high, force, width, number):
    """The box of a load, and an arrow along its force in the plane of the picture."""
    axes.add_patch(Rectangle(low, *(high - low), facecolor="none", edgecolor=RED, linewidth=1.1, linestyle="--", zorder=4))
    axes.text(low[0], high[1], f" {number}", color=RED, fontsize=7, ha="left", va="top", zorder=4)
    if not force.any():
        return
    half, centre = 0.05 * width * force / np.linalg.norm(force), 0.5 * (low + high)
    axes.annotate("", centre + half, centre - half, arrowprops={"arrowstyle": "-|>", "color": RED, "linewidth": 1.3}, zorder=5)


def draw_needle(axes, low, high, number):
    """The box that a needle holds."""
    axes.add_patch(Rectangle(low, *(high - low), facecolor="none", edgecolor=RED, linewidth=1.1, hatch="///", zorder=4))
    axes.text(low[0], high[1], f" needle {number}", color=RED, fontsize=7, ha="left", va="bottom", zorder=4)


def frame(axes, width, height, kinds, names):
    """The box, and what holds on its sides in words. @param names  of the sides at the left, right, bottom and top"""
    axes.add_patch(Rectangle((0, 0), width, height, facecolor="none", edgecolor="0.2", linewidth=0.9, zorder=2))
    places = ((-0.015, 0.5, 90, "right", "center"), (1.015, 0.5, 270, "left", "center"), (0.5, -0.02, 0, "center", "top"),
              (0.5, 1.02, 0, "center", "bottom"))
    for name, (x, y, turn, across, upwards) in zip(names, places):
        axes.text(x * width, y * height, f"{name}: {kinds[name].replace('_', ' ')}", rotation=turn, color=GREY, fontsize=7,
                  ha=across, va=upwards, rotation_mode="anchor" if turn == 0 else "default")
    axes.set(xlim=(-0.07 * width, 1.07 * width), ylim=(-0.09 * height, 1.09 * height), aspect="equal")
    axes.set_axis_off()


# --- the wall from above -------------------------------------------------------------------------------------------
def draw_above(axes, state):
    """The wall of a scene in three dimensions from above: where it is wet, its pattern, and the loads below it."""
    width, depth = state.size[:2]
    images = {}
    found = state.samples.get("fluid.contact_angle")
    if found is not None:
        (x, y, _), values = found
        images[SYMBOLS["fluid.contact_angle"]] = axes.pcolormesh(x, y, values[0], cmap=SHADES["fluid.contact_angle"],
                                                                 shading="gouraud", rasterized=True)
    if "fluid" in state.run.parts:
        field = state.fields("fluid")
        x, y, density = field.positions[0][..., 0], field.positions[0][..., 1], field["density"]
        middle = 0.5 * (density.min() + density.max())
        if density.max() > 2 * density.min():
            axes.contour(x, y, density.max(axis=0), levels=[middle], colors="black", linewidths=0.8, linestyles="dotted")
            if density[0].min() < middle < density[0].max():
                axes.contour(x, y, density[0], levels=[middle], colors="black", linewidths=1.2)
    for number, load in enumerate(state.case.get("load", [])):
        low, high = np.array(load["box"], dtype=float)[:, :2]
        draw_load(axes, low, high, np.array(load["force"], dtype=float)[:2], width, number)
    for number, needle in enumerate(state.case.get("needle", [])):
        draw_needle(axes, *np.array(needle["box"], dtype=float)[:, :2], number)
    axes.plot([0, width], [state.middle()[1]] * 2, color=GREY, linewidth=0.6, linestyle=(0, (6, 3, 1, 3)))
    frame(axes, width, depth, state.case["boundary"], ("left", "right", "front", "back"))
    return images


# --- pages ---------------------------------------------------------------------------------------------------------
def draw(figure, state, size=7):
    """The picture of a scene. @param size  of the titles and labels in points;  @return its panels"""
    if len(state.size) == 2:
        panels = [figure.subplots()]
        add_scales(figure, panels[0], Plane(state, panels[0]).draw(), size)
        return panels
    panels = list(figure.subplots(2, 1, height_ratios=[state.size[-1] / state.size[1], 1]))
    add_scales(figure, panels[0], Plane(state, panels[0]).draw(), size)
    add_scales(figure, panels[1], draw_above(panels[1], state), size)
    panels[0].set_title(f"section at y = {state.middle()[1]:.4g}", loc="left", fontsize=size)
    panels[1].set_title("the wall from above; dotted: the outline of the liquid", loc="left", fontsize=size)
    return panels


def add_scales(figure, panel, images, size):
    """A scale of colours for each image {label: image} of a panel: below a flat one, at whose side the label would be
    taller."""
    (left, right), (low, high) = panel.get_xlim(), panel.get_ylim()
    place = {"location": "bottom", "shrink": 0.5, "aspect": 30, "pad": 0.1} if high - low < FLAT * (right - left) else {"shrink": 0.8, "pad": 0.01}
    for label, image in images.items():
        bar = figure.colorbar(image, ax=panel, **{"aspect": 20, **place})
        bar.set_label(label, fontsize=size)
        bar.ax.tick_params(labelsize=size)


def size_of_page(state):
    """Inches of a page of its own."""
    tall = state.size[-1] if len(state.size) == 2 else state.size[1] + state.size[-1]
    scales = 1.4 if state.size[-1] < FLAT * state.size[0] else 0
    return 8.0, float(np.clip(6.2 * tall / state.size[0], 1.2, 11.0)) + 0.8 + scales
