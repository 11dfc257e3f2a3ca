"""run.json, and whether the run it describes is alive. Needs nothing but Python."""

import errno
import fcntl
import json
import os
import socket

from .problem import Problem


def read_record(folder):
    """run.json as a dict; {} where the run has not written it yet. @param folder  a pathlib.Path; raises Problem"""
    path = folder / "run.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except (OSError, ValueError) as error:
        raise Problem(f"cannot read {path}: {error}; is it cut? resume the run, which writes it again") from error


def is_locked(folder):
    """Whether a run writes to the folder: it holds a lock as long as it lives. None where locks give no answer, which
    is where the file system has none."""
    descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
        return False
    except OSError as error:
        return True if error.errno in (errno.EWOULDBLOCK, errno.EACCES) else None
    finally:
        os.close(descriptor)


def told_state(record):
    """running, done, stopped or failed, as run.json says; records without `state` say it by `stop.reason`."""
    if "state" in record:
        return record["state"]
    reason = record.get("stop", {}).get("reason", "running")
    known = {"running": "running", "end reached": "done"}
    return known.get(reason, "failed" if reason.startswith("failed") else "stopped")


def state(folder, record):
    """The state of a run: running, done, stopped, failed, or `died` where run.json does not record the end and no
    process of this machine holds the folder. A run of another machine is believed, since locks may not reach from there
    to here."""
    told = told_state(record)
    if told != "running" or is_locked(folder) is not False:
        return told
    here = record.get("host", socket.gethostname()) == socket.gethostname()
    return "died" if here else told
