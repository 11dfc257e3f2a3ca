"""Runs with several processes."""

import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tests" / "regression"))
from _same import arrays, check_same  # noqa: E402, F401
from _scene import cases, check_true, command_of_file, environment, record, softwet  # noqa: E402, F401

SCHWARZ = "solver.krylov.preconditioner=schwarz"
launcher = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tools" / "_ranks"


def has_configuration(name):
    """Whether this build has one, "3D degree 2"; says so where it has not."""
    has = name in subprocess.run([softwet, "info"], capture_output=True, text=True).stdout
    if not has:
        print(f"this build has no {name}")
    return has


def start(count, case, folder, settings, options=("--overwrite", "--quiet"), threads=1):
    """A run of a case with some processes, which have Schwarz's method alone; 1: without a launcher."""
    command = command_of_file(cases / f"{case}.toml", folder, [SCHWARZ, *settings],
                              [*options, "--threads", str(threads)])
    if count > 1:
        command = [str(launcher), str(count), *command]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            env={**environment, "OMP_NUM_THREADS": str(threads)})


def run(count, case, folder, settings, options=("--overwrite", "--quiet"), threads=1, code=0):
    """Runs to the end. @return what was printed on stderr"""
    process = start(count, case, folder, settings, options, threads)
    _, errors = process.communicate(timeout=900)
    if process.returncode != code:
        sys.exit(f"exit code {process.returncode}, not {code}: {process.args}\n{errors}")
    return errors
