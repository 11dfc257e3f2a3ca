"""Runs whose processes are killed and resumed until they reach their end."""

import json
import os
import pathlib
import random
import shutil
import signal
import time

SAVE_OFTEN = "output.checkpoint.minutes=1e-6"  # after each step


def told(folder):
    """What run.json says; empty before there is one."""
    try:
        return json.loads(pathlib.Path(folder, "run.json").read_text())
    except FileNotFoundError:
        return {}


def steps_of(folder):
    """Steps whose checkpoint is written; -1 before there is one."""
    return told(folder).get("counts", {}).get("steps", -1)


def with_kills(begin, folder, steps, interruptions, victim=None):
    """Computes a run with interruptions: at moments that differ each time its process is killed (SIGKILL), and another
    one resumes it. A process that was not met ends by itself when it has done its share of the steps, so that there are
    as many interruptions on a fast machine as on a slow one.
    @param begin   begin(number, settings, options) starts process `number` of the run
    @param steps   of the whole run
    @param victim  victim() is the number of the process to kill, where it is not that which was started
    @return how many processes were killed"""
    moments, killed = random.Random(1), 0
    shutil.rmtree(folder, ignore_errors=True)
    for number in range(interruptions):
        most = max(number + 1, steps * (number + 1) // (interruptions + 1))
        process = begin(number, [SAVE_OFTEN, f"time.max_steps={most}"], ["--resume"] if number else ["--overwrite"])
        begun = steps_of(folder)
        early = number > 0 and moments.random() < 0.2  # also while the checkpoint is read
        target = begun if early else moments.randint(begun + 1, max(begun + 1, most - 1))
        while steps_of(folder) < target and process.poll() is None:
            time.sleep(0.0005)
        time.sleep(moments.uniform(0, 0.3 if early else 0.005))
        killed += kill(process, victim() if victim else process.pid)
        end(process)
    process = begin(interruptions, [SAVE_OFTEN], ["--resume"])
    message = end(process)
    if process.returncode != 0:
        raise SystemExit(f"exit code {process.returncode} of the last process: {message}")
    return killed


def kill(process, number):
    """Whether there was such a process to kill. @param number  None: it is not known"""
    if number is None or process.poll() is not None:
        return False
    try:
        os.kill(number, signal.SIGKILL)
    except ProcessLookupError:
        return False
    return True


def end(process):
    """Waits for the end of a process. @return what it has printed on stderr"""
    try:
        return process.communicate(timeout=900)[1]
    except BaseException:
        process.kill()
        raise


def first_process(folder):
    """The number of the first of several processes, whose end ends all; None before it has said so itself."""
    number = told(folder).get("process")
    try:
        words = pathlib.Path(f"/proc/{number}/cmdline").read_bytes()
    except FileNotFoundError:
        return None
    return number if str(folder).encode() in words else None
