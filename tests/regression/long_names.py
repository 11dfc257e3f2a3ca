#!/usr/bin/env python3
"""Names of 300 letters, of a case, of folders and of files: refused before anything is computed or changed, with place,
value, range and remedy; names that are just short enough work. usage: long_names.py SOFTWET"""

import pathlib
import shutil
import subprocess
import sys

from _scene import cases, check_true, environment, softwet, tools

LONG, DEEP = "a" * 300, "/".join(["b" * 200] * 25)
CASE = str(cases / "solid_layer_2d.toml")
SMALL = ["--set", "domain.elements=[16,4]", "--set", "time.max_steps=2", "--set", "output.fields.times=[]"]


def start(*words):
    return subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)


def errors(done):
    return [line for line in done.stderr.splitlines() if not line.startswith("softwet: warning: ")]


def refused(name, parts, *words):
    before = sorted(pathlib.Path().iterdir())
    done = start(*words)
    lines = errors(done)
    check_true(f"refused: {name}", done.returncode == 1 and len(lines) == 1 and lines[0].startswith("softwet: error: ") and
               all(part in lines[0] for part in parts), f"{done.returncode} {done.stderr[-1500:]}")
    check_true(f"{name}: nothing is written", sorted(pathlib.Path().iterdir()) == before)


for folder in ("out", "a" * 200 + "_folder", "sweep"):
    shutil.rmtree(folder, ignore_errors=True)

# --- the name of a case
for command in ("check", "run", "steady"):
    refused(f"{command}: the name of a case", ["--set name=aaa", "has 300 letters", "200 at most", "droplet_1"],
            command, CASE, *SMALL, "--set", f"name={LONG}")
text = pathlib.Path(CASE).read_text().replace('name = "solid_layer_2d"', f'name = "{LONG}"')
pathlib.Path("long.toml").write_text(text)
line = next(number for number, line in enumerate(text.splitlines(), 1) if line.startswith("name"))
refused("the name in a file", [f"long.toml:{line}: name", "200 at most"], "run", "long.toml", *SMALL)
for command in ("run", "steady"):
    done = start(command, CASE, *SMALL, "--set", f"name={'a' * 200}", "--quiet", "--threads", "1")
    check_true(f"{command}: a name of 200 letters", done.returncode == 0, done.stderr)

# --- output folders
for name, path, limit in (("a name", LONG, "names may have 255 at most"), ("a name above", f"{LONG}/x", "names may have 255 at most"),
                          ("a path", DEEP, "a path may have 40")):
    for command in ("run", "steady"):
        refused(f"{command} --out with {name}", ["the output folder '", "bytes, and", limit, "with --out"], command, CASE, *SMALL,
                "--out", path)
refused("run --resume", ["300 bytes", "--out"], "run", CASE, *SMALL, "--out", LONG, "--resume")
for words in (["sweep", CASE, "--vary", "substrate.young=1,2"], ["steady", CASE, "--along", "substrate.young=1,2"],
              ["tradeoff", CASE, "--parameters", "time.rho_inf=0.6", "--combine", "0"]):
    refused(f"{words[0]} --out", [LONG, "too long", "255 bytes at most"], *words, *SMALL, "--out", LONG)
refused("check --scene", ["300 bytes", "255 at most"], "check", CASE, "--scene", LONG)
refused("init", ["305 bytes", "255 at most"], "init", f"{LONG}.toml")
refused("a case file", [f"{LONG}.toml", "too long"], "run", f"{LONG}.toml")
refused("initial.from", [f"{LONG}", "too long"], "run", CASE, *SMALL, "--set", f"initial.from={LONG}")
done = start("run", CASE, *SMALL, "--out", "a" * 200 + "_folder", "--quiet", "--threads", "1")
check_true("a folder whose name is short enough", done.returncode == 0, done.stderr)
done = start("sweep", CASE, *SMALL, "--vary", f"name={'a' * 200},{'b' * 200}", "--out", "sweep", "--threads", "1")
check_true("a sweep over long names", done.returncode == 0, done.stderr)

# --- readers of folders
for name in ("status", "watch"):
    refused(name, [LONG, "too long"], name, LONG)
for name in ("plot", "report"):
    done = subprocess.run([sys.executable, str(tools / name), LONG], capture_output=True, text=True, env=environment)
    check_true(f"{name}: one line", done.returncode == 1 and "too long" in done.stderr and len(done.stderr.splitlines()) == 1, done.stderr[-800:])
