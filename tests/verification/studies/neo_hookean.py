"""Neo-Hookean solid: a confined column under its load, against its one-dimensional solution.

A column between slip sides carries a vertical force on its upper half. Nothing moves sideways, so that the stress at the
height y is the load above it, P(s(y)) = - rho_0 f (load above y), with the stretch s. Neo-Hookean: P = G (s - 1/s) + lambda ln(s)/s;
Saint Venant-Kirchhoff: P = (lambda + 2 G) s (s^2 - 1)/2. The stretch is found by bisection, and the height of the top is its
integral. Saint Venant-Kirchhoff bears at most P = (lambda + 2 G)/(3 sqrt 3), at s = 1/sqrt 3. Under a larger load it
has no solution, and softwet has to stop and say so; the neo-Hookean column stands."""

import _measure
import numpy
from _case import case, fields, sides
from scipy.optimize import brentq

MINUTES = {"quick": 0.1, "full": 0.2}
EXPLICIT = "a state at rest, which no scheme changes; to come to rest takes thousands of units of time"
YOUNG, POISSON, HEIGHT = 1.0, 0.3, 1.0
LAMBDA, SHEAR = POISSON * YOUNG / ((1 + POISSON) * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))
LAWS = {"neo_hookean": lambda s: SHEAR * (s - 1 / s) + LAMBDA * numpy.log(s) / s,
        "saint_venant_kirchhoff": lambda s: (LAMBDA + 2 * SHEAR) * s * (s * s - 1) / 2}
CASE = case("A column under a vertical force on its upper half.", "confined_column",
            domain=dict(size=[0.25, HEIGHT], elements=[4, 16]),
            substrate=dict(thickness=HEIGHT, young=YOUNG, poisson=POISSON),
            load=[dict(box=[[0.0, 0.5], [0.25, HEIGHT]], force=[0.0, -0.1], ramp=20.0)],
            boundary=sides("slip", top="free"),
            time=dict(rho_inf=0.0, tolerance=0.01, end=2000.0),
            solver=dict(newton=dict(rtol=1e-8, atol=1e-11), krylov=dict(rtol=1e-4)),
            output=fields(2000.0))


def sinking(law, force):
    """Vertical displacement of the top at rest."""
    lowest = 0.02 if law == "neo_hookean" else 1 / numpy.sqrt(3)
    point, weight = numpy.polynomial.legendre.leggauss(40)
    total = 0.0
    for low in (0.0, 0.5):
        for x, w in zip(0.25 * (point + 1) + low, 0.25 * weight):
            load = force * min(0.5, HEIGHT - x)
            total += w * (brentq(lambda s: LAWS[law](s) + load, lowest, 1.0, xtol=1e-14) - 1)
    return total


def study(lab):
    largest = 2 * (LAMBDA + 2 * SHEAR) / (3 * numpy.sqrt(3))
    parts = (0.3, 0.9) if lab.quick else (0.1, 0.3, 0.6, 0.9)
    wanted = {f"{law}, {part} of the largest load": (CASE, [f"substrate.material={law}", f"load[0].force=[0,{-part * largest}]"])
              for law in LAWS for part in parts}
    beyond = (2.0,) if lab.quick else (1.5, 2.0, 4.0)
    wanted |= {f"neo_hookean, {part} of the largest load": (CASE, ["substrate.material=neo_hookean", f"load[0].force=[0,{-part * largest}]"])
               for part in beyond}
    rows, worst = [], {law: 0.0 for law in LAWS}
    for label, run in lab.runs(wanted).items():
        law, part = label.split(", ")[0], float(label.split(", ")[1].split()[0])
        exact = sinking(law, part * largest)
        found = _measure.interface(run.folder)["displacement_y"].mean()
        worst[law] = max(worst[law], abs(found / exact - 1))
        rows.append((law, part, f"{exact:.6f}", f"{found:.6f}", f"{found / exact - 1:+.1e}"))
    lab.text("The largest load is the one that Saint Venant-Kirchhoff bears. The column is 1 high.")
    lab.table(("law", "part of the largest load", "top sinks by, exact", "run", "relative error"), rows, "column")
    for law in LAWS:
        lab.expect(f"{law}: sinking of the top", "within 0.1 %", f"{100 * worst[law]:.3f} %", worst[law] <= 1e-3)
    run = lab.run("saint_venant_kirchhoff beyond its largest load", CASE,
                  ["substrate.material=saint_venant_kirchhoff", f"load[0].force=[0,{-2 * largest}]"], expect=None)
    lab.expect("Saint Venant-Kirchhoff at twice its largest load", "exit code 2, naming substrate.young", str(run.code),
               run.code == 2 and "substrate.young" in run.message)
