#!/usr/bin/env python3
"""usage: tests/device/machine_code.py [FOLDER] [--stages] [--keep FILE]      Counts what a warp executes in a pass of a tile kernel.

FOLDER is a CUDA build, by default build/cuda, whose options compile passes.cpp, here for an H100 (sm_90). The machine code is read by
nvdisasm, which NVIDIA gives beside nvcc and as a Python package (nvidia-cuda-nvdisasm); it must be on PATH. cuobjdump prints no lines
of the source, so it does not do. --stages shows each stage of a pass, --keep writes the machine code to a file.

A row is a kernel. With full quadrature it has instructions that a warp executes in one pass, as a mean over the warps of a team, by class;
with reduced quadrature instructions of all warps for one element, with its share of what is done once for a tile, and behind them those of
a warp in a pass, and the threads of a team. Then come registers of a thread, and bytes of a thread that are spilled. Classes: floating (with
conversions), integer (addresses, comparisons, moves), shared (memory of the team), other (memory of the device, constants), stack (spilled
registers), branches, barriers.

How often an instruction is counted:
- A pass is the smallest loop with a first sweep and the evaluation at points. What is outside of it, once for each tile, is counted with
  reduced quadrature alone.
- The stage of an instruction is the function of a sweep, a fold or the evaluation that it was inlined from, by its line in the source. One
  without such a line belongs to the stage before it.
- The items of a stage are shared by the threads of the team as `share` and `share_from` do. A warp executes a loop over items in as many
  rounds as it has items for, and skips a stage where it has none. How many items there are follows from the shape of the tile (tile_stages.py).
- With reduced quadrature the stage is the function that run_pass or run of slope_tile.hpp calls.
- Other loops count once.
- Calls of rare branches, such as divisions of denormal numbers, do not count; with reduced quadrature neither do the distribution of work
  of Kokkos, which is not used, and the planes of cut tiles.

The numbers belong to one compiler, and nothing fails because of them. tests/device/loops.py holds bounds."""

import argparse
import collections
import pathlib
import re
import shutil
import subprocess
import sys

from loops import HERE, TILE, options
from tile_stages import ReducedTile, Tile, functions_of_lines, reduced_lines, reduced_stage_at, stage_at

CLASSES = ("floating", "integer", "shared", "other", "stack", "branches", "barriers")
OPCODES = {
    "floating": "DADD DMUL DFMA DSETP DMNMX FADD FMUL FFMA FSETP FMNMX FSEL FCHK MUFU FSWZADD F2F I2F F2I I2FP F2FP FRND",
    "shared": "LDS STS ATOMS", "other": "LDG LD STG ST LDC ULDC RED ATOM", "stack": "LDL STL",
    "branches": "BRA BSSY BSYNC EXIT CALL RET WARPSYNC NOP BREAK BRX YIELD BMOV JMP", "barriers": "BAR MEMBAR ERRBAR DEPBAR CCTL"}
CLASS_OF = {opcode: name for name, words in OPCODES.items() for opcode in words.split()}
# Text of Kokkos 5.0.2 that distributes work among teams: (file, lines)
DISTRIBUTION = {"Kokkos_Cuda_Parallel_Team.hpp": {*range(385, 412), 478}, "Kokkos_MinMax.hpp": None, "device_atomic_functions.hpp": None}

Instruction = collections.namedtuple("Instruction", "opcode target stage reduced_stage kind unused")
Kernel = collections.namedtuple("Kernel", "reduced dimension product real moves term team")


def is_distribution(chain):
    name, line = (pathlib.PurePath(chain[0][0]).name, chain[0][1]) if chain else ("", 0)
    return name in DISTRIBUTION and (DISTRIBUTION[name] is None or line in DISTRIBUTION[name])


