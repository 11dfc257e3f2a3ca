"""The stages of a pass of tiles, and the items that the threads of a team share in each: for machine_code.py.

Tile is a tile with full quadrature. ReducedTile is one of reduced quadrature at degree 2: SlopeTileShape of tile_shape.hpp, and the
counts of items of slope_tile.hpp, slope_sweeps.hpp and slope_folds.hpp."""

import pathlib
import re

DEVICE = pathlib.Path(__file__).resolve().parents[2] / "src" / "operator" / "device"
STAGES = ("along_x", "along_y", "along_z", "along_y_and_z", "evaluate_at", "fold_fluxes", "fold_z_and_y", "fold_x", "fold_y", "fold_z")
REDUCED = ("across", "evaluate_all", "along_x_and_z", "along_y_and_z", "along_x", "trace", "load_blend", "clear", "passes", "load")
WARP = 32
# (fields that are swept, channels) in d dimensions
NUMBERS = {"ConvectionViscosity": lambda d: (d + 1, d), "PressureForce": lambda d: (2, d + 1), "MassFlux": lambda d: (d + 1, 1),
           "VariationalDerivative": lambda d: (1, 1), "NavierStokesKorteweg": lambda d: (2 * d + 2, d + 2)}
BY_NUMBER = {"PressureForce": 6, "MassFlux": 3, "VariationalDerivative": 3}  # folded numbers in 3D that have a thread each


def warps_of(items):
    return -(-items // WARP)


class Tile:
    """The tile of the fluid at degree 2, as ChosenTile of tile_shape.hpp has it, and the items of its stages: (how many, first thread)."""

    def __init__(self, kernel):
        across, self.size = ((7, 1, 4), 252) if kernel.dimension == 2 else ((3, 2, 1), 192)
        nx, ny, layers = across
        self.warps = warps_of(self.size)
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


class ReducedTile:
    """Of a term alone, with `team` threads: items of the stages of a pass, and of what is done once for a tile."""

    passes = 4

    def __init__(self, kernel):
        flat = kernel.dimension == 2
        nx, ny, qy, lines = (32, 1, 1, 2) if flat else (4, 2, 4, 8)
        cx, cy = nx + 2, 1 if flat else ny + 2
        fields, channels = NUMBERS[kernel.term](kernel.dimension)
        points, motion = lines * 2 * nx, 2 * kernel.dimension
        self.warps, self.elements = warps_of(kernel.team), nx * ny * self.passes
        columns = cx * cy * channels
        self.pass_items = {"across": ny * cx * fields, "evaluate_all": points, "along_x": lines * BY_NUMBER.get(kernel.term, channels),
                           "along_y_and_z": columns if columns <= kernel.team else cx * channels, "along_x_and_z": cx * channels}
        self.tile_items = {"load": 2 * nx + (0 if flat else qy) + 4 * self.passes, "trace": nx * qy * motion, "load_blend": 1}
        # In 2D channels of the pressure are of two kinds, one after the other, and a warp runs the text of those that it has.
        self.kinds = {"Yes(), No()": 0.75, "No(), Yes()": 0.5} if flat and kernel.term == "PressureForce" else {}

    def often(self, stage, in_pass, in_loop, kind):
        """How many warps of the team execute an instruction, in all passes of a tile."""
        times, items = (self.passes, self.pass_items) if in_pass else (1, self.tile_items)
        if stage == "clear" and in_loop:
            return 0  # the planes of a cut tile
        if stage not in items or (stage == "trace" and not in_loop):
            return times * self.warps
        rounds = warps_of(items[stage])
        return times * (rounds if in_loop else min(self.warps, rounds)) * self.kinds.get(kind, 1)


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


def reduced_lines():
    """{line of slope_tile.hpp: stage that is called there}, and {line of slope_folds.hpp: kind of channel}"""
    stages, function, stage = {}, None, None
    for n, text in enumerate((DEVICE / "slope_tile.hpp").read_text().splitlines(), 1):
        if "KOKKOS_" in text and (match := re.search(r"void (\w+)\(", text)):
            function, stage = match[1], None
        called = next((name for name in REDUCED if re.search(rf"\b{name}\(", text)), None)
        if function == "run_pass":
            stage = called or stage
            stages[n] = stage
        elif function == "run":
            stages[n] = called or "other"
    folds = (DEVICE / "slope_folds.hpp").read_text().splitlines()
    return stages, {n: match[1] for n, text in enumerate(folds, 1) if (match := re.search(r"body\(((?:Yes|No)\(\), (?:Yes|No)\(\))\)", text))}


def reduced_stage_at(chain, lines):
    """(stage, kind of channel or None)"""
    stages, kinds = lines
    at = [(pathlib.PurePath(file).name, line) for file, line in chain]
    stage = next((stages[line] for name, line in at if name == "slope_tile.hpp" and stages.get(line)), None)
    return stage, next((kinds[line] for name, line in at if name == "slope_folds.hpp" and line in kinds), None)
