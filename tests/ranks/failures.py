#!/usr/bin/env python3
"""What ends one process ends them all, within seconds and with the right exit code; the folder can be resumed.
usage: failures.py SOFTWET"""

import os
import pathlib
import shutil
import signal
import subprocess
import time

from _ranks import check_true, environment, launcher, run, start
from _scene import record, softwet

SCENE = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "load[0].start=2", "load[0].ramp=1",
         "output.fields.times=[]"]
LONG = [*SCENE, "time.max_steps=100000", "time.dt_initial=0.001", "time.dt_max=0.001"]


def processes(folder):
    """The processes of a run that has begun, the first one in front."""
    for _ in range(300):
        if pathlib.Path(folder, "run.json").exists():
            break
        time.sleep(0.1)
    time.sleep(0.5)
    first = record(folder)["process"]
    parent = int(pathlib.Path(f"/proc/{first}/stat").read_text().rsplit(")", 1)[1].split()[1])
    found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(parent)], capture_output=True, text=True).stdout.split()
    return [first] + [int(pid) for pid in found if int(pid) != first]


def end_of(process, within, name):
    begin = time.time()
    _, errors = process.communicate(timeout=900)
    check_true(f"{name}: ends within {within} s", time.time() - begin < within, f"{time.time() - begin:.1f} s")
    return process.returncode, errors


for folder in ("killed", "stopped", "disk", "moved", "there"):
    shutil.rmtree(folder, ignore_errors=True)

# A process is killed.
process = start(3, "tensotaxis_pull_2d", "killed", LONG)
os.kill(processes("killed")[2], signal.SIGKILL)
code, _ = end_of(process, 5, "killed")
check_true("killed: exit code", code != 0, str(code))
steps = record("killed")["counts"]["steps"]
run(2, "tensotaxis_pull_2d", "killed", [*SCENE, f"time.max_steps={steps + 3}"], ("--resume", "--quiet"))
check_true("killed: the folder is resumed", record("killed")["counts"]["steps"] == steps + 3)

# A wish to stop reaches all.
process = start(2, "tensotaxis_pull_2d", "stopped", LONG)
processes("stopped")
process.send_signal(signal.SIGTERM)
code, errors = end_of(process, 10, "stopped")
check_true("stopped: exit code 0", code == 0, f"{code} {errors}")
check_true("stopped: run.json", record("stopped")["state"] == "stopped", record("stopped")["state"])

# The disk takes no checkpoint of the one process that writes.
process = start(2, "tensotaxis_pull_2d", "disk", [*LONG, "output.checkpoint.minutes=0.05"])
processes("disk")
pathlib.Path("disk/checkpoint.h5.partial").mkdir()
code, errors = end_of(process, 15, "disk")
check_true("disk: exit code 3 and a message", code == 3 and "softwet: error:" in errors, f"{code} {errors}")

# Somebody moves the folder, which the first process alone has open.
process = start(2, "tensotaxis_pull_2d", "moved", [*LONG, "output.checkpoint.minutes=0.05"])
processes("moved")
os.rename("moved", "there")
code, errors = end_of(process, 15, "moved")
check_true("moved: exit code 3 and one message", code == 3 and errors.count("was moved") == 1, f"{code} {errors}")
steps = record("there")["counts"]["steps"]
run(2, "tensotaxis_pull_2d", "there", [*SCENE, f"time.max_steps={steps + 3}"], ("--resume", "--quiet"))
check_true("moved: it goes on where it is now", record("there")["counts"]["steps"] == steps + 3)

# A wrong case: one message.
errors = run(3, "tensotaxis_pull_2d", "wrong", ["fluid.viscosity=-1"], code=1)
check_true("wrong case: one message", errors.count("softwet: error:") == 1, errors)
errors = run(4, "tensotaxis_pull_2d", "narrow", [*SCENE, "domain.elements=[12,16]"], code=1)
check_true("too many processes: one message", errors.count("softwet: error:") == 1, errors)
errors = run(2, "tensotaxis_pull_2d", "whole", [*SCENE, "solver.krylov.preconditioner=lu"], code=1)
check_true("a factorisation on each process: one message with two remedies", errors.count("softwet: error:") == 1 and
           'write "schwarz"' in errors and "softwet sweep --jobs" in errors, errors)
result = subprocess.run([str(launcher), "2", softwet, "info"], capture_output=True, text=True, env=environment)
check_true("another command: one message, code 1", result.returncode == 1 and result.stderr.count("error:") == 1,
           f"{result.returncode} {result.stderr}")

# Processes of which MPI knows nothing, as with srun without its --mpi, would each compute all of it.
result = subprocess.run([softwet, "run", "case.toml"], capture_output=True, text=True,
                        env={**environment, "SLURM_STEP_NUM_TASKS": "2", "SLURM_PROCID": "0"})
check_true("MPI knows of one process alone: refused", result.returncode == 1 and "MPI knows of this one alone" in
           result.stderr, f"{result.returncode} {result.stderr}")
