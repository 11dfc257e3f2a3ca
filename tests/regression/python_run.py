#!/usr/bin/env python3
"""The Python package computes cases with the program: what comes out, what is refused, how Ctrl-C ends a run, and the
examples of docs/python.md. usage: python_run.py SOFTWET"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy
from _scene import PULL, cases, check, check_true, environment, tools
from _same import check_same

import softwet
from softwet.definition import assignments, toml_file, toml_text, values_of

DOCS = tools.parent / "docs"
PULL_CASE = cases / "tensotaxis_pull_2d.toml"
SETS = {"domain.elements": [32, 16], "fluid.capillarity": "1/16", "load[0].start": 2, "load[0].ramp": numpy.float64(1),
        "time.end": 4, "output.fields.times": (0, 4)}
LAYER = {"name": "layer", "domain": {"size": numpy.array([1.0, 0.125]), "elements": [16, 4]},
         "substrate": {"thickness": 0.125, "young": "0.7 + 0.1*x", "poisson": 0.3},
         "load": [{"box": [[0.7, 0.0], [0.8, 0.125]], "force": [0.1, 0.0]}], "solver": {"newton": {"rtol": 1e-4}},
         "time": {"end": 2.0}}


def refused(name, action, code, *parts):
    try:
        action()
    except softwet.Problem as problem:
        return check_true(f"refused: {name}", getattr(problem, "code", 0) == code and all(part in str(problem) for part in parts) and
                          "softwet: error" not in str(problem), f"{getattr(problem, 'code', 0)} {problem}")
    check_true(f"refused: {name}", False)


# --- from Python to TOML -------------------------------------------------------------------------------------------
check_true("values", [toml_text(value) for value in (3, numpy.int64(3), 0.1, numpy.float32(0.5), "a\"b\\\n", [1, (2.5,)],
                                                     True, pathlib.Path("x"), {"a b": 1})] ==
           ["3", "3", "0.1", "0.5", '"a\\"b\\\\\\n"', "[1, [2.5]]", "true", '"x"', '{ "a b" = 1 }'])
check_true("settings", assignments({"a": "1/64", "b": [1, 2]}) == ["--set", "a=1/64", "--set", "b=[1, 2]"])
check_true("tables", toml_file({"load": [{"a": 1}, {"a": 2}], "name": "n", "time": {"end": 1}, "empty": []}) ==
           'name = "n"\nempty = []\n[[load]]\na = 1\n[[load]]\na = 2\n[time]\nend = 1\n')
refused("a value that is none", lambda: softwet.Case({"name": object()}), 0, "numbers, texts, lists")

# --- cases ----------------------------------------------------------------------------------------------------------
pull = softwet.Case(PULL_CASE, SETS)
check_true("a case as a dict", dict(pull)["time"] == pull["time"] and len(dict(pull)) == len(pull) == len(list(pull)))
check_true("a case has its defaults", pull["domain"]["degree"] == 2 and pull["fluid"]["capillarity"] == 1 / 16 and "load" in pull)
check_true("warnings", any("field" in warning for warning in softwet.Case(pull, {"time.end": 3}).warnings))
again = softwet.Case(pull, {"time.end": 9})
check_true("a case of a case", (again["time"]["end"], pull["time"]["end"], again["load"][0]["start"]) == (9, 4, 2))
layer = softwet.Case(LAYER)
check_true("a case from a dict", layer["solver"]["newton"]["rtol"] == 1e-4 and layer["load"][0]["force"] == [0.1, 0])
check_true("no file is left", not list(pathlib.Path().glob(".case*")))
refused("a wrong key", lambda: softwet.Case({**LAYER, "fluids": {}}), 1, "the case:", "fluids", "did you mean")
refused("a wrong value", lambda: softwet.Case(layer, {"substrate.poisson": 0.6}), 1, "substrate.poisson = 0.6")
refused("no file", lambda: softwet.Case("nowhere.toml"), 1, "nowhere.toml")
refused("no case", lambda: softwet.Case(3), 0, "3 is not a case")
refused("no key", lambda: layer["fluid"], 0, "has no 'fluid'")

# --- runs -----------------------------------------------------------------------------------------------------------
for folder in ("here", "there", "stopped", "failed"):
    shutil.rmtree(folder, ignore_errors=True)
run = softwet.run(PULL_CASE, "here", SETS, threads=1, progress=False)
check_true("a run", isinstance(run, softwet.Run) and run.state == "done" and run.times == [0, 4] and run.history["t"][-1] == 4)
words = [word for setting in [*PULL, "time.end=4", "output.fields.times=[0,4]"] for word in ("--set", setting)]
subprocess.run([os.environ["SOFTWET_PROGRAM"], "run", str(PULL_CASE), *words, "--out", "there", "--threads", "1", "--quiet"],
               check=True, env=environment)
check_same("the program by itself", "here", "there")
refused("a folder with a result", lambda: softwet.run(pull, "here", threads=1), 1, "--overwrite")
longer = softwet.run(pull, "here", {"time.end": 5}, threads=1, progress=False, resume=True)
check_true("a run goes on", longer.history["t"][-1] == 5 and longer.record["counts"]["steps_before_resume"] > 0)
hopeless = {"solver.newton.max": 1, "time.dt_initial": 1, "time.dt_min": 0.6}
refused("a computation that fails", lambda: softwet.run(pull, "failed", hopeless, threads=1, progress=False), 2, "Newton",
        "failed/checkpoint.h5")
by_hand = softwet.run(LAYER, "failed", threads=1, progress=False, overwrite=True)
check_true("a dict is computed", by_hand.case["substrate"]["young"] == "0.7 + 0.1*x" and by_hand.state == "done")

# --- what was checked is what runs: sources that change later, and another working folder ---------------------------
for folder in ("changed", "elsewhere"):
    shutil.rmtree(folder, ignore_errors=True)
source = {**LAYER, "substrate": {**LAYER["substrate"], "young": 1.0}, "time": {"end": 0.1}}
settings = {"domain.elements": [8, 2]}
kept = softwet.Case(source, settings)
source["substrate"]["young"] = 2.0
settings["domain.elements"][0] = 12
check_true("a dict that changes later", [softwet.Case(case, {"time.end": 0.2})["substrate"]["young"] for case in (kept, source)] == [1, 2]
           and kept.run("changed", threads=1, progress=False).case["domain"]["elements"] == [8, 2])
check_true("and its run", softwet.open("changed").case["substrate"]["young"] == 1)
pathlib.Path("kept.toml").write_text(kept.text)
from_file = softwet.Case("kept.toml")
pathlib.Path("kept.toml").write_text(kept.text.replace("young = 1", "young = 3"))
check_true("a file that changes later", from_file["substrate"]["young"] == 1 and softwet.Case("kept.toml")["substrate"]["young"] == 3
           and from_file.run("changed", threads=1, progress=False, overwrite=True).case["substrate"]["young"] == 1)
earlier = softwet.Case(kept, {"initial.from": "changed"})
pathlib.Path("elsewhere").mkdir()
os.chdir("elsewhere")
moved = from_file.run("run", threads=1, progress=False)
second = earlier.run("second", threads=1, progress=False)
os.chdir("..")
check_true("another working folder", moved.history["t"][-1] == 0.1 and second.history["t"][-1] == 0.1)
check_true("the resolved case holds from any folder", pathlib.Path(second.case["initial"]["from"]) == pathlib.Path("changed").resolve())
check_true("no file is left by them", not list(pathlib.Path().glob("**/.case*")))

# --- a sweep --------------------------------------------------------------------------------------------------------
for folder in ("swept", "broken"):
    shutil.rmtree(folder, ignore_errors=True)
check_true("values", values_of({"a": [1, numpy.float64(0.5), "1/3", [1, 2.5]], "b": "0:1:3"}) ==
           ["--vary", "a=1,0.5,1/3,[1,2.5]", "--vary", "b=0:1:3"])
of_layer = {"domain.elements": [8, 2], "time.end": 0.1}
kinds = {"substrate.poisson": [0.1, 0.3], "load[0].force": [[0.1, 0], [-0.1, 0]]}
swept = softwet.sweep(LAYER, kinds, "swept", of_layer, jobs=2, threads=1, columns=["energy_elastic"], progress=False)
check_true("its members", isinstance(swept, softwet.Sweep) and len(swept) == 4 and {member.status for member in swept} == {"done"} and
           swept[1].values == {"substrate.poisson": 0.1, "load[0].force": [-0.1, 0]})
table = swept.table
check_true("its table", table["substrate.poisson"] == [0.1, 0.1, 0.3, 0.3] and table["t"] == [0.1] * 4 and
           table["status"] == ["done"] * 4 and all(map(numpy.isnan, table["velocity_peak"])) and
           table["energy_elastic"] == [member.run.history["energy_elastic"][-1] for member in swept])
before = pathlib.Path("swept", swept[0].name, "history.csv").stat().st_mtime_ns
more = softwet.sweep(LAYER, {**kinds, "substrate.poisson": [0.1, 0.3, 0.4]}, "swept", of_layer, threads=1, progress=False)
check_true("values are added, and the others stay", len(more) == 6 and softwet.open_sweep("swept").table["t"] == [0.1] * 6 and
           pathlib.Path("swept", swept[0].name, "history.csv").stat().st_mtime_ns == before)
broken = softwet.sweep(LAYER, {"solver.newton.max": [1, 20]}, "broken", {**of_layer, "time.dt_initial": 0.1, "time.dt_min": 0.05},
                       threads=1, progress=False)
check_true("a member that fails is in the table", broken.table["status"] == ["failed", "done"] and numpy.isnan(broken.table["x_centre"][0]))
refused("a wrong value of a sweep", lambda: softwet.sweep(LAYER, {"substrate.poisson": [0.1, 0.6]}, "none", of_layer), 1,
        "substrate.poisson = 0.6")
refused("nothing to vary", lambda: softwet.sweep(LAYER, {}), 0, "nothing to vary", "'substrate.poisson': [")
try:
    import pandas
except ImportError:
    print("no pandas: nothing is read as a DataFrame; on Debian: apt-get install python3-pandas")
else:
    frame, history = pandas.DataFrame(more.table), pandas.DataFrame(swept[0].run.history)
    check_true("pandas: a sweep and a history", len(frame) == 6 and frame[frame["substrate.poisson"] < 0.2]["status"].eq("done").all() and
               len(history) == len(swept[0].run.history["t"]) and history["t"].iloc[-1] == 0.1)

# --- Ctrl-C, of Python alone, as the stop button of a notebook sends it ---------------------------------------------
code = f"""
import softwet
case = softwet.Case({str(PULL_CASE)!r}, {{"domain.elements": [64, 32], "fluid.capillarity": "1/32"}})
try:
    case.run("stopped", threads=1)
