"""What the tools that draw share: the files of an output folder as arrays, and how a picture looks."""

import csv
import json
import math
import sys
import tomllib
from pathlib import Path

try:
    import h5py
    import matplotlib
    import numpy as np
except ImportError as missing:
    sys.exit(f"{Path(sys.argv[0]).name}: {missing}; on Debian: apt-get install python3-h5py python3-matplotlib "
             "python3-numpy, and start with /usr/bin/python3")
matplotlib.use("Agg")

STYLE = {
    "font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "legend.fontsize": 8, "mathtext.fontset": "dejavusans",
    "axes.linewidth": 0.7, "lines.linewidth": 1.3, "savefig.dpi": 140, "axes.formatter.limits": (-3, 4),
    "axes.formatter.use_mathtext": True, "axes.titlelocation": "right",
}
BLUE, RED, GREEN, GREY = "#1f5fa8", "#c0392b", "#2e8b57", "0.55"
UNIT = {"t": r"$t \;/\; L_0\,(ab)^{-1/2}$", "x": r"$x \;/\; L_0$", "y": r"$y \;/\; L_0$"}


class Problem(Exception):
    """A sentence for the user."""


def read_table(path):
    """Columns of a CSV file as arrays; an empty cell is NaN."""
    if not path.is_file():
        raise Problem(f"there is no {path}")
    with open(path, newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    if len(rows) < 2:
        raise Problem(f"{path} has no rows yet")
    try:
        numbers = np.array([[float(cell) if cell else math.nan for cell in row] for row in rows[1:]])
        return dict(zip(rows[0], numbers.T, strict=True))
    except ValueError as error:
        raise Problem(f"{path} is not a table of numbers: {error}") from error


def read_case(folder):
    path = folder / "case.toml"
    if not path.is_file():
        raise Problem(f"{folder} is not an output folder of softwet run: it has no case.toml")
    with open(path, "rb") as file:
        return tomllib.load(file)


def field_files(folder):
    """{time: {"fluid": path, "solid": path}} of the field files there are."""
    found = {}
    for kind in ("fluid", "solid"):
        series = folder / "fields" / f"{kind}.vtkhdf.series"
        if series.is_file():
            for entry in json.loads(series.read_text())["files"]:
                found.setdefault(entry["time"], {})[kind] = series.parent / entry["name"]
    if not found:
        raise Problem(f"{folder / 'fields'} holds no field files; give the case output.fields.times")
    return found


class Block:
    """Points and fields of one file as arrays of shape (rows, points per row)."""

    def __init__(self, path):
        try:
            with h5py.File(path) as file:
                root = file["VTKHDF"]
                if root["Types"][0] != 28:  # VTK_BIQUADRATIC_QUAD
                    raise Problem(f"{path} is not two-dimensional; open it in ParaView")
                points = root["Points"][:]
                shape = (-1, int(root["Connectivity"][3]) // 2)  # the first cell's corner two rows up
                self.x, self.y = points[:, 0].reshape(shape), points[:, 1].reshape(shape)
                self.field = {name: data[:].reshape(*self.x.shape, *data.shape[1:])
                              for name, data in root["PointData"].items()}
        except (OSError, KeyError) as error:
            raise Problem(f"cannot read {path}: {error}") from error

    def stretch(self, low, high, magnify):
        """Magnifies the vertical displacement of points whose reference rows are uniform from low to high."""
        rest = np.linspace(low, high, len(self.y))[:, None]
        self.y = rest + magnify * (self.y - rest)


def nearest(available, wanted):
    time = min(available, key=lambda t: abs(t - wanted))
    if abs(time - wanted) > 1e-6 * max(1.0, abs(wanted)):
        raise Problem(f"no fields at t = {wanted:g}; there are: {', '.join(f'{t:g}' for t in sorted(available))}")
    return time


def refine(values):
    """Two points per element and the ends: the quadratic of each element at eight points, and the last end."""
    first, middle, last = values[:-2:2], values[1:-1:2], values[2::2]
    s = np.arange(8)[:, None] / 8
    inside = first * (1 - s) * (1 - 2 * s) + middle * 4 * s * (1 - s) + last * s * (2 * s - 1)
    return np.append(inside.T.ravel(), values[-1])
