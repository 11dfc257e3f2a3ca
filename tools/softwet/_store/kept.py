"""Runs that are kept by what they are made of: the same program, case and words are one run. Used by
`softwet verify`."""

import hashlib
import json
import math
import os
import pathlib
import resource
import shlex
import subprocess
import tempfile
import time
from functools import cached_property

import softwet

from . import process
from .files import write_atomic

# Threads that wait without spinning: runs share the machine with each other.
ENVIRONMENT = {**os.environ, "OMP_WAIT_POLICY": "passive", "OMP_PROC_BIND": "false"}


class Interrupted(Exception):
    """The runs are stopped, and no other starts."""


class KeptRun:
    """A finished run: .folder, .code, .message (stderr), .seconds (wall), .processor_seconds, .commandline,
    .output, .history, .record."""

    def __init__(self, folder, note):
        self.folder, self.code, self.message = folder, note["code"], note["message"]
        self.seconds, self.commandline = note["seconds"], note["command"]
        self.processor_seconds = note.get("processor_seconds", self.seconds)

    @cached_property
    def output(self):
        """The output folder, a softwet.Run."""
        return softwet.open(self.folder)

    @property
    def history(self):
        """Columns of history.csv by name; an empty cell is nan."""
        return self.output.history

    @property
    def record(self):
        return self.output.record


class KeptRuns:
    """Runs of one program under a folder. A run with the command, case and program of an earlier one is that one.
    @param place  the working folder of the runs"""

    def __init__(self, program, folder, place):
        self.program, self.folder, self.place = pathlib.Path(program), folder, place
        self.content = hashlib.sha1(self.program.read_bytes()).hexdigest()
        self.running, self.stopped = set(), False

    def stop(self):
        """Kills the runs under way, which are not kept; no other starts. Takes no lock: for a signal handler."""
        self.stopped = True
        for job in list(self.running):
            job.kill()

    def get(self, case, shown, settings, options, limit):
        """@param case   path of the case; @param shown  how the command names it
        @return the run, whatever its exit code"""
        self.go_on()
        words = [word for setting in settings for word in ("--set", setting)] + list(options)
        if "--threads" not in words:
            words += ["--threads", "1"]
        told = [self.content, case.read_text(), *words]
        key = hashlib.sha1("\0".join(told).encode()).hexdigest()[:12]
        folder = self.folder / f"{case.stem}_{key}"
        file = self.folder / f"{case.stem}_{key}.json"
        command = shlex.join(["softwet", "run", shown, *words])
        if file.exists():
            return KeptRun(folder, {**json.loads(file.read_text()), "command": command})
        note = self.compute(
            [str(self.program), "run", str(case), *words, "--out", str(folder), "--quiet", "--overwrite"], limit)
        self.go_on()
        note["command"] = command
        if note["code"] in (0, 1, 2):  # else it is the machine's fault, or was too slow: not kept
            write_atomic(file, json.dumps(note))
        return KeptRun(folder, note)

    def go_on(self):
        if self.stopped:
            raise Interrupted("interrupted")

    def compute(self, words, limit):
        begin = time.monotonic()
        with tempfile.TemporaryFile("w+") as errors:
            job = process.start(words, errors, stdout=subprocess.DEVNULL, cwd=self.place, env=ENVIRONMENT)
            self.running.add(job)
            if self.stopped:  # since go_on()
                job.kill()
            processor_seconds = math.ceil(limit * int(words[words.index("--threads") + 1]))  # holds on a busy machine too
            resource.prlimit(job.pid, resource.RLIMIT_CPU, (processor_seconds, processor_seconds))
            _, status, usage = os.wait4(job.pid, 0)
            self.running.discard(job)
            job.returncode = os.waitstatus_to_exitcode(status)
            errors.seek(0)
            message = errors.read()
        wall = time.monotonic() - begin
        if job.returncode < 0:
            message += f"ended by signal {-job.returncode} after {wall:.0f} s (limit {limit} s of processor time a thread)"
        return {"code": job.returncode, "message": message, "seconds": wall,
                "processor_seconds": usage.ru_utime + usage.ru_stime}
