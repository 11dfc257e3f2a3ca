#!/usr/bin/env python3
"""One and two threads give identical bits. usage: threads.py SOFTWET"""

import pathlib

import h5py
from _scene import PULL, check_true, run

SETTINGS = PULL + ["time.end=4", "output.fields.times=[0,4]"]
for count in (1, 2, 3):
    run("tensotaxis_pull_2d", f"threads_{count}", SETTINGS, ["--overwrite", "--quiet", "--threads", str(count)])


def arrays(folder):
    found = {}
    with h5py.File(f"{folder}/checkpoint.h5") as file:
        file.visititems(lambda name, item: found.update({name: item[()].tobytes()} if hasattr(item, "shape") else {}))
    del found["arrays/costs"]  # seconds are of the clock
    return found


one = arrays("threads_1")
check_true("the checkpoint has arrays", len(one) >= 7, str(sorted(one)))
for count in (2, 3):
    for name in ("history.csv", "interface.csv"):
        same = pathlib.Path(f"threads_{count}/{name}").read_bytes() == pathlib.Path(f"threads_1/{name}").read_bytes()
        check_true(f"{count} threads: {name}", same)
    check_true(f"{count} threads: checkpoint", arrays(f"threads_{count}") == one)
