"""Stick-slip of a droplet on a viscous layer: Mokbel, Aland, Karpitschka, EPL 2022, arXiv:2201.04189.

D. Mokbel, S. Aland, S. Karpitschka, "Stick-slip contact line motion on Kelvin-Voigt model substrates": a line carries its ridge along and
the solid brakes it; where it is faster than the ridge can grow, it comes loose from the ridge, and is caught again; where the liquid
brakes more than the solid, nothing sticks. Their speeds and heights could not be read.

Computed is a droplet of tensotaxis_pull_2d on a layer of relaxation time tau = viscosity/G whose surface has the tension of the liquid.
A force along the wall drags it, from the state at rest. With tau = 10 the liquid brakes as much as the solid, with tau = 100 the solid
alone. Compared are ridges and drag with linear theory for the droplet that moves with the speed found (tests/oracle/moving_ridge.py), the
speed at which the drag is largest, and the force at which the droplet comes loose. A chain of forces shows how it sticks and slips.

Its power-law sibling is a layer whose modulus is G (1 + (i w tau)^GEL), of branches in small strains."""

import softwet
from softwet._drawing.look import np
import matplotlib.pyplot as plt

from softwet._figures.journal import BLUE, GREEN, VERMILION, WIDTH, letter
from softwet._papers._oracle import oracle
from softwet._papers._runs import settings

GEL = 0.55                                # exponent of the modulus G (1 + (i w tau)^GEL) of a power-law gel; 1: Kelvin-Voigt
YOUNG, POISSON = 0.7554, 0.45
SHEAR, TENSION, VAPOUR = YOUNG / (2 * (1 + POISSON)), 0.25320, 0.0013523  # sigma over the capillarity, rho_v, at the temperature 0.39
LENGTH, ROOM, RADIUS = 1.5, 0.375, 0.155
FREE, BRAKED = 100.0, 10.0                # relaxation times
FORCES = {BRAKED: ((0.006, 300), (0.017, 200), (0.028, 120), (0.033, 60), (0.040, 40)),  # and how long each acts
          FREE: ((0.006, 500), (0.012, 500), (0.018, 700), (0.021, 700), (0.024, 150), (0.030, 60))}
GEL_FORCES = ((0.012, 200), (0.02, 120), (0.03, 60))  # with the relaxation time BRAKED
CHAIN = ((0.018, 300), (0.030, 40), (0.018, 40), (0.010, 200), (0.018, 300))
FINE = [288, 72]                          # elements of the chain, whose vapour stays above 0 while the droplet slips
QUICK = {BRAKED: ((0.04, 2), (0.06, 2)), FREE: ((0.04, 2),)}
COLOURS = {BRAKED: BLUE, FREE: VERMILION}
OF_GEL = {"color": GREEN, "markersize": 4}


def layer(delay, exponent=1):
    """Keys of [substrate] for a relaxation time."""
    if exponent == 1:
        return {"viscosity": delay * SHEAR}
    return {"gel.exponent": exponent, "gel.time": delay, "gel.decades": [-2, 2], "strain": "small"}


def scene(capillarity, elements):
    return {"name": "sliding_droplet", "domain": {"size": [LENGTH, ROOM], "elements": elements},
            "fluid": {"viscosity": "1/1024", "capillarity": capillarity, "temperature": 0.39, "contact_angle": 75.0,
                      "wall_law": "energy"},
            "substrate": {"thickness": 0.125, "young": YOUNG, "poisson": POISSON, "surface_tension": TENSION * capillarity},
            "droplet": [{"centre": [0.4, 0.125], "radius": RADIUS}],
            "boundary": {"left": "slip", "right": "slip", "bottom": "slip", "top": "no_slip"},
            "time": {"end": 40.0, "tolerance": 1e-3}, "output": {"fields": {"select": ["displacement"]}}}


