#!/usr/bin/env python3
"""tools/device: a report of this machine in Markdown, compared with a table of results, which it also writes.
usage: device.py SOFTWET"""

import csv
import os
import pathlib
import subprocess
import sys

from _scene import check_true, environment, softwet

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
build = pathlib.Path(softwet).parent


def device(*words, code=0):
    done = subprocess.run([sys.executable, ROOT / "tools/device", build, "--quick", "--minutes", "0.6", "--out", "device", *words],
                          capture_output=True, text=True, env={**environment, "OMP_NUM_THREADS": "1"})
    if done.returncode != code:
        sys.exit(f"exit code {done.returncode}, not {code}: {done.args}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


first = device("--record", "here.csv")
check_true("a scene without a result of a processor is not judged", "there is no result of a processor" in first)
second = device("--reference", "here.csv")
report = pathlib.Path("device/device.md").read_text()
for word in ("| starts | yes |", "| same bits twice | yes |", "| pull | yes |", "| impact | yes |", "ns for each unknown"):
    check_true(f"the report says: {word}", word in report, "" if word in report else report)
check_true("and is printed", report in second)

own = device()
check_true("the small meshes have results of their own", all(f"ok    {name}: " in own for name in ("pull", "impact")) and
           own.count("off the processor's result") >= 2 and "FAIL" not in own, own)
rows = list(csv.reader(open("here.csv")))
rows = [[scene, quantity, "0.51" if (scene, quantity) == ("pull", "x_centre") else value] for scene, quantity, value in rows]
csv.writer(open("other.csv", "w")).writerows(rows)
check_true("another result is reported", "| pull | **no** |" in device("--reference", "other.csv", code=1))
pathlib.Path("empty").mkdir(exist_ok=True)
wrong = subprocess.run([sys.executable, ROOT / "tools/device", "empty"], capture_output=True, text=True, env=environment)
check_true("a folder without a program is named", wrong.returncode == 1 and "there is no program empty/softwet" in wrong.stderr, wrong.stderr)
