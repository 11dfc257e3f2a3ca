"""How the page of a study shows its tables: whole where they are short, and else a part, with all rows in a CSV file
that the command of the study writes."""

import re

MOST = 12  # rows of a table on a page


def plain(value):
    return f"{value:.10g}" if isinstance(value, float) else str(value).replace(",", ";")


def cell(value):
    return f"{value:.6g}" if isinstance(value, float) else re.sub(r"(?<!\\)\|", r"\\|", str(value))


def markdown(columns, rows):
    return ["| " + " | ".join(map(cell, columns)) + " |", "|" + "---|" * len(columns),
            *("| " + " | ".join(map(cell, row)) + " |" for row in rows)]


def named_table(columns, rows, file):
    """Lines of a table that the CSV file has whole."""
    rows = list(rows)
    shown = rows if len(rows) <= MOST else rows[:MOST // 2]
    more = [] if len(rows) <= MOST else ["", f"These are {len(shown)} of {len(rows)} rows; all are in `{file}`."]
    return ["", *markdown(columns, shown), *more, ""]


def asked_rows(rows):
    """Of rows (what, asked, measured, holds) those that a page shows: all where they are few, else those that do not
    hold and one of each kind of question that holds."""
    if len(rows) <= MOST:
        return rows
    kinds, shown = set(), []
    for row in rows:
        if row[3] != "yes" or (row[1] not in kinds and len(kinds) < MOST // 2):
            shown.append(row)
        if row[3] == "yes":
            kinds.add(row[1])
    return shown


def asked_table(rows, shown):
    """Lines of a table of rows (what, asked, measured, holds). Where all rows hold, as the verdict above says, the last
    column is left out."""
    columns = ("what", "asked", "measured", "holds")
    width = 3 if all(row[3] == "yes" for row in rows) else 4
    return markdown(columns[:width], [row[:width] for row in shown])
