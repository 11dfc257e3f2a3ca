#!/usr/bin/env python3
"""usage: tests/device/machine_code.py [FOLDER] [--stages] [--keep FILE]      Counts what a warp executes in a pass of a tile kernel.

FOLDER is a CUDA build, by default build/cuda, whose options compile passes.cpp, here for an H100 (sm_90). The machine code is read by
nvdisasm, which NVIDIA gives beside nvcc and as a Python package (nvidia-cuda-nvdisasm); it must be on PATH. cuobjdump prints no lines
of the source, so it does not do. --stages shows each stage of a pass, --keep writes the machine code to a file.

A row is a kernel: instructions that a warp executes in one pass, as a mean over the warps of a team, by class; registers of a thread, and
bytes of a thread that are spilled. Classes: floating (with conversions), integer (addresses, comparisons, moves), shared (memory of the
team), other (memory of the device, constants), stack (spilled registers), branches, barriers.

How often an instruction is counted:
- A pass is the smallest loop with a first sweep and the evaluation at points. What is outside of it, once for each tile, is not counted.
- The stage of an instruction is the function of a sweep, a fold or the evaluation that it was inlined from, by its line in the source. One
  without such a line belongs to the stage before it.
- The items of a stage are shared by the threads of the team as `share` and `share_from` do. A warp executes a loop over items in as many
  rounds as it has items for, and skips a stage where it has none. How many items there are follows from the shape of the tile (Shape).
- Other loops count once; so do all loops of kernels for reduced quadrature, marked *, whose items are not known here.
- Calls of rare branches, such as divisions of denormal numbers, do not count.

The numbers belong to one compiler, and nothing fails because of them. tests/device/loops.py holds bounds."""

import argparse
import collections
import pathlib
import re
import shutil
import subprocess
import sys

from loops import HERE, TILE, options

DEVICE = HERE.parents[1] / "src" / "operator" / "device"
CLASSES = ("floating", "integer", "shared", "other", "stack", "branches", "barriers")
OPCODES = {
    "floating": "DADD DMUL DFMA DSETP DMNMX FADD FMUL FFMA FSETP FMNMX FSEL FCHK MUFU FSWZADD F2F I2F F2I I2FP F2FP FRND",
    "shared": "LDS STS ATOMS", "other": "LDG LD STG ST LDC ULDC RED ATOM", "stack": "LDL STL",
    "branches": "BRA BSSY BSYNC EXIT CALL RET WARPSYNC NOP BREAK BRX YIELD BMOV JMP", "barriers": "BAR MEMBAR ERRBAR DEPBAR CCTL"}
CLASS_OF = {opcode: name for name, words in OPCODES.items() for opcode in words.split()}
STAGES = ("along_x", "along_y", "along_z", "along_y_and_z", "evaluate_at", "fold_fluxes", "fold_z_and_y", "fold_x", "fold_y", "fold_z")
WARP = 32

Instruction = collections.namedtuple("Instruction", "opcode target stage")
Kernel = collections.namedtuple("Kernel", "reduced dimension product real moves")


class Shape:
    """The tile of the fluid at degree 2, as ChosenTile of tile_shape.hpp has it, and the items of its stages: (how many, first thread)."""

    def __init__(self, kernel):
        across, self.size = ((7, 1, 4), 252) if kernel.dimension == 2 else ((3, 2, 1), 192)
        nx, ny, layers = across
        self.warps = -(-self.size // WARP)
        fields = 2 * kernel.dimension + 2 + (kernel.dimension + 2 if kernel.product else 0)
        channels, qx, cz = kernel.dimension + 2, 3 * nx, layers + 2
        if kernel.dimension == 2:
            self.rounds = {"along_x": (cz * qx, 0), "fold_z": (cz * qx, 0), "fold_x": ((nx + 2) * cz * channels, 0)}
        else:
            lines = (ny + 2) * cz
            self.rounds = {"along_x": (lines * qx, 0), "along_y_and_z": (qx * ny * fields, 0),
                           "fold_z_and_y": self.last(qx * channels), "fold_x": self.last(lines * channels)}

    def last(self, count):
        """As share_last of tile_sweeps_3d.hpp."""
        return count, max(0, (self.size - count) // WARP * WARP)

    def of(self, stage):
        """Rounds of all warps, and how many warps have items, each over the number of warps."""
        if stage not in self.rounds:
            return 1, 1
        count, first = self.rounds[stage]
        rounds = []
        for warp in range(self.warps):
            items = [(thread - first) % self.size for thread in range(WARP * warp, min(WARP * (warp + 1), self.size))]
            rounds.append(max(0, -(-(count - min(items)) // self.size)))
        return sum(rounds) / self.warps, sum(map(bool, rounds)) / self.warps


def functions_of_lines():
    """{header: [(line, function that begins there)]}"""
    begins = re.compile(r"\b(?:void|auto|Real|int|S)\s+(\w+)\(")
    found = {}
    for header in DEVICE.glob("*.hpp"):
        lines = header.read_text().splitlines()
        found[header.name] = [(n, match[1]) for n, text in enumerate(lines, 1) if "KOKKOS_" in text and (match := begins.search(text))]
    return found


def stage_at(chain, functions):
    """Of the innermost of these (file, line) that is in a stage."""
    for file, line in chain:
        path = pathlib.PurePath(file)
        if path.parent.name != "device" or path.name not in functions:
            continue
        before = [name for begin, name in functions[path.name] if begin <= line]
        if before and before[-1] in STAGES:
            return before[-1]
    return None


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
    functions, found, chain, lines = functions_of_lines(), {}, [], []
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
            code.append(Instruction(word[1].split(".")[0], target and target[0], stage_at(chain, functions)))
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


def counted(code, labels, shape):
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
        rounds, some = shape.of(stage) if shape else (1, 1)
        name = CLASS_OF.get(code[k].opcode, "integer")
        often = 1 if name == "barriers" else rounds if any(a <= k <= b for a, b in inner) else some
        found.setdefault(stage, collections.Counter())[name] += often
    return found


def show(name, counts, rest=""):
    print(f"  {name:38}{sum(counts.values()):8.0f}" + "".join(f"{counts[c]:10.0f}" for c in CLASSES) + rest)


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
    print(f"  {'a warp in a pass':38}{'all':>8}" + "".join(f"{c:>10}" for c in CLASSES) + "  registers   spilled")
    for mangled, name in zip(functions, names):
        match = TILE.search(name.replace("softwet::", ""))
        if not match or mangled not in of_thread:
            continue
        kernel = Kernel(bool(match[1]), int(match[2]), match[3] == "true", match[4], "WallMotion" in name)
        row = f"{kernel.dimension}D {'product' if kernel.product else 'residual'}, {kernel.real}, {'moving' if kernel.moves else 'rigid'}"
        row += ", reduced*" if kernel.reduced else ""
        counts = counted(*functions[mangled], None if kernel.reduced else Shape(kernel))
        if counts is None:
            print(f"  {row}: no loop of passes found")
            continue
        registers, spilled = of_thread[mangled]
        show(row, sum(counts.values(), collections.Counter()), f"{registers:11}{spilled:10}")
        if arguments.stages:
            for stage, numbers in counts.items():
                show("  " + stage, numbers)
    return 0


if __name__ == "__main__":
    sys.exit(main())
