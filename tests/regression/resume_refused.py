#!/usr/bin/env python3
"""A damaged or foreign checkpoint is refused with one line and exit code 1. usage: resume_refused.py SOFTWET"""

import pathlib

import h5py

from _scene import PULL, check_true, run

SHORT = PULL + ["time.max_steps=3"]
RESUME = ["--resume", "--quiet", "--threads", "1"]


def refused(name, settings, parts):
    before = {path: path.read_bytes() for path in pathlib.Path("run").rglob("*") if path.is_file()}
    told = run("tensotaxis_pull_2d", "run", settings, RESUME, code=1).strip().splitlines()
    lines = [line for line in told if not line.startswith("softwet: warning: ")]
    check_true(f"{name}: one line", len(lines) == 1 and lines[0].startswith("softwet: error: "), str(told))
    for part in parts:
        check_true(f"{name}: names '{part}'", part in lines[0])
    after = {path: path.read_bytes() for path in pathlib.Path("run").rglob("*") if path.is_file()}
    check_true(f"{name}: the folder stays as it was", before == after)


run("tensotaxis_pull_2d", "run", [*SHORT, "output.fields.times=[-2]"])
refused("viscosity", SHORT + ["fluid.viscosity=1/128"], ["checkpoint.h5", "fluid.viscosity was", "0.0078125"])
refused("mesh", SHORT + ["domain.elements=[64,32]"], ["domain.elements was [32, 16] and is [64, 32] now"])
refused("load", SHORT + ["load[0].ramp=2"], ["load[0].ramp was 1 and is 2 now"])
refused("scheme", SHORT + ["time.rho_inf=0.8"], ["time.rho_inf was"])
refused("mass", SHORT + ["time.mass=lumped"], ["time.mass was", "lumped", "may change"])
refused("safety", SHORT + ["time.safety=0.5"], ["time.safety was 0.9 and is 0.5 now"])
refused("start", SHORT + ["time.start=equilibrium"], ["time.start was", "equilibrium"])

# Tables that are not what the run has written.
MORE = PULL + ["time.max_steps=5"]
for table in ("history.csv", "interface.csv"):
    path = pathlib.Path("run", table)
    written = path.read_text()
    head, *rows = written.splitlines(keepends=True)
    edited = {
        "a missing row": [*rows[:1], *rows[2:]],
        "a repeated row": [*rows[:1], *rows],
        "rows in reverse": rows[::-1],
        "a cut row": [*rows[:1], rows[1].rsplit(",", 1)[0] + "\n", *rows[2:]],
        "4.5 as the first number": [rows[0], "4.5" + rows[1][rows[1].index(","):], *rows[2:]],
        "a word": [rows[0], "abc" + rows[1][rows[1].index(","):], *rows[2:]],
        "another number": [rows[0].replace("0", "1"), *rows[1:]],
        "no rows": [],
    }
    for name, changed in edited.items():
        path.write_text(head + "".join(changed))
        refused(f"{table} with {name}", MORE, [f"run/{table}", "put back the file", "--resume"])
    path.unlink()
    refused(f"no {table}", MORE, [f"run/{table}", "is missing"])
    path.write_text(written)

checkpoint = pathlib.Path("run/checkpoint.h5")
good = checkpoint.read_bytes()
middle = len(good) // 2
damage = {
    "cut short": good[:middle],
    "empty": b"",
    "no HDF5": b"step,t\n" * 100,
    "a changed byte": good[:middle] + bytes([good[middle] ^ 0xFF]) + good[middle + 1:],
}
for name, content in damage.items():
    checkpoint.write_bytes(content)
    refused(name, SHORT, ["checkpoint.h5"])

# Files that are whole, with contents no run writes.
def set_entry(file, name, value):
    file["arrays/" + name][3] = value


def set_value(file, name, value):
    file["values"].attrs[name] = value


for name, change, value in [("state/unknown", set_entry, float("nan")), ("state/moment", set_entry, float("inf")),
                            ("time", set_value, float("nan")), ("step_control/proposed", set_value, -1.0),
                            ("previous/dt", set_value, float("inf"))]:
    checkpoint.write_bytes(good)
    with h5py.File(checkpoint, "r+") as file:
        change(file, name, value)
    refused(f"{name} = {value}", SHORT, ["checkpoint.h5", f"'{name}'", str(value).removesuffix(".0"), "--resume"])

checkpoint.write_bytes(good)
with h5py.File(checkpoint, "r+") as file:
    file.attrs["format_version"] = 1
refused("a checkpoint of an older program", SHORT, ["checkpoint.h5", "format 1", "the program that wrote it", "initial.from"])

checkpoint.write_bytes(good)
run("tensotaxis_pull_2d", "run", PULL + ["time.max_steps=5", "solver.newton.rtol=1e-5", "time.dt_max=3"], RESUME)
print("ok    solver and step control may change")
