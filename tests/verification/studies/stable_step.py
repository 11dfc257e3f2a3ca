"""The bound on the steps of explicit schemes, against the largest stable steps, and in scenes that move.

Explicit schemes take `time.safety` (0.9) of a bound that is computed from the state before every step; `softwet check` prints it for
the first state. Here the largest stable step is found by bisection, to 5 %, from whole runs of 300 steps of one size (`time.safety`
is 10 in them, and `time.dt_max` a chosen part of the bound). The bound is the smallest one of a run of 600 steps half as long, and no
run goes on beyond its end: droplets in such small boxes dissolve, which changes the bound.

States: a droplet in the middle of a box, on a rigid wall, in a corner between slip sides, on the soft layer, and on a wall in three
dimensions, on its axis of symmetry in the coordinates (r, z) on both walls; two elements to a capillarity. A quarter of a droplet whose viscosity is so small that the stabilisation limits the steps, and
a beam alone, whose free sides meet, with two elements across. Steps are stable where none is refused and the kinetic energy stays below 10 times the
largest one of the run of half the bound: unstable waves grow by more than that in 300 steps.

Asked: steps of the bound are stable everywhere, and the largest stable step is at most 2.5 of it. The bound adds what limits a step, each at its
worst wave. Where several count, no wave has them all, and the bound belongs to the worst moment of a run in which it changes.

Motion: droplets that meet a side, a wall or a corner late, at temperatures from 0.39 to 0.95, with the default `time.safety`. Liquid at a
side shortens the stable steps several times, so that a bound from before is too long. The wall law has an energy.

Asked: the energy falls in every step, no step is refused, no event reports that the energy rose, and the momentum along x of
scenes that are symmetric about x = 0.5 stays round-off."""

import math

import numpy
from _case import case, sides

MINUTES = {"quick": 0.8, "full": 15}
EXPLICIT = "is about the explicit schemes"
SCHEMES, MASSES, TEMPERATURES = ("kick_drift", "rkl2", "ssp_rk3"), ("corrected", "lumped"), (0.85, 0.7, 0.39)
STEPS, BEFORE, CLOSE, WIDEST, GROWTH, SLACK = 300, 50, 1.05, 4, 10, 2.5
FOREVER = ["time.end=1000", "time.tolerance=1e30", "output.fields.times=[]", "output.history.every=1", "domain.quadrature=reduced"]


def still(name, dimension, centre):
    """A droplet in a box of 16 elements along each axis, or in three dimensions 8."""
    n = 16 if dimension == 2 else 8
    return case("A droplet that comes to rest.", name,
                domain=dict(size=[0.5] * dimension, elements=[n] * dimension),
                fluid=dict(viscosity=1 / 256, capillarity=1 / n, temperature=0.85, contact_angle=75.0, wall_law="energy"),
                droplet=[dict(centre=centre, radius=0.2)],
                boundary=dict(left="slip", right="slip", bottom="no_slip", top="slip"))


STATES = {
    "inside": (still("inside", 2, [0.25, 0.25]), []),
    "wall": (still("wall", 2, [0.25, 0.0]), []),
    "corner": (still("corner", 2, [0.0, 0.0]), ["boundary.bottom=slip"]),
    "soft": ("static_droplet_soft_2d", ["domain.elements=[32,16]", "fluid.capillarity=1/16"]),
    "wall, 3D": (still("wall_3d", 3, [0.25, 0.25, 0.0]), []),
    "axis": (still("axis", 2, [0.0, 0.0]), ["domain.coordinates=axisymmetric"]),
    "soft axis": ("sessile_soft_axisymmetric", ["domain.elements=[16,16]", "fluid.capillarity=1/16", "droplet[0].radius=0.25"]),
    "stabilised": ("oscillating_droplet_2d", ["domain.elements=[16,16]", "fluid.capillarity=1/14", "fluid.viscosity=3e-5"]),
    "beam": ("csm1_beam_2d", ["domain.elements=[35,2]"]),
}


class Search:
    """The largest stable step of one scheme and mass on one state."""

    def __init__(self, lab, state, temperature, scheme, mass):
        self.lab = lab
        self.case, words = STATES[state]
        self.settings = [*words, *FOREVER, f"time.scheme={scheme}", f"time.mass={mass}"]
        if temperature:
            self.settings.append(f"fluid.temperature={temperature}")
        self.label = ", ".join(map(str, filter(None, (state, temperature, scheme, mass))))
        self.start = self.run("half the bound", ["time.safety=0.5", "time.dt_initial=1", "time.dt_max=1"], 2 * STEPS)
        self.bound = self.start.history["dt"][1:].min() / 0.5 if self.start.code == 0 else 0

    def run(self, what, words, steps):
        return self.lab.run(f"{self.label}, {what}", self.case, [*self.settings, *words, f"time.max_steps={steps}"], expect=None,
                            limit=600)

    def stable(self, part):
        """Whether steps of this part of the bound are stable."""
        dt = f"{part * self.bound:.6g}"
        steps = min(STEPS, int(self.start.history["t"][-1] / float(dt)))
        run = self.run(f"{part:.3g} of the bound", ["time.safety=10", f"time.dt_initial={dt}", f"time.dt_max={dt}"], steps)
        if run.code != 0 or run.record["counts"]["rejected_by_newton"] > 0:
            return False
        return run.history["energy_kinetic"][BEFORE:].max() <= GROWTH * self.start.history["energy_kinetic"].max()

    def largest(self):
        """@return the largest stable step and the least unstable one, as parts of the bound; 0 where none is stable"""
        if not self.bound:
            return 0.0, 0.5
        low, high = (1.0, None) if self.stable(1.0) else (None, 1.0)
        while (low is None or high is None) and 1 / WIDEST < (high or low) < WIDEST:
            tried = high / 1.25 if low is None else low * 1.25
            low, high = (tried, high) if self.stable(tried) else (low, tried)
        while low and high and high / low > CLOSE:
            middle = math.sqrt(low * high)
            low, high = (middle, high) if self.stable(middle) else (low, middle)
        return low or 0.0, high or math.inf


