"""Whether two runs gave the same bits."""

from _bits import arrays, results  # noqa: F401
from _scene import check_true


def check_same(name, folder, other):
    """Ends the test where two runs differ in a bit of a table, a field or the checkpoint, or in what their solvers
    did."""
    here, there = results(folder), results(other)
    check_true(f"{name}: the same files", here.keys() == there.keys(), str(sorted(here.keys() ^ there.keys())))
    for part in there:
        told = f"{here[part]}, {there[part]}" if part.startswith("counts") and here[part] != there[part] else ""
        check_true(f"{name}: {part}", here[part] == there[part], told)
