#!/usr/bin/env python3
"""The output folder, or a table, is moved, removed or replaced while a run writes to it: the run says so, ends with
exit code 3, loses nothing that is still there, and writes nothing into the folder of another run.
usage: folder_lost.py SOFTWET"""

import os
import pathlib
import shutil
import signal
import subprocess
import time

from _scene import check_true, command, environment, history, record, run

CASE = "solid_layer_2d"
SCENE = ["domain.elements=[16,4]", "output.fields.times=[]", "time.dt_max=0.01"]
LONG = [*SCENE, "time.end=1e6", "output.checkpoint.minutes=0.005"]
OTHER = [*SCENE, "time.max_steps=3"]


def content(folder):
    return {str(path): path.read_bytes() for path in pathlib.Path(folder).rglob("*") if path.is_file()}


def disturbed(name, disturb, stop=False):
    """A run that is disturbed while it stands still. @param stop  it is asked to stop, too; else it saves soon
    @return its message"""
    for folder in ("run", "moved"):
        shutil.rmtree(folder, ignore_errors=True)
    settings = [*LONG[:-1], "output.checkpoint.minutes=10"] if stop else LONG
    process = subprocess.Popen(command(CASE, "run", settings, ["--threads", "1"]), stderr=subprocess.PIPE, text=True,
                               env=environment)
    while not pathlib.Path("run/run.json").exists() and process.poll() is None:
        time.sleep(0.02)
    os.kill(process.pid, signal.SIGSTOP)
    disturb()
    if stop:
        process.send_signal(signal.SIGTERM)
    process.send_signal(signal.SIGCONT)
    try:
        message = process.communicate(timeout=900)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        message = "it did not end"
    check_true(f"{name}: exit code 3", process.returncode == 3, f"{process.returncode} {message}")
    check_true(f"{name}: one error", message.count("softwet: error: ") == 1, message)
    check_true(f"{name}: not reported as a success", "the result is in" not in message, message)
    return message


def go_on(name, folder):
    """The folder is whole: the run goes on there, and no row is missing."""
    steps = record(folder)["counts"]["steps"]
    run(CASE, folder, [*SCENE, "time.end=1e6", f"time.max_steps={steps + 2}"],
        ["--resume", "--quiet", "--threads", "1"])
    check_true(f"{name}: no row is missing", history(folder)["step"].tolist() == list(range(steps + 3)))


def move():
    os.rename("run", "moved")


def move_and_compute_another():
    move()
    run(CASE, "run", OTHER)
    kept.update(content("run"))


def replace():
    """As an editor does that saves into a new file."""
    shutil.copy("run/history.csv", "mine")
    os.rename("mine", "run/history.csv")


for stop in (False, True):
    how = "asked to stop" if stop else "at its next checkpoint"
    message = disturbed(f"moved, {how}", move, stop)
    parts = ("was moved", "has stopped at t = ", os.path.realpath("moved"), "--resume --out")
    check_true(f"moved, {how}: says where it is", all(part in message for part in parts), message)
    check_true(f"moved, {how}: nothing is left behind", not os.path.exists("run"))
    check_true(f"moved, {how}: its state", record("moved")["state"] == "stopped", record("moved")["state"])
    go_on(f"moved, {how}", "moved")

    kept = {}
    message = disturbed(f"moved, another run in its place, {how}", move_and_compute_another, stop)
    check_true(f"another run, {how}: says where it is", os.path.realpath("moved") in message, message)
    check_true(f"another run, {how}: its files stay", kept == content("run") and "run/checkpoint.h5" in kept)
    go_on(f"another run, {how}", "moved")

    message = disturbed(f"removed, {how}", lambda: shutil.rmtree("run"), stop)
    check_true(f"removed, {how}: says so", "was removed" in message and "start the run again" in message, message)
    check_true(f"removed, {how}: nothing comes back", not os.path.exists("run"))

message = disturbed("a table is removed", lambda: os.remove("run/history.csv"))
check_true("a table is removed: says so", "history.csv was removed or replaced" in message and "--resume" in message,
           message)
go_on("a table is removed", "run")

message = disturbed("a table is replaced", replace)
check_true("a table is replaced: what stood there is kept", pathlib.Path("run/history.csv.replaced").exists())
go_on("a table is replaced", "run")
