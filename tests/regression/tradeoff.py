#!/usr/bin/env python3
"""The command `softwet tradeoff` on a small pull: errors fall with the tolerance, what is refused or fails is a result,
a repeated command computes nothing, other definitions are refused. usage: tradeoff.py SOFTWET"""

import csv
import json
import pathlib
import shutil
import subprocess

from _scene import PULL, cases, check_true, environment, softwet

try:
    import pandas  # noqa: F401
except ImportError:
    raise SystemExit(print("no pandas: nothing to test; on Debian: apt-get install python3-pandas") or 0)
from softwet._store.computation import Computation
from softwet._store.member import Member

CASE = str(cases / "tensotaxis_pull_2d.toml")
SMALL = [*PULL[:2], "load[0].start=1", "load[0].ramp=0.5", "time.end=2", "output.fields.times=[]", "time.dt_min=0.005"]
TIME_ONLY = ["domain.elements=[32,16]"]  # of the reference: steps alone are refined
PARAMETERS = ["time.tolerance=0.1,0.02,0.005", "solver.newton.rtol=1e-2", "solver.newton.max=1", "fluid.contact_angle=200",
         "jacobian,quadrature", "domain.elements=[16,8],[24,10]"]
quiet = {**environment, "OMP_NUM_THREADS": "1"}


def tradeoff(*options, case=CASE, settings=SMALL, reference=TIME_ONLY, parameters=PARAMETERS, code=0):
    words = [word for option, values in (("--set", settings), ("--reference", reference), ("--parameters", parameters))
             for value in values for word in (option, value)]
    done = subprocess.run([softwet, "tradeoff", case, *words, *options], capture_output=True, text=True, env=quiet,
                          timeout=900)
    if done.returncode != code:
        check_true(f"exit code {code}", False, f"{done.returncode}\n{done.stdout}{done.stderr}")
    return done


def refused(name, part, *options, **changes):
    lines = tradeoff(*options, code=1, **changes).stderr.strip().splitlines()
    good = len(lines) == 1 and lines[0].startswith("softwet: error: ") and part in lines[0]
    check_true(f"refused: {name}", good, str(lines))


def rows_of(folder):
    with open(pathlib.Path(folder) / "tradeoff.csv", newline="") as file:
        return {row["member"]: row for row in csv.DictReader(file)}


def stamps(folder):
    return {path: path.stat().st_mtime_ns for path in sorted(pathlib.Path(folder).glob("*/*"))}


for folder in ("pull", "limited", "counted"):
    shutil.rmtree(folder, ignore_errors=True)

listed = tradeoff("--out", "pull", "--dry-run").stdout
parts = ("base: waiting", "time.tolerance=0.02: waiting", "fluid.contact_angle=200: does not apply")
check_true("--dry-run lists the members", all(part in listed for part in parts), listed)
check_true("--dry-run writes nothing", not pathlib.Path("pull").exists())

done = tradeoff("--out", "pull", "--combine", "1")
rows, told = rows_of("pull"), json.loads(pathlib.Path("pull/tradeoff.json").read_text())
states = {name: row["status"] for name, row in rows.items()}
wanted = {"base": "done", "reference": "done", "companion": "done", "time.tolerance=0.02": "done",
          "solver.krylov.jacobian=difference": "done", "solver.newton.max=1": "failed", "fluid.contact_angle=200": "refused",
          "domain.elements=16_8": "done", "domain.elements=24_10": "refused"}
check_true("members and how they ended", wanted.items() <= states.items(), str(states))
for name, part in (("fluid.contact_angle=200", "(0, 180)"), ("solver.newton.max=1", "Newton"),
                   ("domain.elements=24_10", "multiple of the element height")):
    check_true(f"the program's reason of {name}", part in rows[name]["reason"], rows[name]["reason"])
check_true("both are reported", "does not apply: " in done.stdout and "failed: " in done.stdout, done.stdout)