def compiled(build, target):
    """Machine code in `target`, and {mangled kernel: (registers, spilled bytes)}."""
    words = [word for word in options(build) if not word.startswith("-arch")]
    command = ["nvcc", "-x", "cu", "-cubin", "-arch=sm_90", "-lineinfo", "-Xptxas", "-v", "-std=c++20", "-Xcompiler", "-fopenmp", *words,
               "-o", target, HERE / "passes.cpp"]
    done = subprocess.run(command, text=True, capture_output=True)
    if done.returncode:
        sys.exit(f"machine_code: nvcc failed:\n{done.stderr[-2000:]}")
    found = {}
    for part in re.split(r"Compiling entry function '", done.stderr + done.stdout)[1:]:
        spilled, registers = re.search(r"(\d+) bytes spill stores", part), re.search(r"Used (\d+) registers", part)
        found[part[:part.index("'")]] = int(registers[1]) if registers else 0, int(spilled[1]) if spilled else 0
    return found


def read(text):
    """{mangled function: (instructions, {label: place of the next instruction})}"""
    functions, calls, found, chain, lines = functions_of_lines(), reduced_lines(), {}, [], []
    code = labels = None
    for line in text.splitlines():
        if section := re.match(r"\.text\.(\S+):", line):
            code, labels, chain = [], {}, []
            found[section[1]] = code, labels
        elif source := re.search(r'//## File "([^"]+)", line (\d+)', line):
            lines.append((source[1], int(source[2])))
        elif code is None:
            continue
        elif label := re.match(r"\s*(\.L_x_\d+):", line):
            labels[label[1]] = len(code)
        elif word := re.match(r"\s*/\*[0-9a-f]+\*/\s+(?:@!?U?P\w+\s+)?(\S+)\s*(.*?);", line):
            if lines:
                chain, lines = lines, []
            target = re.search(r"\.L_x_\d+", word[2])
            code.append(Instruction(word[1].split(".")[0], target and target[0], stage_at(chain, functions),
                                    *reduced_stage_at(chain, calls), is_distribution(chain)))
    return found


def loops_of(code, labels):
    return [(labels[i.target], k) for k, i in enumerate(code) if i.opcode == "BRA" and labels.get(i.target, k) < k]


def rare(code, labels):
    """The places of blocks that call a function, up to the label that the branch before them jumps to."""
    places = set()
    for k, instruction in enumerate(code):
        if instruction.opcode == "CALL":
            branch = max((j for j in range(k) if code[j].opcode == "BRA"), default=k)
            end = labels.get(code[branch].target, 0)
            if k < end < branch + 40:
                places.update(range(branch + 1, end))
    return places


def pass_of(code, loops):
    def holds(loop, stages):
        return any(i.stage in stages for i in code[loop[0]:loop[1] + 1])
    found = [loop for loop in loops if holds(loop, ("evaluate_at",)) and holds(loop, ("along_x", "along_z"))]
    return min(found, key=lambda loop: loop[1] - loop[0], default=None)


def counted(code, labels, tile):
    """{stage: {class: instructions of a warp in a pass}}; none where there is no pass."""
    loops = loops_of(code, labels)
    whole = pass_of(code, loops)
    if not whole:
        return None
    inner = [loop for loop in loops if whole[0] < loop[0] and loop[1] < whole[1]]
    skipped, found, stage = rare(code, labels), {}, "other"
    for k in range(whole[0], whole[1] + 1):
        stage = code[k].stage or stage
        if k in skipped:
            continue
        rounds, some = tile.of(stage)
        name = CLASS_OF.get(code[k].opcode, "integer")
        often = 1 if name == "barriers" else rounds if any(a <= k <= b for a, b in inner) else some
        found.setdefault(stage, collections.Counter())[name] += often
    return found


