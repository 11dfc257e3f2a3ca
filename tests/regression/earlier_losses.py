#!/usr/bin/env python3
"""`initial.from`: another prestretch and the stress of branches, which no state holds, are reported with both values;
what loses nothing is silent. usage: earlier_losses.py SOFTWET"""

import pathlib
import shutil
import subprocess

from _scene import check_true, environment, history, softwet

SOLID = """
name = "layer"
[domain]
size = [0.5, 0.125]
elements = [8, 4]
[substrate]
thickness = 0.125
young = 1.0
poisson = 0.3
material = "neo_hookean"
[boundary]
left = "slip"
right = "slip"
bottom = "clamped"
top = "free"
[[load]]
box = [[0.0, 0.0], [0.25, 0.125]]
force = [0.0, -0.1]
[time]
end = 0.2
[output]
fields = { times = [0.0, 0.2] }
"""
pathlib.Path("layer.toml").write_text(SOLID)
CARRIED = "the stress in the branches of its solid is not taken over"


def call(command, out, *settings):
    """@return what the command said"""
    words = [softwet, command, "layer.toml", *(word for setting in settings for word in ("--set", setting)),
             *([] if command == "check" else ["--out", out, "--threads", "1", "--overwrite"])]
    done = subprocess.run(words, capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{command} {out}: exit code 0", done.returncode == 0, done.stdout + done.stderr)
    return done.stderr


for folder in ("stretched", "plain", "bound", "rest", "again"):
    shutil.rmtree(folder, ignore_errors=True)
call("run", "plain")
call("run", "stretched", "substrate.prestretch=[1.2]")
pathlib.Path("layer.toml").write_text(SOLID + "[[substrate.branch]]\nmodulus = 0.3\ntime = 1.0\n")
call("run", "bound")
call("steady", "rest")
energy = f"energy_branches = {history('bound')['energy_branches'][-1]:.4g}"
for command in ("run", "check"):
    said = call(command, "again", "initial.from=bound")
    check_true(f"{command}: branches that carry stress", all(part in said for part in (
        "warning: initial.from", CARRIED, "1 branch", energy, "--resume")), said)
said = call("run", "again", "initial.from=bound", "initial.time=0")
check_true("of a time at which they carry nothing", CARRIED not in said, said)
said = call("run", "again", "initial.from=bound", "time.start=equilibrium")
check_true("a start at rest needs none", CARRIED not in said, said)
check_true("nor does a state of rest", CARRIED not in call("steady", "again", "initial.from=bound"))
said = call("run", "again", "initial.from=rest")
check_true("from a state of rest nothing is lost", CARRIED not in said, said)

pathlib.Path("layer.toml").write_text(SOLID)
for settings, parts in (((), ("[1.2]", "[1]")), (("substrate.prestretch=[1.3]",), ("[1.2]", "[1.3]"))):
    said = call("run", "again", "initial.from=stretched", *settings)
    check_true(f"another prestretch {settings}", all(part in said for part in (
        "warning: initial.from", "substrate.prestretch = " + parts[0], "this case has " + parts[1], "write prestretch = [1.2]")), said)
said = call("run", "again", "initial.from=plain", "substrate.prestretch=[1.2]")
check_true("a prestretch after none", "substrate.prestretch = [1], this case has [1.2]" in said, said)
for start, settings in (("stretched", ["substrate.prestretch=[1.2]"]), ("plain", [])):
    said = call("run", "again", f"initial.from={start}", *settings)
    check_true(f"the same prestretch {settings}", "initial.from" not in said, said)
said = call("run", "again", "initial.from=bound")
check_true("branches that this case has no more", "this case has no branches" in said, said)
