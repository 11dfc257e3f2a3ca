#!/usr/bin/env python3
"""Signals before the first step: a run hears them from its start on, and says what the second one does. The case comes
from a pipe, at which the run waits while it is signalled. So do `steady`, which nobody has to read, and `bench`.
usage: signals.py SOFTWET"""

import os
import pathlib
import shutil
import signal
import subprocess
import time

from _scene import RIGID, cases, check_true, environment, hears, record, run, softwet

CASE = cases / "static_droplet_rigid_2d.toml"


def waiting(settings=(), command=("run", "pipe", "--out", "run")):
    """A run that has not read its case yet."""
    shutil.rmtree("run", ignore_errors=True)
    pathlib.Path("pipe").unlink(missing_ok=True)
    os.mkfifo("pipe")
    words = [word for setting in [*RIGID, *settings] for word in ("--set", setting)]
    process = subprocess.Popen([softwet, *command, "--threads", "1", *words],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment,
                               preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
    end = time.monotonic() + 900
    while not hears(process.pid, signal.SIGTERM) and time.monotonic() < end:
        time.sleep(0.01)
    heard = hears(process.pid, signal.SIGTERM)
    if not heard:
        process.kill()  # it would wait for its case without end
    check_true("a run hears signals before it reads its case", heard)
    return process


def fed(process):
    """The run gets its case. @return its message"""
    pathlib.Path("pipe").write_text(CASE.read_text())
    return "".join(process.communicate(timeout=900))


for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU):
    name = number.name
    process = waiting()
    process.send_signal(number)
    message = fed(process)
    check_true(f"{name} at the start: exit code 0", process.returncode == 0, f"{process.returncode} {message}")
    check_true(f"{name} at the start: says what happens", "stopping at the end of this step" in message and
               "stopped by user" in message and "--resume" in message, message)
    check_true(f"{name} at the start: the first state is kept", record("run")["state"] == "stopped" and
               record("run")["counts"]["steps"] == 0)
run(CASE.stem, "run", [*RIGID, "time.max_steps=2"], ["--resume", "--quiet", "--threads", "1"])
check_true("it goes on from there", record("run")["counts"]["steps"] == 2)

process = waiting()
for number in (signal.SIGTERM, signal.SIGTERM, signal.SIGHUP):  # as shells and launchers do
    process.send_signal(number)
message = fed(process)
check_true("signals in one second are one wish", process.returncode == 0 and "stopped by user" in message,
           f"{process.returncode} {message}")

process = waiting()
process.send_signal(signal.SIGTERM)
time.sleep(1.2)
process.send_signal(signal.SIGTERM)
message = process.communicate(timeout=900)[1]
check_true("a second signal ends the run at once", process.returncode == -signal.SIGTERM, str(process.returncode))
check_true("and says so", "ended at once by a second signal" in message, message)

process = waiting(['time.start="equilibrium"'])
process.send_signal(signal.SIGTERM)
message = fed(process)
check_true("stopped before it is at rest: exit code 0", process.returncode == 0, f"{process.returncode} {message}")
check_true("stopped before it is at rest: says so", "before the scene was at rest" in message, message)
check_true("stopped before it is at rest: no folder", not os.path.exists("run"))

for command, told in ((("steady", "pipe", "--out", "run"), "before the scene was at rest"), (("bench", "pipe"), "the lines above are complete")):
    for number in (signal.SIGINT, signal.SIGTERM):
        process = waiting(command=command)
        process.send_signal(number)
        message = fed(process)
        name = f"{command[0]}, {number.name}"
        check_true(f"{name}: exit code 0", process.returncode == 0, f"{process.returncode} {message}")
        check_true(f"{name}: says so", "softwet: stopping" in message and "stopped by user" in message and told in message, message)
        check_true(f"{name}: no folder", not os.path.exists("run"))

# Nobody reads what a search for the state of rest says.
process = waiting(command=("steady", "pipe", "--out", "run"))
process.stdout.close()
process.stderr.close()
pathlib.Path("pipe").write_text(CASE.read_text())
check_true("steady outlives its reader", process.wait(timeout=900) == 0 and record("run")["stop"]["reason"] == "at rest")
