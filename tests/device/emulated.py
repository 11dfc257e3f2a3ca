#!/usr/bin/env python3
"""usage: tests/device/emulated.py BUILD_CUDA BUILD_RELEASE [options]      Executes the kernels of a CUDA build on a processor.

Small scenes are computed twice: by the program of BUILD_CUDA with the CUDA runtime of tests/device/emulate, which executes its
kernels, and by the program of BUILD_RELEASE. Their history.csv must agree, column by column, and the runtime must find no fault.
BUILD_CUDA is compiled with NVCC_APPEND_FLAGS=--no-compress; with -lineinfo as well, faults name lines of the sources. Scenes whose
configuration or quadrature one of the builds lacks are left out and named. Without options a selection of scenes runs, which takes
about a minute of one core; some of it runs once more in another order, with all checks (EMU_SEED=7 EMU_CHECK=2 EMU_LATE=1).

--all            every case as a small scene, and all variants, with all checks (EMU_CHECK=2 EMU_LATE=1) and with each of the seeds
--seeds LIST     orders of warps and of blocks, such as 0,7 (default: 0; with --all: 0,7)
--only TEXT      scenes whose name has the text
--list           prints the names of the scenes
--unit I/N       runs slice I of N (from 1) of softwet_unit of BUILD_CUDA instead of scenes, with EMU_CHECK=2
--barriers TEXT  leaves out the barriers of kernels whose name has the text, one after another, in each scene. At each place of the
                 sources (with -lineinfo, else of a kernel) that must be noticed, by a fault or by a difference. Barriers that are
                 never passed, such as those with which Kokkos gives teams memory that no kernel asks for, are left alone
--limit S        seconds for a run (default 900)

Exit code 1: a scene differs, a fault was found, or a run failed. 77: there is no nvcc, or the program does not use the CUDA
runtime as a library."""

import argparse
import csv
import os
import pathlib
import re
import shutil
import sys

sys.dont_write_bytecode = True
from scenes import CASES, FULL, PULL, REDUCED, Build, Runtime, lacks, make_scenes, run  # noqa: E402

# Columns are compared relative to their largest number, but for those whose numbers are small differences of larger ones, or vanish by
# symmetry. A device takes sums in another order: rounding. On a processor a change of the capillarity by 1e-15 of itself changes
# most columns by up to 5e-13, steps, times and powers, which follow from rates, by 1.2e-11, and places that are searched for, with
# what is read at them, by 2e-11.
SEARCHED = 1e-10
SEARCHED_FOR = ("dt", "dissipation", "wall_stretch", "x_", "y_", "track_", "contact_area", "velocity", "angle_", "wall_angle_",
                "liquid_angle_", "ridge_", "dimple")
ABSOLUTE = ("mass_drift", "momentum_x", "momentum_y", "momentum_z", "laplace", "velocity")
NOT_COMPARED = ("newton", "krylov", "step")  # numbers of iterations, which rounding may change
# Scenes of the selection that run once more, with another order of warps and of blocks, work as late as is allowed, and all checks.
OTHER_ORDERS = ("impact_soft_2d, full", f"{PULL}, full", "impact_axisymmetric, full", "impact_rigid_3d, full")
ALL_CHECKS = {"EMU_CHECK": "2", "EMU_LATE": "1"}


def rows(folder):
    with open(folder / "history.csv") as file:
        return list(csv.DictReader(file))


def bound(column, allowed):
    return max(allowed, SEARCHED if column == "t" or column.startswith(SEARCHED_FOR) else 0)


def difference(expected, found, allowed):
    """(largest difference in parts of what is allowed, its column and row)"""
    if len(expected) != len(found) or not expected:
        return float("inf"), f"{len(found)} rows, not {len(expected)}"
    worst, place = 0.0, "all columns are equal"
    for column in expected[0]:
        if column in NOT_COMPARED or column.startswith("wall_time"):
            continue
        pairs = [(row[column], other.get(column, "")) for row, other in zip(expected, found)]
        if any((x == "") != (y == "") for x, y in pairs):
            return float("inf"), f"{column} is empty in one"
        numbers = [(float(x), float(y)) for x, y in pairs if x != ""]
        scale = 1 if column in ABSOLUTE else max([abs(x) for x, _ in numbers] + [1e-12])
        for n, (x, y) in enumerate(numbers):
            off = abs(x - y) / scale if x == x and y == y else 0 if x != x and y != y else float("inf")
            if off / bound(column, allowed) > worst:
                worst, place = off / bound(column, allowed), f"{off:.2g} in {column}, row {n}: {y!r}, not {x!r}"
    return worst, place


