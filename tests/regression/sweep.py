#!/usr/bin/env python3
"""The command `softwet sweep`: members, table, failure, resume, refusals, the Slurm script. usage: sweep.py SOFTWET"""

import csv
import fcntl
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time

from _scene import cases, check_true, environment, history, record, run, softwet

TOOL = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"]) / "tools" / "sweep"
CASE = str(cases / "solid_layer_2d.toml")
# A solid alone: a member takes 0.1 s. One Newton iteration is enough for the load 0 only.
SOLID = ["domain.elements=[16,4]", "time.max_steps=5", "output.fields.times=[]", "time.dt_initial=1", "time.dt_min=0.6"]
PRODUCT = ["solver.newton.max=1,20", "load[0].force=[0,0],[0.16,0]"]
NAMES = ["max=1__force=0_0", "max=1__force=0.16_0", "max=20__force=0_0", "max=20__force=0.16_0"]


def words(vary, settings=(), options=(), case=CASE):
    lists = [word for option, values in (("--vary", vary), ("--set", settings)) for value in values
             for word in (option, value)]
    return [softwet, "sweep", case, *lists, *options]


def sweep(*arguments, code=0, threads=None, **changes):
    """Runs to the end, with OMP_NUM_THREADS only where `threads` is given."""
    variables = {name: value for name, value in environment.items() if name != "OMP_NUM_THREADS"}
    variables.update({"OMP_NUM_THREADS": str(threads)} if threads else {})
    result = subprocess.run(words(*arguments, **changes), capture_output=True, text=True, timeout=900, env=variables)
    if result.returncode != code:
        check_true(f"exit code {code}", False, f"{result.returncode} {result.args}\n{result.stdout}{result.stderr}")
    return result


def refused(name, parts, *arguments, **changes):
    lines = sweep(*arguments, code=1, **changes).stderr.strip().splitlines()
    good = len(lines) == 1 and lines[0].startswith("softwet: error: ") and all(part in lines[0] for part in parts)
    check_true(f"refused: {name}", good, str(lines))


def table(folder):
    with open(pathlib.Path(folder) / "sweep.csv", newline="") as file:
        return {row["member"]: row for row in csv.DictReader(file)}


def states(folder):
    return [row["status"] for row in table(folder).values()]


def bytes_of(folder, but=()):
    return {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in sorted(pathlib.Path(folder).rglob("*"))
            if path.is_file() and path.name not in but}


def wait_for(condition, what):
    end = time.monotonic() + 900
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    check_true(f"{what} within a minute", time.monotonic() < end)


def child_of(pid):
    """The first process that this one has started."""
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            after_name = stat.read_text().rpartition(")")[2].split()
        except OSError:  # it has just ended
            continue
        if after_name[1] == str(pid):
            return int(stat.parent.name)
    raise AssertionError(f"process {pid} has no child")


def is_free(log):
    """No run and no sweep holds the lock on the log of a member."""
    with open(log, "ab") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True


for folder in ("product", "long", "array", "droplet", "counted", "other"):
    shutil.rmtree(folder, ignore_errors=True)

# The product of two keys, two members at once, one of which fails.
COLUMNS = ["energy_total", "dt"]  # of history.csv
here = ["--out", "product", "--jobs", "2", "--columns", ",".join(COLUMNS)]
listed = sweep(PRODUCT, SOLID, [*here, "--dry-run"]).stdout
check_true("--dry-run lists the members", all(name in listed for name in NAMES))
check_true("--dry-run writes nothing", not os.path.exists("product"))
message = sweep(PRODUCT, SOLID, here, code=2).stderr.strip()
check_true("the failed member is reported, in one line", f"1 of 4 members failed; {NAMES[1]}" in message and
           len(message.splitlines()) == 1, message)
