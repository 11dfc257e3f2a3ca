"""Fibrotaxis: a droplet on a solid with parallel fibres.

A droplet on a soft solid whose fibres are inclined to the wall starts to move by itself, though solid and wall are the same everywhere
(Bhopalam, Bueno and Gomez, Soft Matter 2024, who named it and found it fastest where the contact angle is near the angle of the
fibres, or that plus 90 degrees; their energy of the fibres is not known here, so their numbers are not compared). Here substrate.fibre gives the fibres, between periodic sides, where a droplet can
move for ever. Speeds are means over the last third of the run.

A motion that lasts needs power. On a uniform wall no energy falls while a droplet moves as a whole, so what viscosity dissipates has to
come from elsewhere: with the paper's force on the wall, fluid.wall_tension = "none", it is the column wall_stretch, the energy that
the wall gains by its stretch and no balance pays for. With "acts", the force that belongs to the energy, the droplet must stay."""

import numpy
from _case import case, sides

MINUTES = {"quick": 0.6, "full": 8}
EXPLICIT = "needs tens of units of time at the temperature 0.39: hundreds of thousands of explicit steps"
SCENE = case("A droplet on a soft solid with inclined fibres, between periodic sides.", "fibrotaxis",
             domain=dict(size=[1.0, 0.5], elements=[64, 32]),
             fluid=dict(viscosity="1/256", capillarity="1/32", temperature=0.39, contact_angle=60.0, wall_law="energy"),
             substrate=dict(thickness=0.125, young=0.4, poisson=0.3, fibre=dict(stiffness=0.6, angle=60.0)),
             droplet=[dict(centre=[0.5, 0.125], radius=0.16)],
             boundary=sides("slip", left="periodic", right="periodic", bottom="clamped", top="no_slip"),
             time=dict(end=60.0, tolerance=5e-4))
SIGMA = 0.2532027493 / 32
ACTS = ["fluid.wall_tension=acts", f"substrate.surface_tension={2 * SIGMA}"]


def speed(run):
    """Mean of the velocity over the last third of the time, by the trapezoidal rule."""
    return mean(run, "velocity")


def mean(run, column):
    rows = run.history
    late = rows["t"] > 2 / 3 * rows["t"][-1]
    t, y = rows["t"][late], rows[column][late]
    return float(((y[1:] + y[:-1]) / 2 * numpy.diff(t)).sum() / (t[-1] - t[0]))


def settings(fibres, contact, more=()):
    return SCENE, [f"substrate.fibre.angle={fibres}", f"fluid.contact_angle={contact}", *more]


def study(lab):
    fibres = (60, 120) if lab.quick else tuple(range(0, 180, 15))
    contacts = (60,) if lab.quick else (60, 75, 90, 105, 120)
    wanted = {f"fibres {f}, contact angle {c}": settings(f, c) for c in contacts for f in fibres}
    wanted["acts"] = settings(60, 60, ACTS)
    wanted["none, the same tension"] = settings(60, 60, ACTS[1:])
    runs = lab.runs(wanted, limit=900)
    found = {(f, c): speed(runs[f"fibres {f}, contact angle {c}"]) for c in contacts for f in fibres}
    apart = abs(found[60, 60] + found[120, 60]) / abs(found[60, 60])
    lab.expect("mirror: speeds at 60 and 120 degrees, sum over size", "<= 0.001", f"{apart:.1e}", apart <= 1e-3)
    moving = runs["fibres 60, contact angle 60"]
    fed = mean(moving, "wall_stretch") / mean(moving, "dissipation")
    lab.expect("steady motion: power of wall_stretch over dissipation", "1 +- 0.05", f"{fed:.3f}", abs(fed - 1) <= 0.05)
    stays, same = speed(runs["acts"]), speed(runs["none, the same tension"])
    lab.expect("wall_tension = acts: speed over the speed with none and the same surface tension", "<= 0.002",
               f"{abs(stays / same):.1e}", abs(stays) <= 2e-3 * abs(same))
    if not lab.quick:
        fastest = max(found.values(), key=abs)
        for c in contacts:
            upright = max(abs(found[f, c]) for f in (0, 90))
            lab.expect(f"contact angle {c}: speed for fibres along and across the wall, over the fastest of all", "<= 0.01",
                       f"{upright / abs(fastest):.1e}", upright <= 0.01 * abs(fastest))
        peak = max((f for f in fibres if f <= 90), key=lambda f: abs(found[f, 60]))
        lab.expect("contact angle 60: angle of the fibres with the fastest droplet", "60 +- 15", f"{peak}", abs(peak - 60) <= 15)
    lab.title("Speed of the droplet")
    lab.text("Positive: to the right, sqrt(ab). Fibres are counted from the wall towards the vertical.")
    lab.table(("fibres, degrees", *(f"contact angle {c}" for c in contacts)),
              [(f, *(float(f"{found[f, c]:.3g}") for c in contacts)) for f in fibres], "speed")
    lab.plot("speed", lambda axes: draw(axes, fibres, contacts, found))


def draw(axes, fibres, contacts, found):
    for c in contacts:
        axes.plot(fibres, [found[f, c] for f in fibres], "o-", label=f"contact angle {c}")
    axes.set_xlabel("angle of the fibres, degrees")
    axes.set_ylabel("speed of the droplet")
    axes.legend()
