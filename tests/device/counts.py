#!/usr/bin/env python3
"""usage: tests/device/counts.py BUILD_CUDA [options]      Counts what the kernels of small scenes ask of a device.

The program of BUILD_CUDA runs with the CUDA runtime of tests/device/emulate, each scene once with a few steps and once with more. The
difference of the counts is what steps ask; kernels that only prepare them have no launches in it, and what they ask is counted in the
longer run. A row is a kernel. It has, for one launch and one element: warp instructions of PTX by class, 32-byte sectors of global memory,
and cycles of the banks of shared memory, with their least number without conflicts. From the machine code it has the registers of a thread
and the bytes of its stack, where spilled registers lie; a program without machine code (-arch=compute_90) has
neither, and --record then keeps those of before. The row `a step` of an explicit scene has the sums over all kernels for one step and one
element, and the number of launches. Rows of `all kernels` have the number of kernels of terms of a configuration with full quadrature,
whether scenes run them or not, the largest number of their registers, and the sum of their stacks.

A count may be 2 % larger than in tests/device/counts.csv, and a number of registers no larger. A kernel that is not listed there fails, and
one that is listed and did not run. So does a kernel of a term with hardly any registers: it does nothing, because it calls a function
that is not there on a device. A scene is left out, with its rows, where the build lacks its configuration, and one that has no rows in
the file where neither --record nor --only asks for it. The counts belong to one version of nvcc, which the file names: with another one they are only shown.

--record      writes tests/device/counts.csv: after a change that is worth its counts
--only TEXT   scenes whose name has the text; prints all their rows
--limit S     seconds for a run (default 300)

Exit code 1: a kernel asks for more than recorded, or does nothing. 77: there is no nvcc, or the program does not use the CUDA runtime
as a library."""

import argparse
import csv
import math
import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
from scenes import CASES, NEWTON, Build, Runtime, lacks, make_scenes, run  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
RECORD = HERE / "counts.csv"
# scene: steps of the shorter and of the longer run
SCENES = {"impact_rigid_2d, full": (2, 6), "impact_soft_2d, full": (2, 6), "tensotaxis_pull_2d, full": (1, 2),
          "impact_axisymmetric, full": (1, 2), "impact_rigid_3d, full": (1, 2), "impact_soft_3d, full": (1, 2),
          "fig4_needle_3d_small, full": (1, 2)}
CLASSES = {  # column: the counts of a report that it adds
    "floating": ("fp64", "fp64_div", "fp32", "fp32_div"),
    "integer": ("integer", "convert", "move", "predicate", "branch", "param", "other", "shuffle"),
    "shared": ("load_shared", "store_shared"),
    "global": ("load_global", "store_global", "atomic", "local"),
    "barriers": ("barrier",),
    "sectors_read": ("global sectors_read",),
    "sectors_written": ("global sectors_written",),
    "bank_cycles": ("shared cycles",),
    "least_cycles": ("shared least",),
}
NEEDS = ("registers", "stack")
HEAD = ("scene", "kernel", "launches", *CLASSES, *NEEDS)
STEP, ALL = "a step", "all kernels"
FEWEST_REGISTERS = 16
OF_TERMS = re.compile(r"(?:TileKernel|TeamJacobian|TeamReduce\w*)<[^\d,]*(\d), (\d)")


def read(path):
    """{kernel: {count: number}} of a report; kernels of Kokkos itself are left out."""
    found, entry = {}, None
    for line in path.read_text().splitlines():
        if line.startswith("kernel "):
            entry = found.setdefault(shown(line[7:].strip()), {}) if "softwet::" in line else None
        elif entry is not None and line.startswith("  ") and not line.startswith(("  at ", "  barrier ")):
            section = ""
            for part in re.split(r"[;:]", line):
                if part.strip() in ("global", "shared", "local"):
                    section = part.strip() + " "
                    continue
                for key, value in re.findall(r"([a-z_0-9]+) +([0-9.]+)", part):
                    one = entry.get(section + key, 0)
                    entry[section + key] = max(one, float(value)) if key in NEEDS else one + float(value)
        else:
            entry = None
    return found


def first_argument(text):
    """The text up to the comma or bracket that ends a template argument."""
    depth = 0
    for n, letter in enumerate(text):
        if letter in ",>" and depth == 0:
            return text[:n]
        depth += (letter in "<({") - (letter in ">)}")
    return text


