#!/usr/bin/env python3
"""What the machine, the environment and launchers get wrong is reported in one sentence, with the right exit code.
usage: machine.py SOFTWET"""

import json
import os
import pathlib
import resource
import shutil
import subprocess

from _scene import check_true, cases, command, environment, record, run, softwet

CASE, NAME = str(cases / "solid_layer_2d.toml"), "solid_layer_2d"
SCENE = ["domain.elements=[16,4]", "time.max_steps=2", "output.fields.times=[0]"]
RUN = command(NAME, "run", SCENE, ["--overwrite", "--quiet"])
TABLES = ("history.csv", "interface.csv")
CORES = len(os.sched_getaffinity(0))
# What this test itself was started with is of no concern.
PLAIN = {name: value for name, value in environment.items()
         if not name.startswith(("KOKKOS_", "OMP_NUM", "OMP_THREAD"))}


def answer(words, variables=(), **options):
    return subprocess.run(words, capture_output=True, text=True, timeout=900, env={**PLAIN, **dict(variables)},
                          **options)


def refused(name, code, parts, words, variables=(), **options):
    done = answer(words, variables, **options)
    lines = [line for line in done.stderr.splitlines() if line and not line.startswith(("libgomp: ", "OMP: "))]  # before main
    good = done.returncode == code and len(lines) == 1 and lines[0].startswith("softwet: error: ")
    check_true(name, good and all(part in lines[0] for part in parts), f"{done.returncode} {done.stderr}")


# --- threads ---------------------------------------------------------------------------------------------------------
shutil.rmtree("run", ignore_errors=True)
refused("--threads 600", 1, ["--threads", "512"], [*RUN, "--threads", "600"])
for name, value in (("KOKKOS_NUM_THREADS", "abc"), ("KOKKOS_NUM_THREADS", "600"), ("OMP_NUM_THREADS", "abc"),
                    ("OMP_NUM_THREADS", "600"), ("KOKKOS_DISABLE_WARNINGS", "maybe"), ("KOKKOS_DEVICE_ID", "x")):
    refused(f"{name}={value}", 1, [name, value, "must be"], RUN, {name: value})
check_true("nothing was written", not os.path.exists("run"))
refused("OMP_THREAD_LIMIT", 1, ["OMP_THREAD_LIMIT"], [*RUN, "--threads", "2"], {"OMP_THREAD_LIMIT": "1"})
run(NAME, "run", SCENE)
for name in ("KOKKOS_NUM_THREADS", "OMP_NUM_THREADS"):
    done = answer(RUN, {name: "2"})
    check_true(f"{name}=2", done.returncode == 0 and record("run")["threads"] == 2, done.stderr)
done = answer([*RUN, "--threads", str(CORES + 1)])
check_true("more threads than cores: one warning", done.returncode == 0 and done.stderr.count("warning: ") == 1 and
           f"{CORES + 1} threads share" in done.stderr, done.stderr)
done = answer([*RUN, "--threads", "1"])
check_true("one thread: no warning", done.returncode == 0 and not done.stderr, done.stderr)

# --- copies that know nothing of each other --------------------------------------------------------------------------
several = {"SLURM_STEP_NUM_TASKS": "2", "SLURM_PROCID": "0"}
refused("one of two tasks of Slurm", 1, ["one of several processes (SLURM_STEP_NUM_TASKS = 2)", "env -u"], RUN, several)
if "built without MPI" in answer(RUN, several).stderr:  # a program with MPI would ask MPI first
    for name, value in (("PMIX_RANK", 1), ("PMI_RANK", 1), ("PMI_SIZE", 2), ("MPI_LOCALRANKID", 1), ("SLURM_PROCID", 1),
                        ("OMPI_COMM_WORLD_SIZE", 2)):
        refused(f"{name}={value}", 1, [f"one of several processes ({name} = {value})"], RUN, {name: str(value)})
for alone in ({"SLURM_NTASKS": "4", "SLURM_PROCID": "0"}, {"SLURM_STEP_NUM_TASKS": "1", "SLURM_PROCID": "0"},
              {"SLURM_ARRAY_TASK_ID": "3", "SLURM_PROCID": "0", "SLURM_NTASKS": "1"}):
    done = answer(RUN, alone)
    check_true(f"alone: {alone}", done.returncode == 0, done.stderr)
