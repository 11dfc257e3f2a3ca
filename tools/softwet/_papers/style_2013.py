"""Ridge of a droplet on a soft gel: Style et al., Phys. Rev. Lett. 110, 066103 (2013), in (r, z).

R. W. Style, R. Boltyanskiy, Y. Che, J. S. Wettlaufer, L. A. Wilen, E. R. Dufresne, "Universal deformation of soft substrates near a
contact line and the direct measurement of solid surface stresses". Glycerol on a silicone gel of 3 kPa, in the numbers of van
Brummelen's group, as in cases/style_2013_axisymmetric.toml.

Computed are the states of rest of droplets of five radii, on a surface with a tension alone and on one with the surface moduli of
silicone too, and of the droplet of the case with interfaces twice and half as wide. They are compared with linear elasticity at the same
width of the interface (tests/oracle/axial_ridge.py), with the opening of Neumann's triangle, and with Young's angle. The measured
profiles could not be read."""

import math

import softwet
from softwet._drawing.look import Problem, np
import matplotlib.pyplot as plt

from softwet._figures.journal import BLUE, GREEN, ORANGE, VERMILION, WIDTH, letter
from softwet._papers._oracle import oracle
from softwet._papers._runs import done, settings

LENGTH = 500.0                        # micrometres of a length of 1
LIQUID, WET, DRY = 46.0, 36.0, 31.0   # mN/m
GEL, TENSION = 0.08257, 1.7064e-3     # Young's modulus and dry tension of the case, at its capillarity of 1/100
MODULI = (43.0, 20.0)                 # lambda_s and G_s of silicone, mN/m (Xu, Style, Dufresne, Soft Matter 2018)
PAPER = 178.4                         # radius of the case, micrometres
RADII = (44.6, 89.2, 133.8, PAPER, 223.0)
COLOURS = ("0.6", ORANGE, GREEN, BLUE, VERMILION)
YOUNG = math.degrees(math.acos((DRY - WET) / LIQUID))
NEUMANN = math.degrees(math.acos((LIQUID**2 - WET**2 - DRY**2) / (2 * WET * DRY)))


def scene(radius, width, moduli):
    """Settings of the case for a radius and a half width of the interface in micrometres."""
    g = width / LENGTH
    scale = g * 100  # stresses and tensions are in units of the liquid's
    cosine = (DRY - WET) / LIQUID
    margin = 0.04 * scale
    values = {"domain.elements": [round(2 / g)] * 2, "fluid.capillarity": g, "substrate.young": GEL * scale,
              "substrate.surface_tension": TENSION * scale, "droplet[0].radius": radius / LENGTH,
              "domain.grading.box": [[0.0, max(0.0, 0.1 - margin)],
                                     [radius / LENGTH + margin, 0.1 + radius / LENGTH * (1 - cosine) + margin]]}
    if moduli:
        values["substrate.surface_modulus"] = [TENSION * scale * value / DRY for value in MODULI]
    return values


def states(quick):
    """(name, radius, half width, with surface moduli) of each run, the longest at the end."""
    if quick:
        return [(f"R{radius:g}_g20{'_moduli' * moduli}", radius, 20.0, moduli) for radius in (PAPER,) for moduli in (0, 1)]
    def same(moduli):
        return [(f"R{radius:g}_g5{'_moduli' * moduli}", radius, 5.0, moduli) for radius in RADII]

    coarse, fine = ((f"R{PAPER:g}_g{width:g}", PAPER, width, 0) for width in (10.0, 2.5))
    return [*same(0), coarse, *same(1), fine]


def compute(runs):
    for name, radius, width, moduli in states(runs.quick):
        runs.softwet("steady", runs.case("style_2013_axisymmetric"), *settings(scene(radius, width, moduli)), out=name)


