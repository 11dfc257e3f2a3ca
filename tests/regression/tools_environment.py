#!/usr/bin/env python3
"""The tools write nothing beside themselves, and draw without a home. usage: tools_environment.py SOFTWET"""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

from _scene import check_true, environment, run, tools

PLAIN = {name: value for name, value in environment.items()
         if name not in ("PYTHONDONTWRITEBYTECODE", "HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "MPLCONFIGDIR")}
PLAIN["TMPDIR"] = os.path.abspath("temporary")

for folder in ("copy", "temporary", "no_home"):
    shutil.rmtree(folder, ignore_errors=True)
os.mkdir("temporary")
shutil.copytree(tools, "copy", ignore=shutil.ignore_patterns("__pycache__"))
run("static_droplet_rigid_2d", "run", ["domain.elements=[16,8]", "fluid.capillarity=1/8", "time.max_steps=1",
                                       "output.fields.times=[0]"])
python = [path.name for path in sorted(pathlib.Path("copy").iterdir())
          if path.is_file() and path.read_bytes().startswith(b"#!/usr/bin/env python3")]
check_true("there are tools in Python", {"sweep", "plot", "report", "verify"} <= set(python), str(python))
for name in python:
    subprocess.run([sys.executable, f"copy/{name}", "--help"], capture_output=True, env=PLAIN, timeout=900)
left = [str(path) for path in pathlib.Path("copy").rglob("__pycache__")]
check_true("nothing is written beside the tools", not left, str(left))

if importlib.util.find_spec("matplotlib") is None:
    sys.exit(print("no matplotlib: no page is made here"))
for name, home in (("no folder", "/proc/nowhere"), ("a file", str(pathlib.Path("copy/sweep").absolute()))):
    done = subprocess.run([sys.executable, "copy/report", "run"], capture_output=True, text=True, timeout=900,
                          env={**PLAIN, "HOME": home})
    check_true(f"HOME is {name}: no word of matplotlib", done.returncode == 0 and not done.stderr, done.stderr)
check_true("what matplotlib kept is gone", not os.listdir("temporary"), str(os.listdir("temporary")))
