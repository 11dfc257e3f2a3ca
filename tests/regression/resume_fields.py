#!/usr/bin/env python3
"""Field files keep their times when a run is resumed with others. usage: resume_fields.py SOFTWET"""

import json
import pathlib

import h5py
from _scene import RIGID, check_true, run


def times(folder):
    """Times of the series of the fluid; each must be the time of its file."""
    listed = []
    for number, entry in enumerate(json.load(open(f"{folder}/fields/fluid.hdf.series"))["files"]):
        with h5py.File(f"{folder}/fields/{entry['name']}") as file:
            stored = float(file["VTKHDF/FieldData/TimeValue"][0])
        check_true(f"{entry['name']} is listed with its time", entry["name"] == f"fluid_{number:04}.hdf"
                   and entry["time"] == stored, f"{entry['time']:g}, {stored:g}")
        listed.append(entry["time"])
    return listed


def resumed(end, wanted, *settings):
    run("static_droplet_rigid_2d", "out", RIGID + [f"time.end={end}", f"output.fields.times={wanted}", *settings],
        ["--resume", "--quiet", "--threads", "1"])
    return times("out")


def rows(folder):
    return sorted({float(line.split(",")[0]) for line in open(f"{folder}/interface.csv").readlines()[1:]})


run("static_droplet_rigid_2d", "out", RIGID + ["time.end=4", "output.fields.times=[0,2]"])
check_true("as asked", times("out") == [0, 2])
check_true("at the time of the resume, and later", resumed(6, "[0,4,6]") == [0, 2, 4, 6], str(times("out")))
check_true("times that are over are left alone", resumed(8, "[1,2,8]") == [0, 2, 4, 6, 8], str(times("out")))
check_true("interface.csv has them all", rows("out") == [0, 2, 4, 6, 8], str(rows("out")))
check_true("times of an interval that are over are left alone", resumed(9, "[]", "output.fields.every=3") == [0, 2, 4, 6, 8, 9],
           str(times("out")))
check_true("case.toml is the one of the last run", "end = 9" in open("out/case.toml").read())

# Files that a user has removed are neither written again, nor does their number go to another one.
removed = pathlib.Path("out/fields/fluid_0001.hdf")
removed.unlink()
others = {path.name: path.read_bytes() for path in pathlib.Path("out/fields").glob("*.hdf")}
run("static_droplet_rigid_2d", "out", RIGID + ["time.end=10", "output.fields.times=[10]"], ["--resume", "--quiet", "--threads", "1"])
listed = json.load(open("out/fields/fluid.hdf.series"))["files"]
check_true("the series lists the files that are there", [entry["time"] for entry in listed] == [0, 4, 6, 8, 9, 10]
           and all(pathlib.Path("out/fields", entry["name"]).exists() for entry in listed), str(listed))
check_true("no other file has changed", not removed.exists() and all(
    pathlib.Path("out/fields", name).read_bytes() == content for name, content in others.items()))
message = run("static_droplet_rigid_2d", "out", RIGID + ["time.end=3", "output.fields.times=[]"],
              ["--resume", "--threads", "1"])
check_true("nothing left to do: says what to raise", "raise time.end" in message, message.strip())
check_true("and leaves case.toml alone", "end = 10" in open("out/case.toml").read())
