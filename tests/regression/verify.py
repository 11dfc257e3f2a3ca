#!/usr/bin/env python3
"""The command `softwet verify`: its list, its errors, its exit codes, its files. usage: verify.py SOFTWET"""

import os
import pathlib
import shutil
import subprocess
import sys

from _scene import check_true, softwet

STUDY = '''"""A solid layer.

Its height. And more."""
from _lab import Known

MINUTES = {{"quick": 0.1, "full": 0.1}}


def study(lab):
    run = lab.run("layer", "solid_layer_2d", ["{setting}"])
    lab.expect("steps", 2, run.record["counts"]["steps"], run.record["counts"]["steps"] == {steps}, {known})
    lab.table(("a", "b"), [(1, 0.5)], "numbers")
'''
ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])


def verify(*words, tools=None, **changes):
    environment = {**os.environ, **changes}
    if tools:
        environment["SOFTWET_TOOLS"] = str(tools)
    return subprocess.run([softwet, "verify", *words], capture_output=True, text=True, env=environment, timeout=900)


def fails(name, result, code, *parts):
    lines = result.stderr.strip().splitlines()
    good = result.returncode == code and len(lines) == 1 and all(part in lines[0] for part in parts)
    check_true(name, good and lines[0].startswith("softwet: error: "), f"{result.returncode} {lines}")


def copy_with(steps, known="None", setting="time.max_steps=2"):
    """Sources of the studies with STUDY alone. @return their folder tools"""
    copy = pathlib.Path("copy").resolve()
    shutil.rmtree(copy, ignore_errors=True)
    for folder in ("tools", "cases", "tests/oracle", "tests/verification"):
        shutil.copytree(ROOT / folder, copy / folder, ignore=shutil.ignore_patterns("studies", "__pycache__"))
    studies = copy / "tests" / "verification" / "studies"
    studies.mkdir()
    (studies / "layer.py").write_text(STUDY.format(steps=steps, known=known, setting=setting))
    return copy / "tools"


listed = verify("--list")
names = {path.stem for path in (ROOT / "tests" / "verification" / "studies").glob("*.py")}
check_true("--list names every study", {line.split()[0] for line in listed.stdout.splitlines()} == names, listed.stderr)
fails("unknown name", verify("tensotaxi"), 1, "'tensotaxi'", "'tensotaxis'")
fails("no jobs", verify("--jobs", "0"), 1, "--jobs 0")
fails("jobs is a word", verify("--jobs", "many"), 1, "--jobs", "many")
fails("unknown option", verify("--fast"), 1, "--fast")
fails("no tools", verify(tools="/nowhere"), 1, "SOFTWET_TOOLS", "/nowhere")
fails("no Python", verify(SOFTWET_PYTHON="/nowhere/python3"), 1, "SOFTWET_PYTHON", "/nowhere/python3")
bare = pathlib.Path("bare_python3").resolve()  # it finds no packages
bare.write_text(f'#!/bin/sh\nexec {sys.executable} -S "$@"\n')
bare.chmod(0o755)
fails("Python without the modules", verify("--list", SOFTWET_PYTHON=str(bare)), 1, "verify: SOFTWET_PYTHON", "numpy and scipy and h5py")

shutil.rmtree("result", ignore_errors=True)
good = verify("layer", "--out", "result", "--docs", "result/docs", tools=copy_with(2))
check_true("a study that holds: exit code 0", good.returncode == 0, good.stdout + good.stderr)
text = pathlib.Path("result/layer/layer.md").read_text()
check_true("its document", "| what | asked | measured |\n|---|---|---|\n| steps | 2 | 2 |\n" in text and "`layer_commands.csv`" in text)
check_true("the commands beside it", "layer,softwet run cases/solid_layer_2d.toml" in pathlib.Path("result/layer/layer_commands.csv").read_text())
check_true("pages and pictures alone go to the documentation", {path.suffix for path in pathlib.Path("result/docs/verification").iterdir()} <= {".md", ".png"})
check_true("its table", pathlib.Path("result/layer/layer_numbers.csv").read_text() == "a,b\n1,0.5\n")
check_true("copied", pathlib.Path("result/docs/verification/layer.md").read_text() == text)
index = pathlib.Path("result/docs/verification.md").read_text()
check_true("the index", "| [layer](verification/layer.md) | A solid layer | 1 of 1 hold |" in index, index)

before = [(path, path.stat().st_mtime_ns) for path in sorted(pathlib.Path("result/runs").rglob("*"))]
bad = verify("layer", "--out", "result", "--docs", "result/docs", tools=copy_with(3))
check_true("a study that fails: exit code 1", bad.returncode == 1, bad.stdout + bad.stderr)
after = [(path, path.stat().st_mtime_ns) for path in sorted(pathlib.Path("result/runs").rglob("*"))]
check_true("the equal run is kept", before == after)
check_true("the index shows it", "**1 fail**" in pathlib.Path("result/docs/verification.md").read_text())
for within, code, told in ((True, 0, "2 | **no** (1) |\n\n(1) why; known: 2 at most."), (False, 1, "2; worse than known: 2 at most | **no** |")):
    missed = verify("layer", "--out", "result", tools=copy_with(3, f'Known("why", "2 at most", {within})'))
    check_true(f"a known miss, within its bound {within}: exit code {code}", missed.returncode == code, missed.stdout + missed.stderr)
    text = pathlib.Path("result/layer/layer.md").read_text()
    check_true("the document shows it", told in text, text)
broken = verify("layer", "--out", "result", tools=copy_with(2, setting="time.max_stepz=2"))
check_true("a run that fails: exit code 2", broken.returncode == 2 and "max_stepz" in broken.stderr, broken.stderr)
two = '"""Two programs"""\nMINUTES = {"quick": 1, "full": 1}\n\n\ndef study(lab):\n    lab.tools("first_one", "softwet", "second_one")\n'
pathlib.Path("copy/tests/verification/studies/layer.py").write_text(two)
needs = verify("layer", "--out", "result", tools=pathlib.Path("copy/tools").resolve())
check_true("programs that are missing are named at once", "tools/setup softwet first_one second_one" in needs.stderr, needs.stderr)
check_true("and the exit code is 2", needs.returncode == 2, f"{needs.returncode}")
sys.exit(0)