class Wall:
    """A state of rest and linear theory beside it, in micrometres and degrees."""

    def __init__(self, folder):
        run = softwet.open(folder)
        case, wall = run.case, run.interface[run.times[-1]]
        self.radius, self.width = case["droplet"][0]["radius"] * LENGTH, case["fluid"]["capillarity"] * LENGTH
        self.moduli = any(case["substrate"]["surface_modulus"])
        self.contact, self.angle = run.history["x_right"][-1] * LENGTH, run.history["angle_right"][-1]
        self.place, self.height = (wall["x_reference"] + wall["displacement_x"]) * LENGTH, wall["displacement_y"] * LENGTH
        self.ridge, self.middle, self.lowest = self.height.max(), self.height[0], self.height.min()
        self.outside = self.height[self.place > self.contact + 15].min()
        self.opening = opening(np.diff(self.height) / np.diff(self.place))
        self.turn = math.degrees(math.atan(np.interp(self.contact, self.place, np.gradient(self.height, self.place))))
        at, foot, height, slope = oracle("axial_ridge").wall(
            self.width, case["substrate"]["poisson"], radius=self.radius, modulus=self.moduli * (MODULI[0] + 2 * MODULI[1]))
        self.linear = {"ridge": height.max(), "middle": height[0], "lowest": height.min(), "outside": height[at > foot + 15].min(),
                       "opening": opening(slope), "turn": math.degrees(math.atan(np.interp(foot, at, slope)))}

    def row(self):
        values = [getattr(self, name) for name in ("ridge", "middle", "lowest", "outside", "opening", "turn")]
        pairs = [f"{value:.3f}" for pair in zip(values, self.linear.values()) for value in pair]
        return [f"{self.radius:g}", f"{self.width:g}", "yes" if self.moduli else "no", f"{self.contact:.2f}", f"{self.angle:.2f}", *pairs]


HEADER = ("radius", "half_width", "surface_moduli", "contact_radius", "apparent_angle",
          *(name + kind for name in ("ridge", "middle", "lowest", "outside", "opening", "turn") for kind in ("", "_linear")))


def opening(slopes):
    return 180 - math.degrees(math.atan(slopes.max()) - math.atan(slopes.min()))


def limit(values):
    """Of a sequence at halved widths, if its changes shrink by a constant factor."""
    first, second = values[1] - values[0], values[2] - values[1]
    return values[2] + second**2 / (first - second)


# --- agreement -----------------------------------------------------------------------------------------------------
def judged(good, why):
    return "agrees" if good else f"does not: {why}"


def agreement(walls):
    plain = [wall for wall in walls if not wall.moduli and wall.width == walls[0].width]
    yield from ridges(plain)
    yield from ridges_with_moduli([(wall, other) for wall in plain for other in walls if other.moduli and other.radius == wall.radius])
    yield from angles(plain)
    yield from sharp_opening(sorted((wall for wall in walls if wall.radius == PAPER and not wall.moduli), key=lambda wall: -wall.width))


def ridges(walls):
    for wall in walls:
        more = wall.ridge / wall.linear["ridge"] - 1
        foot = wall.radius * math.sin(math.radians(YOUNG))
        yield (f"ridge, R = {wall.radius:g} µm", f"{wall.linear['ridge']:.2f} µm, linear; 10 to 20 % more for finite slopes",
               f"{wall.ridge:.2f} µm, {more:+.0%}",
               judged(0.1 <= more <= 0.2, f"the droplet sinks in, its contact radius is {wall.contact:.1f} and not {foot:.1f} µm"))


def ridges_with_moduli(pairs):
    for wall, other in pairs:
        linear, found = (one / two - 1 for one, two in ((other.linear["ridge"], wall.linear["ridge"]), (other.ridge, wall.ridge)))
        yield (f"ridge with surface moduli, R = {wall.radius:g} µm", f"{100 * linear:+.1f} %, linear", f"{100 * found:+.1f} %",
               judged(abs(found - linear) < 0.01, "the strain of the surface changes its tension, which linear theory leaves out"))


def angles(walls):
    openings = [wall.opening for wall in walls]
    names = f"radii: {len(walls)}"
    yield (f"opening of the gel, {names}", "the same: universal, the paper", f"{min(openings):.1f} to {max(openings):.1f} degrees",
           judged(max(openings) - min(openings) < 2, "it depends on the radius"))
    turns = [(wall.linear["turn"], wall.turn) for wall in walls]
    yield (f"turn of the wall at the contact line, {names}", f"{listed(linear for linear, _ in turns)} degrees, linear",
           f"{listed(found for _, found in turns)} degrees",
           judged(all(abs(found - linear) < 1 for linear, found in turns), "slopes are not small"))
    apart = [wall.angle - (YOUNG - wall.turn) for wall in walls]
    yield (f"apparent angle, {names}", f"{listed(YOUNG - wall.turn for wall in walls)} degrees, Young's {YOUNG:.2f} less that turn",
           f"{listed(wall.angle for wall in walls)} degrees",
           judged(max(map(abs, apart)) < 1, "the circle from 2 g above the wall upwards meets the wall "
                                            f"{min(apart):.1f} to {max(apart):.1f} degrees steeper than Young's law there"))