class Comparison:
    """Runs scenes with both programs."""

    def __init__(self, cuda, release, runtime, limit):
        self.cuda, self.release, self.runtime, self.limit = cuda, release, runtime, limit
        self.out = runtime.folder / "scenes"
        self.out.mkdir(exist_ok=True)
        self.expected = {}  # of each scene: exit code, rows, seconds

    def words(self, program, scene, folder):
        settings = list(scene.settings)
        if not {FULL, REDUCED} & set(settings) and not (self.cuda.reduced and self.release.reduced):
            settings.append(FULL)
        settings += [f"time.max_steps={scene.steps}", "output.history.every=1", "output.fields.times=[]"]
        shutil.rmtree(folder, ignore_errors=True)
        return [program, "run", CASES / f"{scene.case}.toml", "--out", folder, "--quiet",
                *(word for setting in settings for word in ("--set", setting))]

    def reference(self, name, scene):
        if name not in self.expected:
            folder = self.out / (re.sub(r"\W+", "_", name) + "_expected")
            code, text, seconds = run(self.words(self.release.program, scene, folder), os.environ, self.limit)
            if code != 0:
                print(text)
            self.expected[name] = code, rows(folder) if code == 0 else [], seconds
        return self.expected[name]

    def compare(self, name, scene, **variables):
        """(what is wrong or "", a line about the run)"""
        code, expected, first = self.reference(name, scene)
        if code != 0:
            return f"the reference ended with exit code {code}", ""
        folder = self.out / re.sub(r"\W+", "_", name)
        words = self.words(self.cuda.program, scene, folder)
        code, text, seconds = run(words, self.runtime.environment(**variables), self.limit)
        (self.out / (folder.name + ".log")).write_text(text)
        found = re.findall(r"FAULT.*|cannot go on.*", text)
        written = rows(folder) if (folder / "history.csv").is_file() else []
        off, place = difference(expected, written, scene.allowed)
        wrong = [f"exit code {code}"] if code != 0 else []
        wrong += [f"{len(found)} faults, the first: {found[0]}"] if found else []
        wrong += [f"differs by {off:.2g} times what is allowed: {place}"] if not off <= 1 else []
        return "; ".join(wrong), f"{place} ({off:.2g} of what is allowed); {first:.1f} s, {seconds:.1f} s"


def compare_all(comparison, runs):
    """Compares (name, variables of the environment) one after another."""
    failed = 0
    for name, scene, variables in runs:
        wrong, line = comparison.compare(name, scene, **variables)
        failed += bool(wrong)
        how = " ".join(f"{variable}={value}" for variable, value in variables.items())
        print(f"emulated: {'FAILED' if wrong else 'ok'}: {name}, {how}: {wrong or line}", flush=True)
    print(f"emulated: {len(runs)} runs, {failed} failed")
    return 1 if failed else 0


def runs_of(scenes, given):
    """[(name, scene, variables of the environment)]"""
    seeds = (given.seeds or ("0,7" if given.all else "0")).split(",")
    checks = ALL_CHECKS if given.all else {}
    runs = [(name, scene, {"EMU_SEED": seed, **checks}) for seed in seeds for name, scene in scenes.items()]
    if given.all or given.only or given.seeds:
        return runs
    return runs + [(name, scenes[name], {"EMU_SEED": "7", **ALL_CHECKS}) for name in OTHER_ORDERS if name in scenes]


