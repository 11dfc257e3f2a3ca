"""Pictures of runs in three dimensions: droplets on the deformed substrate, and the profile of its surface.

Surfaces are cut out of the fields, projected, sorted by depth and plotted as polygons of matplotlib: no window system and
no 3D library is needed.
"""

from . import look as outputs
from .output3d import Output, box_edges, indices, level_set, on_lattice, profile, quads, refine, track_line
import contourpy  # a part of matplotlib
import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

LIQUID = np.array([0.36, 0.62, 0.86])
RED, GREEN = "#c0392b", "#2e8b57"
ORDER = [RED, GREEN, "#d4a017", "#1f5fa8"]  # red, green, yellow, blue: the times of Figs. 4C and 5C of the paper
COLOURS = "PuOr_r"
LIGHT = np.array([-0.45, 0.55, 0.70])  # to the left, above, towards the eye
LIGHT /= np.linalg.norm(LIGHT)
LETTERS = "ABCDEFGHI"  # of the scenes and of the profile


# --- the view --------------------------------------------------------------------------------------------------------
class View:
    """Orthographic view: the eye `turn` degrees around the track from its right-hand side, `rise` above the horizon."""

    def __init__(self, track, turn=16.0, rise=30.0):
        around, up = np.arctan2(track[1], track[0]) + np.radians(turn - 90), np.radians(rise)
        self.eye = np.array([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])
        self.right = np.array([-np.sin(around), np.cos(around), 0.0])
        self.up = np.cross(self.eye, self.right)
        self.light = LIGHT @ [self.right, self.up, self.eye]

    def flat(self, points):
        """Places on the page."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def polygons(self, corners, colours, **style):
        """A collection of polygons (n, corners, 3), farthest first."""
        order = np.argsort((corners @ self.eye).mean(axis=1))
        return PolyCollection(self.flat(corners[order]), facecolors=colours[order], edgecolors="face", linewidths=0.15,
                              rasterized=True, **style)


# --- the scene -------------------------------------------------------------------------------------------------------
def see_through(image, _):
    """Makes a surface transparent as a whole, so that no seams show between its polygons."""
    return np.concatenate([image[..., :3], np.minimum(image[..., 3:], 0.68)], axis=-1), 0, 0


class Scene:
    """What is plotted at one time."""

    def __init__(self, output, time, magnify, view):
        self.output, self.time, self.magnify, self.view = output, time, magnify, view
        self.solid = output.positions("solid", time, magnify)
        self.lines = output.lines("solid", time)[::-1]  # of the same points, x first
        self.lift = refine(output.run.fields(time, "solid").moved()[..., 2], output.fine)
        self.density = None
        if output.middle is not None:
            density = output.run.fields(time, "fluid").read("density")
            liquid = np.nonzero((density >= output.middle).any(axis=(1, 2)))[0]
            if len(liquid):  # whole elements, up to just above the droplet
                self.rows = slice(0, min((liquid.max() + 4) // 2 * 2 + 1, len(density)))
                self.density = refine(density[self.rows], output.fine)

    def draw(self, axes, limit, first):
        """@param limit colours from -limit to limit, displacement in L0; @param first the scene of the dashed line"""
        image = self.draw_substrate(axes, limit)
        self.draw_section(axes)
        if first is not self:
            for line in first.contact_lines():
                self.draw_on_wall(axes, line, color="black", linewidth=1.0, linestyle=(0, (4, 2.5)), zorder=3)
        self.draw_loads(axes)
        self.draw_droplet(axes)
        if first is self:
            self.draw_axes(axes)
        axes.set_aspect("equal")
        axes.set_axis_off()
        axes.autoscale_view()
        return image

    def draw_substrate(self, axes, limit):
        image = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(-1e3 * limit, 1e3 * limit), COLOURS)
        faces = [(self.solid[-1], self.lift[-1], np.array([0, 0, 1.0]))]
        for axis, side in ((0, 0), (0, -1), (1, 0), (1, -1)):
            normal = np.zeros(3)
            normal[axis] = -1 if side == 0 else 1
            if normal @ self.view.eye > 0:
                cut = (slice(None), slice(None), side) if axis == 0 else (slice(None), side)
                faces.append((self.solid[cut], self.lift[cut], normal))
        for points, lift, normal in faces:
            corners = quads(points)
            across = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
            across *= np.sign(across @ normal)[:, None] / np.linalg.norm(across, axis=1)[:, None]
            colours = image.to_rgba(1e3 * quads(lift[..., None]).mean(axis=(1, 2)))
            colours[:, :3] *= (0.7 + 0.3 * np.clip(across @ self.view.light / self.view.light[2], 0, 1))[:, None]
            axes.add_collection(self.view.polygons(corners, colours, zorder=1))
            rim = np.concatenate([points[0], points[1:, -1], points[-1, -2::-1], points[-2::-1, 0]])
            axes.plot(*self.view.flat(rim).T, color="0.25", linewidth=0.6, zorder=2, solid_joinstyle="round")
        return image

    def draw_droplet(self, axes):
        if self.density is None:
            return
        lines = self.output.lines("fluid", self.time, self.rows)
        slope = -np.stack(np.gradient(self.density, *lines)[::-1], axis=-1)
        place = self.output.positions("fluid", self.time, self.magnify, self.rows)
        corners, normal = level_set(self.density, self.output.middle, place, slope)
        normal = normal.mean(axis=1)
        normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
        seen = normal @ self.view.eye > -0.05
        corners, normal = corners[seen], normal[seen]
        half = self.view.eye + self.view.light
        gloss = np.clip(normal @ (half / np.linalg.norm(half)), 0, 1) ** 40
        shade = 0.55 + 0.45 * np.clip(normal @ self.view.light, 0, 1)
        colours = np.ones((len(corners), 4))
        colours[:, :3] = np.clip(LIQUID * shade[:, None] + 0.55 * gloss[:, None], 0, 1)
        surface = self.view.polygons(corners, colours, zorder=4)
        surface.set_agg_filter(see_through)
        axes.add_collection(surface)
        for line in self.contact_lines():
            self.draw_on_wall(axes, line, color="#173a5e", linewidth=0.9, zorder=3.2)

    def contact_lines(self):
        """Lines of the wall where the droplets end, places (n, 2) in the plane of the wall."""
        if self.density is None:
            return []
        lines = contourpy.contour_generator(z=self.density[0]).lines(self.output.middle)
        return [on_lattice(self.solid[-1, ..., :2], line) for line in lines if len(line) > 1]

    def wall_at(self, places):
        """Points of the deformed surface above places (n, 2)."""
        surface, rest = self.solid[-1], places
        for _ in range(20):  # the displacement is small and smooth: the error shrinks by its slope each time
            rest = rest + places - on_lattice(surface, indices(self.lines[:2], rest))[:, :2]
        return on_lattice(surface, indices(self.lines[:2], rest))

    def draw_on_wall(self, axes, places, **style):
        axes.plot(*self.view.flat(self.wall_at(places)).T, solid_joinstyle="round", **style)

    def draw_axes(self, axes):
        """The directions of the coordinates, in the lower left corner."""
        page = self.view.flat(self.solid.reshape(-1, 3))
        reach = 0.075 * self.output.size[0]
        tips = self.view.flat(np.eye(3))
        corner = page.min(axis=0) - 1.5 * reach * np.minimum(tips.min(axis=0), 0)
        for tip, name in zip(tips, "xyz"):
            arrow = axes.annotate("", corner + reach * tip, corner, arrowprops={
                "arrowstyle": "-|>,head_width=0.12,head_length=0.25", "color": "0.2", "linewidth": 0.7, "shrinkA": 0,
                "shrinkB": 0})
            label = axes.text(*(corner + 1.5 * reach * tip), f"${name}$", ha="center", va="center", fontsize=8,
                              color="0.2")
            for artist in (arrow, label):
                artist.set_in_layout(False)

    def draw_section(self, axes):
        """The vertical plane of the profile: its line on the surface."""
        self.draw_on_wall(axes, track_line(self.output)[1], color=GREEN, linewidth=1.0, zorder=2.5)

    def draw_loads(self, axes):
        """Boxes where the solid has carried them, and the direction of the force: an arrow while the load acts, shorter
        while it grows. The boxes of needles have full lines."""
        for needle in self.output.case.get("needle", []):
            self.draw_box(axes, *np.array(needle["box"], dtype=float), "-")
        for load in self.output.case.get("load", []):
            low, high = np.array(load["box"], dtype=float)
            self.draw_box(axes, low, high, (0, (3, 1.5)))
            force = np.array(load["force"], dtype=float)
            part = outputs.fraction_of(load, self.output.case, self.time)
            if not force.any() or part == 0:
                continue
            centre = self.carried(np.array([[*(0.5 * (low + high))[:2], high[2]]]))[0]
            reach = part * 0.13 * self.output.size[0] * force / np.linalg.norm(force)
            tail, head = self.view.flat(np.array([centre - reach, centre + reach]))
            axes.annotate("", head, tail, zorder=6, arrowprops={"arrowstyle": "-|>,head_width=0.28,head_length=0.55",
                                                                "color": RED, "linewidth": 1.8, "shrinkA": 0,
                                                                "shrinkB": 0})

    def draw_box(self, axes, low, high, style):
        for start, end in box_edges(low, high):
            line = start + np.linspace(0, 1, 25)[:, None] * (end - start)
            axes.plot(*self.view.flat(self.carried(line)).T, color=RED, linewidth=0.9, linestyle=style, zorder=3.5)

    def carried(self, points):
        """Where reference points of the solid are now."""
        index = indices(self.lines, points)
        level = np.clip(np.floor(index[:, 2]).astype(int), 0, len(self.solid) - 2)
        share = (index[:, 2] - level)[:, None]
        result = np.empty_like(points)
        for k in np.unique(level):
            at = level == k
            below, above = (on_lattice(self.solid[k + n], index[at, :2]) for n in (0, 1))
            result[at] = (1 - share[at]) * below + share[at] * above
        return result


# --- the profile -----------------------------------------------------------------------------------------------------
def draw_profiles(axes, output, times):
    colours = ORDER if len(times) <= len(ORDER) else matplotlib.colormaps["viridis"](np.linspace(0, 0.9, len(times)))
    for time, colour in zip(times, colours):
        s, lift = profile(output, time)
        axes.plot(s, 1e3 * lift, color=colour, label=f"$t = {time:g}$")
    axes.axhline(0, color="0.55", linewidth=0.6, zorder=0)
    axes.set(xlabel=r"distance along the track from the middle $/\; L_0$", ylabel=r"$u_z \;/\; 10^{-3} L_0$",
             xlim=tuple(track_line(output)[0][[0, -1]]))
    axes.legend(frameon=False, ncols=2, handlelength=1.5)


# --- the figure ------------------------------------------------------------------------------------------------------
def check_options(scenes, magnify, turn, rise):
    if len(scenes) >= len(LETTERS):
        raise outputs.Problem(f"--scenes with {len(scenes)} times: a picture has 1 to {len(LETTERS) - 1}; draw the "
                              "others into another picture")
    outputs.check_number("--magnify", magnify, 0, 1e6)
    outputs.check_number("--turn", turn, -360, 360)
    outputs.check_number("--rise", rise, -90, 90)


def figure(folder, scenes=None, profiles=None, magnify=1.0, turn=16.0, rise=30.0):
    """(A), (B): the droplets at two times, more or fewer as asked; last: profiles of the surface."""
    check_options(scenes or [], magnify, turn, rise)
    output = Output(folder)
    started = [t for t in output.times if t >= 0] or output.times
    scenes = [output.run.time(t) for t in scenes] if scenes else sorted({started[0], started[-1]})
    profiles = [output.run.time(t) for t in profiles] if profiles else (started[1:] or started)
    view = View(output.track, turn, rise)
    drawn = [Scene(output, time, magnify, view) for time in scenes]
    limit = max(np.abs(scene.lift[-1]).max() for scene in drawn) or 1e-3
    plt.rcParams.update(outputs.STYLE)
    picture = plt.figure(figsize=(7.2, 5.0 if len(scenes) < 3 else 6.2), layout="constrained")
    top, bottom = picture.subfigures(2, 1, height_ratios=[1.35, 1])
    panels = top.subplots(1, len(drawn), squeeze=False)[0]
    for letter, scene, axes in zip(LETTERS, drawn, panels):
        image = scene.draw(axes, limit, drawn[0])
        axes.text(0, 0.98, f"({letter})  $t = {scene.time:g}$", transform=axes.transAxes, va="top")
    for which in ("xlim", "ylim"):  # one scale for all
        ends = np.array([plt.getp(axes, which) for axes in panels])
        plt.setp(panels, **{which: (ends[:, 0].min(), ends[:, 1].max())})
    bar = top.colorbar(image, ax=list(panels), orientation="horizontal", shrink=0.5, aspect=40, pad=0.02,
                       label=r"vertical displacement $u_z \;/\; 10^{-3} L_0$")
    bar.outline.set_linewidth(0.5)
    if magnify != 1:
        panels[-1].text(1, 0.98, f"shape: $u_z$ × {magnify:g}", transform=panels[-1].transAxes, va="top", ha="right")
    axes = bottom.subplots()
    draw_profiles(axes, output, profiles)
    axes.set_title(f"({LETTERS[len(drawn)]})", loc="left")
    return picture
