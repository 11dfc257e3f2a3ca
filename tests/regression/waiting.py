#!/usr/bin/env python3
"""How the threads of a run wait: they look a limited number of times before they sleep, and what the user has set wins.
The OpenMP runtime says so when it is loaded; other runtimes than GCC's do not know the variable.
usage: waiting.py SOFTWET"""

import os
import re
import subprocess

from _scene import check_true, softwet

CHOSEN = "3000"


def looks(command, **variables):
    """The number of looks before a thread sleeps; None where the runtime does not say."""
    kept = {name: value for name, value in os.environ.items() if name not in ("OMP_WAIT_POLICY", "GOMP_SPINCOUNT")}
    done = subprocess.run([softwet, command, "--help"], capture_output=True, text=True, timeout=900,
                          env={**kept, "OMP_DISPLAY_ENV": "verbose", **variables})
    check_true(f"softwet {command} --help, {variables}", done.returncode == 0)
    found = re.findall(r"GOMP_SPINCOUNT = '(\d+)'", done.stderr)  # reported twice by a program that begins again
    return found[-1] if found else None


usual = looks("check")
if usual is None:
    print("ok    the OpenMP runtime does not print GOMP_SPINCOUNT: nothing to look at")
else:
    check_true("run and bench look so often", looks("run") == looks("bench") == CHOSEN != usual, usual)
    check_true("a number that the user has set", looks("run", GOMP_SPINCOUNT="77") == "77")
    check_true("a policy that the user has set", looks("run", OMP_WAIT_POLICY="passive") == "0")