# The reference differs from these members in its steps alone: the error is the error of the steps. Steps as long as
# the steps of 0.1 are beyond the range in which errors fall with them: their energy is nearer than with 0.02.
by_tolerance = ["time.tolerance=0.02", "time.tolerance=0.005", "base"]
for name in ("path", "energy"):
    errors = [float(rows[member][name]) for member in by_tolerance]
    falling = errors == sorted(errors, reverse=True) and errors[0] > 3 * errors[-1]
    check_true(f"{name}: errors fall with the tolerance", falling, str(errors))
    estimate = told["reference_error"][name]
    check_true(f"{name}: the reference is nearer than the base", 0 < estimate < errors[-1], f"{estimate}, {errors[-1]}")
differing, exact = (float(rows[name]["path"]) for name in ("solver.krylov.jacobian=difference", "base"))
# Differences are multiplied in double precision, the base in single: Newton's method ends at other residuals, all below
# its tolerance of 1e-3.
check_true("how the Jacobian is multiplied changes no result", abs(differing - exact) < 1e-2 * exact, f"{differing} {exact}")
check_true("no fields, no density", rows["base"]["density"] == "" and rows["base"]["wall"] == "")
check_true("costs are the ones of run.json", all(
    int(row["krylov"]) == json.loads(pathlib.Path("pull", name, "run.json").read_text())["counts"]["krylov"]
    for name, row in rows.items() if row["status"] == "done"))
check_true("ratios", rows["base"]["ratio"] == "1" and float(rows["reference"]["ratio"]) > 1)
front = [row for row in rows.values() if row["front"] == "1"]
check_true("a front without reference", front and not {row["kind"] for row in front} & {"reference", "companion"})
check_true("a combination", sum(row["kind"] == "combination" for row in rows.values()) == 1, str(states))
text = pathlib.Path("pull/tradeoff.md").read_text()
check_true("the table for a page", "| * |" in text and "softwet tradeoff " in text and "**path**" in text)

# Again: nothing is computed, and the tables are the same.
before, table = stamps("pull"), pathlib.Path("pull/tradeoff.csv").read_text()
again = tradeoff("--out", "pull", "--combine", "1")
check_true("again: no member is started", "started" not in again.stdout and stamps("pull") == before, again.stdout)
check_true("again: the same table", pathlib.Path("pull/tradeoff.csv").read_text() == table)
refused("another end", "holds another comparison", "--out", "pull", settings=[*SMALL, "time.rho_inf=0.6"])
refused("another reference", "holds another comparison", "--out", "pull", reference=[])
refused("no such parameter", "there is no such parameter", "--out", "pull", parameters=["toleranse"])
refused("no case", "no.toml", "--out", "nowhere", case="no.toml")
refused("a wrong setting", "must be", "--out", "nowhere", settings=["time.rho_inf=7"])
refused("no number of jobs", "--jobs 0", "--out", "nowhere", "--jobs", "0")
refused("no number of threads", "--threads 0", "--out", "nowhere", "--threads", "0")
check_true("refusals write nothing", not pathlib.Path("nowhere").exists())

# --threads: of each member. One setting is changed.
tradeoff("--out", "counted", "--threads", "2", "--combine", "0", settings=[*SMALL, "time.max_steps=2"],
         parameters=["time.rho_inf=0.6"])
threads = [json.loads(path.read_text())["threads"] for path in pathlib.Path("counted").glob("*/run.json")]
check_true("--threads reaches the members", len(threads) == 4 and set(threads) == {2}, str(threads))
check_true("and the command in the table", "--threads=2" in pathlib.Path("counted/tradeoff.md").read_text())

# A member that takes too long is asked to end, counts as failed, and is not computed again.
folder = pathlib.Path("limited").resolve() / "long"
member = Member("long", (), ["time.dt_initial=1e-4", "time.dt_max=1e-4", *SMALL[:2]], folder)
for _ in range(2):
    Computation(softwet, CASE, 1, False, lambda: None, limit=1).run([member])
    state, note = member.status()
    check_true("a member that is too slow", state == "failed" and "slower than its limit" in note["reason"] and
               note["seconds"] < 20 and 0 < note["processor"] < 20, str(note))
