"""What the runs of a folder are made of: the text of the case and the words of some options."""

import itertools
import json

from .._tools.messages import fail
from .files import read_json, write_atomic

LONGEST_CASE = 16 << 20  # bytes, as in softwet


class Definition:
    """It is kept in a file of the folder, so that a later change of the case reaches none of the runs.

    new, old  {"case": text, option: words}, as the command has it and as the folder has it: {} where it has none"""

    def __init__(self, file, case, **options):
        self.file, self.new, self.old = file, {"case": read_case(case), **options}, read_json(file)

    def difference(self, *options):
        """What forbids the command in the folder, in words: another case, or other words of these options. Empty where
        nothing does."""
        if not self.old:
            return ""
        if self.old["case"] != self.new["case"]:
            return case_difference(self.old["case"], self.new["case"])
        told = (option_difference(self.old[option], self.new[option], option) for option in options)
        return next(filter(None, told), "")

    def keep(self, copy=None):
        """Writes it. @param copy  file for the case, beside it, at the first time"""
        self.file.parent.mkdir(parents=True, exist_ok=True)
        if copy and not self.old:
            write_atomic(self.file.with_name(copy), self.new["case"])
        write_atomic(self.file, json.dumps(self.new, indent=1) + "\n")


def case_difference(old, new):
    """What differs between two texts of a case, in words."""
    lines = itertools.zip_longest(old.splitlines(), new.splitlines())
    changed = [(number, was, now) for number, (was, now) in enumerate(lines, 1) if was != now]
    told = "line {} of the case was {!r} and is {!r} now"
    return told.format(*changed[0]) if changed else "the line ends of the case changed"


def option_difference(old, new, option):
    """What differs between the words of an option, in words; empty where nothing does."""
    gone, new_ones = (" ".join(f"--{option} {word}" for word in some if word not in other)
                      for some, other in ((old, new), (new, old)))
    if gone or new_ones:
        return f"it was made {f'with {gone}' if gone else f'without {new_ones}'}" + (
            f", not with {new_ones}" if gone and new_ones else "")
    return f"its --{option} came in another order" if old != new else ""


def read_case(path):
    """The text of a case; refuses a path that has none."""
    try:
        with open(path, "rb") as file:
            text = file.read(LONGEST_CASE + 1)
        if len(text) > LONGEST_CASE:
            fail(f"cannot read the case file '{path}': it is longer than 16 MiB, which no case is")
        return text.decode(errors="surrogateescape")
    except OSError as error:
        fail(f"cannot read the case file '{path}': {error.strerror}; give the path of a case, for example "
             "cases/tensotaxis_pull_2d.toml")
