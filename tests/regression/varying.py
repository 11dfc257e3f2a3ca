#!/usr/bin/env python3
"""Numbers that vary in space or time: loads with a factor, the work of loads, steps that end at the kinks of tables,
fields at the start, and what the command line says of them. usage: varying.py SOFTWET"""

import pathlib
import shutil
import subprocess

import h5py
import numpy
from _scene import cases, check, check_true, environment, history, record, run, run_file, softwet

# A layer whose energy only a load changes: small strains, no numerical damping.
LAYER = ["domain.elements=[32,4]", "load.ramp=0.25", "load.force=[0.002,0]", "substrate.strain=small", "time.rho_inf=1",
         "time.end=3", "output.fields.times=[0]", "output.history.every=1", "time.tolerance=1e-5"]
KINKS = [0.5, 0.75, 1.5, 2.125]
table = pathlib.Path("pulses.csv")
table.write_text("t,value\n" + "".join(f"{t},{v}\n" for t, v in zip(KINKS, [1, -2, 0, 0.5])))


def ask(*words):
    return subprocess.run([softwet, *words], capture_output=True, text=True, timeout=900, env=environment)


def bytes_of(folder):
    return pathlib.Path(folder, "history.csv").read_bytes()


# A factor of 2 is twice the force, to the last bit; and so is an expression that says 2.
run("solid_layer_2d", "twice", [*LAYER, "load.force=[0.004,0]"])
for name, factor in (("number", "2"), ("constant", "4*H/(2*H)"), ("expression", "2 + 0*t")):
    run("solid_layer_2d", name, [*LAYER, f"load.factor={factor}"])
    check_true(f"a factor of 2 as {name} is twice the force", bytes_of(name) == bytes_of("twice"))

# The work of a load that varies is what the energy gains.
sine = "load.factor=sin(2*pi*t/1.5)"
for scheme in ("generalized_alpha", "kick_drift"):
    mass = ["time.mass=consistent"] if scheme == "kick_drift" else []
    run("solid_layer_2d", f"work_{scheme}", [*LAYER, "time.dt_max=0.02", sine, f"time.scheme={scheme}", *mass])
    rows = history(f"work_{scheme}")
    work = numpy.sum(0.5 * (rows["power_load"][1:] + rows["power_load"][:-1]) * numpy.diff(rows["t"]))
    gained = rows["energy_total"][-1] - rows["energy_total"][0]
    swing = numpy.ptp(rows["energy_total"])
    check(f"{scheme}: work of the load against the energy", abs(work - gained) / swing, 5e-3)
    check_true(f"{scheme}: the load also takes work back", rows["power_load"].min() < 0 < rows["power_load"].max())

# Steps end at the points of a table, at the start of the load and at the end of its ramp. The table lies beside the
# case.
text = (cases / "solid_layer_2d.toml").read_text()
pathlib.Path("pulsed.toml").write_text(text.replace("[boundary]", 'factor = "pulses.csv"\n[boundary]', 1).replace("start = 0.0", "start = 0.125"))
for scheme in ("generalized_alpha", "kick_drift", "rkl2"):
    run_file("pulsed.toml", f"pulsed_{scheme}", [*LAYER, f"time.scheme={scheme}"])
    times = history(f"pulsed_{scheme}")["t"]
    for moment in (0.0, 0.25, *KINKS):
        check(f"{scheme}: a step ends at t = {moment}", numpy.abs(times - moment).min(), 1e-9)
power = numpy.interp([1.5], times, history("pulsed_rkl2")["power_load"])[0]
check("no power where the factor is 0", abs(power), 0.0)

