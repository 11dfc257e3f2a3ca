"""Inverted Cheerios: two droplets on a soft layer: Karpitschka et al., PNAS 113, 7403 (2016), in 2D.

S. Karpitschka, A. Pandey, L. A. Lubbers, J. H. Weijs, L. Botto, S. Das, B. Andreotti, J. H. Snoeijer, "Liquid drops attract or repel by
the inverted Cheerios effect". Droplets attract each other on thick layers and repel each other on thin ones.

Computed are states of rest of one droplet beside a side on which fluid and layer slip: a mirror, behind which the second droplet lies. A
wetting that is best at one place holds the droplet there, a trap: beside X the cosine of the contact angle falls as (x - X)^2 k/2. How far
the droplet is pulled out of the trap gives the force,
    F = sigma (cos alpha(x_left) - cos alpha(x_right)),
where x_left and x_right are the material points of the wall at its contact lines. Three thicknesses are compared with two pairs of line
forces on a linear elastic layer (tests/oracle/two_droplets.py), with the width of the interface and the foot of the droplet that were
found. The paper's numbers could not be read, and its droplets are not cylinders; its sign is what is compared."""

import math

import softwet
from softwet._drawing.look import np
import matplotlib.pyplot as plt

from softwet._figures.journal import BLUE, GREEN, VERMILION, WIDTH, letter
from softwet._papers._oracle import oracle

SIDE, ABOVE, PER_LENGTH, CAPILLARITY = 0.75, 0.25, 128, 1 / 64  # of the box, the fluid above the layer, elements
YOUNG, POISSON = 0.4, 0.49
TENSION = 0.2532 * CAPILLARITY  # of the solid, as large as the liquid's
FOOT, TRAP = 0.11, 20.0         # half of the wet width where the angle is 90 degrees; k
HEIGHTS, COLOURS, NAMES = (0.375, 0.125, 0.0625), (BLUE, GREEN, VERMILION), ("thick", "between", "thin")
PLACES = (0.1875, 0.203125, 0.21875, 0.25, 0.3125)  # a whole number of elements, so that the mesh has no force on the droplet
MIDDLE = 0.5 * SIDE + 0.25 / PER_LENGTH  # where the mesh alone exerts a force: a quarter of an element beside the middle


def case_of(height, place):
    start = math.acos(TRAP / 2 * FOOT**2)  # angle of the cap with which a run begins; its area is half a disc on the foot
    radius = FOOT * math.sqrt(0.5 * math.pi / (start - math.sin(start) * math.cos(start)))
    cosine = f"max(-0.5, {TRAP / 2} * ({FOOT}^2 - (x - {place})^2))"
    return {
        "name": f"H{height:g}_X{place:g}",
        "domain": {"size": [SIDE, height + ABOVE], "elements": [round(SIDE * PER_LENGTH), round((height + ABOVE) * PER_LENGTH)]},
        "fluid": {"viscosity": 1 / 256, "capillarity": CAPILLARITY, "temperature": 0.39, "wall_law": "energy",
                  "contact_angle": f"acos({cosine}) * {180 / math.pi}"},
        "substrate": {"thickness": height, "young": YOUNG, "poisson": POISSON, "material": "neo_hookean", "surface_tension": TENSION},
        "droplet": [{"centre": [place, height], "radius": radius}],
        "boundary": {"left": "slip", "right": "slip", "bottom": "clamped", "top": "no_slip"},
        "time": {"end": 100.0},
        "output": {"fields": {"times": [0.0, 100.0]}},
    }


def scenes(quick):
    """(thickness, place) of each run."""
    if quick:
        return [(height, 0.21875) for height in (HEIGHTS[0], HEIGHTS[2])]
    return [(height, place) for place in PLACES for height in HEIGHTS] + [(HEIGHTS[1], MIDDLE)]


def compute(runs):
    for height, place in scenes(runs.quick):
        case = runs.write_case(case_of(height, place))
        runs.softwet("steady", case, out=case.stem)


class State:
    """A droplet in its trap, and linear theory beside it. Forces are over sigma."""

    def __init__(self, folder, height, place):
        run = softwet.open(folder)
        wall, ends = run.interface[run.times[-1]], [run.history[name][-1] for name in ("x_left", "x_right")]
        self.height, self.place = height, place
        left, right = np.interp(ends, wall["x_reference"] + wall["displacement_x"], wall["x_reference"])  # material points
        self.wall, self.at = wall["displacement_y"], wall["x_reference"] + wall["displacement_x"]
        self.foot, self.shift = 0.5 * (ends[1] - ends[0]), 0.5 * (left + right) - place
        self.angle = math.acos(TRAP / 2 * (FOOT**2 - 0.25 * (right - left)**2))
        self.force = TRAP * (right - left) * self.shift
        self.linear = self.linear_at(0.5 * sum(ends))

    def linear_at(self, place):
        """The force of linear theory on this droplet at another place."""
        return oracle("two_droplets").force(place, self.height, YOUNG, POISSON, 1, CAPILLARITY, self.foot / math.sin(self.angle),
                                            self.angle, SIDE)

    def row(self):
        return [f"{self.height:g}", f"{2 * self.place:g}", f"{self.force:.6f}", f"{self.linear:.6f}", f"{self.foot:.5f}",
                f"{math.degrees(self.angle):.2f}", f"{self.shift:.6f}", f"{self.wall.max():.6f}"]


