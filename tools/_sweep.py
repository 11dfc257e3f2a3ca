"""Members of a sweep: their folders, their table, their computation. Used by tools/sweep.

The folder of a member is the output folder of its run, with two more files: member.log, what the run says, and
member.json, how it ended. The log is locked as long as the run, or the sweep that started it, lives; so several sweeps,
on several machines too, may work on the same folder, and a sweep that is killed leaves nothing that says "running"."""

import csv
import difflib
import errno
import fcntl
import io
import json
import os
import signal
import socket
import subprocess
import sys
import time

ERROR = "softwet: error: "
WARNING = "softwet: warning: "
COLUMNS = ["x_centre", "velocity", "angle_left", "angle_right", "mass_drift"]  # the default ones: a droplet's


def fail(message, code=1):
    print(f"{ERROR}{message}", file=sys.stderr)
    raise SystemExit(code)


def say(message):
    try:
        print(f"sweep: {message}", flush=True)
    except OSError:  # the terminal is gone; the sweep goes on
        sys.stdout = open(os.devnull, "w")


def last_line(text, start):
    """The last line that starts so, without the start."""
    return next((line[len(start):] for line in reversed(text.splitlines()) if line.startswith(start)), "")


def write_atomic(path, text):
    """The file appears whole or not at all, whoever else writes it. A failure names the file itself."""
    partial = path.with_name(f"{path.name}.{socket.gethostname()}.{os.getpid()}.partial")
    try:
        with open(partial, "w", encoding="utf-8", errors="surrogateescape", newline="") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(partial, path)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error


def read_json(path):
    """Contents of a file; empty where there is none."""
    try:
        return json.loads(path.read_text())
    except (FileNotFoundError, NotADirectoryError, json.JSONDecodeError):
        return {}


def lock(file, kind):
    """@return whether no one else holds a lock; true where the file system has none"""
    try:
        fcntl.flock(file, kind | fcntl.LOCK_NB)
    except OSError as error:
        return error.errno in (errno.ENOSYS, errno.EOPNOTSUPP, errno.ENOLCK)
    return True


class Member:
    """One combination of values. @param settings  all its assignments, as --set takes them"""

    def __init__(self, name, values, settings, folder):
        self.name, self.values, self.settings, self.folder = name, values, settings, folder
        self.note_path, self.log_path = folder / "member.json", folder / "member.log"

    def words(self):
        return [word for setting in self.settings for word in ("--set", setting)]

    def record(self):
        return read_json(self.folder / "run.json")

    def is_locked(self):
        try:
            with open(self.log_path, "rb") as file:
                return not lock(file, fcntl.LOCK_SH)
        except (FileNotFoundError, NotADirectoryError):
            return False

    def status(self):
        """@return the state, and the note on how it ended: exit, reason, seconds. A note without exit is that of a run
        that did not come to its end; there is none before the first start."""
        running = self.is_locked()  # before the note, which is final once the lock is gone
        note = read_json(self.note_path)
        return "running" if running else self.outcome(note), note

    @staticmethod
    def outcome(note):
        if not note:
            return "waiting"
        if note.get("exit") is None or note["reason"] == "stopped by user":
            return "interrupted"
        return "done" if note["exit"] == 0 else "failed"

    def lost_seconds(self):
        """Seconds that run.json knows of and the note does not, for a run whose sweep was killed."""
        known = self.record().get("seconds", {}).get("total", 0)
        return max(0, known - read_json(self.note_path).get("seconds", 0))


