#!/usr/bin/env python3
"""Every room of src/, and the Python package of tools/, has a README that names each of its files, and a file that is
missing there is reported. usage: room_readmes.py SOFTWET

A room is a folder of src/ with all that lies below it. A file is named by its path in the room without the ending, as
code in the first column of a table of the README: `newton`, `host/options`. Header and source of one name are one file.
A README may name files that are still to come."""

import os
import pathlib
import re
import shutil

from _scene import check_true

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
ENDINGS = {".hpp", ".cpp", ".c", ".py"}


def files_of(room):
    """Paths of the files of a room, without their endings."""
    return {str(path.relative_to(room).with_suffix("")) for path in room.rglob("*")
            if path.suffix in ENDINGS and path.stem != "__init__"}


def names_in(text):
    """What stands as code in the first columns of the tables of a page."""
    cells = re.findall(r"^\| *([^|]*?) *\|", text, re.MULTILINE)
    return {name for cell in cells for name in re.findall(r"`([^`]+)`", cell)}


def missing(source):
    """Sentences about rooms without a README, and about files that the README of their room does not name."""
    problems = []
    for room in sorted(path for path in source.iterdir() if path.is_dir()):
        readme = room / "README.md"
        if not readme.is_file():
            problems.append(f"src/{room.name} has no README.md; write one with a row for each of its files")
            continue
        for name in sorted(files_of(room) - names_in(readme.read_text())):
            problems.append(f"src/{room.name}/README.md does not name `{name}`; add it to a first column of its table")
    return problems


problems = missing(ROOT / "src")
check_true("every README of a room names its files", not problems, "\n" + "\n".join(problems))
package = ROOT / "tools/softwet"
unnamed = files_of(package) ^ names_in((package / "README.md").read_text())
check_true("the README of the Python package names its files, and no others", not unnamed, unnamed)

# A copy in which each kind of mistake is made once.
copy = pathlib.Path("copy").resolve()
shutil.rmtree(copy, ignore_errors=True)
shutil.copytree(ROOT / "src", copy)
(copy / "machine/README.md").unlink()
(copy / "time/newcomer.hpp").write_text("#pragma once\n")
(copy / "solver/krylov/newcomer.cpp").write_text("")
(copy / "memory/README.md").write_text(
    "A sentence about `array` is no row.\n\n| file | what it holds |\n|---|---|\n| `chunk`, `large_pages`, `team_scratch`, `start_teams` | `array` |\n")
found = missing(copy)
for sentence in ("src/machine has no README.md", "src/time/README.md does not name `newcomer`",
                 "src/solver/README.md does not name `krylov/newcomer`", "src/memory/README.md does not name `array`"):
    check_true(f"reported: {sentence}", any(sentence in problem for problem in found), found)
check_true("nothing else is reported", len(found) == 4, found)
shutil.rmtree(copy)