rows = table("product")
unsaid = {name: value for name, value in environment.items() if not name.endswith("_NUM_THREADS")}
told = subprocess.run([softwet, "info"], capture_output=True, text=True, env=unsaid).stdout
SHARE = max(1, int(re.search(r"(\d+) threads", told)[1]) // 2)  # two members at once
check_true("members in order", list(rows) == NAMES, str(list(rows)))
check_true("states", states("product") == ["done", "failed", "done", "done"], str(states("product")))
bad = rows[NAMES[1]]
check_true("exit code and reason", bad["exit"] == "2" and "Newton" in bad["reason"] and bad["steps"] == "0", str(bad))
check_true("no values of the failed member", [bad[column] for column in COLUMNS] == ["", ""], str(bad))
check_true("but of the others", all(rows[name][column] for name in NAMES if name != NAMES[1] for column in COLUMNS), str(rows))
for name, row in rows.items():
    folder = pathlib.Path("product") / name
    check_true(f"{name}: values", (f"max={row['solver.newton.max']}", row["load[0].force"]) ==
               (name.partition("__")[0], "[0.16,0]" if "0.16" in name else "[0,0]"), str(row))
    check_true(f"{name}: as run.json", (int(row["steps"]), float(row["t"])) ==
               (record(folder)["counts"]["steps"], record(folder)["stop"]["t"]) and float(row["seconds"]) > 0)
    check_true(f"{name}: log", (folder / "member.log").read_text() != "")
    check_true(f"{name}: its share of the cores", record(folder)["threads"] == SHARE, str(SHARE))
run("solid_layer_2d", "other/alone", [*SOLID, "solver.newton.max=20", "load[0].force=[0.16,0]"])
texts = [(pathlib.Path(folder) / "history.csv").read_text() for folder in ("other/alone", f"product/{NAMES[3]}")]
check_true("a member is what softwet run computes", texts[0] == texts[1])

# Again: nothing is computed. With --retry the failed member alone is.
before = bytes_of("product", ["sweep.csv"])
sweep(PRODUCT, SOLID, here, code=2)
check_true("what ended stays", bytes_of("product", ["sweep.csv"]) == before and table("product") == rows)
sweep(PRODUCT, SOLID, [*here, "--retry"], code=2)
changed = {path.parts[1] for path, content in bytes_of("product", ["sweep.csv"]).items() if before[path] != content}
check_true("--retry: the failed member alone", changed == {NAMES[1]}, str(changed))

# Refused, and nothing changes.
before = bytes_of("product")
mine = pathlib.Path("other/case.toml")
mine.write_text(pathlib.Path(CASE).read_text().replace("young = 0.7554", "young = 0.8"))
refused("other values", ["holds another sweep", "[0.17,0]", "--out"], [PRODUCT[0], "load[0].force=[0,0],[0.17,0]"],
        SOLID, here)
refused("other settings", ["holds another sweep", "time.max_steps=6"], PRODUCT, [*SOLID, "time.max_steps=6"], here)
refused("other case", ["holds another sweep", "line 15", "young = 0.8"], PRODUCT, SOLID, here, case=str(mine))
check_true("refused: the folder stays", bytes_of("product") == before)
elsewhere = ["--out", "nowhere"]
refused("bad member", ["member poisson=0.7", "(-1, 0.5)"], ["substrate.poisson=0.3,0.7"], SOLID, elsewhere)
refused("unknown key", ["substrate.poison", "substrate.poisson"], ["substrate.poison=0.3,0.4"], SOLID, elsewhere)
refused("no list", ["--vary substrate.poisson", "KEY=V1,V2"], ["substrate.poisson"], SOLID, elsewhere)
refused("no values", ["a value is empty"], ["substrate.poisson=0.3,"], SOLID, elsewhere)
refused("twice", ["0.3 is there twice"], ["substrate.poisson=0.3,0.3"], SOLID, elsewhere)
refused("range", ["0:1:1", "a:b:n"], ["substrate.poisson=0:1:1"], SOLID, elsewhere)
for value in ("60:90", "60:90:", "1/4:1/2"):
    refused(f"range {value}", [value, "without the number of values", f"{value.rstrip(':')}:4"],
            [f"time.end={value}"], SOLID, elsewhere)
refused("varied and set", ["time.max_steps", "set twice"], ["time.max_steps=1,2"], SOLID, elsewhere)
MANY = [f"time.{key}=1:100:100" for key in ("end", "dt_min", "dt_max")]
for other in ("load.ramp", "load[00].ramp"):
    refused(f"set as {other}", ["load[0].ramp", "set twice"], ["load[0].ramp=1,2"], [f"{other}=1"], elsewhere)
refused("too many", ["1000000 members"], MANY, [], elsewhere)
refused("no such member", ["--member 2", "0 to 1"], ["time.max_steps=1,2"], [], [*elsewhere, "--member", "2"])
refused("no case", ["nowhere.toml", "No such file"], ["time.max_steps=1,2"], [], elsewhere, case="nowhere.toml")
refused("no such column, before any run", ["--columns x_center", "x_centre"], ["time.max_steps=1,2"], [],
        [*elsewhere, "--columns", "t,x_center"])
refused("nothing to vary", ["--vary"], [], [], elsewhere)
check_true("refused: no folder", not os.path.exists("nowhere"))
NO_FILES = {"a file has that name": ["--out", "other/case.toml"], "is not a program": ["--softwet", "other/case.toml"],
            "cannot use 'nowhere/a.sh'": ["--out", "other/new", "--slurm", "nowhere/a.sh"]}
for part, options in NO_FILES.items():
    command = [str(TOOL), CASE, "--softwet", softwet, "--vary", "substrate.poisson=0.3,0.4", *options]
    result = subprocess.run(command, capture_output=True, text=True, timeout=900, env=environment)
    check_true(f"refused with its remedy: {' '.join(options)}", result.returncode == 3 and part in result.stderr and
               result.stderr.count("\n") == 1 and "full" not in result.stderr, result.stderr)

# Stopped by Ctrl-C, then killed, then to the end: as if nothing had happened. The run is held while it is looked at.
LONG = [*SOLID[:1], "time.max_steps=9000", "time.end=90", "output.fields.times=[]", "time.dt_max=0.01",
        "output.history.every=1000"]
WHOLE = list(range(0, 9001, 1000))  # rows of history.csv
VARY = ["substrate.poisson=0.3:0.4:2"]
line = words(VARY, LONG, ["--out", "long"])
log = pathlib.Path("long/poisson=0.3/member.log")
one_thread = {**environment, "OMP_NUM_THREADS": "1"}  # many steps of a tiny mesh: more threads would only wait


def held(begun):
    """A sweep whose first member runs and is stopped for a while. @return the processes of both"""
    process = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=one_thread,
                               start_new_session=True)
    wait_for(begun, "the run begins")
    time.sleep(0.1)  # some steps
    child = child_of(process.pid)
    os.kill(child, signal.SIGSTOP)
    check_true("the first member runs", states("long") == ["running", "waiting"], str(states("long")))
    return process, child


