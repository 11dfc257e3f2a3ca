"""Fluid and solid of one time of an output folder on axes: density, displacement, streamlines, outline, loads."""

from .look import RED, Problem, fraction_of, is_axisymmetric, np
from matplotlib.tri import LinearTriInterpolator, Triangulation

NEAR = 4  # capillarities from a contact line to the edge of its close-up


class Block:
    """Where a part of the scene is plotted, x and y of shape (rows, points per row), and its fields.
    @param magnify   of the vertical displacement
    @param mirrored  the mirror image at x = 0 is plotted too"""

    def __init__(self, field, magnify, mirrored):
        self.field, self.mirrored = field, mirrored
        rest, now = field.reference[..., 1], field.positions
        self.x = self.both(now[..., 0], -1)
        self.y = self.both(rest + magnify * (now[..., 1] - rest))

    def both(self, values, sign=1):
        """Values at the points that are plotted; in the mirror image they have the sign."""
        return np.concatenate([sign * values[:, :0:-1], values], axis=1) if self.mirrored else values.copy()


class Scene:
    """What is plotted at one time of a softwet.Run in 2D."""

    def __init__(self, run, time, magnify=1.0):
        if run.dimension != 2:
            raise Problem(f"{run.folder} is not two-dimensional; tools/figures3d or ParaView draw its fields")
        self.time, self.case = run.time(time), run.case
        self.fluid, self.solid = (Block(run.fields(time, part), magnify, is_axisymmetric(self.case))
                                  if part in run.parts else None for part in ("fluid", "solid"))

    @property
    def has_density(self):
        """Not where output.fields.select leaves it out."""
        return self.fluid is not None and "density" in self.fluid.field

    @property
    def lowest(self):
        """Where the picture ends below: at 0, or where the solid or the fluid hangs lower."""
        return min([0.0, *(block.y.min() for block in (self.solid, self.fluid) if block)])

    def middle(self):
        """(density at the points, halfway between its extremes); nan where there is no droplet."""
        density = self.fluid.both(self.fluid.field["density"])
        low, high = density.min(), density.max()
        return density, 0.5 * (low + high) if high > 2 * low else np.nan

    def outline(self, axes, **style):
        """The droplet: density halfway between its extremes."""
        density, middle = self.middle()
        if middle > 0:
            axes.contour(self.fluid.x, self.fluid.y, density, levels=[middle], **style)

    def contact(self):
        """Where the outline meets the soft wall at the right, as a place in the picture; None where it does not."""
        if not self.solid or not self.has_density:
            return None
        density, middle = self.middle()
        row = density[0] - middle
        ends = np.flatnonzero(row[1:] * row[:-1] < 0)
        if not len(ends):
            return None
        i = ends[-1]
        share = row[i] / (row[i] - row[i + 1])
        return np.array([(1 - share) * line[0, i] + share * line[0, i + 1] for line in (self.fluid.x, self.fluid.y)])

    def close_up(self, axes):
        """Axes in an upper corner for what lies around the contact line, with its frame in the picture; None where
        there is none, where it would be enlarged less than twice, or where a droplet is in both corners."""
        place, (left, right), (low, high) = self.contact(), axes.get_xlim(), axes.get_ylim()
        side = min(0.5 * (high - low), 0.4 * (right - left))
        reach = NEAR * self.case["fluid"]["capillarity"] if place is not None else np.inf
        if side < 4 * reach:
            return None
        density, middle = self.middle()
        for corner in (right - 1.02 * side, left + 0.02 * side):
            inside = (abs(self.fluid.x - corner - 0.5 * side) < 0.6 * side) & (self.fluid.y > high - 1.1 * side)
            above = place[1] + reach < high - 1.02 * side or not -reach < place[0] - corner < side + reach
            if above and not (density[inside] > middle).any():
                box = [corner, high - 1.02 * side, side, side]
                inset = axes.inset_axes(box, transform=axes.transData, xlim=place[0] + [-reach, reach], ylim=place[1] + [-reach, reach],
                                        xticks=[], yticks=[])
                axes.indicate_inset_zoom(inset, edgecolor="0.2", linewidth=0.6)
                return inset
        return None

    def draw_fluid(self, axes, darkest=1.0):
        """The density, from white to the blue of the density `darkest`."""
        return axes.pcolormesh(self.fluid.x, self.fluid.y, self.fluid.both(self.fluid.field["density"]), cmap="Blues",
                               vmin=0, vmax=darkest, shading="gouraud", rasterized=True)

    def quantity(self, name):
        """A field of the fluid, or with _x or _y at its end a component of a vector."""
        vector, _, axis = name.rpartition("_")
        if axis in ("x", "y") and vector in self.fluid.field:
            return self.fluid.both(self.fluid.field[vector][..., "xy".index(axis)], -1 if axis == "x" else 1)
        values = self.fluid.field[name]
        if values.ndim != 2:
            raise Problem(f"{name} is not a scalar; give a component of it, {name}_x or {name}_y")
        return self.fluid.both(values)

    def draw_quantity(self, axes, name, ends):
        """A field of the fluid between two values; red and blue where it has both signs."""
        return axes.pcolormesh(self.fluid.x, self.fluid.y, self.quantity(name), cmap="RdBu_r" if ends[0] < 0 else "viridis",
                               vmin=ends[0], vmax=ends[1], shading="gouraud", rasterized=True)

    def velocity(self, columns, rows):
        """A uniform grid over the fluid, and both components of the velocity there; masked outside."""
        x = np.linspace(self.fluid.x.min(), self.fluid.x.max(), columns)
        y = np.linspace(self.fluid.y.min(), self.fluid.y.max(), rows)
        mesh = Triangulation(self.fluid.x.ravel(), self.fluid.y.ravel())
        at = np.meshgrid(x, y)
        velocity = self.fluid.field["velocity"]
        both = (self.fluid.both(velocity[..., 0], -1), self.fluid.both(velocity[..., 1]))
        return x, y, *(LinearTriInterpolator(mesh, component.ravel())(*at) for component in both)

    def draw_streamlines(self, axes, **style):
        """Streamlines of the fluid; `colour_speed` = (colour map, norm) colours them by the speed."""
        x, y, u, v = self.velocity(161, 81)
        look = {"color": "0.25", "linewidth": 0.5, "arrowsize": 0.6, "density": 1.1}
        if "colour_speed" in style:
            look["color"] = np.hypot(u, v)
            look["cmap"], look["norm"] = style.pop("colour_speed")
        return axes.streamplot(x, y, u, v, **(look | style))

    def vertical_displacement(self):
        return 1e3 * self.solid.both(self.solid.field.moved()[..., 1])

    def draw_solid(self, axes, limit):
        image = axes.pcolormesh(self.solid.x, self.solid.y, self.vertical_displacement(), cmap="PuOr_r", vmin=-limit,
                                vmax=limit, shading="gouraud", rasterized=True)
        axes.plot(self.solid.x[-1], self.solid.y[-1], color="0.2", linewidth=0.8)
        return image

    def fill_solid(self, axes, colour):
        """The deformed solid in one colour."""
        axes.fill_between(self.solid.x[-1], 0.0, self.solid.y[-1], facecolor=colour, edgecolor="none")
        axes.plot(self.solid.x[-1], self.solid.y[-1], color="0.2", linewidth=0.8)

    def load_ring(self, load):
        """Columns and rows of points around the box of a load or a needle."""
        size, wall = self.case["domain"]["size"], self.case["substrate"]["thickness"]
        rows, last = self.solid.x.shape[0], self.solid.x.shape[1] - 1
        axis = last // 2 if self.solid.mirrored else 0  # the column of x = 0
        (x0, y0), (x1, y1) = load["box"]
        i0, i1 = (axis + round(x / size[0] * (last - axis)) for x in (x0, x1))
        j0, j1 = (round(y / wall * (rows - 1)) for y in (y0, y1))
        ring = [(j0, i) for i in range(i0, i1)] + [(j, i1) for j in range(j0, j1)] + \
               [(j1, i) for i in range(i1, i0, -1)] + [(j, i0) for j in range(j1, j0 - 1, -1)]
        return ring + ring[:1], ((j0 + j1) // 2, (i0 + i1) // 2)

    def draw_loads(self, axes, colour=RED):
        """The loaded boxes where the solid has carried them, and the direction of the force: an arrow while the load
        acts, shorter while it grows. The boxes of needles have a full line."""
        for needle in self.case.get("needle", []):
            j, i = np.array(self.load_ring(needle)[0]).T
            axes.plot(self.solid.x[j, i], self.solid.y[j, i], color=colour, linewidth=1.1)
        for load in self.case.get("load", []):
            ring, middle = self.load_ring(load)
            j, i = np.array(ring).T
            axes.plot(self.solid.x[j, i], self.solid.y[j, i], color=colour, linewidth=1.1, linestyle=(0, (4, 2)))
            part = fraction_of(load, self.case, self.time)
            if not np.any(load["force"]) or part == 0:
                continue
            half = part * 0.032 * self.case["domain"]["size"][0] * np.array(load["force"]) / np.linalg.norm(load["force"])
            centre = np.array([self.solid.x[middle], self.solid.y[middle]])
            axes.annotate("", centre + half, centre - half,
                          arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.3})
