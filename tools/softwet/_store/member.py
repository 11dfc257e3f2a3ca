"""Members of a sweep: their folders and their table. Used by tools/sweep and tools/tradeoff.

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
import socket
import subprocess
import sys

from .._tools.messages import WARNING

STOPPED = "stopped by user"  # the reason of run.json
# The default ones: those of a droplet.
COLUMNS = ["x_centre", "velocity", "angle_left", "angle_right", "ridge_left", "ridge_right", "dimple", "mass_drift"]


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
        """@return the state, and the note on how it ended: exit, reason, seconds, and `again` where the machine ended it
        (a full disk) and it can go on. A note without exit is that of a run that did not come to its end; there is none
        before the first start."""
        running = self.is_locked()  # before the note, which is final once the lock is gone
        note = read_json(self.note_path)
        return "running" if running else self.outcome(note), note

    @staticmethod
    def outcome(note):
        if not note:
            return "waiting"
        if note.get("exit") is None or note["reason"] == STOPPED or note.get("again"):
            return "interrupted"
        return "done" if note["exit"] == 0 else "failed"

    def lost_seconds(self):
        """Seconds that run.json knows of and the note does not, for a run whose sweep was killed."""
        known = self.record().get("seconds", {}).get("total", 0)
        return max(0, known - read_json(self.note_path).get("seconds", 0))


def ask_check(program, case, member):
    """What `softwet check` says of a member. @return CompletedProcess, with its stdout and stderr"""
    words = [str(program), "check", str(case), *member.words()]
    return subprocess.run(words, text=True, capture_output=True, env={**os.environ, "OMP_NUM_THREADS": "1"})


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
