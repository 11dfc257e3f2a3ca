"""The folder of a sweep."""

import csv
import json
import math
import pathlib
from fractions import Fraction
from functools import cached_property

from .problem import Problem
from .run import Run


def value_of(text):
    """A value of --vary: a number, a list, or else the text."""
    try:
        return float(Fraction(text)) if "/" in text else float(text)
    except (ValueError, ZeroDivisionError):
        pass
    try:
        return json.loads(text)
    except ValueError:
        return text.strip("\"'")


class Member:
    """One run of a sweep. name, folder;  values  {key: value} of --vary;  row  its cells in sweep.csv, as texts;
    status  waiting, running, interrupted, done or failed, as sweep.csv gives it"""

    def __init__(self, name, folder, values, row):
        self.name, self.folder, self.values, self.row = name, folder, values, row
        self.status = row.get("status", "")

    def __repr__(self):
        return f"<member {self.name}{': ' if self.status else ''}{self.status}>"

    @cached_property
    def run(self):
        """Its output folder, a Run; raises Problem where it has not begun."""
        return Run(self.folder)


class Sweep:
    """Members of a sweep in their order: iterate over it, count them with len, take one with [i].

    A folder without sweep.csv that holds output folders is taken too; its members have no values.
    table  {column of sweep.csv: list of numbers and texts, nan where a cell is empty}, for pandas.DataFrame"""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if (self.folder / "sweep.csv").is_file():
            self.keys, self.members = self._from_table()
        else:
            found = [path.parent for path in sorted(self.folder.glob("*/case.toml"))]
            self.keys, self.members = [], [Member(path.name, path, {}, {}) for path in found]
        if not self.members:
            raise Problem(f"{folder} holds no output folder; write it with softwet sweep")

    def _from_table(self):
        try:
            vary = json.loads((self.folder / "sweep.json").read_text())["vary"]
            keys = [entry.partition("=")[0] for entry in vary]
            with open(self.folder / "sweep.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            members = [Member(row["member"], self.folder / row["member"], {key: value_of(row[key]) for key in keys}, row)
                       for row in rows]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise Problem(f"cannot read the sweep {self.folder}: {error!r}; 'softwet sweep ... --table' writes its table "
                          "again") from error
        return keys, members

    @cached_property
    def table(self):
        """The columns of sweep.csv."""
        names = list(self.members[0].row) or ["member"]
        rows = [member.row or {"member": member.name} for member in self.members]
        return {name: [math.nan if row[name] == "" else value_of(row[name]) for row in rows] for name in names}

    def __iter__(self):
        return iter(self.members)

    def __len__(self):
        return len(self.members)

    def __getitem__(self, number):
        return self.members[number]
