"""Tables of numbers: history.csv, interface.csv, and tables to compare with."""

import csv
import math
import os

from .problem import Problem


def read_rows(path, growing=False):
    """Names of the columns and rows of numbers; an empty cell is nan. Lines that begin with # are comments.
    @param growing  a run may be writing the file: a last line without its end is left out"""
    if not os.path.isfile(path):
        raise Problem(f"there is no {path}")
    try:
        with open(path, newline="") as file:
            lines = [line for line in file if not line.startswith("#")]
        if growing and lines and not lines[-1].endswith("\n"):
            lines.pop()
        names, *rows = csv.reader(lines) if lines else [[]]
        numbers = [[float(cell) if cell else math.nan for cell in row] for row in rows]
        if any(len(row) != len(names) for row in numbers):
            raise ValueError(f"a row does not have the {len(names)} cells of the first line")
    except (OSError, ValueError, csv.Error) as error:
        raise Problem(f"{path} is not a table of numbers: {error}") from error
    return names, numbers


def read_table(path, *needed, growing=False):
    """Columns of a CSV file as arrays by name; an empty cell is nan.
    @param needed  columns that must be there;  raises Problem where one is missing or there are no rows"""
    import numpy
    names, rows = read_rows(path, growing)
    if not rows:
        raise Problem(f"{path} has no rows yet")
    table = dict(zip(names, numpy.array(rows).T))
    missing = [name for name in needed if name not in table]
    if missing:
        raise Problem(f"{path} has no column {missing[0]}, only {', '.join(table)}; name the columns in its first line")
    return table


def last_row(path):
    """The last whole row of a table as {column: number}, without its empty cells; {} where there is none."""
    try:
        with open(path, "rb") as file:
            names = file.readline().decode().strip().split(",")
            begin = file.tell()
            file.seek(0, os.SEEK_END)
            file.seek(max(begin, file.tell() - 65536))
            lines = file.read().decode(errors="replace").split("\n")[:-1]  # what follows the last end is not whole
        cells = lines[-1].split(",") if lines else []
        return {name: float(cell) for name, cell in zip(names, cells) if cell} if len(cells) == len(names) else {}
    except (OSError, ValueError):
        return {}


class ByTime(dict):
    """Values by time: [t] finds the time that is equal but for rounding; another one is a Problem.
    @param what  they are, for the message"""

    def __init__(self, values, what):
        super().__init__(values)
        self.what = what

    def time(self, wanted):
        """The time of the entry that `wanted` means."""
        found = min(self, key=lambda t: abs(t - wanted), default=math.nan)
        if not abs(found - wanted) <= 1e-6 * max(1.0, abs(wanted)):  # NaN is no time either
            there = ", ".join(f"{t:g}" for t in sorted(self)) or "none"
            raise Problem(f"no {self.what} at t = {wanted:g}; there are: {there}")
        return found

    def __missing__(self, wanted):
        return self[self.time(wanted)]