done = answer([softwet, "check", CASE], {"SLURM_STEP_NUM_TASKS": "2"})
check_true("commands that compute nothing may have copies", done.returncode == 0, done.stderr)

# --- files -----------------------------------------------------------------------------------------------------------
def small_files():
    resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))


refused("limit of the size of a file", 3, ["File too large", "ulimit -f"],
        command(NAME, "limited", ["domain.elements=[64,16]", *SCENE[1:]], ["--overwrite", "--quiet", "--threads", "1"]),
        preexec_fn=small_files)
resume = command(NAME, "run", SCENE, ["--resume", "--quiet", "--threads", "1"])
for file, parts in (("checkpoint.h5", ["checkpoint.h5", "a pipe"]), ("history.csv", ["history.csv", "a pipe"])):
    path = pathlib.Path("run") / file
    kept = path.read_bytes()
    path.unlink()
    os.mkfifo(path)
    refused(f"a pipe as {file}", 1, parts, [*resume, "--set", "time.max_steps=4"])
    path.unlink()
    path.write_bytes(kept)
refused("a case without end", 1, ["/dev/zero", "longer than 16 MiB"], [softwet, "check", "/dev/zero"])
pathlib.Path("wide.toml").write_text(pathlib.Path(CASE).read_text(), encoding="utf-16")
refused("a case in UTF-16", 1, ["wide.toml", "UTF-16", "UTF-8"], [softwet, "check", "wide.toml"])
for name, line in (("standard input", f'"{softwet}" check /dev/stdin < "{CASE}"'),
                   ("a pipe", f'cat "{CASE}" | "{softwet}" check /dev/stdin'),
                   ("a substituted process", f'"{softwet}" check <(cat "{CASE}")')):
    done = answer(["bash", "-c", line])
    check_true(f"a case from {name}", done.returncode == 0 and f'name = "{NAME}"' in done.stdout, done.stderr)
if os.path.exists("/dev/full"):
    with open("/dev/full", "w") as full:
        done = subprocess.run([softwet, "explain"], stdout=full, stderr=subprocess.PIPE, text=True, env=PLAIN)
    check_true("a full disk for what is printed", done.returncode == 3 and "cannot be written" in done.stderr,
               f"{done.returncode} {done.stderr}")

# --- closed streams --------------------------------------------------------------------------------------------------
line = " ".join(f"'{word}'" for word in command(NAME, "closed", SCENE, ["--overwrite", "--threads", "1"]))
answer(["bash", "-c", f"{line} <&- >&- 2>&-"])
check_true("what is reported goes into no table", [(pathlib.Path("closed") / table).read_text() for table in TABLES] ==
           [(pathlib.Path("run") / table).read_text() for table in TABLES])

# --- times as people write them --------------------------------------------------------------------------------------
run(NAME, "times", [SCENE[0], "load[0].start=30", "time.end=1.2", "time.dt_initial=0.05", "time.dt_max=2",
                    "output.fields.times=[]", "output.fields.every=0.1"])
decimals = [number / 10 for number in range(13)]
rows = [float(row.split(",")[1]) for row in pathlib.Path("times/history.csv").read_text().splitlines()[1:]]
check_true("t of history.csv", rows[-13:] == decimals, str(rows))
series = [entry["time"] for entry in json.loads(pathlib.Path("times/fields/solid.hdf.series").read_text())["files"]]
check_true("times of the field files", series == decimals, str(series))

# --- the same bytes --------------------------------------------------------------------------------------------------
run(NAME, "again", SCENE)
one, other = (pathlib.Path(folder, "fields/solid_0000.hdf").read_bytes() for folder in ("run", "again"))
check_true("fields of the same case have the same bytes", one == other)
check_true("a sign of zero is no other case", answer(command(NAME, "zero", [*SCENE, "substrate.poisson=0"],
                                                             ["--overwrite", "--quiet"])).returncode == 0)
done = answer(command(NAME, "zero", [*SCENE, "time.max_steps=3", "substrate.poisson=-0.0"], ["--resume", "--quiet"]))
check_true("-0.0 after 0 is resumed", done.returncode == 0, done.stderr)
