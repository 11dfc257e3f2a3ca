"""Durotaxis: a droplet on a solid whose stiffness grows along it.

The Young modulus is E_0 exp(s (x - 1/2)), 0.6 in the middle, where the droplet is put. It moves to one side; the speed is its mean
between the times 10 and 30. In this model the direction depends on the contact angle (Bueno, Bazilevs, Juanes and Gomez,
Soft Matter 2018, on the same equations; droplets in experiments go to the softer side: Style et al., PNAS 2013). Both forms of the force
on the wall are computed: fluid.wall_tension = "none" is the paper's, "acts" is the derivative of the energy, with which a droplet can only
go where the sum of all energies falls."""

import numpy
from _case import case, sides

MINUTES = {"quick": 0.5, "full": 6}
EXPLICIT = "needs tens of units of time at the temperature 0.39: hundreds of thousands of explicit steps"
SCENE = case("A droplet on a solid whose stiffness grows from left to right.", "durotaxis",
             domain=dict(size=[1.0, 0.5], elements=[64, 32]),
             fluid=dict(viscosity="1/256", capillarity="1/32", temperature=0.39, contact_angle=75.0, wall_law="energy"),
             substrate=dict(thickness=0.125, young="0.6*exp(2*(x - 0.5))", poisson=0.45),
             droplet=[dict(centre=[0.5, 0.125], radius=0.16)],
             boundary=sides("slip", bottom="clamped", top="no_slip"),
             time=dict(end=30.0, tolerance=5e-4))
SIGMA = 0.2532027493 / 32
FORCES = {"none": [], "acts": ["fluid.wall_tension=acts", f"substrate.surface_tension={SIGMA}"]}


def speed(run):
    rows = run.history
    late = rows["t"] >= 10
    return float((rows["x_centre"][late][-1] - rows["x_centre"][late][0]) / (rows["t"][late][-1] - rows["t"][late][0]))


def settings(slope, contact, force):
    return SCENE, [f"substrate.young=0.6*exp({slope}*(x - 0.5))", f"fluid.contact_angle={contact}", *FORCES[force]]


def study(lab):
    contacts = (75,) if lab.quick else (60, 75, 90, 105, 120)
    slopes = (-2, 2) if lab.quick else (-2, 0, 1, 2)
    keys = [(s, c, f) for f in FORCES for c in contacts for s in slopes]
    runs = lab.runs({f"s = {s}, contact angle {c}, {f}": settings(s, c, f) for s, c, f in keys}, limit=900)
    found = {(s, c, f): speed(runs[f"s = {s}, contact angle {c}, {f}"]) for s, c, f in keys}
    for f in FORCES:
        size = max(abs(found[2, c, f]) for c in contacts)
        apart = max(abs(found[2, c, f] + found[-2, c, f]) for c in contacts) / size
        lab.expect(f"{f}: the mirrored solid moves the droplet the other way, sum of both over the largest speed", "<= 0.01",
                   f"{apart:.1e}", apart <= 0.01)
        if lab.quick:
            continue
        still = max(abs(found[0, c, f]) for c in contacts) / size
        lab.expect(f"{f}: speed on a uniform solid over the largest", "<= 0.001", f"{still:.1e}", still <= 1e-3)
        shares = [found[1, c, f] / found[2, c, f] for c in contacts if abs(found[2, c, f]) > 0.2 * size]
        worst = max(shares, key=lambda r: abs(r - 0.5))
        lab.expect(f"{f}: speed at half of the gradient over that at the gradient", "0.5 +- 0.1", f"{worst:.2f}",
                   abs(worst - 0.5) <= 0.1)
    acts = runs[f"s = 2, contact angle {contacts[0]}, acts"].history
    rise = numpy.diff(acts["energy_total"]).max() / (acts["energy_total"][0] - acts["energy_total"][-1])
    lab.expect("acts: largest rise of the energy in a step over what it loses in all", "<= 0.001", f"{rise:.1e}", rise <= 1e-3)
    lab.title("Speed of the droplet")
    lab.text("sqrt(ab); positive: towards the stiffer side. On this Saint Venant-Kirchhoff layer all droplets go to the softer side, as in "
             "experiments. On a neo-Hookean layer the direction turns with the contact angle, as found in 2018: `tools/papers "
             "bueno_2018`.")
    rows = [(c, *(float(f"{found[s, c, f]:.3g}") for f in FORCES for s in slopes if s > 0)) for c in contacts]
    lab.table(("contact angle", *(f"{f}, s = {s}" for f in FORCES for s in slopes if s > 0)), rows, "speed")
    if len(contacts) > 1:
        lab.plot("speed", lambda axes: draw(axes, contacts, found))


def draw(axes, contacts, found):
    for f in FORCES:
        axes.plot(contacts, [found[2, c, f] for c in contacts], "o-", label=f'wall_tension = "{f}"')
    axes.axhline(0, color="black", linewidth=0.5)
    axes.set_xlabel("contact angle, degrees")
    axes.set_ylabel("speed towards the stiffer side")
    axes.legend()
