"""The computation of members, several at once, with notes of how they ended."""

import json
import os
import re
import resource
import signal
import subprocess
import sys
import time

from .._tools.messages import last_line, say
from ..program import ERROR, WARNING
from . import process
from .devices import Devices, check_room
from .files import read_json, take, write_atomic
from .member import STOPPED

MACHINE = 3  # exit code
TOO_LARGE = ("can be had here", "out of memory")  # in what the machine refuses however often it is asked
# Several processes of a job step may compute members side by side; the members know nothing of that.
OF_LAUNCHERS = {f"{launcher}_{word}" for launcher in ("OMPI_COMM_WORLD", "MV2_COMM_WORLD", "PMI") for word in
                ("SIZE", "RANK")} | {"PMIX_RANK", "PALS_RANKID", "MPI_LOCALNRANKS", "MPI_LOCALRANKID", "FLUX_JOB_SIZE",
                                     "FLUX_TASK_RANK", "SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}


def processor_seconds():
    """Time that all ended child processes have had processors."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Job:
    """A member that runs. @param log  holds its lock;  @param note  its note, with the seconds of earlier parts
    @param device  its device, or None"""

    def __init__(self, member, log, process, note, device):
        self.member, self.log, self.process, self.seconds = member, log, process, note["seconds"]
        self.device = device
        self.processor = note["processor"]
        self.start, self.signals, self.overdue = time.monotonic(), 0, False

    def finish(self, processor):
        """Writes how it ended. A run that a stop ended before it could listen is interrupted, not failed.
        @param processor  seconds that this part of the run had processors"""
        code, member = self.process.returncode, self.member
        note = {"exit": code, "seconds": self.seconds + time.monotonic() - self.start,
                "processor": self.processor + processor}
        if code < 0:
            note["exit"] = None if self.signals else 128 - code
            note["reason"] = f"ended by signal {-code} ({signal.strsignal(-code)})"
        else:
            note["reason"] = self.reason(code)
        if code == MACHINE and not any(words in note["reason"] for words in TOO_LARGE):
            note["again"] = True
        if self.overdue and note["reason"] != "end reached":
            note["exit"] = 2
            note["reason"] = f"slower than its limit: ended at t = {member.record().get('stop', {}).get('t', 0):.4g}"
        write_atomic(member.note_path, json.dumps(note) + "\n")
        self.log.close()
        state, counts = member.outcome(note), member.record().get("counts", {})
        say(f"{member.name}: {state}, " + (note["reason"] if state == "failed" else
                                           f"{counts.get('steps', 0)} steps, {note['seconds']:.1f} s"))

    def reason(self, code):
        """Why the run ended: run.json says it without the remedies that the log has, but run.json of an earlier run may
        be there where this one was stopped before its first row."""
        told = self.member.record().get("stop", {}).get("reason", "")
        if code == 0:
            return told if told and told != "running" and not told.startswith("failed: ") else STOPPED
        if code == 2 and "failed: " in told:
            return told.removeprefix("failed: ")
        said = last_line(self.member.log_path.read_text(errors="replace"), ERROR)
        return said or f"ended with exit code {code}, and the log does not say why"


def cores(program):
    """Cores that this process may use, as softwet counts them: a container may grant less than there are."""
    environment = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    told = subprocess.run([program, "info"], capture_output=True, text=True, env=environment).stdout
    found = re.search(r"(\d+) threads", told)
    return int(found[1]) if found else len(os.sched_getaffinity(0))


def threads_option(threads):
    """The words that give a run its number of threads. @param threads  None: what it takes by itself"""
    return [f"--threads={threads}"] if threads else []


def warn_of_cores(program, jobs, threads):
    """Says so where members at once have more threads than there are cores."""
    if not threads or jobs * threads <= cores(str(program)):
        return
    print(f"{WARNING}--jobs {jobs} times --threads {threads} are {jobs * threads} threads on {cores(str(program))} cores: members "
          f"wait for each other; give --threads {max(1, cores(str(program)) // jobs)} or fewer --jobs", file=sys.stderr)


class Computation:
    """Computes members, `jobs` at once. The first SIGINT, SIGTERM or SIGHUP asks the runs to write their checkpoints
    and end, the next one ends them at once.
    @param case  path of the case;  @param changed  called after starts and ends of members
    @param limit  seconds after which a run is asked to end; it then counts as failed. None: no limit
    @param threads  of each run; None: OMP_NUM_THREADS, or else its share of the cores
    @param devices  for members; None: those that the program sees, one member on each
    @param command  of the program: run, or steady, which begins anew where it was stopped"""

    def __init__(self, program, case, jobs, retry, changed, limit=None, threads=None, devices=None, command="run"):
        self.devices = devices or Devices(program)
        check_room(self.devices, jobs, option=devices is not None)
        self.limit, self.threads, self.command = limit, threads_option(threads), command
        self.program, self.case, self.jobs, self.changed = str(program), str(case), jobs, changed
        self.wanted = ("waiting", "interrupted", "failed") if retry else ("waiting", "interrupted")
        self.running, self.signals = [], 0
        self.environment = {name: value for name, value in os.environ.items() if name not in OF_LAUNCHERS}
        if not self.environment.get("OMP_NUM_THREADS"):
            self.environment["OMP_NUM_THREADS"] = str(max(1, cores(self.program) // jobs))
        if jobs > 1:
            self.environment["OMP_PROC_BIND"] = "false"  # else all of them bind to the same cores

    def run(self, members):
        process.when_asked_to_stop(self.count_signal)
        waiting = [member for member in members if member.status()[0] in (*self.wanted, "running")]
        try:
            while self.running or (waiting and not self.signals):
                changed = self.end_some()
                while waiting and len(self.running) < self.jobs and not self.signals:
                    changed |= self.start(waiting.pop(0))
                if changed:
                    self.changed()
                time.sleep(0.03)
        finally:
            for job in self.running:
                if not job.signals:
                    job.process.terminate()

    def count_signal(self, *_):
        self.signals += 1

    def end_some(self):
        """Passes signals on and takes ended jobs off the list. @return whether there were any"""
        for job in self.running:
            if job.signals < self.signals:
                job.process.terminate()
                job.signals = self.signals
            if self.limit and not job.overdue and job.seconds + time.monotonic() - job.start > self.limit:
                job.process.terminate()
                job.overdue = True
        ended = []
        for job in list(self.running):
            before = processor_seconds()
            if job.process.poll() is not None:  # its processor time is known as soon as it has ended
                ended.append(job)
                self.running.remove(job)
                self.devices.give_back(job.device)
                job.finish(processor_seconds() - before)
        return bool(ended)

    def start(self, member):
        """Starts a member, unless someone else has it or has had it. @return whether it was started"""
        member.folder.mkdir(parents=True, exist_ok=True)
        log = open(member.log_path, "ab")
        if not take(log):
            log.close()
            say(f"{member.name}: runs already, started by another sweep; left alone")
            return False
        note = read_json(member.note_path)
        if member.outcome(note) not in self.wanted:
            log.close()
            return False
        self.launch(member, log, note)
        return True

    def launch(self, member, log, note):
        saved = self.command == "run" and (member.folder / "checkpoint.h5").exists()
        options = [] if not note else ["--resume"] if saved else ["--overwrite"]
        seconds = note.get("seconds", 0) + (member.lost_seconds() if note and "reason" not in note else 0)
        begun = {"exit": None, "seconds": seconds, "processor": note.get("processor", 0)}
        write_atomic(member.note_path, json.dumps(begun) + "\n")
        words = [self.program, self.command, self.case, *member.words(), "--out", str(member.folder), *options, *self.threads]
        device = self.devices.take()
        environment = {**self.environment, **self.devices.environment(device)}
        self.running.append(Job(member, log, process.start(words, log, env=environment), begun, device))
        where = "" if device is None else f" on device {device}"
        say(f"{member.name}: {'resumed' if '--resume' in options else 'started'}{where}")
