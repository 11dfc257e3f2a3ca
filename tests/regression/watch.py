#!/usr/bin/env python3
"""`softwet status` and `softwet watch` on runs that are done, alive, dead and failed, and on records of older versions.
usage: watch.py SOFTWET"""

import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import time

from _scene import PULL, check_true, command, environment, history, record, run, softwet, tools


def tell(name, *words, code=0, **changes):
    result = subprocess.run([softwet, name, *words], capture_output=True, text=True, timeout=900,
                            env={**environment, **changes})
    check_true(f"softwet {name} {' '.join(words)}: exit code {code}", result.returncode == code, result.stderr)
    return result.stdout if code == 0 else result.stdout + result.stderr


def tells(name, text, *parts):
    check_true(name, text.count("\n") == 1 and all(part in text for part in parts), text)


def rewrite(folder, **changes):
    """run.json of a folder with other values; None removes a key."""
    told = {key: value for key, value in {**record(folder), **changes}.items() if value is not None}
    pathlib.Path(folder, "run.json").write_text(json.dumps(told))


# A run that is done.
run("tensotaxis_pull_2d", "done", [*PULL, "time.end=2", "output.fields.times=[]"])
last = {name: values[-1] for name, values in history("done").items()}
tells("status of a run that is done", tell("status", "done"), "done: done", "t = 2 of 2", f"step {last['step']:.0f}",
      f"contact line {last['x_left']:.4f} to {last['x_right']:.4f}", "s a step")
text = tell("watch", "done", "--once", COLUMNS="100", LINES="30")
check_true("watch: the line of status and five panels", text.startswith("done: done") and all(
    title in text for title in ("contact lines", "velocity", "total energy", "ridges", "time step")), text)
check_true("watch: curves", sum(0x2800 < ord(c) < 0x2900 for c in text) > 100)
check_true("watch: as wide and high as the terminal", max(map(len, text.splitlines())) <= 100 and text.count("\n") <= 30)
check_true("watch ends with the run", tell("watch", "done", "--every", "0.1", COLUMNS="100", LINES="30") == text)
check_true("watch: without UTF-8", "?" in tell("watch", "done", "--once", PYTHONIOENCODING="ascii"))
check_true("two folders, one of them none", "nowhere is not an output folder" in tell("status", "done", "nowhere", code=1))
check_true("watch: a wrong pause", "--every 0: must be" in tell("watch", "done", "--every", "0", code=1))

# Records of older versions, of a run that will take a while, a failed one, one of another machine.
shutil.rmtree("written", ignore_errors=True)
shutil.copytree("done", "written")
rewrite("written", state=None, updated=None, started=None, events=None, seconds_left=None)
tells("a record without state", tell("status", "written"), "written: done")
now = time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())
rewrite("written", state="failed", stop={"reason": "failed: Newton does not converge", "t": 1})
tells("a failed run", tell("status", "written"), "failed: Newton does not converge")
check_true("watch: exit code of a failed run", "Newton" in tell("watch", "written", code=2))
rewrite("written", state="running", host=socket.gethostname())
tells("running, and the folder is free", tell("status", "written"), "written: died", "--resume")
rewrite("written", host="elsewhere", updated=now, seconds_left=7300.0, events=[{"t": 1.5, "what": "a droplet is gone"}])
tells("a run of another machine", tell("status", "written"), "written: running", "2.0 h left", "at t = 1.5 a droplet is gone")
pathlib.Path("written/run.json").unlink()
tells("before the first record", tell("status", "written"), "t = 2 of 2")
pathlib.Path("written/run.json").write_text("{")
check_true("a cut record", "cannot read written/run.json" in tell("status", "written", code=1))

# A run that is alive, then killed.
shutil.rmtree("alive", ignore_errors=True)
process = subprocess.Popen(command("tensotaxis_pull_2d", "alive", [*PULL, "time.end=1e4", "time.dt_max=1e-2"],
                                   ["--quiet", "--threads", "1"]), env=environment)
try:
    rows = pathlib.Path("alive/history.csv")
    while process.poll() is None and not (rows.exists() and rows.read_text().count("\n") > 2):
        time.sleep(0.05)
    tells("status of a run that is alive", tell("status", "alive"), "alive: running", "of 10000")
    watch = subprocess.Popen([sys.executable, str(tools / "watch"), "alive", "--every", "0.1"], stdout=subprocess.PIPE,
                             text=True, env=environment)
    time.sleep(1)
    check_true("watch goes on while the run lives", watch.poll() is None)
finally:
    process.send_signal(signal.SIGKILL)
    process.wait()
rewrite("alive", state="running") if os.path.exists("alive/run.json") else None
text = watch.communicate(timeout=900)[0]
check_true("watch sees that it died", watch.returncode == 2 and "died" in text, f"{watch.returncode} {text[-2000:]}")
