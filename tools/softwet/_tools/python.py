"""Which python3 a tool runs in: the same choice for all of them.

A tool begins with `need(modules)`. Where this interpreter lacks one, or where SOFTWET_PYTHON names another, the tool
starts again in SOFTWET_PYTHON, or else in python3, or else in /usr/bin/python3. `softwet verify` and its like start it in
the first of these that starts at all."""

import atexit
import importlib.util
import logging
import os
import shutil
import signal
import subprocess
import sys
import tempfile

NEWEST = "tomllib"  # the module that Python has since 3.11
STARTED = "SOFTWET_PYTHON_STARTED"  # in the environment of a tool that was started again


def need(*modules):
    """Goes on in a python3 of 3.11 or newer that has the modules; ends with exit code 1 or 3 and a sentence where there is none."""
    atexit.register(flush)
    sys.excepthook = tell
    chosen = os.environ.get("SOFTWET_PYTHON", "")
    started = os.environ.pop(STARTED, None) is not None
    missing = [module for module in (NEWEST, *modules) if importlib.util.find_spec(module) is None]
    if not missing and (started or not chosen or shutil.which(chosen) == sys.executable):
        if "matplotlib" in modules:
            give_folder_to_matplotlib()
        return
    for python in [chosen] if chosen else ["python3", "/usr/bin/python3"]:
        if not started and serves(python, modules):
            start_again(python)
    if chosen:
        has_no = f", has no {' and '.join(modules)}," if modules else ""
        end(f"SOFTWET_PYTHON = '{chosen}' does not start{has_no} or is older than 3.11; give a python3 that serves, or unset it", 1)
    packages = " ".join(f"python3-{module}" for module in modules) or "python3"
    with_them = f" with {' and '.join(modules)}" if modules else ""
    end(f"no python3 of 3.11 or newer{with_them}; on Debian: apt-get install {packages}, elsewhere set SOFTWET_PYTHON to one", 3)


def serves(python, modules):
    """Whether the interpreter starts and has the modules."""
    question = f"from importlib.util import find_spec; raise SystemExit(None in map(find_spec, {[NEWEST, *modules]}))"
    try:
        return subprocess.run([python, "-c", question], capture_output=True).returncode == 0
    except OSError:
        return False


def give_folder_to_matplotlib():
    """Where matplotlib has no folder to write to, as without a home, it says so at every start, in several lines: it gets
    one that lasts as long as the tool."""
    logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)  # it says that its new folder has no fonts yet
    config = os.environ.get("XDG_CONFIG_HOME") or os.path.expanduser("~/.config")
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    if not os.environ.get("MPLCONFIGDIR") and not all(map(takes_files, (config, cache))):
        os.environ["MPLCONFIGDIR"] = tempfile.mkdtemp(prefix="softwet_matplotlib_")
        atexit.register(shutil.rmtree, os.environ["MPLCONFIGDIR"], ignore_errors=True)


def takes_files(base):
    """Whether there is a folder matplotlib in `base`, or can be, that takes files."""
    folder = os.path.join(base, "matplotlib")
    try:
        os.path.isabs(folder) and os.makedirs(folder, exist_ok=True)
    except OSError:
        return False
    return os.path.isabs(folder) and os.access(folder, os.W_OK)


def start_again(python):
    os.environ[STARTED] = "yes"
    os.execvp(python, [python, os.path.abspath(sys.argv[0]), *sys.argv[1:]])


def end_unread():
    """Ends a tool whose reader has read enough, as in `| head -1`, without a word."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    raise SystemExit(128 + signal.SIGPIPE)


def flush():
    """At the end of a tool: what is still to be written may find that its reader is gone."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        os._exit(128 + signal.SIGPIPE)


def tell(kind, error, trace):
    """How an error that nothing has caught is reported, unless its cause is a reader who is gone."""
    if kind is BrokenPipeError:
        os._exit(128 + signal.SIGPIPE)
    sys.__excepthook__(kind, error, trace)


def end(message, code):
    """Ends the tool with a sentence, which begins as those of softwet where that has started it."""
    name, by_softwet = os.path.basename(sys.argv[0]), "--softwet" in sys.argv[1:2]
    print(f"softwet: error: {name}: {message}" if by_softwet else f"{name}: error: {message}", file=sys.stderr)
    raise SystemExit(code)
