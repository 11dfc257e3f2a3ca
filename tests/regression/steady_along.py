#!/usr/bin/env python3
"""`softwet steady --along`: keys of the start, values whose folders would have one name, a branch that comes back, a
folder that holds something else, and commands that are stopped and go on. usage: steady_along.py SOFTWET"""

import csv
import hashlib
import pathlib
import shutil
import signal
import subprocess
import time

from _scene import cases, check, check_true, environment, history, record, softwet

DROPLET = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "output.fields.times=[]", 'fluid.wall_law="energy"']
LAYER = ["domain.elements=[16,4]", "output.fields.times=[]"]


def words(case, folder, settings, *more):
    sets = [word for setting in settings for word in ("--set", setting)]
    return [softwet, "steady", str(cases / f"{case}.toml"), "--out", str(folder), *sets, "--threads", "1", *more]


def steady(case, folder, settings, *more, code=0):
    """@return what the command said"""
    done = subprocess.run(words(case, folder, settings, *more), capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{folder} {' '.join(more)}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stdout + done.stderr


def states(folder):
    with open(pathlib.Path(folder, "states.csv"), newline="") as file:
        return list(csv.DictReader(file))


def contents(folder):
    """Checksums and times of all files."""
    return {path: (hashlib.sha1(path.read_bytes()).hexdigest(), path.stat().st_mtime_ns)
            for path in pathlib.Path(folder).rglob("*") if path.is_file()}


for folder in ("radius", "alone", "collide", "back", "sweep", "single", "whole", "parts", "comma", "field", "refused"):
    shutil.rmtree(folder, ignore_errors=True)

# --- a key of the start: each state is the one of the command by itself
steady("static_droplet_rigid_2d", "radius", DROPLET, "--along", "droplet[0].radius=0.14,0.2")
rows = states("radius")
for row in rows:
    steady("static_droplet_rigid_2d", "alone", [*DROPLET, f"droplet[0].radius={row['droplet[0].radius']}"], "--overwrite")
    found, alone = history(pathlib.Path("radius") / row["folder"]), history("alone")
    check_true(f"radius {row['droplet[0].radius']}: the state of the command by itself",
               all(found[name][-1] == alone[name][-1] for name in ("mass", "x_right", "energy_total")))
    check_true("and its row", float(row["mass"]) == alone["mass"][-1] and float(row["x_right"]) == alone["x_right"][-1])
check("the wet length grows with the radius", 1.3, (float(rows[1]["x_right"]) - 0.5) / (float(rows[0]["x_right"]) - 0.5))
said = steady("static_droplet_rigid_2d", "start", DROPLET, "--along", "droplet.radius=0.14,5", "--overwrite", code=1)
check_true("a start that is wrong is reported", "droplet" in said and "radius=5" in said, said)
for key in ("time.end", "load[0].ramp"):
    said = steady("solid_layer_2d", "refused", LAYER, "--along", f"{key}=1,2", code=1)
    check_true(f"{key} is refused, with what to do", f"--along {key}" in said and "softwet sweep" in said, said)
check_true("and nothing is written", not pathlib.Path("refused").exists())

# --- a case that gives its fields at the start: the states still follow each other
text = (cases / "solid_layer_2d.toml").read_text()
pathlib.Path("field.toml").write_text(text + '\n[initial]\ndisplacement = [0, "0.001*y"]\n')
sets = [word for setting in LAYER for word in ("--set", setting)]
done = subprocess.run([softwet, "steady", "field.toml", "--out", "field", *sets, "--threads", "1", "--along",
                       "substrate.young=1,0.9"], capture_output=True, text=True, timeout=900, env=environment)
check_true("fields at the start", done.returncode == 0, done.stdout + done.stderr)
resolved = pathlib.Path("field/young=0.9/case.toml").read_text()
check_true("are those of the state before", "young=1" in resolved and "0.001*y" not in resolved, resolved)

# --- one name for two values; a branch that comes back
steady("solid_layer_2d", "collide", LAYER, "--along", "substrate.young=1*1.5,1/1.5")
names = [row["folder"] for row in states("collide")]
check_true("two values have two folders", len(set(names)) == 2 and all(pathlib.Path("collide", name).is_dir() for name in names), str(names))
for row in states("collide"):
    young = row["substrate.young"]
    steady("solid_layer_2d", "alone", [*LAYER, f"substrate.young={young}"], "--overwrite")
    energies = history(pathlib.Path("collide") / row["folder"])["energy_elastic"][-1], history("alone")["energy_elastic"][-1]
    check(f"young = {young}: energy of the state by itself", abs(energies[0] / energies[1] - 1), 1e-8)
steady("solid_layer_2d", "back", LAYER, "--along", "substrate.young=1,0.5,1")
rows = states("back")
check_true("there and back", [row["folder"] for row in rows] == ["young=1", "young=0.5", "young=1_2"], str(rows))
steady("solid_layer_2d", "comma", LAYER, "--along", "substrate.young=max(1,0.5),0.5")
check_true("commas in parentheses separate nothing", len(states("comma")) == 2)

# --- a folder that holds something else
vary = ["--vary", "substrate.young=1,0.5", *(word for setting in [*LAYER, "time.max_steps=2"] for word in ("--set", setting))]
subprocess.run([softwet, "sweep", str(cases / "solid_layer_2d.toml"), *vary, "--out", "sweep"], capture_output=True, check=True, env=environment)
before = contents("sweep")
for more in ((), ("--overwrite",)):
    said = steady("solid_layer_2d", "sweep", LAYER, "--along", "substrate.young=1,0.5", *more, code=1)
    check_true("members of a sweep stay", contents("sweep") == before and "holds a sweep" in said and "--out" in said, said)
steady("solid_layer_2d", "single/young=0.5", LAYER)
before = contents("single")
said = steady("solid_layer_2d", "single", LAYER, "--along", "substrate.young=1,0.5", code=1)
check_true("so does the result of a run", contents("single") == before and "young=0.5" in said and "--overwrite" in said, said)

# --- the same command again; another one
STEPS = "substrate.young=1:0.4:7"
steady("solid_layer_2d", "whole", LAYER, "--along", STEPS)
before = {path: entry for path, entry in contents("whole").items() if path.name not in ("states.csv", "states.png", "along.json")}
table = pathlib.Path("whole/states.csv").read_text()
said = steady("solid_layer_2d", "whole", LAYER, "--along", STEPS)
check_true("what is there stays", before.items() <= contents("whole").items() and "7 states of rest" in said, said)
check_true("and its table", pathlib.Path("whole/states.csv").read_text() == table)
for settings, along, word in ((LAYER, "substrate.young=1,0.9", "--along"), ([*LAYER, "substrate.poisson=0.2"], STEPS, "--set")):
    said = steady("solid_layer_2d", "whole", settings, "--along", along, code=1)
    check_true(f"another {word} is refused", "the states of another command" in said and word in said, said)
check_true("and changes nothing", before.items() <= contents("whole").items() and pathlib.Path("whole/states.csv").read_text() == table)


# --- stopped between two states, in one, and by the end of its reader
def start(**streams):
    return subprocess.Popen(words("solid_layer_2d", "parts", LAYER, "--along", STEPS), text=True, env=environment, **streams)


for number in (signal.SIGTERM, signal.SIGINT):
    process = start(stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    line = process.stdout.readline()
    check_true("a state that is new", "at rest" in line, line)
    time.sleep(0.05)
    process.send_signal(number)
    said, errors = process.communicate(timeout=900)
    check_true(f"{number.name}: exit code 0", process.returncode == 0, f"{process.returncode} {said}{errors}")
    check_true(f"{number.name}: says what goes on", "stopped by user" in said and "the same command goes on" in said and not errors, said + errors)
    check_true(f"{number.name}: before the last state", 0 < len(states("parts")) < 7, str(len(states("parts"))))
process = start(stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
process.stdout.close()  # nobody reads
check_true("a command that nobody reads goes on to its end", process.wait(timeout=900) == 0)
check_true("its states are the ones of a command that was not stopped", [record(f"parts/{row['folder']}")["rest"]["steps"] for row in states("parts")] ==
           [record(f"whole/{row['folder']}")["rest"]["steps"] for row in states("whole")])
check_true("to the last bit", all(pathlib.Path("parts", row["folder"], "history.csv").read_bytes() ==
                                  pathlib.Path("whole", row["folder"], "history.csv").read_bytes() for row in states("whole")))
check_true("and so is their table", pathlib.Path("parts/states.csv").read_text() == table)
