"""The table of `softwet converge`: a row for each column, with its values at all widths and at zero."""

import math

from .._store.files import write_csv
from .fits import NEEDED, digits_of, limit


class Row:
    """column;  values  at each width, nan where there is none;  limit  of them, or None"""

    def __init__(self, column, widths, values):
        self.column, self.values = column, values
        there = [(width, value) for width, value in zip(widths, values) if not math.isnan(value)]
        whole = not math.isnan(values[-1]) and len(there) >= NEEDED
        self.limit = limit(*zip(*there), self.column.unit) if whole else None

    def needs(self):
        """How many widths more give it a limit; 0 where it has one, or no value at all."""
        there = sum(not math.isnan(value) for value in self.values)
        return NEEDED - there if there and not self.limit else 0

    def zero(self):
        """value +- bar, with two digits of the bar."""
        if not self.limit:
            return ""
        places = digits_of(self.limit.bar)
        return f"{self.limit.value:.{places}f} +- {self.limit.bar:.{places}f}"


def write_table(path, widths, rows):
    names = ["column", "unit", "zero", "bar", *(f"g={width:.6g}" for width in widths)]
    lines = [[row.column.text, row.column.shown, *((row.limit.value, row.limit.bar) if row.limit else ("", "")),
              *("" if math.isnan(value) else value for value in row.values)] for row in rows]
    write_csv(path, [names, *lines])


def terminal(widths, rows):
    """The same for the eye."""
    unit, factor = rows[0].column.units.of("dimple") if rows else ("", 1.0)  # of a length
    width_name = f"half width, {unit}" if unit else "fluid.capillarity"
    lines = [[width_name, "unit", *(f"{width * factor:.4g}" for width in widths), "zero width"]]
    for row in rows:
        places = digits_of(row.limit.bar) + 1 if row.limit else 6
        shown = ["" if math.isnan(value) else f"{value:.{places}f}" for value in row.values]
        lines.append([row.column.text, row.column.shown, *shown, row.zero()])
    wide = [max(len(line[k]) for line in lines) for k in range(len(lines[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(line, wide)).rstrip() for line in lines)
