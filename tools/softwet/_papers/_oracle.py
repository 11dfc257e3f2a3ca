"""The formulas a paper is compared with: programs of tests/oracle, which have no code of softwet."""

import importlib
import pathlib
import sys

from softwet import Problem

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "tests/oracle"


def oracle(name):
    """The module of tests/oracle with that name."""
    if not (FOLDER / f"{name}.py").is_file():
        raise Problem(f"{FOLDER}/{name}.py does not exist; tools/papers needs the folder tests of the repository")
    if str(FOLDER) not in sys.path:
        sys.path.insert(0, str(FOLDER))
    return importlib.import_module(name)