def compute(runs):
    g, elements = (1 / 16, [48, 12]) if runs.quick else (1 / 64, [192, 48])
    case = runs.write_case(scene(g, elements))

    def of(delay, exponent=1):
        return {f"substrate.{key}": value for key, value in layer(delay, exponent).items()}

    def slide(before, delay, force, end, out, mesh=elements, exponent=1):
        values = {"domain.elements": mesh, "fluid.gravity": [force, 0.0], "time.end": end, "initial.from": before,
                  "output.fields.times": [f"0:{end}:{min(81, 2 * end + 1)}"],
                  "droplet[0].centre": [softwet.open(before).history["x_centre"][-1], 0.125]}
        return runs.softwet("run", case, *settings(values | of(delay, exponent)), out=out)

    rest = runs.softwet("run", case, *settings({"time.end": 2 if runs.quick else 40, **of(1.0)}), out="rest")
    for delay, forces in (QUICK if runs.quick else FORCES).items():
        for force, end in forces:
            slide(rest, delay, force, end, f"tau_{delay:g}/f_{1000 * force:03.0f}")
    for force, end in GEL_FORCES[:0 if runs.quick else None]:
        slide(rest, BRAKED, force, end, f"gel/f_{1000 * force:03.0f}", exponent=GEL)
    before = rest
    for number, (force, end) in enumerate(CHAIN[:0 if runs.quick else None]):
        before = slide(before, FREE, force, end, f"chain/{number}", FINE)


class Slide:
    """A run: a force."""

    def __init__(self, folder):
        run = softwet.open(folder)
        self.case, self.history, self.interface = run.case, run.history, run.interface
        self.force = self.case["fluid"]["gravity"][0]
        width, height = self.case["domain"]["size"]
        self.capillarity = self.case["fluid"]["capillarity"]
        room = width * (height - self.case["substrate"]["thickness"])
        self.pull = self.force * (self.history["mass"][-1] - VAPOUR * room)  # on what the droplet has more than the vapour
        gel = self.case["substrate"].get("gel", {})
        self.exponent = gel.get("exponent", 0) or 1  # 0: there is no gel
        self.delay = self.case["substrate"]["viscosity"] / SHEAR if self.exponent == 1 else gel["time"]
        late = self.history["t"] >= 0.8 * self.history["t"][-1]
        mean = {name: values[late].mean() for name, values in self.history.items() if name in
                ("ridge_left", "ridge_right", "dissipation", "dissipation_solid", "wall_stretch")}
        self.speed = np.polyfit(self.history["t"][late], self.history["x_centre"][late], 1)[0]
        self.rear, self.front, solid = mean["ridge_left"], mean["ridge_right"], mean["dissipation_solid"]
        self.drag, self.liquid = solid / self.speed, (mean["dissipation"] - solid) / self.speed**2
        self.fed = mean["wall_stretch"] / (self.speed * self.pull)  # power of a wall whose tension does not know f_w, over the power of the force
        self.ahead = self.place_of_ridge()

    def place_of_ridge(self):
        """Of the front ridge from the contact line, positive where it is ahead."""
        wall, line = self.interface[max(self.interface)], self.history["x_right"][-1]
        x = wall["x_reference"] + wall["displacement_x"]
        near = np.abs(x - line) < 4 * self.capillarity
        x, height = x[near], wall["displacement_y"][near]
        top = min(max(height.argmax(), 1), len(x) - 2)
        bend, slope, _ = np.polyfit(x[top - 1:top + 2] - line, height[top - 1:top + 2], 2)
        return -slope / (2 * bend)

    def loose(self, result):
        return self.speed * self.delay > 3 * result.delays[result.turn()]

    def found(self):
        """As the theory has them."""
        return self.rear, self.front, self.drag, self.ahead

    def row(self, chain, theory):
        return [chain, f"{self.delay:g}", f"{self.force:g}", f"{self.speed:.4e}", f"{self.speed * self.delay:.4e}",
                *(f"{value:.4e}" for pair in zip(self.found(), theory(self.speed * self.delay, self.exponent)) for value in pair),
                f"{self.liquid:.4f}"]