def barriers_of(report, text):
    """{(kernel, number): place} of barriers that a run has passed, from a report of the runtime. Without -lineinfo each is a place of its
    own; else kernels share the places of the sources."""
    kernel, found = "", {}
    for line in report.read_text().splitlines():
        if line.startswith("kernel "):
            kernel = line[7:]
        elif barrier := re.match(r"  barrier (\d+) at line \d+ of the PTX: (.*): passed (\d+)", line):
            if int(barrier[3]) and text in kernel:
                found[kernel, int(barrier[1])] = barrier[2] or f"number {barrier[1]} of {kernel}"
    return found


def leave_out_barriers(comparison, scenes, text):
    """Leaves out one barrier after another of the kernels whose names have the text, in each scene that passes it. A place in the sources
    needs one kernel that notices: terms without gradients or fluxes do not need all barriers of a tile."""
    noticed = {}  # of each place
    report = comparison.out / "report.txt"
    for name, scene in scenes.items():
        wrong, _ = comparison.compare(name, scene, EMU_REPORT="2", EMU_REPORT_FILE=str(report), EMU_REPORT_ONLY=text)
        if wrong:
            print(f"emulated: FAILED: {name}: {wrong}")
            return 1
        for (kernel, number), place in barriers_of(report, text).items():
            if not noticed.get(place):
                noticed[place], _ = comparison.compare(name, scene, EMU_CHECK="2", EMU_STOP="1", EMU_DROP=str(number),
                                                       EMU_DROP_IN=kernel)
                print(f"emulated: {name}: without the barrier at {place[:300]}: {noticed[place][:200] or 'not noticed'}", flush=True)
    missed = [place for place in noticed if not noticed[place]]
    for place in missed:
        print(f"emulated: NOT NOTICED: the barrier at {place[:1000]}")
    print(f"emulated: barriers at {len(noticed)} places were left out, {len(missed)} were not noticed")
    return 1 if missed or not noticed else 0


def run_unit_tests(cuda, runtime, part, limit):
    """One slice of the unit tests of a CUDA build."""
    number, count = (int(word) for word in part.split("/"))
    variables = {"GTEST_TOTAL_SHARDS": str(count), "GTEST_SHARD_INDEX": str(number - 1), "EMU_CHECK": "2"}
    code, text, seconds = run([cuda.folder / "softwet_unit", "--gtest_brief=1"], runtime.environment(**variables), limit)
    found = re.findall(r"FAULT.*|cannot go on.*", text)
    good = code == 0 and not found and "PASSED" in text
    if not good:
        print(text[-8000:])
    result = "ok" if good else f"FAILED: exit code {code}, {len(found)} faults"
    print(f"emulated: unit tests, slice {part}: {result}; {seconds:.0f} s")
    return 0 if good else 1


def options():
    parser = argparse.ArgumentParser(usage=__doc__, add_help=False)
    parser.add_argument("cuda", type=pathlib.Path)
    parser.add_argument("release", type=pathlib.Path)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--seeds")
    parser.add_argument("--only", default="")
    parser.add_argument("--unit")
    parser.add_argument("--barriers")
    parser.add_argument("--limit", type=int, default=900)
    return parser.parse_args()


def main():
    if len(sys.argv) > 1 and sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0
    given = options()
    cuda, release = Build(given.cuda), Build(given.release)
    wanted = {name: scene for name, scene in make_scenes().items()
              if given.only in name and (given.all or given.only or scene.fast)}
    scenes = {}
    for name, scene in wanted.items():
        if missing := lacks(scene, cuda, release):
            print(f"emulated: left out: {name}: no {missing}")
        else:
            scenes[name] = scene
    if given.list:
        print("\n".join(scenes))
        return 0
    if not scenes and not given.unit:
        print("emulated: no scene is left; --list --all prints the names")
        return 1
    runtime = Runtime(cuda)
    if given.unit:
        return run_unit_tests(cuda, runtime, given.unit, given.limit)
    comparison = Comparison(cuda, release, runtime, given.limit)
    if given.barriers:
        return leave_out_barriers(comparison, scenes, given.barriers)
    return compare_all(comparison, runs_of(scenes, given))


if __name__ == "__main__":
    sys.exit(main())
