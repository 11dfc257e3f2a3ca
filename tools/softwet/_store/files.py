"""Files of a folder of runs: whole or not at all, read where they are there, and locked by who works on them."""

import csv
import errno
import fcntl
import io
import json
import os
import socket
import time


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


def write_csv(path, rows):
    """A table: one row of names, and one of values each."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    write_atomic(path, text.getvalue())


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


def take(file):
    """Locks a file for this process. @return whether it could; who only looks at it has the lock for an instant"""
    for _ in range(5):
        if lock(file, fcntl.LOCK_EX):
            return True
        time.sleep(0.05)
    return False