HEADER = ("chain", "tau", "force", "speed", "speed_tau", "ridge_rear", "ridge_rear_linear", "ridge_front", "ridge_front_linear",
          "drag", "drag_linear", "front_ridge_ahead", "front_ridge_ahead_linear", "liquid_drag_over_speed")


def theory_at(capillarity):
    """Function of V tau and the exponent: ridges at the rear and at the front, drag, and place of the front ridge, in
    linear theory."""
    moving = oracle("moving_ridge")

    def theory(delay, exponent=1):
        x, height, drag = moving.droplet(delay, capillarity, LENGTH, RADIUS, exponent=exponent)
        ahead = x > 0
        return height[x < 0].max(), height[ahead].max(), drag, x[ahead][height[ahead].argmax()] - RADIUS * np.sin(moving.ANGLE)

    return theory


class Result:
    def __init__(self, folder):
        chains = [path for path in sorted(folder.glob("tau_*")) if path.is_dir()]
        self.slides = [Slide(one) for chain in chains for one in sorted(chain.iterdir()) if one.is_dir()]
        self.chain = [Slide(one) for one in sorted((folder / "chain").glob("*")) if one.is_dir()]
        self.gel = [Slide(one) for one in sorted((folder / "gel").glob("f_*")) if one.is_dir()]
        self.theory = theory_at(self.slides[0].capillarity)
        self.delays = np.geomspace(1e-3, 3, 71)
        self.curves = np.array([self.theory(delay) for delay in self.delays]).T
        self.curves_of_gel = np.array([self.theory(delay, GEL) for delay in self.delays]).T
        self.liquid = np.median([slide.liquid for slide in self.slides if slide.delay == BRAKED])

    def of(self, delay):
        return sorted((slide for slide in self.slides if slide.delay == delay), key=lambda slide: slide.force)

    def turn(self):
        """Number of the delay beyond which the droplet needs less force with FREE: there it comes loose."""
        return (np.diff(self.foreseen(FREE)[0]) < 0).argmax()

    def steady(self):
        return [slide for delay in FORCES for slide in self.of(delay) if delay != FREE or not slide.loose(self)]

    def foreseen(self, delay):
        """Force per unit mass against speed: the drag of linear theory, and the friction of the liquid as it was found
        with BRAKED."""
        speeds = self.delays / delay
        mass = self.slides[-1].pull / self.slides[-1].force
        return (self.curves[2] + self.liquid * speeds) / mass, speeds


# --- agreement -----------------------------------------------------------------------------------------------------
LINES = ((0, 5.621e-3, -.0010, 0), (.003, 5.601e-3, -.0024, 4.98e-5), (.01, 5.412e-3, -.0059, 1.404e-4), (.03, 4.551e-3, -.0117, 2.105e-4),
         (.1, 2.708e-3, -.0176, 1.523e-4))  # V tau, ridge, its place, drag of one line: an independent computation
PARTS = {"rear ridge": 0.1, "front ridge": 0.1, "drag": 0.2}  # what may differ: slopes of the wall are finite


def judged(found, asked):
    """Of ridges, drag, place."""
    off = [f"{name} {100 * (own / other - 1):+.0f} %" for (name, part), own, other in zip(PARTS.items(), found, asked)
           if abs(own / other - 1) > part]
    off += [f"place {found[3] - asked[3]:+.4f}"] * (abs(found[3] - asked[3]) > 0.002)
    return "does not: " + ", ".join(off) + ", see the text" if off else "agrees"


def told(values):
    return "{:.3e}, {:.3e}, {:.3e}, {:+.4f}".format(*values)


