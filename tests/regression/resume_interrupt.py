#!/usr/bin/env python3
"""Ctrl-C ends a run cleanly and resumably; a failed computation leaves its last good state. usage: ... SOFTWET"""

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
    while not pathlib.Path("stopped/case.toml").exists() and process.poll() is None:
        time.sleep(0.05)  # until it has begun, and hears signals
    time.sleep(0.5)
    message = run("tensotaxis_pull_2d", "stopped", PULL, code=1)
    check_true("the folder is taken while it runs", "another run" in message, message.strip())
    process.send_signal(number)
    message = process.communicate(timeout=60)[1]
    name = signal.Signals(number).name
    check_true(f"{name}: exit code 0", process.returncode == 0, f"{process.returncode}")
    check_true(f"{name}: tells how to go on", "stopped by user" in message and "--resume" in message, message.strip())
    check_true(f"{name}: run.json", record("stopped")["stop"]["reason"] == "stopped by user")
    steps = history("stopped")["step"]
    check_true(f"{name}: history is whole", steps[-1] == record("stopped")["counts"]["steps"] == len(steps) - 1)
    run("tensotaxis_pull_2d", "stopped", LONG + [f"time.max_steps={int(steps[-1]) + 2}"], ["--resume", "--quiet"])
    check_true(f"{name}: resumed", history("stopped")["step"][-1] == steps[-1] + 2)
    left = [str(path) for path in pathlib.Path("stopped").rglob("*.partial")]
    check_true(f"{name}: no partial files", not left, str(left))

# One Newton iteration is not enough, and smaller steps are not allowed.
HOPELESS = PULL + ["solver.newton.max=1", "time.dt_initial=1", "time.dt_min=0.6"]
message = run("tensotaxis_pull_2d", "failed", HOPELESS, code=2).strip()
check_true("failure: one line", len(message.splitlines()) == 1 and "checkpoint.h5" in message, message)
check_true("failure: run.json tells why", "Newton" in record("failed")["stop"]["reason"])
run("tensotaxis_pull_2d", "failed", PULL + ["time.max_steps=2"], ["--resume", "--quiet"])
check_true("failure: resumed with other settings", history("failed")["step"][-1] == 2)
