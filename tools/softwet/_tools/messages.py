"""How tools speak to the user: one sentence for each error, one line for each event."""

import errno
import os
import pathlib
import sys

from ..problem import Problem
from ..program import ERROR, find_program

REMEDIES = {
    errno.EEXIST: "a file has that name; choose another folder, or move the file",
    errno.ENOTDIR: "a part of the path is a file; choose another path",
    errno.EISDIR: "a folder has that name; give the name of a file",
    errno.ENOENT: "make its folder, or choose another path",
    errno.ENAMETOOLONG: "choose a shorter path, whose names have 255 bytes at most",
    errno.EACCES: "it is not yours; choose another path, or ask its owner",
    errno.EPERM: "it is not yours; choose another path, or ask its owner",
    errno.EROFS: "the file system is read-only; choose another path",
    errno.ENOSPC: "the disk is full; make room and give the same command again",
    errno.EDQUOT: "your share of the disk is full; make room and give the same command again",
    errno.ENOEXEC: "it is no program of this machine; give --softwet the one that tools/setup builds",
}


def fail(message, code=1):
    print(f"{ERROR}{message}", file=sys.stderr)
    raise SystemExit(code)


def fail_of_machine(error):
    """Ends with exit code 3 and the remedy of an OSError; with 1 where the path itself is wrong."""
    place = f"cannot use '{error.filename}': " if error.filename else ""
    fail(f"{place}{error.strerror or error}; {REMEDIES.get(error.errno, 'the same command goes on')}", 1 if error.errno == errno.ENAMETOOLONG else 3)


def say(message):
    """Prints a line that begins with the name of the tool."""
    try:
        print(f"{os.path.basename(sys.argv[0])}: {message}", flush=True)
    except OSError:  # the terminal is gone; the computation goes on
        sys.stdout = open(os.devnull, "w")


def last_line(text, start):
    """The last line that starts so, without the start."""
    return next((line[len(start):] for line in reversed(text.splitlines()) if line.startswith(start)), "")


def need_program(path):
    """The path of softwet, resolved: the given one, else the one that the Python package starts. Refuses what is no
    program."""
    try:
        path = path or pathlib.Path(find_program())
    except Problem as problem:
        fail(problem, 3)
    if not path.exists():
        fail(f"{path} is not there; build it with tools/setup", 3)
    if not path.is_file() or not os.access(path, os.X_OK):
        fail(f"--softwet {path}: is not a program; give the path of softwet, which tools/setup builds", 3)
    return path.resolve()
