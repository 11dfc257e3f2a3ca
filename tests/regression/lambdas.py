#!/usr/bin/env python3
"""tools/lambdas finds kernels that are lambdas where nvcc may call a null pointer, and no others.
usage: lambdas.py SOFTWET"""

import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
# file: its text, and the lines that are wrong
SOURCES = {
    "src/a.hpp": ("inline void f() {\n  start(KOKKOS_LAMBDA(int i) { x(i) = 0; });\n}\n", [2]),
    "src/unnamed.hpp": ("namespace {\ninline void f() { start(KOKKOS_LAMBDA(int) {}); }\n}\n", [2]),
    "src/good.cpp": ("namespace softwet {\nnamespace {\nvoid f() { start(KOKKOS_LAMBDA(int) {}); }\n}\n}\n", []),
    "src/after.cpp": ("namespace {\nvoid g() {}\n}\nvoid f() { start(KOKKOS_LAMBDA(int) {}); }\n", [4]),
    "src/silent.cpp": ("// KOKKOS_LAMBDA {\n#define KOKKOS_LAMBDA [=] __device__\nconst char* s = \"KOKKOS_LAMBDA\";\n", []),
    "kernels/plain.cpp": ("void f() {\n  start([=] __device__(int) {});\n  start([=](int) {});\n}\n", [2]),
    "tests/unit/member.cpp": ("struct A {\n  void f() { start(KOKKOS_CLASS_LAMBDA(int) {}); }\n};\n", [2]),
}
failures = []


def answer(folder):
    return subprocess.run([sys.executable, ROOT / "tools/lambdas", folder], capture_output=True, text=True)


with tempfile.TemporaryDirectory() as name:
    nothing = answer(name)
    if nothing.returncode != 1 or "no source was found" not in nothing.stdout:
        failures.append(f"an empty folder: {nothing}")
    for path, (text, _) in SOURCES.items():
        file = pathlib.Path(name, path)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    done = answer(name)
    wanted = sorted(f"{path}:{line}" for path, (_, lines) in SOURCES.items() for line in lines)
    seen = sorted(":".join(line.split(":")[:2]) for line in done.stdout.splitlines()[:-1])
    if done.returncode != 1 or seen != wanted:
        failures.append(f"wrong are {wanted}: {done}")
for failure in failures:
    print(f"lambdas: {failure}", file=sys.stderr)
sys.exit(1 if failures else 0)
