"""Pictures of runs in three dimensions: droplets on the deformed substrate, and the profile of its surface.

PyVista renders the surfaces, without a display too. matplotlib draws lines and labels, which stay sharp in a PDF."""

import itertools

from . import look as outputs
from .output3d import Output, profile, track_line
import matplotlib
import matplotlib.pyplot as plt
import numpy as np

LIQUID = (0.36, 0.62, 0.86)
RED, GREEN = "#c0392b", "#2e8b57"
ORDER = [RED, GREEN, "#d4a017", "#1f5fa8"]  # red, green, yellow, blue: the times of Figs. 4C and 5C of the paper
COLOURS = "PuOr_r"
LIGHT = (-0.45, 0.55, 0.70)  # to the left, above, towards the eye
LETTERS = "ABCDEFGHI"  # of the scenes and of the profile
PIXELS = 1500  # of the longer side of a rendered picture


def pyvista():
    """The library, which says nothing of a display that is not there. Raises Problem where it is missing."""
    try:
        import pyvista as library
        from vtkmodules.vtkCommonCore import vtkLogger
    except ImportError as missing:
        raise outputs.Problem(f"{missing}; pictures in 3D need PyVista: python3 -m pip install pyvista") from missing
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    return library


# --- the view --------------------------------------------------------------------------------------------------------
class View:
    """Orthographic view: the eye `turn` degrees around the track from its right-hand side, `rise` above the horizon."""

    def __init__(self, track, turn=16.0, rise=30.0):
        around, up = np.arctan2(track[1], track[0]) + np.radians(turn - 90), np.radians(rise)
        self.eye = np.array([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])
        self.right = np.array([-np.sin(around), np.cos(around), 0.0])
        self.up = np.cross(self.eye, self.right)

    def flat(self, points):
        """Places on the page."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def render(self, axes, mesh, zorder, alpha=1.0, **look):
        """Draws a pyvista mesh to scale into axes whose coordinates are places on the page."""
        page = self.flat(np.array(list(itertools.product(*np.reshape(mesh.bounds, (3, 2))))))
        low, high = page.min(axis=0), page.max(axis=0)
        pixels = np.maximum(np.ceil(PIXELS * (high - low) / max(high - low)), 2).astype(int)
        plotter = pyvista().Plotter(off_screen=True, window_size=[int(n) for n in pixels], lighting="none")
        plotter.add_light(pyvista().Light(position=LIGHT, light_type="camera light"))
        plotter.add_mesh(mesh, smooth_shading=True, show_scalar_bar=False, **look)
        centre, across = np.array(mesh.center), float(mesh.length) or 1.0
        plotter.camera_position = [centre + 2 * across * self.eye, centre, self.up]
        plotter.enable_parallel_projection()
        plotter.camera.parallel_scale = 0.5 * (high - low)[1]
        plotter.camera.clipping_range = (across, 3 * across)
        plotter.enable_anti_aliasing("ssaa")
        image = plotter.screenshot(transparent_background=True, return_img=True)
        plotter.close()
        x, y = self.flat(centre)
        half = 0.5 * (high - low)[1] * np.array([pixels[0] / pixels[1], 1])
        axes.imshow(image, extent=(x - half[0], x + half[0], y - half[1], y + half[1]), zorder=zorder, alpha=alpha,
                    interpolation="antialiased")


# --- the scene -------------------------------------------------------------------------------------------------------
class Scene:
    """What is plotted at one time."""

    def __init__(self, output, time, magnify, view):
        self.output, self.time, self.magnify, self.view = output, time, magnify, view

    def mesh(self, part, field):
        """The part of the scene as a pyvista grid, with the vertical displacement magnified."""
        pyvista()
        places = self.output.run.fields(self.time, part)
        grid = places.to_pyvista(field)
        grid["lift"] = grid.points[:, 2] - np.repeat(places.lines[0], len(grid.points) // len(places.lines[0]))
        grid.points[:, 2] += (self.magnify - 1) * grid["lift"]
        return grid

    def lifted(self):
        """The largest vertical displacement of the surface."""
        return np.abs(self.output.run.fields(self.time, "solid").moved(slice(-1, None))[..., 2]).max()

    def draw(self, axes, limit, first):
        """@param limit colours from -limit to limit, displacement in L0; @param first the scene of the dashed line"""
        image = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(-1e3 * limit, 1e3 * limit), COLOURS)
        solid = self.mesh("solid", "displacement")
        self.view.render(axes, solid, 1, scalars="lift", cmap=COLOURS, clim=(-limit, limit), ambient=0.7, diffuse=0.36,
                         split_sharp_edges=True)
        self.draw_rims(axes, solid)
        self.draw_on_wall(axes, track_line(self.output)[1], color=GREEN, linewidth=1.0, zorder=2.5)
        if first is not self:
            for line in first.output.contact_lines(first.time):
                self.draw_on_wall(axes, line, color="black", linewidth=1.0, linestyle=(0, (4, 2.5)), zorder=3)
        self.draw_loads(axes)
        self.draw_droplet(axes)
        if first is self:
            self.draw_axes(axes, self.view.flat(solid.points))
        axes.set_aspect("equal")
        axes.set_axis_off()
        axes.autoscale_view()
        return image

    def draw_rims(self, axes, solid):
        """The edges of the top, and of the sides that the eye sees."""
        nx, ny, nz = solid.dimensions
        points = solid.points.reshape(nz, ny, nx, 3)
        faces = [points[-1]]
        for axis, side in itertools.product((0, 1), (0, -1)):
            if self.view.eye[axis] * (-1 if side == 0 else 1) > 0:
                faces.append(points[:, :, side] if axis == 0 else points[:, side])
        for face in faces:
            rim = np.concatenate([face[0], face[1:, -1], face[-1, -2::-1], face[-2::-1, 0]])
            axes.plot(*self.view.flat(rim).T, color="0.25", linewidth=0.6, zorder=2, solid_joinstyle="round")

    def draw_droplet(self, axes):
        if self.output.middle is None:
            return
        droplet = self.mesh("fluid", "density").contour([self.output.middle], scalars="density")
        if droplet.n_points:
            self.view.render(axes, droplet, 4, alpha=0.68, color=LIQUID, ambient=0.5, diffuse=0.5, specular=0.55, specular_power=40)
        for line in self.output.contact_lines(self.time):
            self.draw_on_wall(axes, line, color="#173a5e", linewidth=0.9, zorder=3.2)

    def draw_on_wall(self, axes, places, **style):
        points = self.output.on_wall(self.time, places, self.magnify)
        axes.plot(*self.view.flat(points).T, solid_joinstyle="round", **style)

    def draw_axes(self, axes, page):
        """The directions of the coordinates, in the lower left corner. @param page  places of the substrate"""
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

    def draw_loads(self, axes):
        """Boxes where the solid has carried them, and the direction of the force: an arrow while the load acts, shorter
        while it grows. The boxes of needles have full lines."""
        for needle in self.output.case.get("needle", []):
            self.draw_box(axes, np.array(needle["box"], dtype=float), "-")
        for load in self.output.case.get("load", []):
            box, force = np.array(load["box"], dtype=float), np.array(load["force"], dtype=float)
            self.draw_box(axes, box, (0, (3, 1.5)))
            part = outputs.fraction_of(load, self.output.case, self.time)
            if not force.any() or part == 0:
                continue
            centre = self.output.carried(self.time, np.array([[*box.mean(axis=0)[:2], box[1, 2]]]), self.magnify)[0]
            reach = part * 0.13 * self.output.size[0] * force / np.linalg.norm(force)
            tail, head = self.view.flat(np.array([centre - reach, centre + reach]))
            axes.annotate("", head, tail, zorder=6, arrowprops={"arrowstyle": "-|>,head_width=0.28,head_length=0.55",
                                                                "color": RED, "linewidth": 1.8, "shrinkA": 0,
                                                                "shrinkB": 0})

    def draw_box(self, axes, box, style):
        """The twelve edges of a box. @param box  its low and its high corner"""
        for axis, *others in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            for corner in itertools.product((0, 1), repeat=2):
                line = np.linspace(*box, 25)
                line[:, others] = box[corner, others]
                points = self.output.carried(self.time, line, self.magnify)
                axes.plot(*self.view.flat(points).T, color=RED, linewidth=0.9, linestyle=style, zorder=3.5)


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
    limit = max(scene.lifted() for scene in drawn) or 1e-3
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