except KeyboardInterrupt:
    print("stopped is", softwet.open("stopped").state)
"""
process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                           env={**environment, "PYTHONPATH": str(tools)})
end = time.monotonic() + 900
while not pathlib.Path("stopped/run.json").exists() and process.poll() is None and time.monotonic() < end:
    time.sleep(0.05)
process.send_signal(signal.SIGINT)
out, told = process.communicate(timeout=900)
check_true("Ctrl-C stops the run with a checkpoint", process.returncode == 0 and "stopped is stopped" in out and
           pathlib.Path("stopped/checkpoint.h5").exists(), f"{process.returncode} {out} {told}")
check_true("and what the program says is passed on", "stopped by user" in told and "--resume" in told, told)

# --- pyvista, played by a class: its StructuredGrid takes points with x fastest -------------------------------------
pathlib.Path("pyvista.py").write_text("class StructuredGrid:\n    def __init__(self):\n        self.point_data = {}\n")
sys.path.insert(0, str(pathlib.Path().resolve()))
solid = softwet.open("there").fields(4, "solid")
grid = solid.to_pyvista("displacement", "volume_ratio")
check_true("pyvista: a grid", grid.dimensions == (65, 9, 1) and grid.points.shape == (585, 3) and
           list(grid.point_data) == ["displacement", "volume_ratio"] and grid.point_data["volume_ratio"].shape == (585,))
check("pyvista: points and values in one order", abs((grid.points - grid.point_data["displacement"])[:, :2] -
                                                      solid.reference.reshape(-1, 2)).max(), 1e-12)
check_true("pyvista: x goes fastest", grid.points[1, 0] > grid.points[0, 0])
check_true("pyvista: all fields, tensors in rows of nine", solid.to_pyvista().point_data["cauchy_stress"].shape == (585, 9))

# --- the documentation ----------------------------------------------------------------------------------------------
if not pathlib.Path("cases").exists():
    pathlib.Path("cases").symlink_to(cases)
shutil.rmtree("out", ignore_errors=True)
blocks = re.findall(r"```python\n(.*?)```", (DOCS / "python.md").read_text(), re.DOTALL)
result = subprocess.run([sys.executable, "-W", "error", "-c", "\n".join(blocks)], capture_output=True, text=True,
                        env={**environment, "PYTHONPATH": str(tools)}, timeout=900)
check_true("docs/python.md", result.returncode == 0 and "1 --set substrate.poisson=0.6" in result.stdout, result.stdout + result.stderr)
try:
    import scipy.optimize  # noqa: F401
except ImportError:
    sys.exit(print("no scipy: docs/fit_young.py is left out"))
result = subprocess.run([sys.executable, "-W", "error", str(DOCS / "fit_young.py")], capture_output=True, text=True,
                        env={**environment, "PYTHONPATH": str(tools)}, timeout=900)
found = re.search(r"Young's modulus: ([0-9.]+)", result.stdout)
check_true("docs/fit_young.py", result.returncode == 0 and found, result.stdout + result.stderr)
check("it finds the modulus of which the heights were made", abs(float(found.group(1)) - 0.5), 2e-3)
