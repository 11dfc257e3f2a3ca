#!/usr/bin/env python3
"""tests/device/counts.py, which counts what kernels of a CUDA build ask of a device: reads a report, tells kernels apart, takes the difference
of two runs, and finds what has grown. usage: device_counts.py SOFTWET"""

import os
import pathlib
import sys

from _scene import check_true

ROOT = pathlib.Path(os.environ["SOFTWET_SOURCE_DIR"])
sys.path.insert(0, str(ROOT / "tests/device"))
import counts  # noqa: E402
import emulated  # noqa: E402

check_true("every scene that is counted is a scene of emulated.py", set(counts.SCENES) <= set(emulated.make_scenes()))

LAUNCH = "void Kokkos::Impl::cuda_parallel_launch_local_memory<Kokkos::Impl::ParallelFor<"
TILE = LAUNCH + ("softwet::TileKernel<softwet::ChosenTile<2, 2, true, float>, true, float, softwet::TermList<softwet::TermOnMesh<"
                 "softwet::Korteweg, softwet::WallMotion<2, float>, false>, softwet::TermOnMesh<softwet::Solid<softwet::Hooke>, "
                 "softwet::NoMotion, true> > >, Kokkos::TeamPolicy<Kokkos::Cuda>, Kokkos::Cuda>(x)")
LAMBDA = LAUNCH + ("_INTERNAL_1a_unity_0_cxx::softwet::(anonymous namespace)::add(Kokkos::View<double const*, Kokkos::Device<"
                   "Kokkos::Cuda, Kokkos::HostSpace> > const&)::{lambda(int)#1}, Kokkos::RangePolicy<Kokkos::Cuda>, Kokkos::Cuda>(x)")
REDUCE = LAUNCH.replace("ParallelFor<", "ParallelReduce<Kokkos::Impl::CombinedFunctorReducer<") + "softwet::Sum<2>, Kokkos::A<1> > >(x)"
short = {TILE: "TileKernel<ChosenTile<2, 2, true, float>, true, float, TermList<Korteweg moving, Solid<Hooke> fixed, blended>>",
         LAMBDA: "add(View&)::{lambda(int)#1}", REDUCE: "Sum<2>"}
for name, expected in short.items():
    check_true(f"the short name of {expected}", counts.shown(name) == expected, counts.shown(name))


def report(launches, floating):
    """What the runtime prints of a kernel and of one of Kokkos, with a kernel that prepares steps."""
    text = f"""kernel {{}}
  launches {launches}  teams 6  threads 192  shared_bytes 8  registers {{}}  stack 16  seconds 0.5
  warp_instructions 99  lanes 32.00  parted 0  fp64 {floating} fp64_div 1 integer 8
  global: accesses 4  sectors_read 12  sectors_written 2  bytes_read 5  bytes_written 5  atomics 0; shared: accesses 3  cycles 20  least 10  atomics 0; local: 3
  barrier 0 at line 9 of the PTX: : passed 3
"""
    prepare = text.format(REDUCE, 20).replace(f"launches {launches} ", "launches 1 ").replace(f"fp64 {floating}", "fp64 7")
    return text.format(TILE, 70) + text.format("Kokkos::ViewCopy", 70) + prepare + "calls: launches 9\n"


files = pathlib.Path("fewer.txt"), pathlib.Path("more.txt")
for file, numbers in zip(files, ((2, 9), (8, 33))):
    file.write_text(report(*numbers))
fewer, more = map(counts.read, files)
tile, prepare = short[TILE], short[REDUCE]
check_true("kernels of Kokkos are left out", set(more) == {tile, prepare}, more)
# Two more steps launch the kernel six times, with 24 instructions of 4 elements.
rows = counts.of_steps(more, fewer, 2, 4, False)
check_true("launches in a step", (rows[tile]["launches"], rows[prepare]["launches"]) == (3, 0), rows)
check_true("instructions for a launch and an element", (rows[tile]["floating"], rows[prepare]["floating"]) == (24 / 6 / 4, 8 / 4), rows)
check_true("of a step", (rows[counts.STEP]["launches"], rows[counts.STEP]["floating"]) == (3, 3), rows)
check_true("registers", (rows[tile]["registers"], rows[tile]["stack"]) == (70, 16), rows)
rows = counts.of_steps(more, more | {tile: {**more[tile], "launches": 2}}, 2, 4, True)
check_true("launches of an implicit step depend on its iterations", rows[tile]["launches"] == "" and counts.STEP not in rows, rows)

needs, empty = counts.needs_of(f"64 16 {TILE}\n80 8 {TILE.replace('Hooke', 'Axisymmetric')}\n8 0 {TILE.replace('Hooke', 'Other')}\n0 0 {TILE}\n9 0 other\n")
check_true("what all kernels of terms need", needs == {"2x2": {"launches": 2, "registers": 64, "stack": 16}, "rz2": {"launches": 1, "registers": 80, "stack": 8}}, needs)
check_true("a kernel that does nothing", empty == [counts.shown(TILE).replace("Hooke", "Other")], empty)

row = {"launches": 3, **{column: 100.0 for column in counts.CLASSES}, "registers": 64, "stack": 16}
counts.RECORD = pathlib.Path("counts.csv")
counts.SCENES = {"a": (1, 2), "b": (1, 2)}
counts.record({("b", "k"): {**row, "launches": ""}}, "nvcc 1", {})
counts.record({("a", "k"): row}, "nvcc 1", counts.recorded()[1])
target, bounds = counts.recorded()
counts.record({("b", "k"): {**row, "registers": "", "stack": "", "integer": 50.0}}, "nvcc 1", counts.recorded()[1])
found = {column: counts.recorded()[1]["b", "k"][column] for column in ("registers", "stack", "integer")}
check_true("a kernel without machine code keeps its registers", found == {"registers": "64", "stack": "16", "integer": "50"}, found)
counts.record({("b", "k"): {**row, "launches": ""}}, "nvcc 1", counts.recorded()[1])
check_true("scenes that were not counted keep their rows", list(bounds) == [("a", "k"), ("b", "k")], bounds)
check_true("and the numbers of these", bounds["b", "k"]["launches"] == "" and bounds["b", "k"]["integer"] == "100", bounds)
check_true("the version of nvcc", target == "nvcc 1", target)
here = {("a", "k"): row}
compared = {  # rows that were counted: beginning of what is wrong, and how many are smaller
    "equal rows": (here, [], 0),
    "2 % more": ({("a", "k"): {**row, "bank_cycles": 101.9}}, [], 0),
    "more cycles": ({("a", "k"): {**row, "bank_cycles": 102.1}}, ["a, k: bank_cycles 102.1, recorded 100"], 0),
    "a register more": ({("a", "k"): {**row, "registers": 65}}, ["a, k: registers 65, recorded 64"], 0),
    "a stack": ({("a", "k"): {**row, "stack": 32}}, ["a, k: stack 32, recorded 16"], 0),
    "a launch more": ({("a", "k"): {**row, "launches": 4}}, ["a, k: launches 4, recorded 3"], 0),
    "fewer instructions": ({("a", "k"): {**row, "integer": 90.0}}, [], 1),
    "a new kernel": (here | {("a", "new"): row}, ["a, new: not listed"], 0),
    "a scene without rows": (here | {("c", "k"): row}, [], 0),
    "a kernel that did not run": ({}, ["a, k: listed, and did not run"], 0),
}
for what, (found, wrong, less) in compared.items():
    result = counts.compare(found, bounds, {"a"})
    check_true(f"compared: {what}", result == (wrong, less), result)
