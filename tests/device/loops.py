#!/usr/bin/env python3
"""usage: tests/device/loops.py [FOLDER] [--record]      Counts loops and integer instructions of tile kernels in PTX.

FOLDER is a CUDA build, by default build/cuda, whose options compile tiles.cpp. What the compiler knows while it compiles, such as where a
field lies, must not be computed by the device: a loop over the fields of a term that stays a loop shows as a backward branch, and its
searches as integer instructions beside those of floating point. The counts are those of the text of a kernel with the functions that
it calls, however often a thread comes by. A kernel fails that has more of either than loops.csv, by more than a tenth; --record writes that
file. The numbers belong to one compiler: with others they are only shown. Exit code 1: a kernel has more."""

import argparse
import csv
import json
import pathlib
import re
import shlex
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
RECORD = HERE / "loops.csv"
KEPT = ("-D", "-I", "-arch", "-extended", "-expt")  # options that matter for a kernel
COLUMNS = ("loops", "integer", "floating")
INTEGER = re.compile(r"(add|sub|mul|mad|shl|shr|and|or|xor|not|div|rem|setp|selp|min|max|cvt|bfe|bfi|lop3|shf)\.\S*[subp](16|32|64|red)\b")
FLOATING = re.compile(r"(fma|mul|add|sub)\.\S*f(32|64)\b")
FUNCTION = re.compile(r"^(?=\.(?:visible |weak |extern )*\.?(?:entry|func)\b)", re.MULTILINE)
TILE = re.compile(r"TileKernel<(?:ChosenTile|(SlopeTileShape))<(\d), \d, \w+(?:, \w+)?>, (true|false), (float|double)")


def options(build):
    """Those of a source of the kernels, without its configuration."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if entry["file"].endswith("scene/pieces.cpp"):
            words = iter(shlex.split(entry["command"]))
            kept = []
            for word in words:
                if word == "-isystem":
                    kept += [word, next(words)]
                elif word.startswith(KEPT) and "SOFTWET_DIMENSION" not in word:
                    kept.append(word)
            return [*kept, "-DSOFTWET_DIMENSION=2"]
    sys.exit(f"loops: {build} is no build of softwet")


def compiled(build):
    target = build / "tiles.ptx"
    subprocess.run(["nvcc", "-x", "cu", "-ptx", "-std=c++20", "-Xcompiler", "-fopenmp", *options(build), "-o", target, HERE / "tiles.cpp"],
                   check=True)
    return target.read_text()


def counts_of(body):
    labels, loops, integer, floating = set(), 0, 0, 0
    for line in map(str.strip, body.splitlines()):
        if label := re.match(r"(\$\w+):", line):
            labels.add(label[1])
        elif branch := re.search(r"\bbra(?:\.uni)?\s+(\$\w+);", line):
            loops += branch[1] in labels
        else:
            word = re.sub(r"^@!?%p\d+\s+", "", line)
            integer += bool(INTEGER.match(word))
            floating += bool(FLOATING.match(word))
    return loops, integer, floating


def kernels(text):
    """{kernel: counts}; a kernel and the functions made for it alone have its name in theirs."""
    parts = [part for part in FUNCTION.split(text) if "{" in part and "TileKernel" in part[:part.index("{")]]
    names = subprocess.run(["c++filt"], input="\n".join(re.search(r"_Z\w+", part)[0] for part in parts), text=True, capture_output=True,
                           check=True).stdout.splitlines()
    found = {}
    for name, part in zip(names, parts):
        reduced, dimension, tangent, real = TILE.search(name.replace("softwet::", "")).groups()
        key = f"{dimension}D {'product' if tangent == 'true' else 'residual'}, {real}{', reduced' if reduced else ''}"
        found[key] = tuple(map(sum, zip(found.get(key, (0, 0, 0)), counts_of(part))))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, nargs="?", default=HERE.parents[1] / "build" / "cuda")
    parser.add_argument("--record", action="store_true", help="writes loops.csv")
    arguments = parser.parse_args()
    version = subprocess.run(["nvcc", "--version"], text=True, capture_output=True, check=True).stdout
    compiler = "nvcc " + re.search(r"release ([\d.]+)", version)[1]
    found = kernels(compiled(arguments.build))
    if arguments.record:
        rows = [f"# {compiler}", ";".join(("kernel", *COLUMNS)), *(";".join(map(str, (k, *n))) for k, n in sorted(found.items()))]
        RECORD.write_text("\n".join(rows) + "\n")
    lines = RECORD.read_text().splitlines()
    recorded = {row["kernel"]: [int(row[c]) for c in COLUMNS] for row in csv.DictReader(lines[1:], delimiter=";")}
    held, worse = lines[0] == f"# {compiler}", 0
    for kernel, counts in sorted(found.items()):
        more = kernel not in recorded or any(n > 1.1 * bound for n, bound in zip(counts[:2], recorded[kernel]))
        worse += more
        print(f"  {kernel}: {', '.join(f'{c} {n}' for c, n in zip(COLUMNS, counts))}" + (f"; recorded: {recorded.get(kernel)}" if more else ""))
    print(f"loops: {len(found)} kernels, {worse} with more than recorded" + ("" if held else f" with {lines[0][2:]}: only shown"))
    return 1 if found.keys() != recorded.keys() or (worse and held) else 0


if __name__ == "__main__":
    sys.exit(main())
