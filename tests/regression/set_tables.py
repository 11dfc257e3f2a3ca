#!/usr/bin/env python3
"""--set with a whole table, as TOML writes it on one line: the case is the one that a file with this table gives; and
what is wrong in it is reported with its remedy. usage: set_tables.py SOFTWET"""

import pathlib
import subprocess
import tomllib

from _scene import cases, check_true, softwet

LAYER = (cases / "solid_layer_2d.toml").read_text()
DROPLET = (cases / "tensotaxis_pull_2d.toml").read_text()
NEEDLE = "{ stiffness = 10, box = [[0.2, 0], [0.3, 0.125]] }"
LOADS = "[{ box = [[0.2, 0], [0.3, 0.125]], force = [0.1, 0] }, { box = [[0.5, 0], [0.6, 0.125]], force = [0, '1/8'], ramp = 2 }]"


def ask(text, *sets):
    pathlib.Path("case.toml").write_text(text)
    words = [f"--set={word}" for word in sets]
    return subprocess.run([softwet, "check", "--resolved", "case.toml", *words], capture_output=True, text=True)


def resolved(text, *sets):
    done = ask(text, *sets)
    check_true(f"{' '.join(sets) or 'the case'} is taken", done.returncode == 0, done.stderr)
    return done.stdout


def same(name, text, *sets, base=LAYER):
    """The case with these settings is the one of the text."""
    check_true(name, resolved(base, *sets) == resolved(text))


def refused(parts, *sets, text=LAYER):
    done = ask(text, *sets)
    lines = done.stderr.splitlines()
    check_true(f"refused: {' '.join(sets)}", done.returncode == 1 and len(lines) == 1 and
               all(part in lines[0] for part in ("softwet: error: --set ", *parts)), done.stderr)


# --- tables that appear once, and groups in them
gel = "[substrate]\ngel = { exponent = 0.5, time = 2.0, decades = [-1, 1] }"
same("a group", LAYER.replace("[substrate]", gel), "substrate.gel={ exponent = 0.5, time = 2.0, decades = [-1, 1] }")
same("without blanks", LAYER.replace("[substrate]", gel), "substrate.gel={exponent=0.5,time=2.0,decades=[-1,1]}")
same("a later key counts", LAYER.replace("[substrate]", gel), "substrate.gel={exponent=0.1,time=2,decades=[-1,1]}",
     "substrate.gel.exponent=0.5")
short = LAYER.replace("[substrate]", "[substrate]\ngel = { exponent = 0.5, time = 2.0 }")
same("a table replaces the one of the file", short, "substrate.gel={ exponent = 0.5, time = 2.0 }",
     base=LAYER.replace("[substrate]", gel))
same("a group of two words", LAYER + "\n[solver]\nnewton = { rtol = 1e-5 }\n", "solver.newton={rtol=1e-5}")
whole = "{ thickness = 0.125, young = 2.0, poisson = 0.3, branch = [{ modulus = 1.0, time = 1.0 }] }"
found = tomllib.loads(resolved(LAYER, f"substrate={whole}"))["substrate"]
check_true("a whole table with a list in it", (found["young"], found["poisson"]) == (2, 0.3) and len(found["branch"]) == 1, str(found))

# --- lists of tables: all of them, one, one more
found = tomllib.loads(resolved(LAYER, f"load={LOADS}"))["load"]
check_true("a list of loads", [load["force"] for load in found] == [[0.1, 0], [0, 0.125]] and found[1]["ramp"] == 2, str(found))
check_true("no loads", "load" not in tomllib.loads(resolved(LAYER, "load=[]")))
for name in ("load[0]", "load"):
    found = tomllib.loads(resolved(LAYER, name + "={ box = [[0.2, 0], [0.3, 0.125]], force = [0.1, 0] }"))["load"]
    check_true(f"{name}: the first load", [(load["box"], load["ramp"]) for load in found] == [([[0.2, 0], [0.3, 0.125]], 0)], str(found))
found = tomllib.loads(resolved(LAYER, f"load[1]={LOADS[1:LOADS.index('},') + 1]}"))["load"]
check_true("one more", len(found) == 2 and found[0]["ramp"] == 5 and found[1]["force"] == [0.1, 0], str(found))
for setting in (f"needle[0]={NEEDLE}", f"needle={NEEDLE}", f"needle=[{NEEDLE}]"):
    found = tomllib.loads(resolved(LAYER, setting))["needle"]
    check_true(f"{setting.partition('=')[0]} of a case without needles", len(found) == 1 and found[0]["stiffness"] == 10, str(found))
found = tomllib.loads(resolved(LAYER, f"needle={NEEDLE}", "needle.stiffness=20"))["needle"]
check_true("and a key of it", found[0]["stiffness"] == 20)
found = tomllib.loads(resolved(LAYER, "substrate.branch=[{ modulus = 1.0, time = 1.0 }, { modulus = 2.0, time = 3.0 }]"))["substrate"]
check_true("a list in a table", [branch["time"] for branch in found["branch"]] == [1, 3], str(found))

# --- what is wrong
refused(["substrate.gel.exponnt", "exponent"], "substrate.gel={ exponnt = 0.5 }")
refused(["substrate.gel.exponent = 7", "must be"], "substrate.gel={ exponent = 7, time = 1 }")
refused(["substrate.gel", "is no TOML", "--set 'substrate.gel={ exponent ="], "substrate.gel={ time = 1/2 }")
refused(["substrate.gel", "is no TOML", "double quotes"], "substrate.gel={ exponent = 0.5")
refused(["substrate.gel = 5", "is a table", "--set 'substrate.gel={ exponent ="], "substrate.gel=5")
refused(["substrate.gel = exponent=0.5", "is a table"], "substrate.gel=exponent=0.5")
refused(["substrate.gel", "is a table"], "substrate.gel=[{ exponent = 0.5 }]")
refused(["load[3]", "the case has 1 of these tables", "--set 'load[1]={ box ="], "load[3]={ force = [0, 0] }")
refused(["needle[0].stiffness = 5", "the case has 0 of these tables", "--set 'needle[0]={ box ="], "needle.stiffness=5")
refused(["load[0].box", "is missing"], "load={ force = [0, 0] }")
refused(["load", "is a table"], "load=[1, 2]")
refused(["gell", "unknown"], "substrate.gell={ exponent = 0.5 }")
done = subprocess.run(["bash", "-c", '"$0" check case.toml --set substrate.gel={exponent=0.5,time=1}', softwet], capture_output=True,
                      text=True)
check_true("braces that the shell has taken apart", done.returncode == 1 and "'substrate.gel=time=1' stands alone" in done.stderr and
           "single quotes" in done.stderr, done.stderr)
done = subprocess.run([softwet, "check", "case.toml", "time.end=5"], capture_output=True, text=True)
check_true("a setting without --set", done.returncode == 1 and "--set 'time.end=5'" in done.stderr, done.stderr)

# --- an output folder keeps it, and a sweep takes it
words = ["--vary", "substrate.gel={exponent=0.3,time=1},{exponent=0.5,time=1}", "--set", "domain.elements=[16,4]", "--dry-run"]
done = subprocess.run([softwet, "sweep", "case.toml", *words], capture_output=True, text=True)
check_true("a sweep over tables", done.returncode == 0 and done.stdout.count(": waiting: ") == 2, done.stdout + done.stderr)