# The result finds its table, whose path is absolute there, and a resumed run goes on with it.
where = f'factor = "{table.resolve()}"'
check_true("case.toml has the absolute path of the table", where in pathlib.Path("pulsed_rkl2/case.toml").read_text(), where)
told = ask("check", "pulsed_rkl2/case.toml")
check_true("the resolved case is checked", told.returncode == 0, told.stderr)
check_true("check gives the range of the factor", "load[0].factor" in told.stdout and "-2 to 1 while the load acts" in told.stdout)
run_file("pulsed.toml", "pulsed_rkl2", [*LAYER, "time.scheme=rkl2", "time.end=3.5"], ["--resume", "--quiet", "--threads", "1"])
check("a resumed run goes on", abs(history("pulsed_rkl2")["t"][-1] - 3.5), 1e-9)
table.write_text("t,value\n0,1\n1,3\n")
refused = ask("run", "pulsed.toml", "--out", "pulsed_rkl2", "--resume", *(w for s in [*LAYER, "time.scheme=rkl2"] for w in ("--set", s)))
check_true("with other values in the table it is refused", refused.returncode == 1 and "load[0].factor" in refused.stderr, refused.stderr)

# Three droplets from an expression are the droplets of entries [[droplet]] with the same densities, up to what a tanh
# differs from the interface, which is steeper in the liquid: 1 % of the mass at this capillarity. The energy falls, and
# the mass stays.
THREE = ["domain.elements=[48,48]", "fluid.capillarity=1/48", "time.end=0.2", "output.fields.times=[0]", "time.tolerance=1e-4",
         "solver.newton.rtol=1e-8", "solver.newton.atol=1e-13"]
run("three_droplets_2d", "expression", THREE)
text = (cases / "three_droplets_2d.toml").read_text()
begin, end = text.index("[initial]"), text.index("[boundary]")
drops = "".join(f"[[droplet]]\ncentre = [{x}, {y}]\nradius = {r}\n" for x, y, r in ((0.25, 0.5, 0.15), (0.75, 0.5, 0.1), (0.4, 0.78, 0.08)))
pathlib.Path("drops.toml").write_text(text[:begin] + drops + text[end:])
run_file("drops.toml", "drops", [*THREE, "fluid.initial=[0.10658,0.60238]"])
given, drop = history("expression"), history("drops")
check("energy against [[droplet]]", abs(given["energy_total"][0] / drop["energy_total"][0] - 1), 0.02)
check("mass against [[droplet]]", abs(given["mass"][0] / drop["mass"][0] - 1), 0.02)
check("largest rise of the energy", numpy.diff(given["energy_total"]).max(), 1e-12)
check("drift of the mass", numpy.abs(given["mass_drift"]).max(), 1e-12)
check_true("a scene without entries has no columns of droplets", "x_left" not in given)

# What --set takes, and what is said of a mistake.
for setting, parts in (("substrate.young=1 + 2*foo", ["column 7", "'foo' is not known", "--set substrate.young"]),
                       ("substrate.young=1 - x", ["is 0 at (1, 0)", "(0, inf)"]),
                       ("load.factor=pulse.csv", ["pulse.csv cannot be read", "folder of the case"]),
                       ("load.factor=cos(x)", ["column 5", "known are t"])):
    answer = ask("check", str(cases / "tensotaxis_pull_2d.toml"), "--set", setting)
    check_true(f"{setting} is refused", answer.returncode == 1 and all(part in answer.stderr for part in parts), answer.stderr)

pathlib.Path("pictures").mkdir(exist_ok=True)
answer = ask("check", str(cases / "solid_layer_2d.toml"), "--picture", "pictures")
check_true("a picture that is a folder is refused", answer.returncode == 1 and "pictures/scene.png" in answer.stderr and
           not answer.stdout, answer.stderr)

# From the result of another run: on the same mesh and on one of half the elements' size the fields are the same
# functions.
SOFT = ["fluid.capillarity=1/16", "output.fields.times=[0]"]
run("static_droplet_soft_2d", "rest", [*SOFT, "domain.elements=[32,16]", "time.end=2"])
last = {name: column[-1] for name, column in history("rest").items()}
for elements, near in (([32, 16], 1e-9), ([64, 32], 1e-6)):
    name = f"from_{elements[0]}"
    run("static_droplet_soft_2d", name, [*SOFT, f"domain.elements={elements}", "time.end=0.01", "initial.from=rest"])
    first = {key: column[0] for key, column in history(name).items()}
    scale = abs(last["energy_total"])
    for key in ("mass", "energy_total", "energy_free", "energy_elastic", "energy_kinetic"):
        bound = near * (scale if key.startswith("energy") else last["mass"])
        check(f"{elements}: {key} of the earlier run", abs(first[key] - last[key]), bound)
    check(f"{elements}: contact point of the earlier run", abs(first["x_left"] - last["x_left"]), 1e-3)
