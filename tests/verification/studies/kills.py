"""Runs whose processes are killed and resumed, against runs that were not disturbed.

Each run is computed once without a disturbance, and once with a checkpoint after each step, by processes that are killed
(SIGKILL) at moments which differ each time: between two steps, while a step is computed, while a checkpoint, a table or a
field file is written, and while the checkpoint of the process before is read. The next process resumes the run, with 1, 2 or
3 threads in turn. Compared bit by bit: history.csv, interface.csv, the lists of the field files, all arrays of the field
files and of the last checkpoint, and how often the solvers have iterated and built."""

import re
import resource
import subprocess
import sys

import _lab

sys.path.insert(0, str(_lab.ROOT / "tests" / "regression"))
from _bits import differences  # noqa: E402
from _kills import first_process, with_kills  # noqa: E402

MINUTES = {"quick": 0.3, "full": 10}
EXPLICIT = "The explicit schemes are among its runs."
PULL = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "load[0].start=2", "load[0].ramp=1",
        "output.fields.times=[-1,0,1,3]", "time.end=3"]
FAST = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.temperature=0.7", "load[0].start=0.3", "load[0].ramp=0.2",
        "load[0].force=[2,0]", "output.fields.times=[0,0.1]", "output.history.every=1"]
NEEDLE = ["domain.elements=[20,20,10]", "fluid.capillarity=2/25", "time.dt_max=0.2", "output.fields.times=[0]"]

# Name: case, settings of the full and of the quick form, interruptions in them, processes.
RUNS = {
    "2D, generalized_alpha": ("tensotaxis_pull_2d", [*PULL, "time.dt_initial=0.006", "time.dt_max=0.006"],
                              [*PULL, "time.dt_max=0.1"], 400, 4, 1),
    "2D, a row for every 7 steps": ("tensotaxis_pull_2d", [*PULL, "time.dt_max=0.03", "output.history.every=7"], None, 100, 0, 1),
    "2D, schwarz, around a periodic axis":
        ("tensotaxis_pull_2d", [*PULL, "time.dt_max=0.03", "solver.krylov.preconditioner=schwarz", "boundary.left=periodic",
                                "boundary.right=periodic"], None, 100, 0, 1),
    "3D, generalized_alpha": ("fig4_needle_3d_small", [*NEEDLE, "time.max_steps=100"], None, 50, 0, 1),
    "kick_drift, corrected": ("tensotaxis_pull_2d", [*FAST, "time.scheme=kick_drift", "time.end=0.8"],
                              [*FAST, "time.scheme=kick_drift", "time.end=0.1"], 75, 3, 1),
    "ssp_rk3, lumped": ("tensotaxis_pull_2d", [*FAST, "time.scheme=ssp_rk3", "time.mass=lumped", "time.end=0.8"], None, 75, 0, 1),
    "rkl2, corrected": ("tensotaxis_pull_2d", [*FAST, "time.scheme=rkl2", "time.end=0.8"], None, 75, 0, 1),
    "kick_drift, consistent": ("tensotaxis_pull_2d", [*FAST, "time.scheme=kick_drift", "time.mass=consistent", "time.end=0.2"],
                               None, 75, 0, 1),
    "2D, generalized_alpha, 2 processes": ("tensotaxis_pull_2d", [*PULL, "time.dt_max=0.03"], None, 50, 0, 2),
}


def processor_seconds():
    """Of all processes so far that this one has started and that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def disturbed(lab, name, case, settings, interruptions, processes):
    """@return the row of the table"""
    whole = lab.run(name, case, settings)
    folder = lab.store.folder / f"killed_{whole.folder.name}"
    steps = whole.record["counts"]["steps"]
    path, _ = lab.case_file(case)

    def begin(number, more, options):
        words = [str(lab.program), "run", str(path), "--out", str(folder), "--quiet", "--threads", str(1 + number % 3), *options]
        for setting in [*settings, *more]:
            words += ["--set", setting]
        launcher = [str(_lab.ROOT / "tools" / "_ranks"), str(processes)] if processes > 1 else []
        return subprocess.Popen([*launcher, *words], stderr=subprocess.PIPE, text=True, env=_lab.ENVIRONMENT)

    before = processor_seconds()
    killed = with_kills(begin, folder, steps, interruptions, (lambda: first_process(folder)) if processes > 1 else None)
    lab.seconds[f"{name}, killed"] = processor_seconds() - before
    different = differences(folder, whole.folder)
    lab.expect(f"{name}: {steps} steps, killed {killed} times: results that differ in a bit", "none",
               ", ".join(different) or "none", not different)
    return name, steps, killed, interruptions - killed, ", ".join(different) or "none"


def study(lab):
    about = subprocess.run([str(lab.program), "info"], capture_output=True, text=True, check=True).stdout
    rows = []
    for name, (case, full, quick, many, few, processes) in RUNS.items():
        settings, interruptions = (quick, few) if lab.quick else (full, many)
        missing = "3D degree 2" if name.startswith("3D") and "3D degree 2" not in about else "MPI" if (
            processes > 1 and not re.search("MPI +yes", about)) else ""
        if missing and not lab.quick:
            lab.text(f"Left out, because this program was built without {missing}: {name}.")
        elif settings:
            rows.append(disturbed(lab, name, case, settings, interruptions, processes))
    lab.title("Kills")
    lab.table(("run", "steps", "killed", "ended by themselves before", "results that differ"), rows, "runs")
