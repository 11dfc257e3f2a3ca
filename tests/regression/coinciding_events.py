#!/usr/bin/env python3
"""Jumps, ramps, field times and the end of a run that come at one time: the run ends at time.end, all field files are
there, and what comes at a time that a step ends at anyhow takes no step more. usage: coinciding_events.py SOFTWET"""

import itertools
import pathlib

from _scene import check, check_true, history, open_output, run_file

BOX = "box = [[0.0, 0.0], [1.0, 0.5]]"
PART = "box = [[0.2, 0.1], [0.5, 0.4]]"


def table(name, rows):
    pathlib.Path(name).write_text("t,value\n" + "".join(f"{t!r},{v!r}\n" for t, v in rows))
    return f'"{name}"'


def load(rest, force="1e-9"):
    return "load", f"{{ {BOX}, force = [{force}, 0.0], {rest} }}"


# By name: what an event at t = T, on a clock that is 0 at the run time ZERO, adds to the case. None moves the body
# much.
KINDS = {
    "field time": lambda T, zero: ("field", T),
    "time.end": lambda T, zero: ("end", T),
    "load with <": lambda T, zero: load(f'start = {zero!r}, factor = "t < {T!r} ? 0 : 1"'),
    "load with <=": lambda T, zero: load(f'start = {zero!r}, factor = "t <= {T!r} ? 0 : 1"'),
    "load with sin": lambda T, zero: load(f'start = {zero!r}, factor = "sin(pi*t/{T!r}) > 0 ? 1 : 0"'),
    "load with a rounded time": lambda T, zero: load(f'start = {zero!r}, factor = "3*t < 3*{T!r} ? 0 : 1"'),
    "load with a table": lambda T, zero: load(f"start = {zero!r}, factor = {table('jump.csv', [(0, 0), (T, 0), (T + 1e-9, 1), (9, 1)])}"),
    "path of a load": lambda T, zero: ("load", f'{{ {PART}, start = {zero!r}, force = [1e-9, 0.0], path = ["t < {T!r} ? 0 : 0.1", "t < {T!r} ? 0 : 0.05"] }}'),
    "path of a needle": lambda T, zero: ("needle", f'{{ {PART}, stiffness = 1e-8, path = ["t < {T!r} ? 0 : 0.1", "t < {T!r} ? 0 : 0.05"] }}'),
    "start of a load": lambda T, zero: load(f"start = {zero + T!r}, ramp = 0"),
    "start of a ramp": lambda T, zero: load(f"start = {zero + T!r}, ramp = 50"),
    "end of a ramp": lambda T, zero: load(f"start = {zero!r}, ramp = {T!r}"),
    "end of a short ramp": lambda T, zero: load(f"start = {zero + T - 8e-9!r}, ramp = 8e-9"),
}


def write(name, events, zero, end, scheme):
    """The events beside a load from run time `zero` on, which sets the clock. Returns the field times."""
    lists = {"load": [load(f"start = {zero!r}", force="0.01")[1]], "needle": []}
    fields = {0.0}
    for kind, what in events:
        if kind == "end":
            end = what
        elif kind == "field":
            fields.add(what)
        else:
            lists[kind].append(what)
    fields = sorted(fields | {end})
    needles = f"needle = [ {', '.join(lists['needle'])} ]" if lists["needle"] else ""
    pathlib.Path(f"{name}.toml").write_text(f"""
name = "{name}"
domain = {{ size = [1.0, 0.5], elements = [4, 2] }}
substrate = {{ thickness = 0.5, young = 1.0, poisson = 0.3 }}
boundary = {{ left = "free", right = "free", bottom = "free", top = "free" }}
load = [ {', '.join(lists['load'])} ]
{needles}
time = {{ end = {end!r}, dt_initial = 0.04, dt_max = 0.04, max_steps = 400, scheme = "{scheme}" }}
solver = {{ newton = {{ rtol = 1e-9 }} }}
output = {{ fields = {{ times = {fields!r} }} }}
""")
    return fields, end


def ends_well(name, events, zero, end, scheme):
    """Computes the case, and returns how many steps it took."""
    fields, end = write("pair", events, zero, end, scheme)
    run_file("pair.toml", "pair")
    rows = history("pair")
    # A ramp that takes no time is a jump at its start, behind which nothing is left of a run that ends in it.
    late = rows["t"][-1] - end
    check_true(f"{name}: ends at time.end", late == 0 or ("short ramp" in name and -1e-8 < late < 0), f"{rows['t'][-1]!r}, not {end!r}")
    written = list(open_output("pair").times)
    check_true(f"{name}: all field files", written == fields, f"{written}, not {fields}")
    check(f"{name}: impulse, relative", abs(rows["momentum_x"][-1] / (0.01 * 0.5 * end) - 1), 1e-5)
    return int(rows["step"][-1])


for scheme, T, zero in (("generalized_alpha", 0.3, 0.37), ("kick_drift", 0.5, 0.0)):
    def pair(*names):
        events = [KINDS[name](T, zero) for name in names]
        return ends_well(f"{scheme}, T = {T}: {', '.join(names)}", events, zero, 2 * T, scheme)

    alone = {name: pair(name) for name in KINDS}
    for first, second in itertools.combinations(KINDS, 2):
        if scheme == "kick_drift" and first not in ("field time", "time.end", "load with <"):
            continue
        steps, usual = pair(first, second), max(alone[first], alone[second])
        if "time.end" in (first, second):
            usual = alone["time.end"]
        check_true(f"{scheme}, T = {T}: {first}, {second}: steps", steps == usual, f"{steps}, not {usual}")

    # What is written at a jump is the state of before.
    write("before", [load(f'start = {zero!r}, factor = "t < {T!r} ? 0 : 1"', force="1.0")], zero, 2 * T, scheme)
    run_file("before.toml", "before", [f"time.end={T}", f"output.fields.times=[{T}]"])
    rows = history("before")
    check(f"{scheme}: impulse up to a jump, relative", abs(rows["momentum_x"][-1] / (0.01 * 0.5 * T) - 1), 1e-5)
    check_true(f"{scheme}: fields of before the jump", list(open_output("before").times) == [T] and rows["t"][-1] == T)

# Steps that follow the error, and an expression that jumps again and again, each time at a field time.
needle = f"needle = [ {{ {PART}, stiffness = 50.0, path = ['t < 2 ? 0 : 0.002', 't < 2 ? 0 : 1e-9'] }} ]"
pathlib.Path("layer.toml").write_text(f"""
name = "layer"
domain = {{ size = [1.0, 0.5], elements = [8, 4] }}
substrate = {{ thickness = 0.5, young = 1.0, poisson = 0.3, viscosity = 0.1 }}
boundary = {{ left = "slip", right = "slip", bottom = "clamped", top = "free" }}
{needle}
load = [ {{ {BOX}, force = [1e-3, 0.0], factor = "sin(pi*t) > 0 ? 1 : 0" }} ]
time = {{ end = 5, max_steps = 400 }}
output = {{ fields = {{ times = ["0:5:6"] }} }}
""")
steps = {}
for name, path in (("both", []), ("one", ["needle[0].path=['t < 2 ? 0 : 0.002', 0]"])):
    run_file("layer.toml", name, path)
    steps[name] = int(history(name)["step"][-1])
    check_true(f"{name}: field files", list(open_output(name).times) == [0, 1, 2, 3, 4, 5], str(list(open_output(name).times)))
    check_true(f"{name}: ends at time.end", history(name)["t"][-1] == 5)
check_true("one step is not taken twice for two jumps", steps["both"] == steps["one"], str(steps))