# From the field files of that run at a time: at its end they are its last state, at its start its first one.
run("static_droplet_soft_2d", "timed", ["fluid.capillarity=1/16", "domain.elements=[32,16]", "time.end=2", "output.fields.times=[0,2]"])
for time, row in ((0, 0), (2, -1)):
    sets = [*SOFT, "domain.elements=[64,32]", "time.end=0.01", "initial.from=timed", f"initial.time={time}"]
    run("static_droplet_soft_2d", f"from_t{time}", sets)
    then, first = history("timed"), history(f"from_t{time}")
    for key in ("mass", "energy_total", "energy_elastic", "energy_kinetic"):
        bound = 1e-6 * (abs(then["energy_total"][-1]) if key.startswith("energy") else then["mass"][-1])
        check(f"t = {time}: {key}", abs(first[key][0] - then[key][row]), bound)
# From the checkpoint of an older program.
shutil.rmtree("older", ignore_errors=True)
shutil.copytree("rest", "older")
with h5py.File("older/checkpoint.h5", "r+") as file:
    file.attrs["format_version"] = 1
run("static_droplet_soft_2d", "from_older", [*SOFT, "domain.elements=[32,16]", "time.end=0.01", "initial.from=older"])
check("of an older program: mass", abs(history("from_older")["mass"][0] - last["mass"]), 1e-9 * last["mass"])
# A run may undershoot the small density of its vapour, and so may one that starts from it.
start = record("rest")["unknowns"]["velocity"]
with h5py.File("rest/checkpoint.h5", "r+") as file:
    file["arrays/state/unknown"][start + record("rest")["unknowns"]["density"] - 1] = -0.01
run("static_droplet_soft_2d", "from_below", [*SOFT, "domain.elements=[32,16]", "time.end=0.01", "initial.from=rest"])
check_true("a run starts from one that undershoots", history("from_below")["rho_min"][0] < 0)
answer = ask("run", str(cases / "static_droplet_soft_2d.toml"), *(word for key in [*SOFT, "domain.elements=[32,16]",
             "initial.from=rest", "solver.newton.undershoot=0.005"] for word in ("--set", key)), "--out", "from_too_low", "--quiet")
check_true("but not below its own bound", answer.returncode == 1 and "initial.from" in answer.stderr and
           "[-0.005, 0.999)" in answer.stderr and "initial.time" in answer.stderr, answer.stderr)
# A run whose table is gone.
gone = pathlib.Path("gone.csv")
gone.write_text("x,value\n0,1\n1,2\n")
run("solid_layer_2d", "gone", [*LAYER, "time.end=0.5", f"substrate.young={gone.resolve()}"])
gone.unlink()
run("solid_layer_2d", "after_gone", [*LAYER, "time.end=0.01", "initial.from=gone", "load.force=[0,0]"])
then, first = history("gone")["energy_kinetic"][-1], history("after_gone")["energy_kinetic"][0]
check("from a run whose table is gone: kinetic energy", abs(first / then - 1), 1e-9)
begin = history("from_64")
check_true("time begins anew", begin["t"][0] == 0)
for settings, parts in ((["initial.from=nowhere"], ["initial.from", "nowhere/case.toml"]),
                        (["initial.from=rest", "domain.size=[1,1]"], ["initial.from", "the box of that run is 1 x 0.5"]),
                        (["initial.from=timed", "initial.time=1"], ["initial.time = 1", "of the times 0, 2"]),
                        (["initial.time=1"], ["initial.time", "belongs to initial.from"]),
                        (["initial.from=timed", "initial.time=[0,2]"], ["initial.time", "must be one time"])):
    sets = [word for setting in ["domain.elements=[32,16]", *SOFT, *settings] for word in ("--set", setting)]
    answer = ask("check", str(cases / "static_droplet_soft_2d.toml"), *sets)
    check_true(f"{settings} is refused", answer.returncode == 1 and all(part in answer.stderr for part in parts), answer.stderr)
