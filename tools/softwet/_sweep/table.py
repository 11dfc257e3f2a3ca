"""sweep.csv."""

import csv
import difflib
import sys

from .._store.files import write_csv
from ..program import WARNING

# The columns of history.csv without --columns: what a droplet does.
COLUMNS = ["x_centre", "velocity", "angle_left", "angle_right", "ridge_left", "ridge_right", "dimple", "mass_drift"]


class Table:
    """sweep.csv: a row per member, in the order of the members."""

    def __init__(self, path, keys, members, columns):
        self.path, self.keys, self.members, self.columns = path, keys, members, columns
        self.kept, self.warned = {}, set()  # rows of ended members; columns that are missing

    def write(self):
        names = ["member", *self.keys, "status", "exit", "reason", "seconds", "steps", "t", *self.columns, "velocity_peak"]
        write_csv(self.path, [names, *map(self.row, self.members)])

    def row(self, member):
        state, note = member.status()
        ended = state in ("done", "failed")
        if ended and self.kept.get(member.name, (None,))[0] == note:
            return self.kept[member.name][1]
        record = member.record() if note else {}
        end = ["", ""] if state == "running" else [note.get("exit"), note.get("reason")]
        row = [member.name, *member.values, state, *end,
               f"{note['seconds']:.2f}" if note else "", record.get("counts", {}).get("steps"),
               record.get("stop", {}).get("t"), *self.from_history(member, bool(record), state == "done")]
        if ended:
            self.kept[member.name] = (note, row)
        return row

    def from_history(self, member, begun, complete):
        """Last values of the columns, and the largest |velocity| at t >= 0, the start of the load. Empty for a member
        that is not done: what it had come to is no result beside the results of the others."""
        rows = []
        if begun:
            try:
                with open(member.folder / "history.csv", newline="") as file:
                    rows = [row for row in csv.DictReader(file) if None not in row.values()]  # whole rows
            except FileNotFoundError:  # a run that starts anew has just removed it
                pass
        if rows:
            self.warn(member, list(rows[0]))
        if not rows or not complete:
            return [""] * (len(self.columns) + 1)
        speeds = [abs(float(row["velocity"])) for row in rows if row.get("velocity") and float(row["t"]) >= 0]
        return [*(rows[-1].get(name, "") for name in self.columns), max(speeds, default="")]

    def warn(self, member, names):
        for name in sorted(set(self.columns) - set(names) - set(COLUMNS) - self.warned):
            self.warned.add(name)
            near = difflib.get_close_matches(name, names, 1, 0)[0]
            print(f"{WARNING}--columns {name}: history.csv of {member.name} has no such column; did you mean '{near}'?",
                  file=sys.stderr)
