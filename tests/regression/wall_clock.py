#!/usr/bin/env python3
"""A run with time.wall_clock stops by itself with a checkpoint, says so, and goes on to the bits of a run without a
limit. How often it stops depends on the machine; what it ends with does not. usage: wall_clock.py SOFTWET"""

import os
import shutil
import subprocess

from _same import check_same
from _scene import PULL, check_true, command, environment, record

SHORT = 0.25 / 3600  # hours


def compute(folder, hours, *options):
    words = command("tensotaxis_pull_2d", folder, [*PULL, f"time.wall_clock={hours}"], [*options, "--threads", "1"])
    done = subprocess.run(words, capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"exit code 0 with {hours:g} hours {' '.join(options)}", done.returncode == 0, done.stderr)
    return done.stderr


for folder in ("whole", "parts"):
    shutil.rmtree(folder, ignore_errors=True)
compute("whole", 0)
told = compute("parts", 1e-9)
check_true("a limit that is over at once: the first state is kept", record("parts")["counts"]["steps"] == 0 and
           record("parts")["state"] == "stopped" and record("parts")["stop"]["reason"] == "time.wall_clock reached")
check_true("and the user is informed", "time.wall_clock reached at t = -2" in told and "--resume" in told, told)
told = compute("parts", 1e-9, "--resume")
check_true("each start after it takes a step, however short the time is", record("parts")["counts"]["steps"] == 1, told)
told = compute("parts", 1e-9, "--resume")
check_true("and the next one", record("parts")["counts"]["steps"] == 2, told)
check_true("and the user is asked to give more time", "with more time" in told and "one step" in told, told)
steps = [2]
for session in range(6):
    told = compute("parts", SHORT, "--resume")
    steps.append(record("parts")["counts"]["steps"])
    if "end reached" in told:
        break
    check_true("stopped by the clock", "time.wall_clock reached" in told, told)
compute("parts", 0, "--resume")
print(f"steps after each session: {steps}")
check_true("the end is the same as without a limit", record("parts")["state"] == "done")
check_same("a run that the clock stopped", "parts", "whole")

told = compute("rest", 1e-9, "--overwrite", "--set", 'time.start="equilibrium"')
check_true("over before the scene is at rest: nothing is written, and it is reported", "time.wall_clock reached before" in told and
           "more time" in told and not os.path.exists("rest"), told)
