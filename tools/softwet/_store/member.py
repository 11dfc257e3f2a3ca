"""One run of several that are kept in a folder.

The folder of a member is the output folder of its run, with two more files: member.log, what the run says, and
member.json, how it ended. The log is locked as long as the run, or the tool that started it, lives; so several tools,
on several machines too, may work on the same folder, and a tool that is killed leaves nothing that says "running"."""

import fcntl
import os
import subprocess

from .files import lock, read_json

STOPPED = "stopped by user"  # the reason of run.json


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
        """@return the state, and the note on how it ended: exit, reason, seconds, and `again` where the machine ended
        it (a full disk) and it can go on. A note without exit belongs to a run that did not come to its end; there is
        none before the first start."""
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
