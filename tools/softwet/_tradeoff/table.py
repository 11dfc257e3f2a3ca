"""Results of `softwet tradeoff`: a data frame with a row for each member, the Pareto front, and the table as text, CSV,
JSON and Markdown."""

import functools
import json

import pandas

from .._store.files import write_atomic
from .measures import MEASURES, OWN, UNITS, about, measure
from softwet import open as open_output

COSTS = {"seconds": ("seconds", "total"), "processor": (), "steps": ("counts", "steps"),
         "residuals": ("counts", "residuals"), "products": ("counts", "products"), "krylov": ("counts", "krylov"),
         "memory_mib": ("peak_memory_mib",)}
COUNTS = ["steps", "residuals", "products", "krylov"]  # costs that are exact; the others differ from one run to the next
EXACT = [*COUNTS, *MEASURES]  # two members that agree in these computed the same
SHOWN = ["krylov", "products", "residuals", "memory_mib"]
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


def frame_of(entries, cost="seconds"):
    """The members as a data frame, one row each: what it is, its costs and errors, nan where there is none."""
    frame = pandas.DataFrame([
        {"member": entry.setting.name if entry.kind in ("parameter", "combination") else entry.kind, "kind": entry.kind,
         "parameters": " ".join(entry.setting.parameters), "settings": entry.setting.label, "status": entry.state,
         "reason": getattr(entry, "reason", ""), "front": int(entry.front), "ratio": None,
         **{name: values.get(name) for known, values in ((COSTS, entry.costs), (MEASURES, entry.errors)) for name in known}}
        for entry in entries])
    frame = frame.astype({**dict.fromkeys([*COSTS, *MEASURES], float), **dict.fromkeys(COUNTS, "Int64")})
    spent = frame[cost].where(frame[cost] > 0)
    frame["ratio"] = spent / spent[0]
    return frame


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
    reference.errors = {name: value for name, value in reference.errors.items() if name in OWN}
    if not companion or companion.state != "done":
        return {}
    divisor = 2 ** companion.order - 1 if companion.order else 1
    return {name: value / divisor for name, value in companion.errors.items() if name not in OWN}


def rated(entries, name, floor, cost):
    """[(entry, cost, error)] of the members that a reader may choose from: all but the reference and its companion. An
    error is not less than what the reference itself is off. Members that computed the same have the smallest cost of
    any of them."""
    frame = frame_of(entries)
    frame["error"] = frame[name].clip(lower=floor.get(name, 0))
    chosen = frame[~frame.kind.isin(["reference", "companion"]) & frame.status.eq("done") & frame[cost].gt(0) & frame.error.notna()]
    least = chosen.groupby(EXACT, dropna=False)[cost].transform("min")
    return [(entries[i], float(least[i]), float(chosen.error[i])) for i in chosen.index]


def like_base(entries):
    """The members that computed the same as the base."""
    frame = frame_of(entries)
    exact = frame[EXACT].astype(float).fillna(-1)
    same = exact.eq(exact.loc[0]).all(axis=1) & frame.status.eq("done")
    return [entry for entry, is_same in zip(entries[1:], same[1:]) if is_same]


def beaten(seconds, error, others, factor=1.0):
    """Whether one of [(entry, seconds, error)] is as good in both and better in one, by the factor."""
    return any(s * factor <= seconds and e * factor <= error and (s * factor, e * factor) != (seconds, error)
               for _, s, e in others)


def mark_front(entries, name, floor, cost):
    """Marks the Pareto front: no other member is both cheaper and nearer to the reference. @return the table of
    rated"""
    points = rated(entries, name, floor, cost)
    for entry, spent, error in points:
        entry.front = not beaten(spent, error, points)
    return points


def near_front(points):
    return [point for point in points if not beaten(*point[1:], points, NEAR)]


# --- cells

def number(value, digits=3):
    return "" if pandas.isna(value) else f"{value:.{digits}g}" if abs(value) < 10 ** digits else f"{value:.0f}"


def error_cell(kind, value, name, floor):
    """The error of a member of this kind as a text."""
    limit = floor.get(name)
    if kind == "reference" and name not in OWN:
        return f"~ {number(limit, 2)}" if limit is not None else ""
    return f"<= {number(limit, 2)}" if limit and value <= limit else number(value)


def table_rows(entries, floor, cost):
    """The table of the members that are done as texts, with its heads. @return its rows, and the measures that it
    has"""
    frame = frame_of(entries, cost)
    names = [name for name in MEASURES if frame[name].notna().any()]
    frame["label"] = [entry.label for entry in entries]
    rows = [["", "setting", "x base", "seconds" if cost == "seconds" else f"{cost} s", *SHOWN,
             *(f"{name} {UNITS[name]}".strip() for name in names)]]
    for _, row in frame[frame.status.eq("done")].iterrows():
        rows.append(["*" if row.front else "", row.label, number(row.ratio), number(row[cost]), *(number(row[c], 4) for c in SHOWN),
                     *(error_cell(row.kind, row[name], name, floor) for name in names)])
    return rows, names


def others(entries):
    """(setting, why it has no numbers) of the members that are not done."""
    told = [(entry.label, "does not apply" if entry.state == "refused" else entry.state, entry.reason.partition("; ")[0])
            for entry in entries if entry.state != "done"]
    return [(label, f"{state}: {reason}" if reason else state) for label, state, reason in told]


def terminal(entries, floor, cost):
    """The table for a terminal."""
    rows, _ = table_rows(entries, floor, cost)
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ["  ".join(cell.ljust(w) if i < 2 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths))).rstrip()
             for row in rows]
    return "\n".join([*lines, *(f"{setting}: {why}" for setting, why in others(entries))])


def markdown(entries, floor, notes, cost):
    rows, names = table_rows(entries, floor, cost)
    lines = [f"| {' | '.join(f'`{cell}`' if i == 1 and '=' in cell else cell for i, cell in enumerate(row))} |"
             for row in rows]
    lines.insert(1, "|" + "---|" * len(rows[0]))
    left = [f"- `{setting}`: {why}" for setting, why in others(entries)]
    return "\n".join([*notes, "", *lines, *(["", "Without numbers:", "", *left] if left else []), "",
                      *(f"- **{name}**: {about(name)}" for name in names), ""])


def write_table(path, entries, cost):
    write_atomic(path, frame_of(entries, cost).to_csv(index=False, float_format="%.6g"))


def write_json(path, entries, floor, facts, cost):
    frame = frame_of(entries, cost).astype(object)
    document = {**facts, "measures": {name: {"unit": UNITS[name], "definition": about(name)} for name in MEASURES},
                "reference_error": floor, "members": frame.where(frame.notna(), None).to_dict("records")}
    write_atomic(path, json.dumps(document, indent=1, allow_nan=False) + "\n")
