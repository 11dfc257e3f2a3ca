"""Results of `softwet tradeoff`: one row per member, the Pareto front, and the table as text, CSV, JSON and Markdown."""

import functools
import json
import math

from .._store.files import write_atomic, write_csv
from .measures import MEASURES, OWN, UNITS, about, measure
from softwet import open as open_output

COSTS = {"seconds": ("seconds", "total"), "processor": (), "steps": ("counts", "steps"),
         "residuals": ("counts", "residuals"), "products": ("counts", "products"), "krylov": ("counts", "krylov"),
         "memory_mib": ("peak_memory_mib",)}
DISTURBED = ("seconds", "processor", "memory_mib")  # costs that differ from one run to the next; the others are exact
SHOWN = ("krylov", "products", "residuals", "memory_mib")
NEAR = 1.15  # a member is near the front where none is better by this factor in cost and error


class Entry:
    """A member and its results. kind: base, reference, companion, parameter or combination"""

    def __init__(self, kind, setting, member):
        self.kind, self.setting, self.member = kind, setting, member
        self.costs, self.errors, self.front = {}, {}, False
        self.refresh()

    def refresh(self):
        """How the member stands, and what it cost."""
        self.state, self.note = ("refused", {}) if self.setting.refusal else self.member.status()
        self.reason = self.setting.refusal or self.note.get("reason", "")
        record = self.member.record() if self.state in ("done", "failed") else {}
        found = {name: functools.reduce(lambda part, key: part.get(key, {}), keys, record) for name, keys in COSTS.items()}
        self.costs = {**{name: None if value == {} else value for name, value in found.items()},
                      "processor": self.note.get("processor") if record else None}

    @property
    def label(self):
        """What the tables call it."""
        return self.setting.label if self.kind in ("parameter", "combination") else self.kind


def compare(entries):
    """Fills in the errors of all members that are done.
    @return {measure: estimated error of the reference}; None where it is not known"""
    by_kind = {entry.kind: entry for entry in entries}
    reference, companion = by_kind["reference"], by_kind.get("companion")
    if reference.state != "done":
        return {}
    truth = open_output(reference.member.folder)
    for entry in entries:
        if entry.state == "done" and not entry.errors:
            entry.errors = measure(open_output(entry.member.folder), truth)
            entry.errors = {name: None if math.isnan(value) else value for name, value in entry.errors.items()}
            if entry is reference:
                entry.errors = {name: entry.errors[name] if name in OWN else None for name in MEASURES}
    if not companion or companion.state != "done":
        return {}
    order = companion.order
    divisor = 2 ** order - 1 if order else 1
    return {name: value / divisor for name, value in companion.errors.items() if value is not None and name not in OWN}


def error_of(entry, name, floor):
    """The error of a member, not less than what the reference itself is off."""
    value = entry.errors.get(name)
    return None if value is None else max(value, floor.get(name, 0))


def computed(entry):
    """What a member did: two with the same exact costs and errors differ by nothing but disturbances of their time."""
    return (*(value for name, value in entry.costs.items() if name not in DISTURBED), *entry.errors.values())


def rated(entries, name, floor, cost):
    """[(entry, cost, error)] of the members that a reader may choose from: all but the reference and its companion.
    Members that computed the same have the smallest cost of any of them."""
    chosen = [entry for entry in entries if entry.kind not in ("reference", "companion") and entry.state == "done"
              and entry.costs[cost] and error_of(entry, name, floor) is not None]
    least = {}
    for entry in chosen:
        least[computed(entry)] = min(entry.costs[cost], least.get(computed(entry), math.inf))
    return [(entry, least[computed(entry)], error_of(entry, name, floor)) for entry in chosen]


def like_base(entries):
    """The members that computed the same as the base."""
    return [entry for entry in entries[1:] if entry.state == "done" and computed(entry) == computed(entries[0])]


def beaten(seconds, error, others, factor=1.0):
    """Whether one of [(entry, seconds, error)] is as good in both and better in one, by the factor."""
    return any(s * factor <= seconds and e * factor <= error and (s * factor, e * factor) != (seconds, error)
               for _, s, e in others)


