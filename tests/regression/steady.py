#!/usr/bin/env python3
"""`softwet steady`: it finds the state that a long run comes to, sooner, keeps the mass, and says that it is at rest;
loads act at their full strength; a run goes on from it, and status reads it; a state is followed along a key until none
follows; what does not rest, and loads without an end, are answered with a sentence.
usage: steady.py SOFTWET"""

import csv
import math
import pathlib
import subprocess

from _scene import cases, check, check_true, environment, history, record, run, run_file, softwet

SMALL = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "output.fields.times=[]"]
ONE = ("--overwrite", "--threads", "1")


def steady(case, folder, settings=(), options=ONE, code=0):
    """Starts the command. @return what it said"""
    sets = [word for setting in settings for word in ("--set", setting)]
    path = case if str(case).endswith(".toml") else cases / f"{case}.toml"
    done = subprocess.run([softwet, "steady", str(path), "--out", str(folder), *sets, *options], capture_output=True,
                          text=True, timeout=900, env=environment)
    check_true(f"{folder}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stdout + done.stderr


def last(folder):
    return {name: column[-1] for name, column in history(folder).items()}


def states(folder):
    with open(pathlib.Path(folder, "states.csv"), newline="") as file:
        return list(csv.DictReader(file))


# --- the state of a long run, much sooner
for kind in ("rigid", "soft"):
    case, settings = f"static_droplet_{kind}_2d", [*SMALL, 'fluid.wall_law="energy"']
    said = steady(case, kind, settings)
    run(case, f"{kind}_long", [*settings, "time.end=20000", "time.dt_max=2000"])
    found, told, long = last(kind), record(kind), last(f"{kind}_long")
    rest, long_counts = told["rest"], record(f"{kind}_long")["counts"]
    check(f"{kind}: residual over what the last digits make", rest["residual_over_round_off"], 8)
    check(f"{kind}: largest speed", rest["largest_speed"], 1e-11)
    check(f"{kind}: mass that was lost", abs(rest["mass_change"]), 1e-12)
    check(f"{kind}: mass", abs(found["mass"] / history(f"{kind}_long")["mass"][0] - 1), 1e-12)
    width = [row["x_right"] - row["x_left"] for row in (found, long)]
    check(f"{kind}: width of the droplet", abs(width[0] / width[1] - 1), 1e-6)
    check(f"{kind}: energy", abs(found["energy_total"] / long["energy_total"] - 1), 1e-8)
    check(f"{kind}: iterations over iterations of the long run", rest["newton"] / long_counts["newton"], 0.5)
    check_true(f"{kind}: says that it is at rest, and how far the droplet moved",
               told["state"] == "done" and told["stop"]["reason"] == "at rest" and "at rest after" in said
               and "moved by" in said, said)

# --- whether it is stable: a run that is disturbed a little follows the rate of the mode that stays longest
stable = steady("static_droplet_soft_2d", "stable", SMALL)
rate = record("stable")["rest"]["stability"]["growth_rates"][0]
check_true("a stable droplet", rate < 0 and "softwet: stable: " in stable, f"{rate}: {stable}")
disturbed = pathlib.Path("disturbed.toml")
disturbed.write_text((cases / "static_droplet_soft_2d.toml").read_text()
                     + '\n[[wave]]\nfield = "density"\namplitude = 1e-5\nmode = [1, 0]\n')
run_file(disturbed, "disturbed", [*SMALL, "initial.from=stable", "time.end=4000", "time.dt_max=50", "solver.newton.rtol=1e-9"])
rows = history("disturbed")
away = [abs(x - last("stable")["x_centre"]) for t, x in zip(rows["t"], rows["x_centre"]) if t > 2000]
times = [t for t in rows["t"] if t > 2000]
check("rate of a run over the rate of the mode", abs(math.log(away[-1] / away[0]) / (times[-1] - times[0]) / rate - 1), 0.03)

# --- what reads it, and goes on from it
status = subprocess.run([softwet, "status", "soft"], capture_output=True, text=True, env=environment).stdout
check_true("status", "done" in status, status)
run("static_droplet_soft_2d", "goes_on", [*SMALL, 'fluid.wall_law="energy"', "initial.from=soft", "time.end=10"])
check("fastest liquid of a run from there", history("goes_on")["speed_max_liquid"].max(), 1e-8)

# --- loads at their full strength: a column whose load pushes it down
LAYER = ["domain.elements=[16,4]", "output.fields.times=[]"]
steady("solid_layer_2d", "layer", LAYER)
check("a solid alone is at rest", record("layer")["rest"]["residual_over_round_off"], 8)
check_true("and its load acts", last("layer")["energy_elastic"] > 0, str(last("layer")))

# --- a load without a ramp, the default, has the same state as one with a ramp
for ramp in (0, 1):
    steady("tensotaxis_pull_2d", f"ramp_{ramp}", [*SMALL, "load.start=0", f"load.ramp={ramp}"])
sudden, slow = last("ramp_0"), last("ramp_1")
check("without a ramp: place of the droplet", abs(sudden["x_centre"] - slow["x_centre"]), 1e-7)
check("without a ramp: elastic energy, relative", abs(sudden["energy_elastic"] / slow["energy_elastic"] - 1), 1e-6)
check_true("the load moves the droplet", sudden["x_centre"] > 0.6, str(sudden["x_centre"]))

# --- a body that nothing holds: after a push it drifts, and no disturbance grows by itself; one that a load pushes has
# no state of rest
pathlib.Path("body.toml").write_text("""
name = "body"
domain = { size = [1.0, 0.5], elements = [8, 4] }
substrate = { thickness = 0.5, young = 1.0, poisson = 0.3 }
boundary = { left = "free", right = "free", bottom = "free", top = "free" }
time = { end = 1.0 }
output = { fields = { times = [] } }
""")
said = steady("body.toml", "body")
check_true("a body that nothing holds", "neither stable nor unstable: nothing holds the solid" in said, said)
said = steady("body.toml", "held", ['boundary.bottom="clamped"'])
check_true("one that a side holds", "nothing holds" not in said and "not stable" not in said, said)
pathlib.Path("pushed.toml").write_text(pathlib.Path("body.toml").read_text() + """
[[load]]
box = [[0.2, 0.1], [0.5, 0.4]]
force = [0.01, 0.0]
""")
said = steady("pushed.toml", "pushed", code=2)
check_true("a body that is pushed is not at rest", "no state of rest was found" in said, said)

# --- along a key
said = steady("static_droplet_soft_2d", "along", [*SMALL, 'fluid.wall_law="energy"'],
              [*ONE, "--along", "substrate.young=1:0.5:3:log"])
rows = states("along")
check_true("a row for each state", [row["state"] for row in rows] == ["at rest"] * 3, str(rows))
ridges = [float(row["ridge"]) for row in rows]
check_true("softer layers have higher ridges", 0 < ridges[0] < ridges[1] < ridges[2], str(ridges))
check_true("each with its growth rate", all(float(row["growth_rate"]) < 0.1 for row in rows), str(rows))
check("equal ratios", abs(float(rows[1]["substrate.young"]) ** 2 - 0.5), 1e-12)
said = steady("static_droplet_soft_2d", "end", [*SMALL], [*ONE, "--along", "substrate.young=1,0.02"], code=2)
check_true("the end of a branch is reported", "the branch ends: at substrate.young = " in said, said)
check_true("and is in the table", {row["state"] for row in states("end")} == {"at rest", "not at rest"})
check_true("with values of states of rest alone", all((row["energy_total"] != "") == (row["state"] == "at rest") and row["steps"]
                                                      for row in states("end")), str(states("end")))

# --- what is refused
for setting, word in (("load[0].factor=\"1+0.1*sin(t)\"", "factor"), ("time.scheme=\"kick_drift\"", "time.scheme")):
    said = steady("tensotaxis_pull_2d", "refused", [*SMALL, setting], code=1)
    check_true(f"{word}: says what to write", "steady: " in said and word in said and "--set" in said, said)
    check_true(f"{word}: nothing is written", not pathlib.Path("refused").exists())
said = steady("static_droplet_soft_2d", "refused", SMALL, [*ONE, "--along", "substrate.young=1"], code=1)
check_true("a single value is no way", "--along" in said, said)

# --- what does not rest: a layer that is too soft
said = steady("static_droplet_soft_2d", "too_soft", [*SMALL, "substrate.young=0.02"], code=2)
check_true("says so", "no state of rest was found" in said and record("too_soft")["state"] == "failed", said)
check_true("and what may help, once", said.count("raise substrate.young") == 1, said)
check_true("and leaves the last state",
           pathlib.Path("too_soft/checkpoint.h5").is_file() and len(history("too_soft")["t"]) == 1)
