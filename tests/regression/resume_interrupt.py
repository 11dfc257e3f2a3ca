#!/usr/bin/env python3
"""Ctrl-C ends a run cleanly and resumably; a failed computation leaves its last good state; a run that was killed is
reported from one that is under way. usage: resume_interrupt.py SOFTWET"""

import datetime
import os
import pathlib
import shutil
import signal
import subprocess
import time

from _scene import PULL, check_true, command, environment, history, record, run

LONG = PULL + ["time.end=1e6", "output.fields.times=[0]", "time.dt_max=0.01"]
for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
    shutil.rmtree("stopped", ignore_errors=True)
    process = subprocess.Popen(command("tensotaxis_pull_2d", "stopped", LONG, ["--overwrite", "--threads", "1"]),
                               stderr=subprocess.PIPE, text=True, env=environment,
                               preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
    while not pathlib.Path("stopped/run.json").exists() and process.poll() is None:
        time.sleep(0.05)  # until it has begun, and hears signals
    live = record("stopped")
    check_true("run.json is there as soon as the run has begun", live["state"] == live["stop"]["reason"] == "running")
    check_true("it names the process", live["process"] == process.pid, f"{live['process']}")
    age = datetime.datetime.now(datetime.timezone.utc) - datetime.datetime.fromisoformat(live["started"].replace("Z", "+00:00"))
    check_true("and when it began", datetime.timedelta(0) <= age < datetime.timedelta(minutes=2), str(live["started"]))
    check_true("with a checkpoint to resume from", pathlib.Path("stopped/checkpoint.h5").exists())
    for options in (["--quiet"], ["--resume", "--quiet"], ["--overwrite", "--quiet"]):
        message = run("tensotaxis_pull_2d", "stopped", PULL, options, code=1)
        check_true("the folder is taken while it runs", "another run" in message and "is writing" in message, message.strip())
    process.send_signal(number)
    message = process.communicate(timeout=900)[1]
    name = signal.Signals(number).name
    check_true(f"{name}: exit code 0", process.returncode == 0, f"{process.returncode}")
    check_true(f"{name}: says how to go on", "stopped by user" in message and "--resume" in message, message.strip())
    check_true(f"{name}: run.json", record("stopped")["stop"]["reason"] == "stopped by user")
    check_true(f"{name}: its state", record("stopped")["state"] == "stopped" and record("stopped")["started"] == live["started"])
    steps = history("stopped")["step"]
    check_true(f"{name}: history is whole", steps[-1] == record("stopped")["counts"]["steps"] == len(steps) - 1)
    run("tensotaxis_pull_2d", "stopped", LONG + [f"time.max_steps={int(steps[-1]) + 2}"], ["--resume", "--quiet"])
    check_true(f"{name}: resumed", history("stopped")["step"][-1] == steps[-1] + 2)
    check_true(f"{name}: it is still the same run", record("stopped")["started"] == live["started"])
    left = [str(path) for path in pathlib.Path("stopped").rglob("*.partial")]
    check_true(f"{name}: no partial files", not left, str(left))

# One Newton iteration is not enough, and smaller steps are not allowed.
HOPELESS = PULL + ["solver.newton.max=1", "time.dt_initial=1", "time.dt_min=0.6"]
message = run("tensotaxis_pull_2d", "failed", HOPELESS, code=2).strip()
errors = [line for line in message.splitlines() if not line.startswith("softwet: warning: ")]
check_true("failure: one line", len(errors) == 1 and "checkpoint.h5" in errors[0], message)
check_true("failure: run.json says why", "Newton" in record("failed")["stop"]["reason"])
check_true("failure: its state", record("failed")["state"] == "failed")
run("tensotaxis_pull_2d", "failed", PULL + ["time.max_steps=2"], ["--resume", "--quiet"])
check_true("failure: resumed with other settings", history("failed")["step"][-1] == 2)

# Killed before its first checkpoint: both ways to call it say what is left to do.
shutil.rmtree("stopped")
process = subprocess.Popen(command("tensotaxis_pull_2d", "stopped", LONG, ["--overwrite", "--quiet", "--threads", "1"]), env=environment)
while not pathlib.Path("stopped/history.csv").exists() and process.poll() is None:
    time.sleep(0.01)
process.kill()
process.wait()
pathlib.Path("stopped/checkpoint.h5").unlink(missing_ok=True)
for options in (["--quiet"], ["--resume", "--quiet"]):
    message = run("tensotaxis_pull_2d", "stopped", PULL, options, code=1).strip()
    check_true("killed early: reported as it is", "before its first checkpoint" in message and "--overwrite" in message, message)
run("tensotaxis_pull_2d", "stopped", PULL + ["time.max_steps=2"])

# Somebody stops reading the progress lines: the run goes on.
reader, writer = os.pipe()
os.close(reader)
process = subprocess.Popen(command("tensotaxis_pull_2d", "unread", PULL + ["time.max_steps=2"], ["--overwrite", "--threads", "1"]),
                           stderr=writer, env=environment)
os.close(writer)
check_true("unread: exit code 0", process.wait(timeout=900) == 0, f"{process.returncode}")
check_true("unread: it computed", record("unread")["counts"]["steps"] == 2)
