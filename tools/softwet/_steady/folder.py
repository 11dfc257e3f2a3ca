"""The folder of `softwet steady --along`: what is computed in it, what of that is there already, and the names of its
states.."""

import csv
import math
import os
import shutil

from .._store.definition import Definition
from .._store.files import take
from .._store.values import member_name
from .._tools.messages import fail

TABLE, LOG = "states.csv", "steady.log"
OTHERS = "replace it with --overwrite, or choose another folder with --out"


class StatesFolder:
    """A folder that holds the states of one command. The same command again finds those that are there and goes on. The
    folder is locked as long as the command lives."""

    def __init__(self, arguments, key, values):
        self.path, self.key, self.names = arguments.out, key, set()
        definition = Definition(self.path / "along.json", arguments.case, along=[arguments.along], set=arguments.set)
        if (self.path / "sweep.json").exists():
            fail(f"{self.path} holds a sweep; choose another folder with --out")
        if not arguments.overwrite:
            self.refuse_others(definition, values)
        self.path.mkdir(parents=True, exist_ok=True)
        self.hold()
        if arguments.overwrite:
            self.remove_states()
        self.kept = self.read_states()
        definition.keep()

    def refuse_others(self, definition, values):
        """Refuses a folder that holds something else, before anything changes."""
        told = definition.difference("along", "set")
        if told:
            fail(f"{self.path} holds the states of another command: {told}; give the same case and options to go on, or "
                 f"{OTHERS}")
        if not definition.old and (self.path / TABLE).exists():
            fail(f"{self.path} holds the states of an earlier command; {OTHERS}")
        for folder in (self.path / member_name([self.key], [value]) for value in values):
            if folder.exists() and not definition.old:
                fail(f"{folder} exists already, and is not a state of this command; {OTHERS}")

    def hold(self):
        self.descriptor = os.open(self.path, os.O_RDONLY)
        if not take(self.descriptor):
            fail(f"another command is writing to {self.path} at this moment; wait for its end, or choose another folder with "
                 "--out")

    def remove_states(self):
        for old in self.path.iterdir():
            if (old / LOG).is_file():
                shutil.rmtree(old)
        (self.path / TABLE).unlink(missing_ok=True)

    def read_states(self):
        """Rows of the table, in the order in which they were found."""
        try:
            with open(self.path / TABLE, newline="") as file:
                return [read_row(row) for row in csv.DictReader(file)]
        except FileNotFoundError:
            return []

    def name(self, value):
        """A folder of its own for a value, also where a branch comes to it again, or where two values have one name."""
        first = name = member_name([self.key], [value])
        count = 1
        while name in self.names:
            count += 1
            name = f"{first}_{count}"
        self.names.add(name)
        return self.path / name

    def next_kept(self, value, folder):
        """The row of the next state, where an earlier command has computed it; else None, and what came after it counts
        no more, for it began from another state."""
        row = self.kept.pop(0) if self.kept else {}
        if (row.get("value"), row.get("folder")) == (value, folder.name) and all(
                (folder / name).is_file() for name in (LOG, "run.json")):
            return row
        self.kept = []
        return None


def read_row(row):
    """A row as the table has written it."""
    (_, value), *cells = row.items()
    return {"value": value, **{name: content(cell) for name, cell in cells}}


def content(cell):
    """What a cell holds: a whole number, a number (nan where it is empty), or else its text."""
    if not cell:
        return math.nan
    for kind in (int, float):
        try:
            return kind(cell)
        except ValueError:
            continue
    return cell
