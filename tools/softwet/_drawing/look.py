"""What the tools that draw share: how a picture looks, and small helpers. Output folders are read by softwet/."""

import re

import matplotlib
import numpy as np

import softwet
from softwet import Problem
from softwet.units import OF_THE_CASE

matplotlib.use("Agg")

STYLE = {
    "font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "legend.fontsize": 8, "mathtext.fontset": "dejavusans",
    "axes.linewidth": 0.7, "lines.linewidth": 1.3, "savefig.dpi": 140, "axes.formatter.limits": (-3, 4),
    "axes.formatter.use_mathtext": True, "axes.titlelocation": "right",
    "pdf.fonttype": 42, "ps.fonttype": 42, "svg.fonttype": "none",  # letters stay letters, as journals ask
}
BLUE, RED, GREEN, GREY, ORANGE, PURPLE = "#1f5fa8", "#c0392b", "#2e8b57", "0.55", "#d98200", "#7d4ea8"
TIME = r"$t \;/\; L_0\,(ab)^{-1/2}$"
FEW = 25  # with fewer points a curve shows them


def check_number(name, value, low, high):
    """Refuses a number outside of [low, high], and NaN."""
    if not low <= value <= high:
        raise Problem(f"{name} {value:g}: must be a number in [{low:g}, {high:g}]")


def is_axisymmetric(case):
    """Whether the left side is an axis of symmetry; pictures then show the half on its other side too."""
    return case["domain"].get("coordinates") == "axisymmetric"


def axis_names(case):
    """What the axes of a scene in 2D are called: r and z about an axis of symmetry."""
    return "rz" if is_axisymmetric(case) else "xy"


def length(name):
    """The label of a length."""
    return rf"${name} \;/\; L_0$"


def lift(case):
    """The label of the upright displacement."""
    return rf"$u_{axis_names(case)[1]} \;/\; 10^{{-3}} L_0$"


def unit_of(column, dimension=2):
    """The unit of a column of history.csv for a label, as the program has it; "" where there is no program to ask.
    @param dimension  d of the unit"""
    try:
        unit = softwet.columns()[column].unit
    except Problem:
        return ""
    if unit in ("", "degrees"):
        return unit
    unit = unit.replace("^(d-1)", f"^{dimension - 1}").replace("^d", f"^{dimension}").replace("L0", "L_0")
    return "$" + re.sub(r"/sqrt\((\w+)\)", r"\\,(\1)^{-1/2}", unit).replace("sqrt(ab)", "(ab)^{1/2}") + "$"


def with_unit(text, column, dimension=2, units=OF_THE_CASE):
    """A label: what is shown, and the unit of its column."""
    unit = units.of(column)[0].replace("um", "µm") or unit_of(column, dimension)
    return f"{text} / {unit}" if unit else text


def markers(count):
    """Style of a curve through so many points: few are shown, so that nobody takes the line between them as
    computed."""
    return {"marker": "o", "markersize": 3} if count < FEW else {}


def letter(axes, number):
    """(a), (b), ... above the upper left corner of a panel, before its titles, which follow it so that they cannot meet
    it."""
    titles = [axes.get_title(loc=place) for place in ("left", "right")]
    axes.set_title("  ".join([f"({chr(ord('a') + number)})", *filter(None, titles)]), loc="left")
    axes.set_title("", loc="right")


def fraction_of(load, case, time):
    """The part of a load that acts at a time of the results: 0 before its start, then rising over its ramp to its
    factor, which counts as 1 where it is an expression or a table. Loads start on the clock of the computation; time 0
    of the results is the start of the first one."""
    since = time - (load["start"] - min(other["start"] for other in case["load"]))
    if since < 0 or (since == 0 and load["ramp"] > 0):
        return 0.0
    factor = load.get("factor", 1.0)
    return (1.0 if load["ramp"] == 0 else min(1.0, since / load["ramp"])) * (1.0 if isinstance(factor, str) else factor)


def refine(values):
    """Two points per element and the ends: the quadratic of each element at eight points, and the last end."""
    first, middle, last = values[:-2:2], values[1:-1:2], values[2::2]
    s = np.arange(8)[:, None] / 8
    inside = first * (1 - s) * (1 - 2 * s) + middle * 4 * s * (1 - s) + last * s * (2 * s - 1)
    return np.append(inside.T.ravel(), values[-1])