def shown(name):
    """A short name of a kernel: what it starts, without what all names have."""
    start = re.search(r"Parallel(?:For|Reduce|Scan)<(?:Kokkos::Impl::CombinedFunctorReducer<)?", name)
    text = first_argument(name[start.end():]) if start else name
    text = re.sub(r"softwet::|\(anonymous namespace\)::|_INTERNAL_\w+?::|Kokkos::Impl::|any_precision::|mass_kernels::", "", text)
    while re.search(r"Kokkos::View<[^<>]*<", text):
        text = re.sub(r"(Kokkos::View<[^<>]*)<[^<>]*>", r"\1", text)
    text = re.sub(r"Kokkos::View<[^<>]*>", "View", text)
    text = re.sub(r"\bconst\b|Kokkos::", "", text)
    text = re.sub(r"WallMotion<[^<>]*>", "moving", text).replace("NoMotion", "fixed")
    text = re.sub(r", false>", ">", re.sub(r", true>", ", blended>", text)) if "TermOnMesh" in text else text
    text = re.sub(r"TermOnMesh<(.*?), (moving|fixed)((?:, blended)?)>", r"\1 \2\3", text)
    return re.sub(r" (?=[ >,)&])", "", text.replace(";", ",")).strip()


def of_steps(more, fewer, steps, elements, implicit):
    """{kernel: {column: number}} of what the longer run asks beyond the shorter one, and of kernels that only prepare steps. How often an
    implicit step starts a kernel follows from its iterations, and is no number here."""
    found, step = {}, dict.fromkeys(("launches", *CLASSES), 0)
    for name, counts in more.items():
        beyond = {key: value - fewer.get(name, {}).get(key, 0) for key, value in counts.items()}
        often = beyond["launches"] / steps
        asked = beyond if often else counts
        row = {column: sum(asked.get(key, 0) for key in keys) / asked["launches"] / elements for column, keys in CLASSES.items()}
        step = {column: number + often * row.get(column, 1) for column, number in step.items()}
        found[name] = {"launches": "" if implicit else often, **row, **{key: counts[key] if counts["registers"] else "" for key in NEEDS}}
    return found if implicit else found | {STEP: step}


class Counter:
    """Runs scenes of a build and counts."""

    def __init__(self, build, limit):
        self.build, self.runtime, self.limit = build, Runtime(build), limit
        self.folder = self.runtime.folder / "counts"
        self.folder.mkdir(exist_ok=True)

    def report(self, name, scene, steps):
        file = self.folder / f"{re.sub(r'[^a-z0-9]+', '_', name)}_{steps}.txt"
        file.unlink(missing_ok=True)
        settings = [*scene.settings, f"time.max_steps={steps}", "output.history.every=1", "output.fields.times=[]"]
        words = [self.build.program, "run", CASES / f"{scene.case}.toml", "--out", self.folder / "out", "--overwrite", "--quiet",
                 *(word for setting in settings for word in ("--set", setting))]
        code, text, _ = run(words, self.runtime.environment(EMU_REPORT="1", EMU_REPORT_FILE=str(file), EMU_CHECK="0",
                                                            EMU_NEEDS_FILE=str(self.folder / "needs.txt")), self.limit)
        if code != 0:
            sys.exit(f"counts: {name}: exit code {code}: {text[-2000:]}")
        return read(file)

    def count(self, name, scene):
        fewer, more = SCENES[name]
        elements = next(setting for setting in scene.settings if setting.startswith("domain.elements="))
        number = math.prod(int(n) for n in re.findall(r"\d+", elements))
        return of_steps(self.report(name, scene, more), self.report(name, scene, fewer), more - fewer, number, NEWTON[0] in scene.settings)

    def needs(self):
        """What the kernels of terms of each configuration need, and those that do nothing."""
        text = (self.folder / "needs.txt").read_text()
        rows, empty = needs_of(text)
        return {name: row for name, row in rows.items() if name in self.build.configurations and not self.build.reduced}, empty


def needs_of(text):
    """({configuration: row}, kernels that do nothing) of a list of registers, stacks and kernels; without machine code there are none."""
    rows, empty = {}, []
    for registers, stack, name in re.findall(r"^(\d+) (\d+) (.*)$", text, re.MULTILINE):
        if int(registers) and (match := OF_TERMS.search(name)):
            configuration = f"rz{match[2]}" if "Axisymmetric" in name else f"{match[1]}x{match[2]}"
            row = rows.setdefault(configuration, {"launches": 0, "registers": 0, "stack": 0})
            row["launches"] += 1
            row["registers"] = max(row["registers"], int(registers))
            row["stack"] += int(stack)
            if int(registers) < FEWEST_REGISTERS:
                empty.append(shown(name))
    return rows, empty


