"""What `softwet converge` computes: the case at several widths, each half of the one before."""

import math
import subprocess
import tomllib

from .._store.member import Member
from .._store.values import one_spelling
from .._tools.messages import fail, last_line
from ..definition import toml_text
from ..program import ERROR, WARNING, sentences
from .fits import NEEDED
from .keys import Rescaling, units_of_keys

ELEMENTS_TO_WIDTH = 2  # of fluid.capillarity
WIDTHS_TO_RADIUS, WIDTHS_TO_LAYER = 8, 2  # of the first width, where the case has a narrower one
LONGEST_ELEMENT = 64   # domain.grading.coarsest, at most
LOCKS = 0.45           # Poisson ratio above which a layer of degree 2 needs selective integration
NO_LIMIT = "Neumann's triangle does not exist"  # in the sentence of the program
# What changes at the start or the width of no run of these widths can follow.
OF_ONE_WIDTH = ("from", "density", "velocity", "displacement")


class Plan:
    """case      the resolved case;  members  one of each width, the widest first;  widths  theirs, in units of the
    case"""

    def __init__(self, arguments):
        self.program, self.path, self.settings = arguments.softwet, arguments.case, arguments.set
        self.case, self.warnings = self.resolved()
        self.refuse_without_limit()
        doublings = self.doublings()
        self.ratios = [2.0 ** (doublings - k) for k in range(arguments.widths)]
        self.widths = [self.case["fluid"]["capillarity"] * ratio for ratio in self.ratios]
        units = units_of_keys(self.program)
        self.members = []
        for width, ratio in zip(self.widths, self.ratios):
            changed = {**Rescaling(units, ratio).settings(self.case), **self.mesh(ratio), **self.quadrature()}
            words = [*self.settings, *(f"{key}={text}" for key, text in changed.items())]
            name = f"g={width:.6g}"
            self.members.append(Member(name, (), words, arguments.out / name))

    def resolved(self):
        """Every key of the case, and what the program warns of."""
        words = [str(self.program), "check", "--resolved", str(self.path), *(f"--set={word}" for word in self.settings)]
        told = subprocess.run(words, capture_output=True, text=True)
        if told.returncode:
            fail(last_line(told.stderr, ERROR), told.returncode)
        return tomllib.loads(told.stdout), sentences(told.stderr.splitlines(), WARNING)

    def refuse_without_limit(self):
        """Refuses what depends on the width however narrow it is."""
        case = self.case
        if "fluid" not in case or not (case.get("droplet") or case.get("film")):
            fail(f"{self.path} has no droplet: without an interface nothing depends on its width")
        for sentence in self.warnings:
            if NO_LIMIT in sentence:
                fail(f"there is no limit at zero width: {sentence}")
        solid = case.get("substrate")
        if solid and solid["surface_tension"] == 0 and solid["surface_tension_wet"] == 0:
            fail("there is no limit at zero width: the solid has no surface tension, so that Neumann's triangle does not exist and "
                 "the ridge is as sharp as the interface is narrow; give substrate.surface_tension what the solid has, for "
                 "example by 'softwet units --help'")
        given = case.get("initial", {})
        if any(given.get(key) for key in OF_ONE_WIDTH):
            fail("[initial] gives fields that have the interface of one width; describe the start by droplets and films")

    def given(self, key):
        """Whether the file or an option --set gives a key."""
        if any(one_spelling(word.partition("=")[0]).startswith(key) for word in self.settings):
            return True
        table = tomllib.loads(self.path.read_text(errors="surrogateescape"))
        for part in key.split("."):
            table = table.get(part) if isinstance(table, dict) else None
        return table is not None

    def radius(self):
        """Of the smallest droplet; 0 where there are films alone."""
        return min((droplet["radius"] for droplet in self.case.get("droplet", [])), default=0.0)

    def doublings(self):
        """How often the width of the case is doubled for the first one: as long as a droplet has eight of them, the
        layer two, and the mesh still has an end of elements on the wall; at most so often that the third is the one of
        the case."""
        solid, counts = self.case.get("substrate", {"thickness": math.inf}), self.refined(1)
        often = 0
        while often < NEEDED - 1:
            width = self.case["fluid"]["capillarity"] * 2 ** (often + 1)
            coarser = [count / 2 ** (often + 1) for count in counts]
            wall = coarser[-1] * solid["thickness"] / self.case["domain"]["size"][-1] if "substrate" in self.case else 0
            if width * WIDTHS_TO_RADIUS > self.radius() * (1 + 1e-9) or width * WIDTHS_TO_LAYER > solid["thickness"] * (1 + 1e-9):
                break
            if any(count != int(count) for count in coarser) or abs(wall - round(wall)) > 1e-6:
                break
            often += 1
        return often

    def refined(self, ratio):
        """domain.elements with two to the width."""
        domain, width = self.case["domain"], self.case["fluid"]["capillarity"]
        longest = max(size / count for size, count in zip(domain["size"], domain["elements"]))
        more = max(1, math.ceil(ELEMENTS_TO_WIDTH * longest / width * (1 - 1e-9))) / ratio
        return [round(count * more) for count in domain["elements"]]

    def mesh(self, ratio):
        """Two elements to the width near the interface, and longer ones elsewhere. A box of the case stays."""
        longest = max(self.case["domain"]["grading"]["coarsest"], self.radius() / self.case["fluid"]["capillarity"]) / ratio
        settings = {"domain.elements": toml_text(self.refined(ratio)),
                    "domain.grading.coarsest": toml_text(max(1, min(longest, LONGEST_ELEMENT)))}
        if not self.given("domain.grading.box"):
            settings.update({"domain.grading.fine": "automatic", "domain.grading.box": "[[], []]"})
        return settings

    def quadrature(self):
        """A layer that would lock is integrated selectively, unless the case says how."""
        solid = self.case.get("substrate")
        if not solid or solid["poisson"] <= LOCKS or self.case["domain"]["degree"] != 2 or self.given("substrate.volume_quadrature"):
            return {}
        return {"substrate.volume_quadrature": "selective"}


def too_coarse(record, widths):
    """What the finest width leaves open, in words; empty where it is fine enough. @param record  run.json of the finest
    width"""
    over = record.get("groups", {}).get("solid_tension_over_interface")
    needed = 1.25  # g = 0.4 Upsilon/E: below it the fits were measured to hold
    if over is None or over >= needed * (1 - 1e-6):
        return ""
    more = math.ceil(math.log2(needed / over) - 1e-6)
    return (f"the finest width is {0.5 / over:.2g} times Upsilon/E, where the solid's tension gives way to its elasticity; the limits are "
            f"sure below 0.4: give --widths {widths + more}")