def mark_front(entries, name, floor, cost):
    """Marks the Pareto front: no other member is both cheaper and nearer to the reference. @return that of rated"""
    points = rated(entries, name, floor, cost)
    for entry, spent, error in points:
        entry.front = not beaten(spent, error, points)
    return points


def near_front(points):
    return [point for point in points if not beaten(*point[1:], points, NEAR)]


# --- cells

def ratio(entry, base, cost):
    """Cost over that of the base; None where one is not known."""
    return entry.costs[cost] / base.costs[cost] if entry.costs[cost] and base.costs[cost] else None


def number(value, digits=3):
    return "" if value is None else f"{value:.{digits}g}" if abs(value) < 10 ** digits else f"{value:.0f}"


def error_cell(entry, name, floor):
    value, limit = entry.errors.get(name), floor.get(name)
    if entry.kind == "reference" and name not in OWN:
        return f"~ {number(limit, 2)}" if limit is not None else ""
    if value is None:
        return ""
    return f"<= {number(limit, 2)}" if limit and value <= limit else number(value)


def shown_measures(entries):
    return [name for name in MEASURES if any(entry.errors.get(name) is not None for entry in entries)]


def cells(entry, base, names, floor, cost):
    """What a row of the table shows: mark, setting, costs, errors."""
    costs = [number(ratio(entry, base, cost)), number(entry.costs[cost]), *(number(entry.costs[c], 4) for c in SHOWN)]
    return ["*" if entry.front else "", entry.label, *costs, *(error_cell(entry, name, floor) for name in names)]


def heads(names, cost):
    spent = "seconds" if cost == "seconds" else f"{cost} s"
    return ["", "setting", "x base", spent, *SHOWN, *(f"{name} {UNITS[name]}".strip() for name in names)]


def table_rows(entries, names, floor, cost):
    done = [entry for entry in entries if entry.state == "done"]
    return [heads(names, cost), *(cells(entry, entries[0], names, floor, cost) for entry in done)]


def others(entries):
    """(setting, why it has no numbers) of the members that are not done."""
    told = [(entry.label, "does not apply" if entry.state == "refused" else entry.state, entry.reason.partition("; ")[0])
            for entry in entries if entry.state != "done"]
    return [(label, f"{state}: {reason}" if reason else state) for label, state, reason in told]


def terminal(entries, floor, cost):
    """The table for a terminal."""
    names = shown_measures(entries)
    rows = table_rows(entries, names, floor, cost)
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(cell.ljust(w) if i < 2 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths))).rstrip()
             for row in rows]
    return "\n".join([*lines, *(f"{setting}: {why}" for setting, why in others(entries))])


def markdown(entries, floor, notes, cost):
    names = shown_measures(entries)
    rows = table_rows(entries, names, floor, cost)
    lines = [f"| {' | '.join(f'`{cell}`' if i == 1 and '=' in cell else cell for i, cell in enumerate(row))} |"
             for row in rows]
    lines.insert(1, "|" + "---|" * len(rows[0]))
    left = [f"- `{setting}`: {why}" for setting, why in others(entries)]
    return "\n".join([*notes, "", *lines, *(["", "Without numbers:", "", *left] if left else []), "",
                      *(f"- **{name}**: {about(name)}" for name in names), ""])


def records(entries, cost):
    """One dict per member, for CSV and JSON: numbers as they are, None where there is none."""
    base = entries[0]
    return [{"member": entry.setting.name if entry.kind in ("parameter", "combination") else entry.kind, "kind": entry.kind,
             "parameters": " ".join(entry.setting.parameters), "settings": entry.setting.label, "status": entry.state,
             "reason": entry.reason, "front": int(entry.front), "ratio": ratio(entry, base, cost), **entry.costs,
             **{name: entry.errors.get(name) for name in MEASURES}} for entry in entries]


def write_table(path, entries, cost):
    rows = records(entries, cost)
    write_csv(path, [rows[0], *([f"{value:.6g}" if isinstance(value, float) else value for value in row.values()] for row in rows)])


def write_json(path, entries, floor, facts, cost):
    document = {**facts, "measures": {name: {"unit": UNITS[name], "definition": about(name)} for name in MEASURES},
                "reference_error": floor, "members": records(entries, cost)}
    write_atomic(path, json.dumps(document, indent=1, allow_nan=False) + "\n")
