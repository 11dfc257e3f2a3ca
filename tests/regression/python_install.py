#!/usr/bin/env python3
"""`pip install ./tools` installs the Python package alone, leaves nothing beside the sources, and computes a case with
the program that SOFTWET_PROGRAM or PATH names. usage: python_install.py SOFTWET"""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

from _scene import cases, check_true, environment, softwet, tools

lacking = [name for name in ("pip", "setuptools", "wheel") if importlib.util.find_spec(name) is None]
if lacking:
    sys.exit(print(f"no {' and '.join(lacking)} for {sys.executable}: nothing is installed; on Debian: apt-get install python3-pip") or 0)

shutil.rmtree("site", ignore_errors=True)
before = sorted(path.name for path in tools.iterdir())
done = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps", "--quiet", "--target",
                       "site", str(tools)], capture_output=True, text=True, env={**environment, "PYTHONWARNINGS": "ignore"}, timeout=900)
check_true("pip install ./tools", done.returncode == 0, done.stderr)
check_true("nothing is left beside the sources", sorted(path.name for path in tools.iterdir()) == before)
sources = {path.relative_to(tools) for path in (tools / "softwet").rglob("*.py")} | {pathlib.Path("softwet/commands.toml")}
installed = {path.relative_to("site") for path in pathlib.Path("site/softwet").rglob("*") if path.suffix in (".py", ".toml")}
check_true("all modules, and no others", installed == sources, str(installed ^ sources))
version = re.search(r"project\(softwet VERSION ([0-9.]+)", (tools.parent / "CMakeLists.txt").read_text())[1]
check_true("the version of CMakeLists.txt", pathlib.Path(f"site/softwet-{version}.dist-info").is_dir())

code = """
import softwet
print(softwet.__file__)
run = softwet.run(CASE, "out", {"domain.elements": [8, 2], "time.max_steps": 2}, threads=1, progress=False, overwrite=True)
print(run.state, len(run.history["t"]))
""".replace("CASE", repr(str(cases / "solid_layer_2d.toml")))
bare = {name: value for name, value in environment.items() if name not in ("SOFTWET_PROGRAM", "PYTHONPATH", "SOFTWET_SOURCE_DIR")}
elsewhere = {**bare, "PYTHONPATH": str(pathlib.Path("site").resolve()), "PATH": "/usr/bin:/bin"}


def start(**variables):
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env={**elsewhere, **variables}, timeout=900)


for name, variables in (("SOFTWET_PROGRAM", {"SOFTWET_PROGRAM": softwet}),
                        ("PATH", {"PATH": f"{pathlib.Path(softwet).parent}{os.pathsep}{elsewhere['PATH']}"})):
    done = start(**variables)
    check_true(f"a case with the program of {name}", done.returncode == 0 and "site/softwet/__init__.py" in done.stdout and
               "stopped 3" in done.stdout, done.stdout + done.stderr)
if shutil.which("softwet", path=elsewhere["PATH"]) is None:
    done = start()
    check_true("without a program", "there is no program softwet" in done.stderr and "SOFTWET_PROGRAM" in done.stderr, done.stderr)
