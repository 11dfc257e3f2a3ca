"""Runs of small scenes with softwet, and their results."""

import os
import pathlib
import subprocess
import sys

tools = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tools"
sys.path.insert(0, str(tools))
from softwet import open as open_output  # noqa: E402

softwet = str(pathlib.Path(sys.argv[1]).resolve())
cases = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "cases"
# Threads that wait without spinning: the tests share the machine with others. Python starts the program under test.
environment = {**os.environ, "OMP_WAIT_POLICY": "passive", "SOFTWET_PROGRAM": softwet}
os.environ.update(environment)

# A pull and a rigid droplet that take seconds.
PULL = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "load[0].start=2", "load[0].ramp=1",
        "time.end=10", "output.fields.times=[0,10]"]
RIGID = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "time.end=20", "output.fields.times=[0,20]"]
TIGHT = ["solver.newton.rtol=1e-11", "solver.newton.atol=1e-14", "solver.krylov.rtol=1e-4"]


def command(case, folder, settings=(), options=()):
    return command_of_file(cases / f"{case}.toml", folder, settings, options)


def command_of_file(path, folder, settings=(), options=()):
    sets = [word for setting in settings for word in ("--set", setting)]
    return [softwet, "run", str(path), "--out", str(folder), *sets, *options]


def run(case, folder, settings=(), options=("--overwrite", "--quiet", "--threads", "1"), code=0):
    """Runs a case of cases/ to the end and returns what was printed on stderr."""
    return run_file(cases / f"{case}.toml", folder, settings, options, code)


def run_file(path, folder, settings=(), options=("--overwrite", "--quiet", "--threads", "1"), code=0):
    result = subprocess.run(command_of_file(path, folder, settings, options), capture_output=True, text=True,
                            timeout=900, env=environment)
    if result.returncode != code:
        sys.exit(f"exit code {result.returncode}, not {code}: {result.args}\n{result.stderr}")
    return result.stderr


def write_box(name, height, elements, capillarity, angle, tables):
    """Writes <name>.toml: a scene in a box 0.8 x 0.8 x height whose mesh is so coarse that it takes seconds.
    @param tables  the rest of the case: droplets, substrate, time, ..."""
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
[domain]
size = [0.8, 0.8, {height}]
elements = {elements}
[fluid]
viscosity = 0.05
capillarity = {capillarity}
temperature = 0.39
contact_angle = {angle}
[solver]
krylov = {{ preconditioner = "lu" }}
{tables}""")


def history(folder):
    """Columns of history.csv by name; an empty cell is nan."""
    return open_output(folder).history


def record(folder):
    return open_output(folder).record


def hears(pid, number):
    """Whether a process has a handler for a signal, and so hears it."""
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("SigCgt:"):
            return bool(int(line.split()[1], 16) >> (number - 1) & 1)
    return False


def check(name, value, bound):
    """Prints a figure and its bound; ends the test where the bound is broken."""
    print(f"{'ok' if value <= bound else 'FAIL':4}  {name}: {value:.3g} (allowed {bound:.3g})")
    if not value <= bound:
        sys.exit(1)


def check_true(name, condition, detail=""):
    print(f"{'ok' if condition else 'FAIL':4}  {name} {detail}")
    if not condition:
        sys.exit(1)