def agreement(result):
    one = oracle("moving_ridge").line
    worst = max(abs(own / asked - 1) for delay, ridge, _, drag in LINES for own, asked in zip(one(delay)[::2], (ridge, drag)) if asked)
    place = max(abs(one(delay)[1] - at) for delay, _, at, _ in LINES)
    yield ("linear theory itself: ridge, place and drag of one line, five speeds", "an independent computation",
           f"the oracle differs by {100 * worst:.1f} %, place by {place:.4f}", "agrees" if worst < 2e-3 and place < 5e-4 else "does not")
    for slide in result.steady():
        asked = result.theory(slide.speed * slide.delay)
        yield (f"rear and front ridge, drag, place of the front ridge; tau = {slide.delay:g}, V tau = {slide.speed * slide.delay:.4f}",
               told(asked), told(slide.found()), judged(slide.found(), asked))
    yield from largest_drag(result)
    yield from loose(result)
    for slide in result.gel:
        asked = result.theory(slide.speed * slide.delay, GEL)
        yield (f"a power-law gel, exponent {GEL:g}: rear and front ridge, drag, place of the front ridge; V tau = {slide.speed * slide.delay:.4f}",
               told(asked), told(slide.found()), judged(slide.found(), asked))


def largest_drag(result):
    """By a parabola through the three runs around the largest."""
    slides = sorted(result.steady(), key=lambda slide: slide.speed * slide.delay)
    top = max(range(len(slides)), key=lambda number: slides[number].drag)
    if not 0 < top < len(slides) - 1:
        return
    near = slides[top - 1:top + 2]
    bend, slope, _ = np.polyfit([np.log(slide.speed * slide.delay) for slide in near], [slide.drag for slide in near], 2)
    found, asked = np.exp(-slope / (2 * bend)), result.delays[result.curves[2].argmax()]
    yield ("V tau at which the drag is largest", f"about 2 g = {2 * near[0].capillarity:.3f}; {asked:.3f} for the droplet", f"{found:.3f}",
           "agrees" if abs(found / asked - 1) < 0.2 else f"does not: {100 * (found / asked - 1):+.0f} %")


def loose(result):
    """The forces between which the droplet comes loose with FREE, and two speeds at one force."""
    force, _ = result.foreseen(FREE)
    top = result.turn()
    slow = [slide.force for slide in result.of(FREE) if not slide.loose(result)]
    fast = [slide.force for slide in result.of(FREE) if slide.loose(result)]
    if slow and fast:
        yield (f"force at which the droplet comes loose, tau = {FREE:g}", f"{force[top]:.4f}, linear theory and the liquid's friction",
               f"between {max(slow):.3f} and {min(fast):.3f}", "agrees" if max(slow) < force[top] < min(fast) else "does not: see the text")
    if len(result.chain) > 2:
        stuck, slips = result.chain[0], result.chain[2]
        both = np.array([slide.speed * FREE for slide in (stuck, slips)])
        below, above = np.arange(len(force)) < top, np.arange(len(force)) > top + force[top:].argmin()
        asked = [np.interp(stuck.force, force[part], result.delays[part]) for part in (below, above)]
        yield (f"two V tau at the force {stuck.force:g}: stuck, and after it came loose", "{:.4f}, {:.2f}".format(*asked),
               "{:.4f}, {:.2f}".format(*both), "agrees" if (abs(both / asked - 1) < 0.25).all() else
               f"does not: {100 * (both / asked - 1)[0]:+.0f} % when stuck; the stretch of the wall feeds {100 * stuck.fed:.0f} % more power")


# --- picture -------------------------------------------------------------------------------------------------------
def draw_speed(axes, result):
    for delay, colour in COLOURS.items():
        axes.semilogy([slide.force for slide in result.of(delay)], [slide.speed for slide in result.of(delay)], "o", color=colour,
                      markersize=4, label=rf"$\tau$ = {delay:g}")
        axes.semilogy(*result.foreseen(delay), "--", color=colour, linewidth=0.8)
    axes.semilogy([slide.force for slide in result.gel], [slide.speed for slide in result.gel], "s", label="gel", **OF_GEL)
    axes.semilogy([slide.force for slide in result.chain], [slide.speed for slide in result.chain], "x", color="black", markersize=4,
                  label="chain")
    axes.set(xlabel=r"force $/\; ab\,L_0^{-1}$", ylabel=r"speed $V \;/\; (ab)^{1/2}$", xlim=(0, 0.045), ylim=(2e-5, 3e-2))
    axes.legend(loc="lower right")


