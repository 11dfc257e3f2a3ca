"""Where two output folders differ in a bit."""

import json
import pathlib

import h5py


def arrays(path):
    """The bytes of all arrays of a file, but for those that depend on the clock."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: found.update({name: item[()].tobytes()} if hasattr(item, "shape") else {}))
    found.pop("arrays/costs", None)
    return found


def results(folder):
    """{name: content} of all that the clock has no part in: tables, fields, the checkpoint, and what the solvers
    did."""
    folder = pathlib.Path(folder)
    found = {name: (folder / name).read_bytes() for name in ("history.csv", "interface.csv")}
    for path in sorted(folder.glob("fields/*.hdf")) + [folder / "checkpoint.h5"]:
        found[str(path.relative_to(folder))] = arrays(path)
    for path in sorted(folder.glob("fields/*.series")):
        found[str(path.relative_to(folder))] = path.read_bytes()
    counts = json.loads((folder / "run.json").read_text())["counts"]
    found["counts in run.json"] = {key: value for key, value in counts.items() if key != "steps_before_resume"}
    return found


def differences(folder, other):
    """Names of the results that two runs do not have alike."""
    here, there = results(folder), results(other)
    return [name for name in sorted(here.keys() | there.keys()) if here.get(name) != there.get(name)]
