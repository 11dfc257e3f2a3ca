"""The keys of a case that follow the width of the interface.

With half the width the same liquid has twice the scale a of its equation of state, since its surface tension in units
of a case is proportional to fluid.capillarity; the length L0 and the density b stay. So a number whose unit has a to
the power p is multiplied by the ratio of the widths to that power: moduli and tensions by the ratio, times by its
inverse root."""

import re
import subprocess

from .._tools.messages import fail
from ..definition import toml_text

WIDTH = "fluid.capillarity"
OF_MESH = ("domain.elements", "domain.grading")  # the mesh has a rule of its own


def power_of_a(unit):
    """The power of a in a unit: 1 in "a b^2 L0", -1/2 in "L0/sqrt(ab)"."""
    above, *below = unit.split("/")
    return power_in(above) - sum(map(power_in, below))


def power_in(factors):
    roots = len(re.findall(r"sqrt\(ab\)", factors))
    return roots / 2 + len(re.findall(r"(?<![\w(])ab?(?![\w^)])", factors))


def units_of_keys(program):
    """{key: unit} of all keys that have one, keys of repeated tables without their brackets: from the page of the
    reference, which has a table of keys below the name of each table of a case."""
    told = subprocess.run([str(program), "explain", "--markdown"], capture_output=True, text=True)
    if told.returncode:
        fail(told.stderr.strip(), told.returncode)
    units, table, place = {}, "", None
    for line in told.stdout.splitlines():
        cells = [cell.strip().strip("`") for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if line.startswith("#"):
            table, place = re.sub(r"[`\[\]# ]", "", line), None
        elif cells[:1] == ["key"]:
            place = cells.index("unit")
        elif place is not None and len(cells) > place and cells[place] not in ("", "---"):
            units[f"{table}.{cells[0]}"] = cells[place]
    return units


def keys_of(tables, name=""):
    """(key with the numbers of its entries, the same without, value) of all keys of a resolved case."""
    for key, value in tables.items():
        plain = f"{name}.{key}".lstrip(".")
        if isinstance(value, dict):
            yield from keys_of(value, plain)
        elif isinstance(value, list) and value and all(isinstance(entry, dict) for entry in value):
            for number, entry in enumerate(value):
                yield from keys_of(entry, f"{plain}[{number}]")
        else:
            yield plain, re.sub(r"\[\d+\]", "", plain), value


class Rescaling:
    """@param units  {key: unit};  @param ratio  the width over the one that the case is written for"""

    def __init__(self, units, ratio):
        self.powers = {key: power_of_a(unit) for key, unit in units.items()}
        self.ratio = ratio

    def settings(self, case):
        """{key: text} of all keys that change. @param case  the resolved case"""
        changed = {WIDTH: toml_text(case["fluid"]["capillarity"] * self.ratio)}
        for name, plain, value in keys_of(case):
            if plain == WIDTH or plain.startswith(OF_MESH) or without_effect(plain, case):
                continue
            new = self.over_time(plain, self.value(name, value, self.factor(plain)))
            if new != value:
                changed[name] = toml_text(new)
        return changed

    def factor(self, plain):
        return self.ratio ** self.powers.get(plain, 0)

    def value(self, name, value, factor):
        """A number, an expression, or a list of these, times a factor."""
        if factor == 1 or isinstance(value, bool):
            return value
        if isinstance(value, list):
            return [self.value(name, entry, factor) for entry in value]
        if isinstance(value, (int, float)):
            return value * factor
        return scaled_text(name, value, factor) if value else value

    def over_time(self, plain, value):
        """A factor or a path that varies in time: its times follow the width."""
        if plain not in ("load.factor", "load.path", "needle.path"):
            return value
        longer = self.ratio ** -0.5
        if isinstance(value, list) and value and all(isinstance(row, list) for row in value):
            return [[row[0] * longer, *row[1:]] for row in value]
        if isinstance(value, list):
            return [self.over_time(plain, entry) for entry in value]
        if not isinstance(value, str):
            return value
        refuse_table(plain, value)
        return re.sub(r"\bt\b", f"(t*{1 / longer!r})", value)


def without_effect(plain, case):
    """Whether the program would warn that a key says nothing in this case: without sticking lines nothing creeps."""
    return plain == "fluid.creep_speed" and not case["fluid"]["contact_angle_range"]


def scaled_text(name, text, factor):
    """A range of times "first:last:count", or an expression."""
    if found := re.fullmatch(r"\s*([^:]+):([^:]+):(\d+)\s*", text):
        first, last, count = found.groups()
        return f"{float(first) * factor!r}:{float(last) * factor!r}:{count}"
    refuse_table(name, text)
    return f"({text})*{factor!r}"


def refuse_table(name, text):
    if re.search(r"\.(csv|h5|hdf5?|txt|dat)\s*$", text):
        fail(f"{name} = \"{text}\": a table in a file cannot follow the width of the interface; write it as an expression")