def draw_ridges(axes, result):
    for number, name, dashes in ((0, "rear", "--"), (1, "front", "-")):
        axes.semilogx(result.delays, 1e3 * result.curves[number], dashes, color="0.4", linewidth=0.8)
        for delay, colour in COLOURS.items():
            axes.semilogx([slide.speed * delay for slide in result.of(delay)],
                          [1e3 * slide.found()[number] for slide in result.of(delay)], "vo"[number], color=colour, markersize=4,
                          label=name if delay == BRAKED else None)
        axes.semilogx(result.delays, 1e3 * result.curves_of_gel[number], dashes, color=GREEN, linewidth=0.8)
        axes.semilogx([slide.speed * BRAKED for slide in result.gel], [1e3 * slide.found()[number] for slide in result.gel], "vo"[number],
                      **OF_GEL)
    axes.set(xlabel=r"$V\tau \;/\; L_0$", ylabel=r"ridge $/\; 10^{-3} L_0$", ylim=(0, None))
    axes.legend(loc="lower left")


def draw_drag(axes, result):
    axes.semilogx(result.delays, 1e4 * result.curves[2], color="0.4", linewidth=0.8)
    for delay, colour in COLOURS.items():
        axes.semilogx([slide.speed * delay for slide in result.of(delay)], [1e4 * slide.drag for slide in result.of(delay)], "o",
                      color=colour, markersize=4)
    axes.semilogx(result.delays, 1e4 * result.curves_of_gel[2], color=GREEN, linewidth=0.8)
    axes.semilogx([slide.speed * BRAKED for slide in result.gel], [1e4 * slide.drag for slide in result.gel], "s", **OF_GEL)
    axes.axvline(2 * result.slides[0].capillarity, color="0.6", linewidth=0.6, zorder=0)
    axes.set(xlabel=r"$V\tau \;/\; L_0$", ylabel=r"drag of the solid $/\; 10^{-4} ab^2 L_0$", ylim=(0, None))


def draw_ages(axes, chain):
    """Height of the wall along x (upwards) and time."""
    begin, places = 0.0, np.linspace(0, LENGTH, 601)
    largest = max(np.abs(wall["displacement_y"]).max() for slide in chain for wall in slide.interface.values())
    for slide in chain:
        times = sorted(slide.interface)
        heights = np.array([np.interp(places, slide.interface[t]["x_reference"] + slide.interface[t]["displacement_x"],
                                      slide.interface[t]["displacement_y"]) for t in times])
        image = axes.pcolormesh(begin + np.array(times), places, 1e3 * heights.T, cmap="RdBu_r", vmin=-1e3 * largest, vmax=1e3 * largest,
                                shading="gouraud", rasterized=True)
        for side in ("x_left", "x_right"):
            axes.plot(begin + slide.history["t"], slide.history[side], color="black", linewidth=0.8)
        axes.text(begin + 0.5 * times[-1], 0.03, f"{slide.force:g}", ha="center", fontsize=6)
        begin += times[-1]
        axes.axvline(begin, color="0.4", linewidth=0.5)
    axes.set(xlabel=r"time $t \;/\; L_0\,(ab)^{-1/2}$", ylabel=r"$x \;/\; L_0$", xlim=(0, begin), ylim=(0, LENGTH))
    axes.figure.colorbar(image, ax=axes, label=r"height of the wall $/\; 10^{-3} L_0$", aspect=12, pad=0.01)


def draw(folder):
    result = Result(folder)
    figure, panels = plt.subplot_mosaic([["A", "B", "C"], ["D", "D", "D"]], figsize=(WIDTH, 4.8), layout="constrained")
    draw_speed(panels["A"], result)
    draw_ridges(panels["B"], result)
    draw_drag(panels["C"], result)
    if result.chain:
        draw_ages(panels["D"], result.chain)
    for name, axes in panels.items():
        letter(axes, name)
    rows = [slide.row("from rest", result.theory) for slide in result.slides] + [slide.row("chain", result.theory) for slide in result.chain]
    rows += [slide.row("gel", result.theory) for slide in result.gel]
    return figure, [HEADER, *rows], list(agreement(result))