process, child = held(log.with_name("history.csv").exists)
os.killpg(process.pid, signal.SIGINT)  # as a terminal does
os.kill(child, signal.SIGCONT)
message = process.communicate(timeout=900)[1]
check_true("SIGINT: exit code 2", process.returncode == 2 and "the same command goes on" in message, message)
check_true("SIGINT: the table is true", states("long") == ["interrupted", "waiting"], str(states("long")))
steps = record("long/poisson=0.3")["counts"]["steps"]
check_true("SIGINT: before the end", steps < 9000, f"after {steps} steps")
check_true("SIGINT: the run ended by itself", "stopped by user" in log.read_text(), log.read_text())

process, child = held(lambda: "resumed at" in log.read_text())
process.kill()
process.wait()
other = sweep(VARY, LONG, ["--out", "long", "--member", "0"], code=2)
check_true("SIGKILL: the run goes on and is left alone", "left alone" in other.stdout, other.stdout)
os.kill(child, signal.SIGCONT)
wait_for(lambda: is_free(log), "the run ends")

subprocess.run(line, check=True, env=one_thread, timeout=900, capture_output=True)
check_true("all are done", states("long") == ["done", "done"], str(states("long")))
check_true("whole histories", all(history(f"long/poisson=0.{n}")["step"].tolist() == WHOLE for n in (3, 4)))
check_true("resumed behind the stop", record("long/poisson=0.3")["counts"]["steps_before_resume"] == steps)

# The array script under a plain shell, its tasks side by side, when its case is gone; then the table.
options = ["--out", "array", "--slurm", "array/../other/array.sh"]
shutil.copy(CASE, "other/gone.toml")
sweep(PRODUCT, SOLID, options, case="other/gone.toml")
os.remove("other/gone.toml")
text = pathlib.Path("other/array.sh").read_text()
check_true("array of four", re.search(r"^#SBATCH --array=0-3$", text, re.M) is not None)
sweep(PRODUCT, SOLID, ["--out", "array", "--table"], code=2)
check_true("--table: all are waiting", states("array") == ["waiting"] * 4)
tasks = [subprocess.Popen(["bash", "other/array.sh"], env={**environment, "SLURM_ARRAY_TASK_ID": str(i)}, text=True,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) for i in range(4)]
ends = [(task.communicate(timeout=900)[1], task.returncode) for task in tasks]
check_true("exit codes of the tasks", [code for _, code in ends] == [0, 2, 0, 0], str(ends))
sweep(PRODUCT, SOLID, ["--out", "array", "--table", "--columns", ",".join(COLUMNS)], code=2)
check_true("the same table but for the seconds", [{**row, "seconds": 0} for row in table("array").values()] ==
           [{**row, "seconds": 0} for row in table("product").values()])

