#!/usr/bin/env python3
"""What one process alone meets ends all alike, at once and with one sentence: a solid that is turned inside out, a
field file that cannot be written. Processes that read different cases or checkpoints refuse to compute, and the files
of the first one show what there is.
usage: together.py SOFTWET"""

import pathlib
import shutil
import subprocess

from _ranks import SCHWARZ, cases, check_true, command_of_file, environment, launcher, start

PULL = cases / "tensotaxis_pull_2d.toml"
SCENE = [SCHWARZ, "domain.elements=[16,8]", "fluid.capillarity=1/8", "load[0].start=0.1", "load[0].ramp=1"]


def start_pair(first, second):
    """Two processes with a command each: (folder, settings, options)."""
    commands = [command_of_file(PULL, folder, [*SCENE, *settings], ["--quiet", "--threads", "1", *options])
                for folder, settings, options in (first, second)]
    return subprocess.Popen([str(launcher), "1", *commands[0], ":", "-n", "1", *commands[1]], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True, env={**environment, "OMP_NUM_THREADS": "1"})


def end_of(process, name, code):
    """Waits for the end. A process that waits for one that is gone would do so for ever."""
    try:
        _, errors = process.communicate(timeout=900)
    except subprocess.TimeoutExpired:
        process.terminate()
        check_true(f"{name}: all processes end", False)
    check_true(f"{name}: exit code {code}", process.returncode == code, f"{process.returncode} {errors}")
    check_true(f"{name}: one message", errors.count("softwet: error:") == (code != 0), errors)
    return errors


def copy(folder, other):
    shutil.copytree(folder, other, ignore=shutil.ignore_patterns("fields"))


for folder in ("inverted", "blocked", "different", "part", "behind", "without"):
    shutil.rmtree(folder, ignore_errors=True)

# A solid that is turned inside out at the start is refused by all, also by those whose part of it is upright.
pathlib.Path("inverted.toml").write_text((cases / "solid_layer_2d.toml").read_text() + """
[[wave]]
field = "displacement_x"
amplitude = 1
mode = [2, 0]
""")
process = start(2, pathlib.Path("inverted").resolve(), "inverted",
                ["domain.elements=[16,4]", "substrate.material=neo_hookean"])
errors = end_of(process, "inverted", 1)
check_true("inverted: names the wave", "wave[0].amplitude" in errors, errors)
check_true("inverted: nothing is written", not pathlib.Path("inverted").exists())

# The folder of the field files cannot be made.
pathlib.Path("blocked").mkdir()
pathlib.Path("blocked/fields").write_text("")
process = start(2, "tensotaxis_pull_2d", "blocked", [*SCENE, "output.fields.times=[0]"], ("--quiet",))
errors = end_of(process, "blocked", 3)
check_true("blocked: names the folder", "fields" in errors, errors)

# Two processes with two cases.
errors = end_of(start_pair(("different", [], []), ("different", ["time.end=3"], [])), "different", 1)
check_true("different: says so", "another case" in errors, errors)
check_true("different: no folder is left", not pathlib.Path("different").exists())

# The second process sees a checkpoint of another time, or no field files. Those of the first one count.
TIMES = ["output.fields.times=[0,0.5]"]
end_of(start(2, "tensotaxis_pull_2d", "part", [*SCENE, *TIMES, "time.max_steps=2"], ("--quiet",)), "part", 0)
copy("part", "behind")
end_of(start(2, "tensotaxis_pull_2d", "part", [*SCENE, *TIMES, "time.end=0.5"], ("--resume", "--quiet")), "part", 0)
copy("part", "without")
END = [*TIMES, "time.end=0.6"]
errors = end_of(start_pair(("part", END, ["--resume"]), ("behind", END, ["--resume"])), "behind", 3)
check_true("behind: says so", "the state of time" in errors, errors)
end_of(start_pair(("part", END, ["--resume"]), ("without", END, ["--resume"])), "without", 0)
check_true("without: no field file twice", len(list(pathlib.Path("part/fields").glob("fluid_*.hdf"))) == 2)
