#!/usr/bin/env python3
"""usage: counts.py MORE FEWER STEPS [ELEMENTS] [UNKNOWNS]      What a step of a program asks of the device.

MORE and FEWER are reports (EMU_REPORT=1 EMU_REPORT_FILE=...) of runs with unlike numbers of steps, and STEPS is the difference of these
numbers. The table has, for each kernel, launches in a step, and for an element (where their number is given): warp instructions of
PTX; of them floating-point, integer and the like, accesses of shared and of global memory, and barriers; cycles of shared memory, and
without conflicts; 32-byte sectors read and written. The last lines have the sums, and bytes of global memory for an unknown."""

import re
import sys

COLUMNS = {  # heading: the counts of a report that it adds
    "launches": ("launches",),
    "warp instr": ("warp_instructions",),
    "fp": ("fp64", "fp64_div", "fp32", "fp32_div"),
    "int+": ("integer", "convert", "move", "predicate", "branch", "param", "other", "shuffle"),
    "shared": ("load_shared", "store_shared"),
    "global": ("load_global", "store_global", "atomic", "local"),
    "barrier": ("barrier",),
    "sh.cycles": ("shared cycles",),
    "least": ("shared least",),
    "sect.rd": ("global sectors_read",),
    "sect.wr": ("global sectors_written",),
}
# Words that all names of kernels have.
COMMON = ("TermList", "TermOnMesh", "WallMotion", "NoMotion", "OneValue", "Nothing", "mass_kernels::WithTies", "FusedParts", "ForEach")


def read(path):
    """{kernel: {count: number}} of a report."""
    found, name = {}, None
    for line in open(path):
        if line.startswith("kernel "):
            name = line[7:].strip()
        elif name and line.startswith("  ") and not line.startswith(("  at ", "  barrier ")):
            section = ""
            for part in re.split(r"[;:]", line):
                if part.strip() in ("global", "shared", "local"):
                    section = part.strip() + " "
                    continue
                for key, value in re.findall(r"([a-z_0-9]+) +([0-9.]+)", part):
                    entry = found.setdefault(name, {})
                    entry[section + key] = entry.get(section + key, 0) + float(value)
    return found


def shown(name):
    """A short name of a kernel."""
    words = [word for word in re.findall(r"softwet::([A-Za-z_:]+)", name) if word not in COMMON]
    return " ".join(dict.fromkeys(words))[:70] or name[:60]


def main():
    more, fewer, steps = read(sys.argv[1]), read(sys.argv[2]), float(sys.argv[3])
    elements, unknowns = (float(sys.argv[n]) if len(sys.argv) > n else 1 for n in (4, 5))
    lines = {}
    for name, counts in more.items():
        step = {key: (value - fewer.get(name, {}).get(key, 0)) / steps for key, value in counts.items()}
        if step.get("launches", 0) > 1e-9:
            lines[name] = [sum(step.get(key, 0) for key in keys) / (1 if heading == "launches" else elements)
                           for heading, keys in COLUMNS.items()]
    print("".join(f"{heading:>11}" for heading in COLUMNS), " kernel")
    for name, line in sorted(lines.items(), key=lambda one: -one[1][1]):
        print("".join(f"{number:11.2f}" for number in line), "", shown(name))
    total = [sum(column) for column in zip(*lines.values())]
    print("".join(f"{number:11.2f}" for number in total), " all")
    if unknowns > 1:
        print(f"{32 * (total[-1] + total[-2]) * elements / unknowns:.0f} bytes of sectors for an unknown")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main()
