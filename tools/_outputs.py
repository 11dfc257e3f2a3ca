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


ANEW = "is it cut? 'softwet check CASE' prints what belongs there"


class Problem(Exception):
    """A sentence for the user."""


def check_number(name, value, low, high):
    """Refuses a number outside of [low, high], and NaN."""
    if not low <= value <= high:
        raise Problem(f"{name} {value:g}: must be a number in [{low:g}, {high:g}]")


def read_table(path, *needed):
    """Columns of a CSV file as arrays; an empty cell is NaN. @param needed  columns that must be there"""
    if not path.is_file():
        raise Problem(f"there is no {path}")
    try:
        with open(path, newline="") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        numbers = np.array([[float(cell) if cell else math.nan for cell in row] for row in rows[1:]])
        table = dict(zip(rows[0], numbers.T, strict=True)) if len(rows) > 1 else {}
    except (OSError, ValueError, csv.Error) as error:
        raise Problem(f"{path} is not a table of numbers: {error}") from error
    if not table:
        raise Problem(f"{path} has no rows yet")
    missing = [name for name in needed if name not in table]
    if missing:
        raise Problem(f"{path} has no column {missing[0]}, only {', '.join(table)}; name the columns in its first line")
    return table


class CaseTable(dict):
    """A table of a case.toml: a key that is not there is a Problem, since the file has every key of the case."""

    def __init__(self, path, table):
        self.path = path
        super().__init__((key, self.wrap(value)) for key, value in table.items())

    def wrap(self, value):
        if isinstance(value, list):
            return [self.wrap(entry) for entry in value]
        return CaseTable(self.path, value) if isinstance(value, dict) else value

    def __missing__(self, key):
        raise Problem(f"{self.path} has no '{key}': {ANEW}")


def read_case(folder):
    path = folder / "case.toml"
    if not path.is_file():
        raise Problem(f"{folder} is not an output folder of softwet run: it has no case.toml")
    try:
        case = CaseTable(path, tomllib.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError) as error:
        raise Problem(f"cannot read {path}: {error}; {ANEW}") from error
    for table in ("domain", "output"):  # the first and the last of each case: the file is whole
        case[table]
    return case


def read_series(path):
    """[(time, name)] of the field files that a .series lists."""
    try:
        return [(float(entry["time"]), str(entry["name"])) for entry in json.loads(path.read_text())["files"]]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Problem(f"cannot read {path}: {error}; is it cut? compute the case again with --overwrite") from error


def field_files(folder):
    """{time: {"fluid": path, "solid": path}} of the field files there are, without what the case has not."""
    case = read_case(folder)
    series = {kind: folder / "fields" / f"{kind}.hdf.series"
              for kind, table in (("fluid", "fluid"), ("solid", "substrate")) if table in case}
    missing = [path for path in series.values() if not path.is_file()]
    if len(missing) == len(series):
        raise Problem(f"{folder / 'fields'} holds no field files; give the case output.fields.times")
    if missing:
        raise Problem(f"there is no {missing[0]}, but the case writes one; compute the case again with --overwrite")
    found = {}
    for kind, path in series.items():
        for time, name in read_series(path):
            found.setdefault(time, {})[kind] = path.parent / name
    found = {time: files for time, files in found.items() if len(files) == len(series)}  # a run may be writing now
    if not found:
        raise Problem(f"{folder / 'fields'} holds no field files yet")
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
    if not abs(time - wanted) <= 1e-6 * max(1.0, abs(wanted)):  # NaN is no time either
        raise Problem(f"no fields at t = {wanted:g}; there are: {', '.join(f'{t:g}' for t in sorted(available))}")
    return time


def refine(values):
    """Two points per element and the ends: the quadratic of each element at eight points, and the last end."""
    first, middle, last = values[:-2:2], values[1:-1:2], values[2::2]
    s = np.arange(8)[:, None] / 8
    inside = first * (1 - s) * (1 - 2 * s) + middle * 4 * s * (1 - s) + last * s * (2 * s - 1)
    return np.append(inside.T.ravel(), values[-1])
