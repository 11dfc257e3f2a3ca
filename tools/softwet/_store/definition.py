"""What a sweep computes: the values of --vary, and how the folder of a sweep keeps them. Parts of it serve tradeoff."""

import hashlib
import itertools
import json
import re
from fractions import Fraction

from .._tools.messages import fail
from .member import read_json, write_atomic

LARGEST = 10000  # members
LONGEST_CASE = 16 << 20  # bytes, as in softwet
NUMBER = r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d\d?)?)(?:/(\d+))?"


def member_name(keys, values, whole=False):
    """Name of a folder. @param whole  with whole keys, not the last part of each where that is enough"""
    leaves = [key if whole else key.rpartition(".")[2] for key in keys]
    shown = [leaf if leaves.count(leaf) == 1 else key for key, leaf in zip(keys, leaves)]
    parts = [f"{key}={re.sub('[^A-Za-z0-9.+-]+', '_', value).strip('_')}" for key, value in zip(shown, values)]
    name = re.sub(r"[^A-Za-z0-9.+=_-]", "_", "__".join(parts))
    return name if len(name) <= 150 else f"{name[:140]}_{hashlib.sha1(name.encode()).hexdigest()[:9]}"


def split_values(text):
    """Parts of a list: at commas outside brackets, parentheses and quotes."""
    parts, depth, quote = [""], 0, ""
    for c in text:
        if quote:
            quote = "" if c == quote else quote
        elif c in "\"'":
            quote = c
        depth += 0 if quote else (c in "([{") - (c in ")]}")
        if c == "," and not quote and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return [part.strip() for part in parts]


def expand(key, value, option="--vary"):
    """n numbers from a to b where the value is a:b:n, with equal ratios where it is a:b:n:log, otherwise the value."""
    if re.fullmatch(rf"{NUMBER}:{NUMBER}:?", value):
        fail(f"{option} {key}: {value} is a range without the number of values; write {value.rstrip(':')}:4 for 4 values, "
             "both ends included")
    found = re.fullmatch(rf"{NUMBER}:{NUMBER}:(\d{{1,9}})(:log)?", value)
    if not found:
        return [value]
    *ends, count, ratios = found.groups()
    count = int(count)
    if not 2 <= count <= LARGEST or 0 in [int(below or 1) for below in ends[1::2]]:
        fail(f"{option} {key}: {value} is no range; a:b:n means n values, 2 to {LARGEST}, from a to b, for example "
             "0:0.45:4")
    first, last = (Fraction(above) / int(below or 1) for above, below in zip(ends[::2], ends[1::2]))
    if ratios:
        if not first * last > 0:
            fail(f"{option} {key}: {value} asks for equal ratios, and the ends of such a range have the same sign and are not 0; "
                 f"write {value.removesuffix(':log')} for equal steps")
        middle = [float(first) * float(last / first) ** (i / (count - 1)) for i in range(1, count - 1)]
        return [repr(float(p)) for p in (first, *middle, last)]
    points = [first + (last - first) * i / (count - 1) for i in range(count)]
    return [str(p) if p.denominator == 1 else repr(float(p)) for p in points]


def one_spelling(key):
    """load[0].ramp and load[00].ramp as load.ramp: spellings of one key."""
    return re.sub(r"\[0+(?=\d+\])", "[", key).replace("[0]", "")


def read_vary(assignments, settings):
    """[(key, values)] of --vary."""
    vary, taken = [], {one_spelling(setting.partition("=")[0]) for setting in settings}
    for assignment in assignments:
        key, equals, text = assignment.partition("=")
        if not equals or not key:
            fail(f"--vary {assignment} is no list of values; write --vary KEY=V1,V2,..., for example "
                 "--vary substrate.poisson=0,0.15,0.3")
        values = [value for part in split_values(text) for value in expand(key, part)]
        twice = [value for i, value in enumerate(values) if value in values[:i]]
        if "" in values or twice:
            fail(f"--vary {assignment}: " + (f"{twice[0]} is there twice" if "" not in values else "a value is empty") +
                 "; write each value once, separated by commas")
        if one_spelling(key) in taken:
            fail(f"{key} is set twice; give it to one --vary or one --set")
        taken.add(one_spelling(key))
        vary.append((key, values))
    return vary


def values_of(vary):
    """{key: its values, as a set} of a list of KEY=V1,V2,..."""
    return {key: set(split_values(text)) for key, _, text in (entry.partition("=") for entry in vary)}


def has_all(some, other):
    """Whether `some` varies the same keys in the same order as `other` over at least its values."""
    mine, theirs = values_of(some), values_of(other)
    return list(mine) == list(theirs) and all(theirs[key] <= mine[key] for key in mine)


def case_difference(old, new):
    """What differs between two texts of a case, in words."""
    lines = itertools.zip_longest(old["case"].splitlines(), new["case"].splitlines())
    changed = [(number, was, now) for number, (was, now) in enumerate(lines, 1) if was != now]
    told = "line {} of the case was {!r} and is {!r} now"
    return told.format(*changed[0]) if changed else "the line ends of the case changed"


def option_difference(old, new, option):
    """What differs between the words of an option, in words; empty where nothing does."""
    gone, new_ones = (" ".join(f"--{option} {word}" for word in some[option] if word not in other[option])
                      for some, other in ((old, new), (new, old)))
    if gone or new_ones:
        return f"it was made {f'with {gone}' if gone else f'without {new_ones}'}" + (
            f", not with {new_ones}" if gone and new_ones else "")
    return f"its --{option} came in another order" if old[option] != new[option] else ""


def difference(old, new, part):
    """What forbids the sweep `new` in the folder of `old`, in words; empty where nothing does. Values may be added.
    @param part  `new` may also have fewer values: a task of an array script from before they were added"""
    if old["case"] != new["case"]:
        return case_difference(old, new)
    grown = has_all(new["vary"], old["vary"]) or (part and has_all(old["vary"], new["vary"]))
    told = (option_difference(old, new, option) for option in (("set",) if grown else ("vary", "set")))
    return next(filter(None, told), "")


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


def read_definition(arguments, vary):
    """Case and values as they are kept in sweep.json; refuses a folder that holds others."""
    new = {"case": read_case(arguments.case), "vary": [f"{key}={','.join(values)}" for key, values in vary],
           "set": arguments.set}
    old = read_json(arguments.out / "sweep.json")
    told = difference(old, new, arguments.member is not None) if old else ""
    if told:
        fail(f"{arguments.out} holds another sweep: {told}; values may be added to --vary, the rest must stay: give the "
             "same case and options, or a new folder with --out")
    return new


def keep_definition(arguments, definition):
    """What the members are made of, kept so that a later change of the case reaches none of them. Values that were
    added are kept too."""
    old = read_json(arguments.out / "sweep.json")
    if old and (old == definition or arguments.member is not None):
        return
    arguments.out.mkdir(parents=True, exist_ok=True)
    if not old:
        write_atomic(arguments.out / "sweep.toml", definition["case"])
    write_atomic(arguments.out / "sweep.json", json.dumps(definition, indent=1) + "\n")
