"""Hysteresis loop of a droplet on a tilted plate: it is pinned, comes loose, slides, and stops.

C. G. L. Furmidge, J. Colloid Sci. 17, 309 (1962): a droplet holds a force along the wall up to its surface tension times the difference
of the cosines of the receding and the advancing contact angle. Computed is cases/sticking_droplet_2d on a rigid wall: the force rises in
steps beyond what the droplet holds, falls through zero to the same with the other sign, and comes back. Each step is a run of its own
that begins where the one before has ended. The parameters are the range of contact angles and the line friction.

Compared are the force at which the droplet comes loose and the one at which it stops, the creep below them (`fluid.creep_speed`), the
force that line friction takes at a speed, and the apparent angles; all with the formulas of docs/theory.md. The measured values of the
paper belong to 3D droplets on real surfaces."""

import softwet
from softwet._drawing.look import np
import matplotlib.pyplot as plt

from softwet._figures.journal import BLUE, GREEN, VERMILION, WIDTH, letter
from softwet._papers._oracle import oracle
from softwet._papers._runs import settings

TENSION, STEP = 0.25320, 0.86536      # sigma over the capillarity, and rho_l - rho_v, at the temperature 0.39
AREA, CREEP = 0.02, 2e-5              # of the droplet of the case; sqrt(ab)
LOOP = (0, 0.25, 0.5, 0.75, 0.9, 1.1, 1.2, 1.3, 1.2, 1.1, 0.9, 0.75, 0.5, 0.25)
SLIDES = (0.5, 1.1, 1.2, 1.3)
# Range of angles, line friction, forces over the one that the droplet holds.
CHAINS = {"65_85": ([65, 85], 0.02, (*LOOP, *(-share for share in LOOP), 0)),
          "70_80": ([70, 80], 0.02, SLIDES),
          "65_85_rough": ([65, 85], 0.1, SLIDES)}
COLOURS = {"65_85": BLUE, "70_80": GREEN, "65_85_rough": VERMILION}
LAST = 0.4                            # part of a run in which its speed is read


def held(angles, capillarity):
    """Force per unit mass that a droplet of the area holds."""
    receding, advancing = np.cos(np.radians(angles))
    return TENSION * capillarity * (receding - advancing) / (STEP * AREA)


def compute(runs):
    capillarity = 1 / 32 if runs.quick else 1 / 64
    common = {"domain.size": [1.0, 0.25], "domain.elements": [96, 24] if runs.quick else [192, 48], "fluid.capillarity": capillarity,
              "fluid.creep_speed": CREEP, "time.end": 2 if runs.quick else 40, "time.tolerance": 1e-3}
    for name, (angles, friction, shares) in CHAINS.items():
        before = None
        for number, share in enumerate((0, 1.3) if runs.quick else shares):
            values = {**common, "fluid.contact_angle_range": angles, "fluid.line_friction": friction,
                      "fluid.gravity": [share * held(angles, capillarity), 0.0]}
            if before:
                values |= {"initial.from": before, "droplet[0].centre": [softwet.open(before).history["x_centre"][-1], 0.0]}
            before = runs.softwet("run", runs.case("sticking_droplet_2d"), *settings(values), out=f"{name}/{number:02d}")


class Step:
    """A run of a chain: one force."""

    def __init__(self, folder):
        run = softwet.open(folder)
        fluid, self.history = run.case["fluid"], run.history
        self.angles, self.friction = fluid["contact_angle_range"], fluid["line_friction"]
        self.share = fluid["gravity"][0] / held(self.angles, fluid["capillarity"])
        self.tension = TENSION * fluid["capillarity"]
        t, x = self.history["t"], self.history["x_centre"]
        late = t >= (1 - LAST) * t[-1]
        self.place, self.speed = x[-1], np.polyfit(t[late], x[late], 1)[0]
        self.rear, self.front = self.history["angle_left"][-1], self.history["angle_right"][-1]
        self.rise = np.diff(self.history["energy_total"]).max() / abs(np.ptp(self.history["energy_total"]) or 1)

    def row(self, name, begin):
        return [name, f"{self.share:.2f}", f"{self.place - begin:.6f}", f"{self.speed:.4e}", f"{self.rear:.2f}", f"{self.front:.2f}"]


