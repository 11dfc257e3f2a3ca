"""The pictures of tools/report: the scene, and the fields at some times in two and three dimensions."""

import textwrap

import numpy as np

from .._drawing.fields import Scene
from .._drawing.look import GREY, Problem, axis_names, is_axisymmetric, length, lift, matplotlib, refine
from .._drawing.scene_picture import draw, with_first_state


NO_DENSITY = "the field files hold no density\n(output.fields.select)"


def scene(figure, run):
    """The scene as it was before the run, or a sentence where the program cannot make its first state. @return its
    panels"""
    try:
        return with_first_state(run.folder / "case.toml", [], lambda state: draw(figure, state, size=6))
    except Problem as problem:
        figure.text(0.5, 0.5, "\n".join(textwrap.wrap(f"no picture of the scene: {problem}", 60)), ha="center", va="center",
                    color=GREY, fontsize=6)
        return []


def chosen_times(run, most=3):
    """At most so many field times: the first from 0 on, the last, and others between."""
    times = [t for t in run.times if t >= 0] or run.times
    if len(times) <= most:
        return times
    return [times[round(i * (len(times) - 1) / (most - 1))] for i in range(most)]


def flat(figure, run, times):
    """Density and vertical displacement in two dimensions."""
    scenes = [Scene(run, t) for t in times]
    limit = max((np.abs(s.vertical_displacement()).max() for s in scenes if s.solid), default=0) or 1.0
    panels, images = figure.subplots(1, len(scenes), squeeze=False, sharey=True)[0], {}
    for scene, axes in zip(scenes, panels):
        if scene.has_density:
            images[r"$\rho / b$"] = scene.draw_fluid(axes)
            scene.outline(axes, colors="black", linewidths=0.9)
        elif scene.fluid:
            axes.text(0.5, 0.95, NO_DENSITY, transform=axes.transAxes, ha="center", va="top", color=GREY, fontsize=6)
        if scene.solid:
            images[lift(run.case)] = scene.draw_solid(axes, limit)
            scene.draw_loads(axes)
        width, height = run.case["domain"]["size"]
        axes.set(aspect="equal", xlim=(-width if is_axisymmetric(run.case) else 0, width), ylim=(scene.lowest, height))
        axes.locator_params(nbins=4)
    for label, image in images.items():
        figure.colorbar(image, ax=list(panels), label=label, aspect=14, shrink=0.8)
    return panels


def deep(figure, run, times):
    """Droplets on the deformed substrate in three dimensions."""
    from .._drawing.scene3d import Output, Scene as Scene3d, View
    output = Output(run.folder)
    view = View(output.track)
    scenes = [Scene3d(output, t, 1.0, view) for t in times]
    limit = max(scene.lifted() for scene in scenes) or 1e-3
    panels = figure.subplots(1, len(scenes), squeeze=False)[0]
    for scene, axes in zip(scenes, panels):
        image = scene.draw(axes, limit, scenes[0])
    figure.colorbar(image, ax=list(panels), label=r"$u_z / 10^{-3} L_0$", aspect=14, shrink=0.8)
    return panels


def section(figure, run, times):
    """Density in the vertical plane through the middle along x: three dimensions without a substrate."""
    size, panels = run.case["domain"]["size"], figure.subplots(1, len(times), squeeze=False, sharey=True)[0]
    x, z = np.linspace(0, size[0], 160), np.linspace(0, size[2], 120)
    places = np.stack(np.broadcast_arrays(x, 0.5 * size[1], z[:, None]), axis=-1)
    for time, axes in zip(times, panels):
        density = run.fields(time).at(places)["density"]
        image = axes.pcolormesh(x, z, density, cmap="Blues", vmin=0, vmax=1, shading="gouraud", rasterized=True)
        axes.set(aspect="equal")
        axes.locator_params(nbins=4)
    figure.colorbar(image, ax=list(panels), label=r"$\rho / b$, middle plane", aspect=14, shrink=0.8)
    return panels


def has_moved(walls):
    """Whether the wall has an upright displacement at some of the times. @param walls  of run.interface"""
    return any(np.ptp(wall["displacement_y"]) > 0 for wall in walls.values())


def wall(axes, run, units):
    """The upright displacement of the wall at all field times, in two dimensions. @param units  in which it is shown"""
    walls, across = run.interface, units.of("x_reference", "interface")[1]
    upright = across if units.named else 1e3  # rises are shown in thousandths of L0
    for (time, points), colour in zip(walls.items(), matplotlib.colormaps["viridis"](np.linspace(0, 0.88, len(walls)))):
        x = refine(points["x_reference"] + points["displacement_x"])
        shown = f"$t = {time * units.of('t')[1]:.4g}$ {units.of('t')[0]}".rstrip()
        axes.plot(across * x, upright * refine(points["displacement_y"]), color=colour, label=shown)
    axes.axhline(0, color=GREY, linewidth=0.6, zorder=0)
    names = axis_names(run.case)
    axes.set(xlabel=f"${names[0]}$ / µm" if units.named else length(names[0]),
             ylabel=f"$u_{names[1]}$ / µm" if units.named else lift(run.case), title="vertical displacement of the interface",
             xlim=(0, across * run.case["domain"]["size"][0]))


def fields(figure, run):
    """Fields at some times, or a sentence where there are none. @return axes, one for each picture"""
    times = chosen_times(run)
    if not times:
        figure.text(0.5, 0.5, "no field files: the case gives no output.fields.times", ha="center", color=GREY)
        return []
    draw = flat if run.dimension == 2 else deep if "solid" in run.parts else section
    if run.dimension == 3 and "fluid" in run.parts and "density" not in run.fields(times[0]):
        figure.text(0.5, 0.5, NO_DENSITY, ha="center", color=GREY)
        return []
    if draw is deep:
        from .._drawing.scene3d import pyvista
        try:
            pyvista()
        except Problem as problem:
            figure.text(0.5, 0.5, problem, ha="center", color=GREY, fontsize=6)
            return []
    panels = draw(figure, run, times)
    for time, axes in zip(times, panels):
        axes.set_title(f"$t = {time:g}$", loc="left")
    return list(panels)
