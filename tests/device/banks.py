#!/usr/bin/env python3
"""usage: tests/device/banks.py      Counts how long a pass of a tile of the fluid in 3D takes for its numbers in shared memory.

The memory that a team shares has 128 bytes in a row of its banks, so it reads or writes 16 numbers in double precision at once, of half a
warp, or 32 in single precision, of a warp: if they lie in different banks, or are the same number. Else it takes as many cycles as a bank has
different numbers. For each stage of a pass: the cycles that it takes, and those that it would take without conflicts. The addresses are
those of tile_sweeps_3d.hpp, tile_sweeps.hpp and TileRooms (degree 2, 3 x 2 elements); tables of a tile, which all threads of a warp read
at the same place, are not counted. Conflicts of the last fold with the sums of a tile are."""

import sys

THREADS, WARP, LANES, QX, QY = 192, 32, 15, 9, 6
BASE, POINTS, LINES = QX * QY, 3 * QX * QY, 12  # of a plane, of a pass; lines of control values along x


class Memory:
    def __init__(self, real):
        self.banks = 128 // real
        self.cycles = {}

    def apart(self, numbers):
        """As TileRooms::apart."""
        return numbers + (QX - numbers) % self.banks

    def take(self, stage, items, places, times=1):
        """`items` of all threads, None without one; place(item) of each number that a thread reads or writes."""
        for place in places:
            for begin in range(0, THREADS, self.banks):
                in_bank = {}
                for item in items[begin:begin + self.banks]:
                    if item is not None:
                        in_bank.setdefault(place(item) % self.banks, set()).add(place(item))
                taken, needed = self.cycles.get(stage, (0, 0))
                self.cycles[stage] = taken + times * max(map(len, in_bank.values()), default=0), needed + times * bool(in_bank)


def shared(count, first=0):
    """The items of all threads, round by round, from one thread on."""
    return [[thread - first + r * THREADS if 0 <= thread - first + r * THREADS < count else None for thread in range(THREADS)]
            for r in range(-(-count // THREADS))]


def points():
    numbers = [t // 16 * LANES + t % 16 if t % 16 < LANES else POINTS for t in range(THREADS)]
    return [p if p < POINTS else None for p in numbers]


def neighbour(axis, r):
    stride = (1, QX, BASE)[axis]
    return lambda p: p + (r if p // (1, QX, BASE)[axis] % 3 + r < 3 else r - 3) * stride


def counted(real, fields, stored, wall, channels=5):
    memory = Memory(real)
    field, point_field = memory.apart(LINES * QX), memory.apart(POINTS)
    for items in shared(LINES * QX):
        memory.take("along_x", items, [lambda i: i], fields)
    for items in shared(QX * fields * 2):
        def split(i):
            return i // (QX * fields), i % (QX * fields) // QX, i % QX  # element along y, field, place along x
        memory.take("along_y_and_z", items, [lambda i, a=a, k=k: split(i)[1] * field + (4 * k + split(i)[0] + a) * QX + split(i)[2]
                                             for k in range(3) for a in range(3)])
        memory.take("along_y_and_z", items, [lambda i, y=y, z=z: split(i)[1] * point_field + z * BASE + (3 * split(i)[0] + y) * QX + split(i)[2]
                                             for z in range(3) for y in range(3)])
    own, others = lambda p: p, [[neighbour(axis, r) for r in (1, 2)] for axis in range(3)]
    memory.take("evaluate_at, values", points(), [own], fields)
    memory.take("evaluate_at, values", points(), sum(others, []), stored)
    memory.take("evaluate_at, wall", points(), [lambda p: p % BASE], wall)
    memory.take("evaluate_at, fluxes", points(), [own], 3 * channels)
    memory.take("fold_fluxes", points(), others[0], channels)
    memory.take("fold_fluxes", points(), [own], channels)
    for items in shared(QX * channels, 4 * WARP):
        memory.take("fold_z_and_y", items, [lambda i, at=at: i // QX * point_field + at * QX + i % QX for at in range(3 * QY)], 3)
        memory.take("fold_z_and_y", items, [lambda i, line=line: i // QX * field + line * QX + i % QX for line in range(LINES)])
    for items in shared(LINES * channels, 4 * WARP):
        memory.take("fold_x", items, [lambda i, q=q: i // LINES * field + i % LINES * QX + q for q in range(QX)])
        memory.take("fold_x", items, [lambda i, x=x: i // LINES * 120 + i % LINES * 5 + x for x in range(5)], 2)
    return memory.cycles


def main():
    for name, arguments in (("residual, double, moving", (8, 8, 5, 12)), ("residual, double, rigid", (8, 8, 5, 0)),
                            ("product, single, moving", (4, 13, 10, 21))):
        cycles = counted(*arguments)
        taken, needed = (sum(pair[k] for pair in cycles.values()) for k in (0, 1))
        print(f"{name}: {taken} cycles, {needed} without conflicts")
        for stage, (some, least) in cycles.items():
            print(f"  {stage:22}{some:6}{least:6}")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        sys.exit(__doc__)
    main()
