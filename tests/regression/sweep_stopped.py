#!/usr/bin/env python3
"""Members of a sweep that are stopped while they come to rest, or that meet a full disk, are not lost: the same command
goes on. A task of an array that is stopped ends with 0. usage: sweep_stopped.py SOFTWET"""

import csv
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import time

from _scene import RIGID, cases, check_true, environment, hears, history, softwet

SOLID = ["domain.elements=[64,16]", "time.max_steps=3", "output.fields.times=[]"]
ONE_THREAD = {**environment, "OMP_NUM_THREADS": "1"}


def words(case, vary, settings, options):
    sets = [word for setting in settings for word in ("--set", setting)]
    return [softwet, "sweep", str(cases / f"{case}.toml"), "--vary", vary, *sets, *options]


def states(folder):
    with open(pathlib.Path(folder) / "sweep.csv", newline="") as file:
        return [(row["status"], row["exit"]) for row in csv.DictReader(file)]


def member_hears(sweep):
    """Whether the run that a sweep has started hears SIGTERM already."""
    found = subprocess.run(["ps", "-o", "pid=,comm=", "--ppid", str(sweep.pid)], capture_output=True, text=True).stdout
    for pid, name in (line.split(None, 1) for line in found.splitlines()):
        try:
            return name.startswith("softwet") and hears(pid, signal.SIGTERM)
        except OSError:  # it has just ended
            continue
    return False


def stopped(line, until):
    """A sweep that gets SIGTERM once `until` holds for its process. @return its exit code, and what it said"""
    process = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ONE_THREAD)
    end = time.monotonic() + 900
    while not until(process) and process.poll() is None and time.monotonic() < end:
        time.sleep(0.01)
    process.send_signal(signal.SIGTERM)
    told = "".join(process.communicate(timeout=900))
    return process.returncode, told


for folder in ("rest", "full", "array"):
    shutil.rmtree(folder, ignore_errors=True)

# --- while it comes to rest ------------------------------------------------------------------------------------------
# On a mesh where this takes longer than a sweep takes to pass a signal on.
REST = words("static_droplet_rigid_2d", "time.max_steps=1,2", [*RIGID[1:], "domain.elements=[96,48]", 'time.start="equilibrium"'], ["--out", "rest"])
first = pathlib.Path("rest/max_steps=1")
code, told = stopped(REST, lambda sweep: (first / "member.log").exists() and member_hears(sweep))
check_true("stopped at rest: before its first row", not (first / "history.csv").exists())
check_true("stopped at rest: exit code 2, the same command goes on", code == 2 and "goes on" in told, f"{code} {told}")
check_true("stopped at rest: interrupted", states("rest")[0] == ("interrupted", "0"), str(states("rest")))
done = subprocess.run(REST, capture_output=True, text=True, env=ONE_THREAD, timeout=900)
check_true("stopped at rest: the same command ends", done.returncode == 0, done.stderr)
check_true("stopped at rest: all rows", history(first)["step"].tolist() == [0, 1])

# --- a full disk -----------------------------------------------------------------------------------------------------
FULL = words("solid_layer_2d", "substrate.poisson=0.1,0.2", SOLID, ["--out", "full"])
done = subprocess.run(FULL, capture_output=True, text=True, env=ONE_THREAD, timeout=900,
                      preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000)))
check_true("full disk: exit code 3 and the reason", done.returncode == 3 and "File too large" in done.stderr and
           "the same command goes on" in done.stderr, f"{done.returncode} {done.stderr}")
check_true("full disk: interrupted", states("full") == [("interrupted", "3")] * 2, str(states("full")))
done = subprocess.run(FULL, capture_output=True, text=True, env=ONE_THREAD, timeout=900)
check_true("full disk: goes on with room", done.returncode == 0 and states("full") == [("done", "0")] * 2, done.stderr)

# --- a task of an array ----------------------------------------------------------------------------------------------
LONG = ["domain.elements=[16,4]", "time.max_steps=200000", "time.end=1e6", "output.fields.times=[]", "time.dt_max=0.01"]
TASK = words("solid_layer_2d", "substrate.poisson=0.1,0.2", LONG, ["--out", "array", "--member", "1"])
member = pathlib.Path("array/poisson=0.2")
code, told = stopped(TASK, lambda _: (member / "run.json").exists())
check_true("a task that is stopped ends with 0", code == 0 and "interrupted" in told, f"{code} {told}")
steps = history(member)["step"][-1]
code, told = stopped(TASK, lambda _: "resumed at" in (member / "member.log").read_text())
check_true("submitted again it goes on", code == 0 and history(member)["step"][-1] >= steps, f"{code} {told}")
# Members do not ask the launcher of the task whether they are one of several.
shutil.rmtree("array")
TWO = words("solid_layer_2d", "substrate.poisson=0.1,0.2", SOLID, ["--out", "array"])
done = subprocess.run(TWO, capture_output=True, text=True, timeout=900,
                      env={**ONE_THREAD, "SLURM_STEP_NUM_TASKS": "2", "SLURM_PROCID": "1"})
check_true("a sweep in a step of several tasks", done.returncode == 0, done.stderr)
