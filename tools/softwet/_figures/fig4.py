"""Fig. 4: a droplet moved by a load in three dimensions. A, B: start and end; C: the surface along the diagonal.

The table holds, at the times of C, the place of the droplet along the track (counted from the middle of the domain),
its contact points and angles, its distance from the diagonal plane, and extremes and ends of the surface along the
track."""

from pathlib import Path

from .._drawing.output3d import Output, profile
from .._drawing.look import Problem, np
from .._drawing.scene3d import figure

TIMES = (63.0, 125.0, 188.0, 251.0)


def add_arguments(parser):
    parser.add_argument("folder", metavar="OUT", type=Path, help="output folder of cases/fig4_needle_3d.toml")
    add_view(parser, TIMES)


def add_view(parser, times):
    parser.add_argument("--magnify", metavar="M", type=float, default=1.0, help="stretch the vertical displacement")
    parser.add_argument("--times", metavar="T", type=float, nargs="+", default=times,
                        help="of C, the last one of B too; default: the paper's")


def draw(options):
    picture = figure(options.folder, [0, options.times[-1]], list(options.times), options.magnify)
    return picture, table(options.folder, options.times)


def table(folder, times):
    """One row per quantity, one column per time; empty where a droplet has none."""
    output = Output(folder)
    history = output.run.history
    if "track_front" not in history:
        raise Problem(f"{folder}: history.csv has no droplets of a run in three dimensions")
    rows = [["quantity", *times]]
    at = [int(np.argmin(np.abs(history["t"] - time))) for time in times]
    for column in history:
        if column.startswith(("contact_area", "x_centre", "track_", "velocity", "angle_")):
            rows.append([column, *(number(history[column][i]) for i in at)])
    rows.append(["x_centre - y_centre", *(number(history["x_centre"][i] - history["y_centre"][i]) for i in at)])
    surfaces = [profile(output, time) for time in times]
    for name, pick in (("highest", np.argmax), ("lowest", np.argmin)):
        rows.append([f"u_z {name}", *(number(lift[pick(lift)]) for _, lift in surfaces)])
        rows.append([f"track of u_z {name}", *(number(s[pick(lift)]) for s, lift in surfaces)])
    for name, end in (("behind", 0), ("in front", -1)):
        rows.append([f"u_z at the end {name}", *(number(lift[end]) for _, lift in surfaces)])
    rows.append(["mass_drift", *(number(history["mass_drift"][i]) for i in at)])
    return rows


def number(value):
    return "" if np.isnan(value) else f"{value:.4g}"