HEADER = ("thickness", "distance", "force_over_tension", "force_linear", "half_of_foot", "contact_angle", "shift_in_trap", "ridge")


# --- agreement -----------------------------------------------------------------------------------------------------
class Mesh:
    """The force of the mesh on a droplet that lies a part of an element beside a node: a wave, zero at nodes. One run
    shows how strong it is: a quarter of an element beside the middle of the box, where no other force acts."""

    def __init__(self, strongest):
        self.strongest = strongest

    def error(self, state):
        return self.strongest * abs(math.sin(2 * math.pi * state.shift * PER_LENGTH))


def words(states):
    return " and ".join(sorted({"repel" if state.force > 0 else "attract" for state in states}))


def agreement(states, mesh):
    for height, name, wanted in ((HEIGHTS[0], "thick", "attract"), (HEIGHTS[2], "thin", "repel")):
        found = words(states[height])
        yield (f"droplets on a {name} layer", f"{wanted}, the paper", found, "agrees" if found == wanted else "does not: see the text")
    for height, name in zip(HEIGHTS, NAMES):
        for state in states.get(height, []):
            off = abs(state.force - state.linear)
            yield (f"10³ force / σ, {name}, distance {2 * state.place:.3f}", f"{1e3 * state.linear:+.3f}, linear",
                   f"{1e3 * state.force:+.3f} ± {1e3 * mesh.error(state):.3f}",
                   "agrees" if off < 0.05 * abs(state.linear) + mesh.error(state) else f"does not: {off / abs(state.linear):.0%} away")


# --- picture -------------------------------------------------------------------------------------------------------
def draw_walls(axes, states):
    for height, colour, name in zip(HEIGHTS, COLOURS, NAMES):
        for state in states.get(height, [])[:1]:
            for side in (-1, 1):
                axes.plot(side * state.at, 1e3 * state.wall, color=colour, label=name if side > 0 else None)
    axes.axvline(0, color="0.6", linewidth=0.6)
    axes.set(xlabel=r"$x \;/\; L_0$, from the mirror", ylabel=r"height of the wall $\;/\; 10^{-3} L_0$", xlim=(-0.45, 0.45),
             ylim=(-10.5, None))
    axes.legend(loc="lower center", ncols=3, columnspacing=1, handlelength=1.2)


def draw_forces(axes, states, mesh):
    for height, colour, name in zip(HEIGHTS, COLOURS, NAMES):
        chosen = states.get(height, [])
        distance = [2 * state.place for state in chosen]
        axes.errorbar(distance, [1e3 * state.force for state in chosen], yerr=[1e3 * mesh.error(state) for state in chosen],
                      fmt="o", markersize=3.5, color=colour, label=f"{name}, H = {height:g}")
        if len(chosen) > 1:
            between = np.linspace(PLACES[0], PLACES[-1], 30)
            axes.plot(2 * between, [1e3 * chosen[0].linear_at(place) for place in between], "--", color=colour)
    axes.axhline(0, color="0.6", linewidth=0.6)
    axes.set(xlabel=r"distance of the droplets $\;/\; L_0$", ylabel=r"force $\;/\; 10^{-3} \sigma$",
             title="above 0 they repel; dashed: linear theory")
    axes.legend()


def draw(folder):
    quick = not (folder / f"H{HEIGHTS[1]:g}_X{PLACES[0]:g}").is_dir()
    found = [State(folder / case_of(height, place)["name"], height, place) for height, place in scenes(quick)]
    mesh = Mesh(0 if quick else abs(found[-1].force - found[-1].linear))
    states = {height: [state for state in found if state.height == height and state.place != MIDDLE] for height in HEIGHTS}
    figure, axes = plt.subplots(1, 2, figsize=(WIDTH, 2.9), layout="constrained")
    draw_walls(axes[0], states)
    draw_forces(axes[1], states, mesh)
    for panel, name in zip(axes, "AB"):
        letter(panel, name)
    return figure, [HEADER, *(state.row() for state in found)], list(agreement(states, mesh))