def chosen(lab):
    """(state, temperature, scheme, masses)"""
    if lab.quick:
        return [("wall", 0.85, scheme, mass) for scheme in SCHEMES for mass in MASSES] + [
            ("soft", 0.39, "rkl2", "corrected"), ("soft", 0.7, "kick_drift", "corrected"), ("corner", 0.7, "kick_drift", "corrected"),
            ("corner", 0.39, "kick_drift", "lumped"), ("axis", 0.85, "kick_drift", "corrected"), ("stabilised", 0.85, "kick_drift", "corrected"),
            ("beam", None, "kick_drift", "corrected")]
    wanted = [(state, temperature, scheme, mass) for state in list(STATES)[:4] for temperature in TEMPERATURES for scheme in SCHEMES
              for mass in MASSES]
    wanted += [("wall, 3D", 0.85, "kick_drift", mass) for mass in MASSES]
    wanted += [(state, temperature, "kick_drift", mass) for state, temperature in (("axis", 0.85), ("axis", 0.39), ("soft axis", 0.7))
               for mass in MASSES]
    return wanted + [(state, temperature, scheme, mass) for state, temperature in (("stabilised", 0.85), ("beam", None))
                     for scheme in ("kick_drift", "ssp_rk3") for mass in MASSES]


def limits(lab):
    rows, least = [], math.inf
    for combination in chosen(lab):
        search = Search(lab, *combination)
        low, high = search.largest()
        least = min(least, low)
        lab.expect(f"{search.label}: the bound", f"stable, the largest stable step at most {SLACK} of it",
                   f"stable at {low:.2f} of it, not at {high:.2f}", 1 <= low <= SLACK)
        rows.append((*(part or "" for part in combination), f"{search.bound:.3g}", f"{low * search.bound:.3g}", f"{low:.2f}", f"{high:.2f}"))
    lab.expect("steps of the bound are stable, everywhere", "at 1 of it", f"at {least:.2f} and more", least >= 1)
    lab.title("Bounds and stable steps")
    lab.table(("state", "temperature", "scheme", "masses", "bound", "largest stable step", "over the bound", "least unstable one over it"),
              rows, "limits")


FLIGHTS = {  # centre and direction of the flight, and whether the scene is symmetric about x = 0.5
    "side": ([0.6, 0.5], (-1, 0), False),
    "wall": ([0.5, 0.6], (0, -1), True),
    "top": ([0.5, 0.4], (0, 1), True),
    "corner": ([0.6, 0.6], (-0.8, -0.8), False),
}
SPEED = 0.15
WARMTH = (0.39, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95)


def flight(name):
    centre, way, _ = FLIGHTS[name]
    return case("A droplet that flies through its box.", f"flight_{name}",
                domain=dict(size=[1.0, 1.0], elements=[24, 24]),
                fluid=dict(viscosity=4e-4, capillarity="1/12", temperature=0.7, contact_angle=75.0, wall_law="energy"),
                droplet=[dict(centre=centre, radius=0.25, velocity=[SPEED * part for part in way])],
                boundary=sides("slip", bottom="no_slip" if name == "wall" else "slip"),
                time=dict(end=3.0))


def motion(lab):
    rows = []
    for temperature in (0.39, 0.7, 0.95) if lab.quick else WARMTH:
        for name, (_, _, symmetric) in FLIGHTS.items():
            scheme = "rkl2" if temperature < 0.5 else "kick_drift"
            label = f"{name}, {temperature}, {scheme}"
            run = lab.run(label, flight(name), [f"fluid.temperature={temperature}", f"time.scheme={scheme}", *FOREVER[2:]], expect=None,
                          limit=600)
            rows.append((name, temperature, scheme, *judged(lab, label, run, symmetric)))
    lab.title("Motion")
    lab.table(("scene", "temperature", "scheme", "steps", "dissipated", "largest rise of the energy in a step", "steps in which it rises",
               "refused steps"), rows, "motion")


def judged(lab, label, run, symmetric):
    """@return cells of the table"""
    if run.code != 0:
        lab.expect(f"{label}: exit code", "0", f"{run.code} at t = {run.history['t'][-1]:.3g}", False)
        return len(run.history["t"]) - 1, "stopped", "", "", run.record["counts"]["rejected_by_newton"]
    energy, refused = run.history["energy_total"], run.record["counts"]["rejected_by_newton"]
    rise, fall = numpy.diff(energy), energy[0] - energy[-1]
    lab.expect(f"{label}: largest change of the energy in a step, over the dissipation", "below 0", f"{rise.max() / fall:.1e}",
               rise.max() < 0)
    lab.expect(f"{label}: refused steps", "none", str(refused), refused == 0)
    told = [event["what"] for event in run.record["events"] if "energy" in event["what"]]
    lab.expect(f"{label}: events about the energy", "none", "; ".join(told) or "none", not told)
    if symmetric:
        sideways = abs(run.history["momentum_x"]).max()
        lab.expect(f"{label}: largest momentum along x", "<= 1e-12", f"{sideways:.1e}", sideways <= 1e-12)
    return len(energy) - 1, f"{fall:.2e}", f"{rise.max():.1e}", (rise >= 0).sum(), refused


def study(lab):
    limits(lab)
    motion(lab)