HEADER = ("chain", "force_over_held", "displacement", "speed", "angle_left", "angle_right")


def sine(angles):
    """Of the static angle, whose cosine is the mean."""
    return np.sqrt(1 - np.cos(np.radians(angles)).mean() ** 2)


def creep(angles):
    """Speeds of a droplet that sticks, and the parts of the force it holds that give them: the law h of docs/theory.md,
    integrated over the profile of the interface at rest."""
    plane = oracle("plane_interface").PlaneInterface(0.39)

    def slope(rho):
        return np.sqrt(2 * plane.excess(rho))

    def part(speed):
        def pull(rho):
            rate = speed * sine(angles) * slope(rho) / mean
            return slope(rho) * rate / np.sqrt(1 + rate**2)
        return plane.integral(pull, 0, 1) / whole

    whole = plane.integral(slope, 0, 1)
    mean = plane.integral(lambda rho: slope(rho) ** 2, 0, 1) / whole
    speeds = np.geomspace(1e-2, 30, 120)
    return CREEP * speeds, np.array([part(speed) for speed in speeds])


def line(steps):
    """Force above the pinning force as a function of speed, for steps that slide: (force without speed, slope)."""
    slope, force = np.polyfit([step.speed for step in steps], [step.share for step in steps], 1)
    return force, slope


def sliding(steps, sign, rising):
    """The steps that slide to one side while the force rises or falls."""
    top = next((number for number, step in enumerate(steps) if step.share * sign == max(other.share * sign for other in steps)), 0)
    chosen = steps[:top + 1] if rising else steps[top:]
    return [step for step in chosen if step.share * sign > 1.05]


# --- agreement -----------------------------------------------------------------------------------------------------
def within(found, asked, part):
    return "agrees" if abs(found - asked) <= part * abs(asked) else f"does not: off by {100 * (found / asked - 1):+.1f} %"


def forces(chains):
    for name, sign, rising, what in (("65_85", 1, True, "comes loose, 65 to 85 degrees"), ("65_85", 1, False, "stops, 65 to 85"),
                                     ("65_85", -1, True, "comes loose to the other side"), ("65_85", -1, False, "stops there"),
                                     ("70_80", 1, True, "comes loose, 70 to 80 degrees")):
        steps = sliding(chains[name], sign, rising)
        if len(steps) < 2:
            continue
        share, asked = abs(line(steps)[0]), held(steps[0].angles, 1 / 64)
        yield (f"force at which it {what}", f"{asked:.6f}", f"{share * asked:.6f}", within(share, 1, 0.03))


def agreement(chains):
    yield from forces(chains)
    speeds, parts = creep(chains["65_85"][0].angles)
    for step in chains["65_85"][1:5]:
        if step.share < 0.95:
            asked = np.interp(step.share, parts, speeds)
            yield (f"speed of creep at {step.share:.2f} of that force", f"{asked:.2e}", f"{step.speed:.2e}", within(step.speed, asked, 0.1))
    smooth, rough = sliding(chains["65_85"], 1, True), sliding(chains["65_85_rough"], 1, True)
    if len(smooth) > 1 and len(rough) > 1:
        kappa = -np.diff(np.cos(np.radians(smooth[0].angles)))[0] / 2
        added = kappa * (line(rough)[1] - line(smooth)[1])  # of sigma, each of two lines
        asked = (rough[0].friction - smooth[0].friction) / smooth[0].tension
        yield ("slope of cos(dynamic angle) against speed, by which line friction 0.1 is above 0.02", f"{asked:.2f}, mu_f / sigma",
               f"{added:.2f}", within(added, asked, 0.1))
    rise = max(step.rise for steps in chains.values() for step in steps)
    yield ("energy in all time steps", "falls", f"largest rise {max(rise, 0):.0e} of its change in the run",
           "agrees" if rise < 1e-6 else "does not: see the text")