def counted_reduced(code, labels, tile):
    """The same for an element, and the instructions of a warp in a pass."""
    loops = loops_of(code, labels)
    points = [k for k, i in enumerate(code) if i.reduced_stage == "evaluate_all"]
    wholes = [loop for loop in loops if sum(loop[0] <= k <= loop[1] for k in points) > 0.8 * len(points)]
    if not points or not wholes:
        return None, 0
    whole = min(wholes, key=lambda loop: loop[1] - loop[0])
    inner = [loop for loop in loops if loop[1] - loop[0] < whole[1] - whole[0]]
    called = next((k for k, i in enumerate(code) if i.opcode == "RET"), len(code))  # functions stand behind the kernel
    end = max(k for k, i in enumerate(code[:called]) if i.opcode == "EXIT") if called < len(code) else len(code) - 1
    skipped, found, stage, in_passes = rare(code, labels), {}, "other", 0
    for k, instruction in enumerate(code[:end + 1]):
        in_pass = whole[0] <= k <= whole[1]
        stage = instruction.reduced_stage or (stage if in_pass else "other")
        if k in skipped or instruction.unused:
            continue
        often = tile.often(stage, in_pass, any(a <= k <= b for a, b in inner), instruction.kind)
        name = CLASS_OF.get(instruction.opcode, "integer")
        found.setdefault(stage, collections.Counter())[name] += often / tile.elements
        in_passes += often * in_pass
    return found, in_passes / tile.warps / tile.passes


def show(name, counts, digits, rest=""):
    print(f"  {name:38}{sum(counts.values()):8.{digits}f}" + "".join(f"{counts[c]:10.{digits}f}" for c in CLASSES) + rest)


def show_kernel(function, kernel, of_thread, stages):
    how = f"{kernel.dimension}D {'product' if kernel.product else 'residual'}, {kernel.real}"
    row = f"{kernel.dimension}D {kernel.term}" if kernel.reduced else how
    row += ", moving" if kernel.moves else ", rigid"
    registers, spilled = of_thread
    if kernel.reduced:
        counts, of_pass = counted_reduced(*function, ReducedTile(kernel))
        rest = f"{of_pass:10.0f}{kernel.team:10}"
    else:
        counts, rest = counted(*function, Tile(kernel)), ""
    if counts is None:
        print(f"  {row}: no loop of passes found")
        return
    show(row, sum(counts.values(), collections.Counter()), int(kernel.reduced), f"{rest}{registers:11}{spilled:10}")
    if stages:
        for stage, numbers in counts.items():
            show("  " + stage, numbers, int(kernel.reduced))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, nargs="?", default=HERE.parents[1] / "build" / "cuda")
    parser.add_argument("--stages", action="store_true", help="shows each stage of a pass")
    parser.add_argument("--keep", type=pathlib.Path, help="a file for the machine code")
    arguments = parser.parse_args()
    missing = [tool for tool in ("nvcc", "nvdisasm", "c++filt") if not shutil.which(tool)]
    if missing:
        sys.exit(f"machine_code: not on PATH: {', '.join(missing)}")
    target = arguments.build / "passes.cubin"
    of_thread = compiled(arguments.build, target)
    text = subprocess.run(["nvdisasm", "-gi", "-c", target], text=True, capture_output=True, check=True).stdout
    if arguments.keep:
        arguments.keep.write_text(text)
    functions = read(text)
    names = subprocess.run(["c++filt"], input="\n".join(functions), text=True, capture_output=True, check=True).stdout.splitlines()
    kernels = {}
    for mangled, name in zip(functions, names):
        match = TILE.search(name.replace("softwet::", ""))
        if match and mangled in of_thread:
            term, team = re.search(r"TermOnMesh<softwet::(\w+)", name)[1], int(re.search(r"LaunchBounds<(\d+)", name)[1])
            kernels[mangled] = Kernel(bool(match[1]), int(match[2]), match[3] == "true", match[4], "WallMotion" in name, term, team)
    for reduced in (False, True):
        head = "reduced: warps for an element" if reduced else "a warp in a pass"
        print(f"  {head:38}{'all':>8}" + "".join(f"{c:>10}" for c in CLASSES) + ("    a pass   threads" if reduced else "") + "  registers   spilled")
        for mangled, kernel in sorted(kernels.items(), key=lambda item: item[1]):
            if kernel.reduced == reduced:
                show_kernel(functions[mangled], kernel, of_thread[mangled], arguments.stages)
    return 0


if __name__ == "__main__":
    sys.exit(main())