def by_instructions(item):
    """The order of rows: those with most instructions first."""
    return -item[1]["floating"] - item[1]["integer"], item[0]


def written(number):
    return "" if number == "" else f"{number:.4g}" if number != round(number) else str(round(number))


def compiler():
    told = subprocess.run(["nvcc", "--version"], text=True, capture_output=True, check=True).stdout
    return "nvcc " + re.search(r"V([\d.]+)", told)[1]


def recorded():
    """What made the file, and {(scene, kernel): {column: number}}"""
    lines = RECORD.read_text().splitlines() if RECORD.exists() else ["#", ";".join(HEAD)]
    return lines[0][2:], {(row["scene"], row["kernel"]): row for row in csv.DictReader(lines[1:], delimiter=";")}


def record(rows, target, kept):
    """Writes the file; scenes that were not counted keep their rows, and kernels without machine code their registers."""
    counted = {scene for scene, _ in rows}
    rows = {key: row | {name: kept[key][name] for name in NEEDS if row.get(name) == "" and key in kept} for key, row in rows.items()}
    rows = {key: row for key, row in kept.items() if key not in rows and (key[0] == ALL or key[0] not in counted)} | rows
    order = [ALL, *SCENES]
    lines = [";".join([scene, kernel, *(row[c] if isinstance(row.get(c), str) else written(row.get(c, "")) for c in HEAD[2:])])
             for (scene, kernel), row in sorted(rows.items(), key=lambda item: order.index(item[0][0]))]
    RECORD.write_text("\n".join([f"# {target}", ";".join(HEAD), *lines]) + "\n")


def larger(row, bound):
    """The columns that are larger than allowed."""
    return [f"{column} {written(row[column])}, recorded {bound[column]}" for column in HEAD[2:]
            if row.get(column, "") != "" and bound[column] != ""
            and row[column] > float(bound[column]) * (1 if column == "registers" else 1.02) + 1e-9]


def compare(rows, bounds, scenes):
    """What is wrong, and what is smaller than recorded."""
    wrong, less, listed = [], 0, {scene for scene, _ in bounds}
    for key, row in rows.items():
        if key[0] not in listed:
            continue
        if key not in bounds:
            wrong.append(f"{', '.join(key)}: not listed")
            continue
        wrong += [f"{', '.join(key)}: {text}" for text in larger(row, bounds[key])]
        less += any(row.get(c, "") != "" and bounds[key][c] != "" and row[c] < 0.98 * float(bounds[key][c]) for c in HEAD[3:])
    return wrong + [f"{', '.join(key)}: listed, and did not run" for key in bounds if key[0] in scenes and key not in rows], less


def options():
    parser = argparse.ArgumentParser(usage=__doc__, add_help=False)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--limit", type=int, default=300)
    return parser.parse_args()


def main():
    if len(sys.argv) > 1 and sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        return 0
    given, rows, scenes = options(), {}, make_scenes()
    listed = recorded()[1]
    counter = Counter(Build(given.build), given.limit)
    for name in [name for name in SCENES if given.only in name]:
        if missing := lacks(scenes[name], counter.build, counter.build):
            print(f"counts: left out: {name}: no {missing}")
            continue
        if name not in {scene for scene, _ in listed} and not given.record and not given.only:
            print(f"counts: left out: {name}: no counts are recorded; --record adds them")
            continue
        rows |= {(name, kernel): row for kernel, row in sorted(counter.count(name, scenes[name]).items(), key=by_instructions)}
    counted = {scene for scene, _ in rows}
    needs, empty = counter.needs()
    if not given.only:
        rows |= {(ALL, name): row for name, row in needs.items() if given.record or (ALL, name) in listed}
    if given.only:
        for (scene, kernel), row in rows.items():
            print(f"  {kernel}: " + ", ".join(f"{column} {written(row[column])}" for column in HEAD[2:] if row.get(column, "") != ""))
    target, (bound_target, bounds) = compiler(), recorded()
    if given.record:
        record(rows, target, bounds if target == bound_target else {})
        bound_target, bounds = recorded()
    wrong, less = compare(rows, bounds, counted)
    for line in wrong + [f"{kernel}: does nothing" for kernel in empty]:
        print(f"counts: {line}")
    held = target == bound_target
    print(f"counts: {len(rows)} rows ({target}), {len(wrong)} larger than recorded or not listed, {less} smaller, {len(empty)} kernels do nothing"
          + ("" if held else f"; recorded with {bound_target or 'no compiler'}, so only shown"))
    return 1 if empty or (wrong and held) else 0


if __name__ == "__main__":
    sys.exit(main())
