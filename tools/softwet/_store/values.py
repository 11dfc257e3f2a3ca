"""Values of a key as a command line has them: lists and ranges, and the folders that are named after them."""

import hashlib
import re
from fractions import Fraction

from .._tools.messages import fail

LARGEST = 10000  # members
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
        fail(f"{option} {key}: {value} is not a range; a:b:n means n values, 2 to {LARGEST}, from a to b, for example "
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


def number(text):
    """The number that a value means, which may be a fraction; raises ValueError."""
    above, _, below = text.partition("/")
    return float(above) / float(below or 1)
