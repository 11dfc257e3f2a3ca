#!/usr/bin/env python3
"""--overwrite replaces a result when the new run starts; a refused one leaves it. usage: overwrite.py SOFTWET"""

import pathlib
import resource
import shutil
import subprocess

from _scene import RIGID, check_true, command, environment, record, run

SHORT = RIGID + ["time.max_steps=2"]
OVERWRITE = ["--overwrite", "--quiet", "--threads", "1"]


def content():
    return {path: path.read_bytes() for path in pathlib.Path("run").rglob("*") if path.is_file()}


def refused(name, case, settings, code, memory=None):
    """@param memory  bytes of address space the run may take"""
    words = command(case, "run", settings, OVERWRITE)
    limit = (lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory))) if memory else None
    before = content()
    result = subprocess.run(words, capture_output=True, text=True, timeout=900, env=environment, preexec_fn=limit)
    check_true(f"{name}: exit code {code}", result.returncode == code, result.stderr.strip())
    check_true(f"{name}: the old result stays", content() == before, str(sorted(before.keys() ^ content().keys())))


shutil.rmtree("run", ignore_errors=True)
run("static_droplet_rigid_2d", "run", SHORT)
mine = pathlib.Path("run/notes.txt")
mine.write_text("of the user\n")

refused("a mistake in the case", "static_droplet_rigid_2d", ["time.end=-1"], 1)
refused("no case", "none", [], 1)
refused("memory before the mesh", "static_droplet_rigid_2d", ["domain.elements=[20000,20000]"], 3)
# A mesh that fits and factors that do not: refused by the count of memory, or by the system, once the scene is set up.
refused("memory before the factors", "tensotaxis_pull_2d", ["domain.elements=[256,128]", "domain.grading.fine=everywhere"], 3, 200 << 20)

fields = set(pathlib.Path("run/fields").iterdir())
run("static_droplet_rigid_2d", "run", SHORT + ["time.max_steps=1", "output.fields.times=[20]"], OVERWRITE)
check_true("a run that starts replaces the result", record("run")["counts"]["steps"] == 1)
check_true("with all its field files", fields and not any(path.exists() for path in fields))
check_true("and leaves what softwet did not write", mine.read_text() == "of the user\n")