class Table:
    """sweep.csv: a row per member, in the order of the members."""

    def __init__(self, path, keys, members, columns):
        self.path, self.keys, self.members, self.columns = path, keys, members, columns
        self.kept, self.warned = {}, set()  # rows of ended members; columns that are missing

    def write(self):
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["member", *self.keys, "status", "exit", "reason", "seconds", "steps", "t", *self.columns,
                         "velocity_peak"])
        for member in self.members:
            writer.writerow(self.row(member))
        write_atomic(self.path, text.getvalue())

    def row(self, member):
        state, note = member.status()
        ended = state in ("done", "failed")
        if ended and self.kept.get(member.name, (None,))[0] == note:
            return self.kept[member.name][1]
        record = member.record() if note else {}
        end = ["", ""] if state == "running" else [note.get("exit"), note.get("reason")]
        row = [member.name, *member.values, state, *end,
               f"{note['seconds']:.2f}" if note else "", record.get("counts", {}).get("steps"),
               record.get("stop", {}).get("t"), *self.from_history(member, bool(record))]
        if ended:
            self.kept[member.name] = (note, row)
        return row

    def from_history(self, member, begun):
        """Last values of the columns, and the largest |velocity| at t >= 0, the start of the load."""
        rows = []
        if begun:
            try:
                with open(member.folder / "history.csv", newline="") as file:
                    rows = [row for row in csv.DictReader(file) if None not in row.values()]  # whole rows
            except FileNotFoundError:  # a run that starts anew has just removed it
                pass
        if not rows:
            return [""] * (len(self.columns) + 1)
        self.warn(member, list(rows[0]))
        speeds = [abs(float(row["velocity"])) for row in rows if row.get("velocity") and float(row["t"]) >= 0]
        return [*(rows[-1].get(name, "") for name in self.columns), max(speeds, default="")]

    def warn(self, member, names):
        for name in sorted(set(self.columns) - set(names) - set(COLUMNS) - self.warned):
            self.warned.add(name)
            near = difflib.get_close_matches(name, names, 1, 0)[0]
            print(f"{WARNING}--columns {name}: history.csv of {member.name} has no such column; did you mean '{near}'?",
                  file=sys.stderr)


class Job:
    """A member that runs. @param log  holds its lock;  @param seconds  those of earlier parts of the run"""

    def __init__(self, member, log, process, seconds):
        self.member, self.log, self.process, self.seconds = member, log, process, seconds
        self.start, self.signals = time.monotonic(), 0

    def finish(self):
        """Writes how it ended. A run that a stop ended before it could listen is interrupted, not failed."""
        code, member = self.process.returncode, self.member
        note = {"exit": code, "seconds": self.seconds + time.monotonic() - self.start}
        if code < 0:
            note["exit"] = None if self.signals else 128 - code
            note["reason"] = f"ended by signal {-code} ({signal.strsignal(-code)})"
        else:  # run.json tells it without the remedies that the log has
            told = member.record().get("stop", {}).get("reason", "")
            said = last_line(member.log_path.read_text(errors="replace"), ERROR) if code else ""
            note["reason"] = told.removeprefix("failed: ") if code == 0 or (code == 2 and "failed: " in told) else said
        write_atomic(member.note_path, json.dumps(note) + "\n")
        self.log.close()
        state, counts = member.outcome(note), member.record().get("counts", {})
        say(f"{member.name}: {state}, " + (note["reason"] if state == "failed" else
                                           f"{counts.get('steps', 0)} steps, {note['seconds']:.1f} s"))


class Computation:
    """Computes members, `jobs` at once. The first SIGINT, SIGTERM or SIGHUP asks the runs to write their checkpoints
    and end, the next one ends them at once.
    @param case  path of the case;  @param changed  called after starts and ends of members"""

    def __init__(self, program, case, jobs, retry, changed):
        self.program, self.case, self.jobs, self.changed = str(program), str(case), jobs, changed
        self.wanted = ("waiting", "interrupted", "failed") if retry else ("waiting", "interrupted")
        self.running, self.signals = [], 0
        self.environment = dict(os.environ)
        self.environment.setdefault("OMP_NUM_THREADS", str(max(1, len(os.sched_getaffinity(0)) // jobs)))
        if jobs > 1:
            self.environment["OMP_PROC_BIND"] = "false"  # else all of them bind to the same cores

    def run(self, members):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            if signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, self.count_signal)
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
        ended = [job for job in self.running if job.process.poll() is not None]
        for job in ended:
            self.running.remove(job)
            job.finish()
        return bool(ended)

    def start(self, member):
        """Starts a member, unless someone else has it or has had it. @return whether it was started"""
        member.folder.mkdir(parents=True, exist_ok=True)
        log = open(member.log_path, "ab")
        for _ in range(5):  # who only looks at the state has the lock for an instant
            if lock(log, fcntl.LOCK_EX):
                break
            time.sleep(0.02)
        else:
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
        saved = (member.folder / "checkpoint.h5").exists()
        options = [] if not note else ["--resume"] if saved else ["--overwrite"]
        seconds = note.get("seconds", 0) + (member.lost_seconds() if note and "reason" not in note else 0)
        write_atomic(member.note_path, json.dumps({"exit": None, "seconds": seconds}) + "\n")
        words = [self.program, "run", self.case, *member.words(), "--out", str(member.folder), *options]
        # A session of its own: Ctrl-C reaches the sweep alone, which passes it on.
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=log, env=self.environment,
                                   start_new_session=True)
        self.running.append(Job(member, log, process, seconds))
        say(f"{member.name}: {'resumed' if '--resume' in options else 'started'}")
