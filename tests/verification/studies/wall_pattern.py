"""Walls whose contact angle varies along them.

Stripe: a rigid wall of 110 degrees has a stripe of half width 0.15 with 60 degrees; the angle passes from one to the other over
two elements, 85 + 25 tanh((|x - 1/2| - 0.15) / b). A droplet whose circle would meet the edges of the stripe at an angle between the two is
held there. In equilibrium its contact points lie where the angle of the wall is the one of the circle with its area over the chord 2 c
between them, A = c^2 (t - sin t cos t) / sin^2 t; for a sharp stripe c = 0.15. Measured areas belong to the liquid: the mass beyond
the vapour's over the difference of the two densities.

Gradient: the cosine of the contact angle grows along a rigid wall. A droplet moves towards the wetting side, faster in proportion to the
gradient and to one over the viscosity (Brochard, Langmuir 5, 432, 1989, for wedges: an order of magnitude here), and what
it dissipates is what its energy loses."""

import math

import _measure
import numpy
from _case import case, sides

MINUTES = {"quick": 0.2, "full": 2}
EXPLICIT = "needs tens of units of time at the temperature 0.39: hundreds of thousands of explicit steps"
HALF = 0.15
STRIPE = case("A droplet on a stripe that wets better than the rest of a rigid wall.", "stripe",
              domain=dict(size=[1.0, 0.5], elements=[64, 32]),
              fluid=dict(viscosity="1/256", capillarity="1/32", temperature=0.39, wall_law="energy",
                         contact_angle=f"85 + 25*tanh((abs(x - 0.5) - {HALF})/0.03)"),
              droplet=[dict(centre=[0.5, 0.0], radius=0.16)],
              boundary=sides("slip", bottom="no_slip", top="no_slip"),
              time=dict(end=100.0))
GRADIENT = case("A droplet on a wall that wets better and better to the right.", "wettability_gradient",
                domain=dict(size=[1.0, 0.5], elements=[64, 32]),
                fluid=dict(viscosity="1/256", capillarity="1/32", temperature=0.39, wall_law="energy",
                           contact_angle="acos(0.2*(x - 0.5))*180/pi"),
                droplet=[dict(centre=[0.5, 0.0], radius=0.16)],
                boundary=sides("slip", bottom="no_slip", top="no_slip"),
                time=dict(end=20.0, tolerance=5e-4))


def cap_area(angle, half):
    """Area of the circle's part above a chord of half length `half` that it meets at this angle."""
    return half ** 2 * (angle - math.sin(angle) * math.cos(angle)) / math.sin(angle) ** 2


def angle_of(area, half):
    low, high = math.radians(5), math.radians(175)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if cap_area(middle, half) < area else (low, middle)
    return math.degrees(low)


def radius_of(area, degrees=60):
    """Of the cap with the angle in the middle of the stripe, which is where the start takes it from."""
    t = math.radians(degrees)
    return math.sqrt(area / (t - math.sin(t) * math.cos(t)))


def equilibrium(area, width):
    """@return  chord and angle on the stripe with smooth edges"""
    low, high = 0.05, 0.3
    for _ in range(60):  # the circle's angle falls with the chord, the wall's rises
        middle = (low + high) / 2
        wall = 85 + 25 * math.tanh((middle - HALF) / width)
        low, high = (middle, high) if angle_of(area, middle) > wall else (low, middle)
    return 2 * low, angle_of(area, low)


def measured(run):
    """@return  area of the liquid, chord, mean angle"""
    rows = run.history
    area = (rows["mass"][-1] - _measure.VAPOUR * 0.5) / (_measure.LIQUID - _measure.VAPOUR)
    return area, rows["x_right"][-1] - rows["x_left"][-1], (rows["angle_left"][-1] + rows["angle_right"][-1]) / 2


def stripe(lab):
    areas = (0.03,) if lab.quick else (0.02, 0.025, 0.03, 0.035, 0.04)
    meshes = {"64,32": ("1/32", 0.03, 1.5, 0.012)} if lab.quick else {
        "64,32": ("1/32", 0.03, 1.5, 0.012), "128,64": ("1/64", 0.015, 1.2, 0.007)}
    wanted = {f"area {area}, {mesh}": (STRIPE, [
        f"domain.elements=[{mesh}]", f"droplet[0].radius={radius_of(area)}", f"fluid.capillarity={capillarity}",
        f"fluid.contact_angle=85 + 25*tanh((abs(x - 0.5) - {HALF})/{width})"])
        for mesh, (capillarity, width, *_) in meshes.items() for area in areas}
    runs = lab.runs(wanted, limit=1500)
    table = []
    for mesh, (_, width, degrees, length) in meshes.items():
        apart, chords = [], []
        for area in areas:
            found, chord, angle = measured(runs[f"area {area}, {mesh}"])
            exact_chord, exact = equilibrium(found, width)
            table.append((mesh, *(float(f"{x:.4g}") for x in (found, chord, exact_chord, angle, exact, angle_of(found, HALF)))))
            apart.append(abs(angle - exact))
            chords.append(abs(chord - exact_chord))
        lab.expect(f"{mesh}: largest error of the angle, degrees", f"<= {degrees}", f"{max(apart):.2f}", max(apart) <= degrees)
        lab.expect(f"{mesh}: largest error of the chord", f"<= {length}", f"{max(chords):.4f}", max(chords) <= length)
    lab.title("Droplets on the stripe")
    lab.table(("mesh", "area of the liquid", "chord", "exact", "angle", "exact", "on a sharp stripe"), table, "stripe")


def gradient(lab):
    forms = {"half the gradient": ["fluid.contact_angle=acos(0.1*(x - 0.5))*180/pi"], "the gradient": [],
             "the other way": ["fluid.contact_angle=acos(-0.2*(x - 0.5))*180/pi"], "twice the viscosity": ["fluid.viscosity=1/128"]}
    runs = lab.runs({f"gradient: {label}": (GRADIENT, words) for label, words in forms.items()})
    speeds = {}
    for label in forms:
        rows = runs[f"gradient: {label}"].history
        late = rows["t"] >= 10
        t, x = rows["t"][late], rows["x_centre"][late]
        speeds[label] = float((x[-1] - x[0]) / (t[-1] - t[0]))
    base = speeds["the gradient"]
    lab.expect("the droplet moves towards the wetting side", "> 0", f"{base:.3g}", base > 0)
    for label, asked, slack in (("half the gradient", 0.5, 0.05), ("the other way", -1, 0.01), ("twice the viscosity", 0.5, 0.1)):
        part = speeds[label] / base
        lab.expect(f"speed with {label}, over the speed with the gradient", f"{asked} +- {slack}", f"{part:.3f}", abs(part - asked) <= slack)
    rows = runs["gradient: the gradient"].history
    late = rows["t"] >= 5
    t, lost, energy = rows["t"][late], rows["dissipation"][late], rows["energy_total"][late]
    sum_lost = float(((lost[1:] + lost[:-1]) / 2 * numpy.diff(t)).sum())
    part = (energy[0] - energy[-1]) / sum_lost
    lab.expect("loss of the energy over the dissipation, t = 5 to 20", "1 +- 0.03", f"{part:.4f}", abs(part - 1) <= 0.03)
    lab.title("Speed on a gradient of the cosine")
    lab.table(("scene", "speed"), [(label, float(f"{speed:.3g}")) for label, speed in speeds.items()], "gradient")


def study(lab):
    stripe(lab)
    gradient(lab)