# --- picture -------------------------------------------------------------------------------------------------------
def draw_displacement(axes, steps):
    shares, places = [step.share for step in steps], np.array([step.place for step in steps]) - steps[0].place
    axes.step(shares, places, where="post", color=BLUE, linewidth=0.8)
    axes.plot(shares, places, "o", color=BLUE, markersize=2.5)
    for share in (-1, 1):
        axes.axvline(share, color="0.6", linewidth=0.6, zorder=0)
    axes.set(xlabel=r"force $/\; f_c$", ylabel=r"displacement $/\; L_0$")


def draw_speed(axes, chains):
    for name, steps in chains.items():
        low, high = steps[0].angles
        axes.plot([step.share for step in steps], [1e3 * step.speed for step in steps], "o", markersize=3, color=COLOURS[name],
                  label=rf"{low:g} to {high:g}°, $\mu_f$ = {steps[0].friction:g}")
        for sign in (1, -1):
            slides = [step for step in steps if step.share * sign > 1.05]
            if len(slides) > 1:
                force, slope = line(slides)
                speeds = np.array([0, sign * max(abs(step.speed) for step in slides)])
                axes.plot(force + slope * speeds, 1e3 * speeds, "-", linewidth=0.7, color=COLOURS[name])
    axes.set(xlabel=r"force $/\; f_c$", ylabel=r"speed $/\; 10^{-3}\,(ab)^{1/2}$")
    axes.legend(loc="upper left")


def draw_angles(axes, steps):
    angles = steps[0].angles
    cosines = np.cos(np.radians(angles))
    share = np.linspace(-1, 1, 101)
    for sign, colour, name, side in ((1, BLUE, "rear", "left"), (-1, VERMILION, "front", "right")):
        exact = np.degrees(np.arccos(cosines.mean() + sign * share * (cosines[0] - cosines[1]) / 2))
        axes.plot(share, exact, "--", color=colour, linewidth=0.8)
        axes.plot([step.share for step in steps], [getattr(step, name) for step in steps], "o", markersize=3, color=colour,
                  label=side)
    for angle in angles:
        axes.axhline(angle, color="0.6", linewidth=0.6, zorder=0)
    axes.set(xlabel=r"force $/\; f_c$", ylabel="apparent angle / degrees", title="dashed: at the wall, formula")
    axes.legend(loc="lower center")


def draw_creep(axes, steps):
    speeds, parts = creep(steps[0].angles)
    axes.semilogy(parts, speeds, "--", color="0.4", linewidth=0.8, label="creep, formula")
    axes.semilogy([abs(step.share) for step in steps if step.share], [abs(step.speed) for step in steps if step.share], "o",
                  markersize=3, color=BLUE, label="softwet, all steps")
    axes.axvline(1, color="0.6", linewidth=0.6, zorder=0)
    axes.set(xlabel=r"|force| $/\; f_c$", ylabel=r"|speed| $/\; (ab)^{1/2}$")
    axes.legend(loc="upper left")


def draw(folder):
    chains = {name: [Step(one) for one in sorted((folder / name).iterdir()) if one.is_dir()] for name in CHAINS}
    figure, axes = plt.subplots(2, 2, figsize=(WIDTH, 4.8), layout="constrained")
    draw_displacement(axes[0, 0], chains["65_85"])
    draw_speed(axes[0, 1], chains)
    draw_angles(axes[1, 0], chains["65_85"])
    draw_creep(axes[1, 1], chains["65_85"])
    for number, panel in enumerate(axes.flat):
        letter(panel, "ABCD"[number])
    rows = [step.row(name, steps[0].place) for name, steps in chains.items() for step in steps]
    return figure, [HEADER, *rows], list(agreement(chains))
