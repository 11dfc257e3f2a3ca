"""The command `softwet` of an installation by pip: the program, with this Python for the commands that are Python
programs."""

import os
import sys

from .program import HERE


def main():
    program = HERE / "program/bin/softwet"
    os.environ.setdefault("SOFTWET_PYTHON", sys.executable)
    try:
        os.execv(program, ["softwet", *sys.argv[1:]])
    except OSError as error:
        sys.exit(f"softwet: error: cannot start {program}: {error}; install the package softwet again")