# A value more: new members are computed, old ones stay. Fewer values are refused, but for the tasks of an older script.
MORE = [PRODUCT[0], "load[0].force=[0,0],[0.08,0],[0.16,0]"]
rows = table("product")
before = bytes_of("product", ["sweep.csv", "sweep.json"])
refused("a value more and other settings", ["holds another sweep", "time.max_steps=6"], MORE,
        [*SOLID, "time.max_steps=6"], here)
sweep(MORE, SOLID, here, code=2)
after = bytes_of("product", ["sweep.csv", "sweep.json"])
check_true("a value more: old members stay", before.items() <= after.items())
check_true("a value more: new members", states("product") == ["done", "failed", "failed", "done", "done", "done"] and
           rows.items() <= table("product").items(), str(states("product")))
refused("a value less", ["holds another sweep", "values may be added"], PRODUCT, SOLID, here)
sweep(PRODUCT, SOLID, [*here, "--member", "3"])
check_true("a task of before: the folder keeps all values", len(json.loads(
    pathlib.Path("product/sweep.json").read_text())["vary"][1].split("],[")) == 3)

# Columns of a droplet: last values and the largest velocity.
RIGID = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "time.end=1", "output.fields.times=[]"]
done = sweep(["fluid.contact_angle=60,120"], RIGID, ["--out", "droplet", "--columns", "x_centre,x_left,contact_area"],
             case=str(cases / "static_droplet_rigid_2d.toml"), threads=2)
check_true("a column of other cases", "warning: --columns contact_area" in done.stderr, done.stderr)
refused("no such column", ["--columns x_center", "did you mean 'x_centre'"], ["fluid.contact_angle=60,120"], RIGID,
        ["--out", "droplet", "--columns", "x_center"], case=str(cases / "static_droplet_rigid_2d.toml"))
for name, row in table("droplet").items():
    check_true(f"{name}: OMP_NUM_THREADS", record(f"droplet/{name}")["threads"] == 2)
    found = history(f"droplet/{name}")
    for column in ("x_centre", "x_left"):
        check_true(f"{name}: {column}", float(row[column]) == found[column][-1], row[column])
    speeds = [abs(v) for v, t in zip(found["velocity"], found["t"]) if t >= 0 and v == v]
    check_true(f"{name}: velocity_peak", float(row["velocity_peak"]) == max(speeds), row["velocity_peak"])

# --threads: of each member, whatever OMP_NUM_THREADS says; its range is as for softwet run.
COUNTED = ["substrate.poisson=0.3,0.4"]
done = sweep(COUNTED, SOLID, ["--out", "counted", "--jobs", "2", "--threads", "3"], threads=1)
check_true("--threads reaches the members", [record(f"counted/poisson={n}")["threads"] for n in (0.3, 0.4)] == [3, 3])
many = int(re.search(r"(\d+) threads", told)[1])
check_true("more threads than cores are reported", ("times --threads 3 are 6 threads on" in done.stderr) == (many < 6), done.stderr)
again = sweep(COUNTED, SOLID, ["--out", "counted", "--threads", "2"])
check_true("another number of threads is no other sweep", "started" not in again.stdout, again.stdout)
listed = sweep(COUNTED, SOLID, ["--out", "other/dry", "--threads", "2", "--dry-run"]).stdout
check_true("--dry-run shows them", listed.count(" --threads=2") == 2, listed)
sweep(COUNTED, SOLID, ["--out", "other/counted", "--threads", "3", "--slurm", "other/counted.sh"])
text = pathlib.Path("other/counted.sh").read_text()
check_true("the script asks for as many processors", "--cpus-per-task=3\n" in text and "${SLURM_CPUS_PER_TASK:-3}" in text, text)
for number in ("0", "513", "two"):
    refused(f"--threads {number}", ["--threads", number], COUNTED, SOLID, ["--out", "other/dry", "--threads", number])
bounds = subprocess.run([softwet, "run", CASE, "--threads", "0"], capture_output=True, text=True).stderr
check_true("the bounds are as for softwet run", "512" in bounds and "--threads" in bounds, bounds)
