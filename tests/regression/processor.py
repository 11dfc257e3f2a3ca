#!/usr/bin/env python3
"""A processor that lacks what the program was built for is named before anything else runs. usage: processor.py SOFTWET

A program with the check of softwet is made to need "fma4", which few processors have; where qemu-x86_64 is installed,
softwet itself is started on an old processor. Where the processor of this machine knows AVX-512, a program with the
check starts the one of its name for AVX-512 in its place."""

import os
import pathlib
import platform
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "src/cli/processor.c"
PROGRAM = """#include <iostream>
extern "C" const char* const softwet_processor_needs[];
extern "C" const char* const softwet_processor_needs[] = {"sse3", "%s", nullptr};
struct Early { Early() { std::cout << "early\\n"; } } early;  // runs before main
int main() { return 0; }
"""


def check(name, good, seen):
    print(f"{'ok' if good else 'FAIL':4}  {name} {'' if good else seen}")
    if not good:
        sys.exit(1)


def program(need):
    pathlib.Path("needs.cpp").write_text(PROGRAM % need)
    subprocess.run(["cc", "-c", SOURCE, "-o", "processor.o"], check=True)
    subprocess.run(["c++", "needs.cpp", "processor.o", "-o", "needs"], check=True)
    return subprocess.run(["./needs"], capture_output=True, text=True)


def take_over(folder):
    """What ./needs prints with a program for AVX-512 beside it, without SOFTWET_AVX512 and with 0."""
    wider = folder / "needs-x86-64-v4"
    wider.write_text("#!/bin/sh\necho wider $1\n")
    wider.chmod(0o755)
    calls = ({}, {"SOFTWET_AVX512": "0"})
    said = [subprocess.run([folder / "needs", "word"], capture_output=True, text=True, env={**os.environ, **extra}).stdout
            for extra in calls]
    wider.unlink()
    return said


def refused(done):
    return done.returncode == 3 and not done.stdout and done.stderr.count("\n") == 1 and "error: this softwet" in done.stderr


if platform.machine() != "x86_64":
    sys.exit(0)
done = subprocess.run([sys.argv[1], "version"], capture_output=True, text=True)
check("this processor has what it needs", done.returncode == 0, done)
if shutil.which("cc") and shutil.which("c++"):
    done = program("sse4.2")
    check("nothing is missing", done.returncode == 0 and done.stdout == "early\n", done)
    flags = pathlib.Path("/proc/cpuinfo").read_text().split()
    knows = all(f"avx512{part}" in flags for part in ("f", "bw", "cd", "dq", "vl"))
    said = take_over(pathlib.Path.cwd())
    check("the program for AVX-512 starts where the processor can", said == ["wider word\n" if knows else "early\n", "early\n"], said)
    if "fma4" not in pathlib.Path("/proc/cpuinfo").read_text():
        done = program("fma4")
        check("fma4 is missing", refused(done) and "lacks fma4;" in done.stderr, done)
if shutil.which("qemu-x86_64"):
    done = subprocess.run(["qemu-x86_64", "-cpu", "Nehalem", sys.argv[1], "version"], capture_output=True, text=True)
    check("a processor without AVX", refused(done) and " avx2 " in done.stderr, done)
