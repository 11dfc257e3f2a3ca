#!/usr/bin/env python3
"""tools/words finds words that sound translated in pages, comments and texts, and leaves code and idioms alone.
usage: words.py SOFTWET"""

import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
# file: its text, and the lines that are wrong
FILES = {
    "README.md": ("The table tells the mass.\n\n```console\ntell me\n```\n`told` is a name, and [a link](held against.md).\n", [1]),
    "docs/idioms.md": ("Colours that one can tell apart. Orders in space and time. It varies in space.\n"
                       "The wall in the plane of x and y.\n", []),
    "docs/lines.md": ("A droplet\nin space, held\nagainst the paper.\n", [2, 2]),
    "docs/reference.md": ("A page that is generated tells nothing.\n", []),
    "docs/chain.md": ("It is that of the case, like that of the paper.\nIt is that of the case. It is not that of the paper.\n",
                      [1]),
    "src/a.cpp": ("int told = 0;  // what is told\nconst char* url = \"http://a b\";\n"
                  "f(\"it tells {told}\", '\"', \"told\");\n/* a\n dial */\n", [1, 3, 5]),
    "src/lines.hpp": ("/// A droplet in\n/// space.\nint a;  ///< it was\n        ///< tried\nf(\"was held \"\n  \"against it\");\n",
                      [1, 3, 5]),
    "tools/b.py": ("told = 1  # it was tried\nf = f\"is {told}\"\n\"\"\"In the\nplane.\"\"\"\n", [1, 3]),
    "tools/script": ("#!/bin/sh\n# dearer\ntell=${#told}\n", [2]),
    "cases/c.toml": ("# drawn\nname = \"told\"\n", [1]),
}
failures = []


def answer(folder):
    return subprocess.run([sys.executable, ROOT / "tools/words", folder], capture_output=True, text=True)


with tempfile.TemporaryDirectory() as name:
    nothing = answer(name)
    if nothing.returncode != 1 or "no page and no source was found" not in nothing.stdout:
        failures.append(f"an empty folder: {nothing}")
    for path, (text, _) in FILES.items():
        file = pathlib.Path(name, path)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    done = answer(name)
    wanted = sorted(f"{path}:{line}" for path, (_, lines) in FILES.items() for line in lines)
    seen = sorted(":".join(line.split(":")[:2]) for line in done.stdout.splitlines()[:-1])
    if done.returncode != 1 or seen != wanted:
        failures.append(f"expected {wanted}, found {seen}: {done}")
    for path, (_, lines) in FILES.items():
        if lines:
            pathlib.Path(name, path).unlink()
    done = answer(name)
    if done.returncode != 0:
        failures.append(f"only good files are left: {done}")

for failure in failures:
    print(f"words: {failure}", file=sys.stderr)
sys.exit(1 if failures else 0)
