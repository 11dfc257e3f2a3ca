"""The program softwet, which this package starts: where it is, what it says, and how it ends."""

import os
import pathlib
import shutil
import signal
import subprocess
import sys

from .problem import Problem

ERROR, WARNING = "softwet: error: ", "softwet: warning: "
HERE = pathlib.Path(__file__).resolve().parent


class Failure(Problem):
    """The program has refused a case, or a run has failed: the text is the sentence of the program.

    code  its exit code: 1 the case or a setting is wrong, 2 the computation failed, 3 the machine failed; negative: the
          number of the signal that ended it"""

    def __init__(self, code, text):
        super().__init__(text)
        self.code = code


def find_program():
    """The path of the program: SOFTWET_PROGRAM, else that of the installation or of the build that this package is part
    of, else the one on PATH. Raises Problem where there is none."""
    chosen = os.environ.get("SOFTWET_PROGRAM")
    if chosen:
        if shutil.which(chosen):
            return chosen
        raise Problem(f"SOFTWET_PROGRAM = '{chosen}' is not a program; give the path of softwet, or unset it")
    places = [HERE / "program/bin/softwet"]  # of a wheel
    if HERE.parent.name == "tools":
        places += [HERE.parents[3] / "bin/softwet",  # of PREFIX/share/softwet/tools
                   HERE.parents[1] / "build" / os.environ.get("SOFTWET_PRESET", "release") / "softwet"]
    for place in places:
        if os.access(place, os.X_OK) and place.is_file():
            return str(place)
    found = shutil.which("softwet")
    if found:
        return found
    raise Problem("there is no program softwet: build it with tools/setup, install it, or set SOFTWET_PROGRAM to its path")


def sentences(lines, mark):
    """What follows a mark at the beginning of lines."""
    return [line[len(mark):] for line in lines if line.startswith(mark)]


def fail(code, lines):
    """Raises Failure with what the program has said on stderr."""
    told = sentences(lines, ERROR) or lines[-1:] or [f"softwet was ended by signal {-code}" if code < 0 else
                                                    f"softwet ended with exit code {code}"]
    raise Failure(code, "\n".join(told))


def ask(*words):
    """Starts the program and waits for it. @return (stdout, lines of stderr); raises Failure"""
    try:
        done = subprocess.run([find_program(), *words], capture_output=True, text=True, errors="replace",
                              stdin=subprocess.DEVNULL)
    except OSError as error:
        raise Problem(f"softwet does not start: {error}") from error
    lines = done.stderr.splitlines()
    if done.returncode != 0:
        fail(done.returncode, lines)
    return done.stdout, lines


def compute(words, tell):
    """Starts the program, passes on what it says, and waits for it. An exception on the way, as Ctrl-C raises, asks the
    program to stop, waits for its checkpoint, and goes on. @param `tell`  called with each line; raises Failure"""
    try:
        process = subprocess.Popen([find_program(), *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, text=True, errors="replace")
    except OSError as error:
        raise Problem(f"softwet does not start: {error}") from error
    lines = []
    with process:
        try:
            for line in process.stdout:
                lines.append(line.rstrip("\n"))
                if not line.startswith(ERROR):  # that comes as an exception
                    tell(lines[-1])
        except BaseException:
            stop(process, tell)
            raise
    if process.returncode != 0:
        fail(process.returncode, lines)


def stop(process, tell):
    """Asks a run to stop and waits until it has. A second Ctrl-C ends it at once."""
    while True:
        try:
            process.send_signal(signal.SIGINT)
            for line in process.stdout:
                tell(line.rstrip("\n"))
            process.wait()
            return
        except KeyboardInterrupt:
            continue


def tell_on_stderr(line):
    print(line, file=sys.stderr, flush=True)
