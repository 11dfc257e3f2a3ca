#!/usr/bin/env python3
"""A wall that folds: the first hints of the message let the scene go on, and its last good state has field files.
Hints about lines that stick, about Poisson's ratio, and hints of `softwet units`. usage: advice.py SOFTWET"""

import pathlib
import re
import shutil
import subprocess

from _scene import cases, check, check_true, environment, history, softwet

SOFT = ["domain.elements=[64,32]", "fluid.capillarity=1/32", "substrate.young=0.2", "time.end=10", "output.fields.times=[0]"]


def call(*words, code=0):
    done = subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"{' '.join(map(str, words))}: exit code {code}", done.returncode == code, done.stdout + done.stderr)
    return done.stdout, done.stderr


def run(case, folder, *settings, options=("--overwrite",), code=0):
    """@return the message of a run that stops, else all that was said"""
    sets = [word for setting in settings for word in ("--set", setting)]
    said = call("run", str(case), "--out", folder, "--quiet", "--threads", "1", *options, *sets, code=code)[1]
    return said.splitlines()[-1] if code else said


def in_order(text, *parts):
    places = [text.find(part) for part in parts]
    return -1 not in places and places == sorted(places)


# The wall folds. What the message names first works.
case = cases / "static_droplet_soft_2d.toml"
shutil.rmtree("folds", ignore_errors=True)
said = run(case, "folds", *SOFT, code=2)
check_true("hints in the order in which they help", in_order(
    said, "inside out", "write substrate.viscosity = 0.02", "substrate.surface_tension = 0.00791", 'fluid.wall_tension = "acts"',
    'fluid.wall_law = "energy"', "time.start", "raise substrate.young"), said)
check_true("it names neither loads nor ramps", "load" not in said and "ramp" not in said, said)
stopped = float(re.search(r"the last good state, that of t = ([\d.]+), is in folds/checkpoint.h5, its fields in folds/fields", said)[1])
run(case, "viscous", *SOFT, "substrate.viscosity=0.02")
run(case, "tense", *SOFT, "substrate.surface_tension=0.00791", 'fluid.wall_tension="acts"', 'fluid.wall_law="energy"')
check("the first hint: end", abs(history("viscous")["t"][-1] - 10), 1e-9)
check("the second one: end", abs(history("tense")["t"][-1] - 10), 1e-9)
said = run(case, "rest", *SOFT, "time.start=equilibrium", code=2)
check_true("no state of rest: hints all the same", in_order(said, "does not come to rest", "wall_tension", "substrate.viscosity"), said)

# Field files of the last good state.
series = [float(time) for time in re.findall(r'"time" *: *([-+\d.e]+)', pathlib.Path("folds/fields/fluid.hdf.series").read_text())]
check_true("fields at the start and at the stop", len(series) == 2 and abs(series[1] - stopped) < 1e-5, str(series))
check("fields of the state at the stop", abs(series[1] - float(history("folds")["t"][-1])), 1e-9)
run(case, "folds", *SOFT, options=("--resume",), code=2)
again = [float(time) for time in re.findall(r'"time" *: *([-+\d.e]+)', pathlib.Path("folds/fields/fluid.hdf.series").read_text())]
check_true("a resumed run adds none of that time", again == series, str(again))

# Lines that stick.
text = (cases / "static_droplet_rigid_2d.toml").read_text().splitlines()
pathlib.Path("sticks.toml").write_text("\n".join(line for line in text if not line.startswith("contact_angle")))
STICKS = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.wall_law=energy", "fluid.contact_angle_range=[65,84.6]",
          "fluid.gravity=[0.05,0]", "time.end=5", "output.fields.times=[]"]
said = run("sticks.toml", "sticks", *STICKS, "fluid.creep_speed=1e-5", "solver.newton.max=12", code=2)
check_true("the speed of their creep is named", "a larger fluid.creep_speed than 1e-05, for example 0.0001" in said, said)
run("sticks.toml", "creeps", *STICKS, "fluid.creep_speed=1e-4")

# A remedy that the case has already; a case as `softwet units` writes it.
for poisson, wanted in ((0.49, False), (0.499, True)):
    said = call("check", str(case), "--set", "domain.elements=[64,32]", "--set", "fluid.capillarity=1/32", "--set",
                f"substrate.poisson={poisson}", "--set", "domain.degree=2")[1]
    check_true(f"poisson = {poisson}: it locks", "% too low" in said and ("or poisson = 0.49" in said) == wanted, said)
for more in ((), ("--solid-density", "7800kg/m3")):
    lines = call("units", "--radius", "100um", "--surface-tension", "72mN/m", "--density", "1000kg/m3", "--viscosity", "10mPa.s",
                 "--young", "30kPa", "--thickness", "200um", *more)[0].splitlines()
    pathlib.Path("units.toml").write_text('name = "units"\n[domain]\nsize = [1.0, 0.6]\nelements = [134, 80]\n' + "\n".join(
        lines[lines.index("[fluid]"):]) + "\ncentre = [0.5, 0.3]\n[time]\nend = 1.0\n")
    said = call("check", "units.toml")[1]
    check_true(f"units {more}: no warning of a density that it wrote", "substrate.density" not in said, said)
