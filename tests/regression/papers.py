#!/usr/bin/env python3
"""tools/papers computes every paper in its quick form, draws it and judges it, and keeps what was computed. Every paper
has its section, picture, numbers and table of agreement in docs/validation.md. usage: papers.py SOFTWET"""

import csv
import os
import pathlib
import shutil
import subprocess
import sys

from _scene import check_true, tools

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
LARGEST = 250_000  # bytes of a picture


def papers(*words, code=0):
    done = subprocess.run([sys.executable, str(tools / "papers"), *words], capture_output=True, text=True,
                          env={**os.environ, "OMP_NUM_THREADS": "1"})
    check_true(f"papers {' '.join(words)}: exit code {code}", done.returncode == code, done.stderr)
    return done


try:
    import matplotlib  # noqa: F401
except ImportError:
    sys.exit(print("no matplotlib: no paper is plotted here"))

names = [line.split()[0] for line in papers("--list").stdout.splitlines()]
check_true("there are papers", len(names) > 1, str(names))
page = (ROOT / "docs/validation.md").read_text()
for name in names:
    check_true(f"docs/validation.md has {name}", f"tools/papers {name}\n" in page and f"](papers/{name}.png)" in page
               and f"](papers/{name}.csv)" in page and f"](papers/{name}.md)" in page)
    agreement = (ROOT / f"docs/papers/{name}.md").read_text().splitlines()
    check_true(f"docs/papers/{name}.md is its table of agreement", agreement[0] == "| quantity | paper or formula | softwet | agreement |",
               agreement[:1])
    rows = [line.split("|")[4].strip() for line in agreement[2:]]
    counted = f"| {sum(row.startswith('agrees') for row in rows)} of {len(rows)} |"
    check_true(f"docs/validation.md counts the rows of {name} that agree", f"| [{name}](#{name}) |" in page and
               counted in page.split(f"| [{name}](#{name}) |")[1].splitlines()[0], counted)
    check_true(f"{name}: its picture is small", (ROOT / f"docs/papers/{name}.png").stat().st_size < LARGEST)

told = papers("nobody_1900", code=2).stderr
check_true("a paper that is not there is named, with those that are", "nobody_1900" in told and names[0] in told, told)
told = papers(names[0], "--redraw", "--work", "nowhere", code=1).stderr
check_true("--redraw without runs", "leave --redraw out" in told and told.count("\n") == 1, told)

for name in names:
    shutil.rmtree(f"out/papers/{name}_quick", ignore_errors=True)
    papers(name, "--quick", "--out", "drawn")
    check_true(f"{name}: a picture", pathlib.Path(f"drawn/{name}.png").read_bytes().startswith(b"\x89PNG"))
    rows = list(csv.reader(open(f"drawn/{name}.csv", newline="")))
    check_true(f"{name}: a table with a header", len(rows) > 1 and len({len(row) for row in rows}) == 1, str(rows[:2]))
    judged = pathlib.Path(f"drawn/{name}.md").read_text().splitlines()
    check_true(f"{name}: a table of agreement", len(judged) > 2 and all(line.count("|") == 5 for line in judged), str(judged))

first = names[0]
again = papers(first, "--quick", "--out", "drawn").stdout
check_true("what is computed stays", f"{first}: " not in again, again)
kept = next(pathlib.Path(f"out/papers/{first}_quick").rglob("*.command"))
kept.write_text("other\n" + kept.read_text())
again = papers(first, "--quick", "--out", "drawn").stdout
check_true("what was computed by another command is computed again", again.count(f"{first}: ") == 1, again)
