"""Which python3 a tool runs in: the same choice for all of them.

A tool begins with `need(modules)`. Where this interpreter lacks one, or where SOFTWET_PYTHON names another, the tool
starts again in SOFTWET_PYTHON, or else in python3, or else in /usr/bin/python3. `softwet verify` and its like start it
in the first of these that starts at all."""

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
OF_PIP = {"pyvista"}  # modules that Debian 12 has no package of
STARTED = "SOFTWET_PYTHON_STARTED"  # in the environment of a tool that was started again


def need(*modules):
    """Goes on in a python3 of 3.11 or newer that has the modules; ends with exit code 1 or 3 and a sentence where there
    is none."""
    atexit.register(flush)
    sys.excepthook = tell
    chosen = os.environ.get("SOFTWET_PYTHON", "")
    started = os.environ.pop(STARTED, None) is not None
    missing = [module for module in (NEWEST, *modules) if importlib.util.find_spec(module) is None]
    if not missing and (started or not chosen or shutil.which(chosen) == sys.executable):
        if "matplotlib" in modules:
            give_folder_to_matplotlib()
        return
    others = [chosen] if chosen else ["python3", "/usr/bin/python3"]
    lacking = [None if NEWEST in missing else missing] if started else [lacks(python, modules) for python in others]
    for python, found in zip(others, lacking):
        if found == [] and not started:
            start_again(python)
    least = min((found for found in lacking if found is not None), key=len, default=None)
    end_without(chosen, list(modules) if least is None else least, least is not None)


def end_without(chosen, lacking, starts):
    """Ends with a sentence that names the modules that are lacking. @param starts  whether the interpreter does"""
    remedies = {"on Debian: apt-get install": [f"python3-{name}" for name in lacking if name not in OF_PIP],
                "python3 -m pip install": [name for name in lacking if name in OF_PIP]}
    remedy = ", ".join(f"{command} {' '.join(names)}" for command, names in remedies.items() if names)
    if chosen and not starts:
        end(f"SOFTWET_PYTHON = '{chosen}' does not start or is older than 3.11; give another python3, or unset it", 1)
    if chosen:
        end(f"SOFTWET_PYTHON = '{chosen}' has no {' and '.join(lacking)}; {remedy}, or give another python3", 1)
    with_them = f" with {' and '.join(lacking)}" if lacking else ""
    end(f"no python3 of 3.11 or newer{with_them}; {remedy or 'on Debian: apt-get install python3'}, elsewhere set SOFTWET_PYTHON to one", 3)


def lacks(python, modules):
    """The modules that an interpreter has not; None where it does not start or is older than 3.11."""
    question = f"from importlib.util import find_spec; print(*[name for name in {[NEWEST, *modules]} if find_spec(name) is None])"
    try:
        done = subprocess.run([python, "-c", question], capture_output=True, text=True)
    except OSError:
        return None
    return None if done.returncode or NEWEST in done.stdout.split() else done.stdout.split()


def give_folder_to_matplotlib():
    """Where matplotlib has no folder to write to, as without a home, it says so at every start, in several lines: it
    gets one that lasts as long as the tool."""
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
    """Ends the tool with a sentence, which begins as softwet's sentences do where softwet has started it."""
    name, by_softwet = os.path.basename(sys.argv[0]), "--softwet" in sys.argv[1:2]
    print(f"softwet: error: {name}: {message}" if by_softwet else f"{name}: error: {message}", file=sys.stderr)
    raise SystemExit(code)