def listed(values):
    return ", ".join(f"{value:.1f}" for value in values)


def sharp_opening(walls):
    """Neumann's law holds for a sharp interface. Openings at three widths are extrapolated to it; what the same
    extrapolation makes of linear theory, whose limit is known, shows its error."""
    exact = 2 * math.degrees(math.atan((WET + DRY) / LIQUID / math.sin(math.radians(YOUNG))))
    for wall in walls:
        why = f"the width of the interface; linear theory has {wall.linear['opening']:.1f} degrees with it and {exact:.1f} without"
        yield (f"opening, R = {wall.radius:g} µm, g = {wall.width:g} µm", f"{NEUMANN:.2f} degrees, Neumann, sharp",
               f"{wall.opening:.1f} degrees", judged(abs(wall.opening - NEUMANN) < 2, why))
    if len(walls) == 3:
        found, linear = limit([wall.opening for wall in walls]), limit([wall.linear["opening"] for wall in walls])
        yield ("opening, extrapolated to a sharp interface", f"{NEUMANN:.2f} degrees, Neumann", f"{found:.1f} degrees",
               judged(abs(found - NEUMANN) < abs(linear - exact) + 1,
                      f"extrapolated from too wide interfaces; linear theory has {linear:.1f} degrees in this way"))


# --- picture -------------------------------------------------------------------------------------------------------
def draw_walls(whole, near, walls):
    for wall in walls:
        colour, dashes = COLOURS[RADII.index(wall.radius)], (0, (2, 1)) if wall.moduli else "-"
        if not wall.moduli:
            whole.plot(wall.place, wall.height, color=colour, label=f"R = {wall.radius:g} µm")
        near.plot(wall.place - wall.contact, wall.height - wall.ridge, color=colour, linestyle=dashes)
    whole.set(xlabel="distance from the axis / µm", ylabel="height of the wall / µm", xlim=(0, 350))
    whole.legend()
    near.set(xlabel="distance from the contact line / µm", ylabel="height over the ridge / µm", xlim=(-25, 25), ylim=(-14, 2),
             title="dashed: with surface moduli", aspect="equal")


def draw_ridges(axes, walls):
    for moduli, colour, name in ((False, BLUE, "tension"), (True, VERMILION, "and moduli")):
        chosen = [wall for wall in walls if wall.moduli == moduli]
        radii = [wall.radius for wall in chosen]
        axes.plot(radii, [wall.ridge for wall in chosen], "o", markersize=4, color=colour, label=f"softwet, {name}")
        axes.plot(radii, [wall.linear["ridge"] for wall in chosen], "--", color=colour, label=f"linear, {name}")
    axes.set(xlabel="radius of the droplet / µm", ylabel="ridge / µm", ylim=(0, None))
    axes.legend()


def draw_widths(axes, walls):
    for wall, colour in zip(walls, (GREEN, BLUE, VERMILION)):
        axes.plot(wall.place - wall.contact, wall.height, color=colour, label=f"g = {wall.width:g} µm")
    axes.set(xlabel="distance from the contact line / µm", ylabel="height of the wall / µm", xlim=(-25, 25), ylim=(-6, 11),
             title=f"R = {PAPER:g} µm", aspect="equal")
    axes.legend()


def draw(folder):
    quick = not (folder / f"R{PAPER:g}_g5").is_dir()
    walls = [Wall(folder / name) for name, *_ in states(quick) if done(folder / name, "steady")]  # what is computed so far
    if not walls:
        raise Problem(f"{folder} has no state of rest; leave --redraw out, so that they are computed")
    same = [wall for wall in walls if wall.width == walls[0].width]
    figure, axes = plt.subplots(2, 2, figsize=(WIDTH, 4.6), layout="constrained")
    draw_walls(axes[0, 0], axes[0, 1], same)
    draw_ridges(axes[1, 0], same)
    draw_widths(axes[1, 1], sorted((wall for wall in walls if wall.radius == PAPER and not wall.moduli), key=lambda wall: -wall.width))
    for number, panel in enumerate(axes.flat):
        letter(panel, "ABCD"[number])
    return figure, [HEADER, *(wall.row() for wall in walls)], list(agreement(walls))
