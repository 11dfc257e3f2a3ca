"""The picture of the states that `softwet steady --along` has found."""

import math

import matplotlib
import softwet
from .._store.values import number
from .._drawing.look import BLUE, GREEN, RED, STYLE, axis_names, letter, with_unit
from softwet.units import OF_THE_CASE
from .table import FOUND, HISTORY
from matplotlib import pyplot as plt

LIKE = {"ridge": "dimple"}  # the column of history.csv that has the same unit
PANELS = [  # columns, their names, what the axis shows; a column of history.csv has its unit
    (("ridge", "dimple"), ("highest", "lowest"), "rise of the wall"),
    (("x_left", "x_right", "x_centre"), ("left", "right", "middle"), "contact lines"),
    (("track_rear", "track_front"), ("rear", "front"), "contact lines"),
    (("angle_left", "angle_right"), ("left", "right"), "apparent angle"),
    (("angle_rear", "angle_front"), ("rear", "front"), "apparent angle"),
    (("growth_rate",), ("",), r"growth rate / $(\sqrt{ab}/L_0)$"),
    (("laplace",), ("",), r"$\mu - \mu_{sat}$"),
]


def place_of(text):
    """The number that a value means; None where it means none."""
    try:
        return number(text)
    except ValueError:
        return None


def draw_walls(axes, folder, rows, key, units):
    """The wall of each state, coloured by its value."""
    factor = units.of("dimple")[1]
    colours = matplotlib.colormaps["viridis"]
    for order, row in enumerate(rows):
        run = softwet.open(folder / row["folder"])
        wall = run.interface[run.times[-1]]
        axes.plot(factor * (wall["x_reference"] + wall["displacement_x"]), factor * wall["displacement_y"], lw=0.9,
                  color=colours(order / max(1, len(rows) - 1)),
                  label=row["value"] if order in (0, len(rows) - 1) else None)
    across, upright = axis_names(run.case)
    axes.set(xlabel=with_unit(f"${across}$", "dimple", units=units), ylabel=with_unit(f"$u_{upright}$", "dimple", units=units),
             title=f"wall, {key}")
    axes.legend(frameon=False)


def draw_states(path, key, rows):
    found = [row for row in rows if row["state"] == FOUND]
    units = softwet.open(path.parent / found[0]["folder"]).units if found else OF_THE_CASE
    values = [place_of(row["value"]) for row in found]
    numbers = None not in values
    places = values if numbers else list(range(len(found)))
    panels = [panel for panel in PANELS if any(math.isfinite(row.get(panel[0][0], math.nan)) for row in found)]
    plane = any("ridge" in row and "x_left" in row for row in found)
    with plt.rc_context(STYLE):
        count = len(panels) + plane
        figure, all_axes = plt.subplots(1, count, figsize=(3.4 * count, 2.9), squeeze=False, layout="constrained")
        for axes, (columns, names, label) in zip(all_axes[0], panels):
            for column, name, colour in zip(columns, names, (BLUE, RED, GREEN)):
                heights = [row.get(column, math.nan) * units.of(LIKE.get(column, column))[1] for row in found]
                axes.plot(places, heights, "o-", ms=3, color=colour, label=name or None)
            like = LIKE.get(columns[0], columns[0])
            axes.set(xlabel=key, ylabel=with_unit(label, like, units=units) if like in [*HISTORY, "dimple"] else label)
            if names[0]:
                axes.legend(frameon=False)
            if not numbers:
                axes.set_xticks(places, [row["value"] for row in found])
        if plane:
            draw_walls(all_axes[0][-1], path.parent, found, key, units)
        for order, axes in enumerate(all_axes[0]):
            letter(axes, order)
        figure.savefig(path)
        plt.close(figure)
