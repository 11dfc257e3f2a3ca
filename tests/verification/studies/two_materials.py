"""Two materials that are joined at a height of the solid: a column under its weight, and a soft layer on a stiff one.

The stiffness jumps at substrate.joint, where the displacement is continuous and its slope is not. Strains are small (substrate.strain =
"small"), so that the displacement of the column is a parabola in each material. With the height H, the joint at H/2, the
weight rho f and the modulus M = lambda + 2 G of a confined column below the joint, 4 M above,
u(H) = - rho f / M (3/8 H^2 + 1/32 H^2): splines of degree 2 have it exactly with a joint, and with the error of a smeared jump without.

A layer whose lower half is a thousand times stiffer is one of half the thickness on a clamped bottom. A load pushes on it near its surface. Without a
joint the stiffness of the lower half is smeared into a row of the soft one.

Rest is reached with rho_inf = 0."""

import _measure
import numpy
from _case import case, fields, sides

MINUTES = {"quick": 0.1, "full": 0.2}
EXPLICIT = "is about states of rest, which steps without a bound reach sooner"
STILL = dict(time=dict(rho_inf=0.0, tolerance=0.05, end=1000.0),
             solver=dict(newton=dict(rtol=1e-9, atol=1e-13), krylov=dict(rtol=1e-4)), output=fields(1000.0))
HEIGHT, WEIGHT, POISSON, RATIO = 0.8, 0.3, 0.3, 4
COLUMN = case("A column of two materials under its weight.", "joined_column", domain=dict(size=[0.3, HEIGHT], elements=[2, 8]),
              substrate=dict(thickness=HEIGHT, young=f"y < {HEIGHT / 2} ? 1 : {RATIO}", poisson=POISSON, strain="small",
                             gravity=[0.0, -WEIGHT]),
              boundary=sides("slip", top="free"), **STILL)


def layer(name, bottom, young):
    """A soft layer 0.125 thick above a height."""
    top = bottom + 0.125
    return case("A layer under a load near its surface.", name, domain=dict(size=[1.0, top], elements=[64, round(64 * top)]),
                substrate=dict(thickness=top, young=young, poisson=0.45, strain="small"),
                load=[dict(box=[[0.45, top - 0.03125], [0.55, top]], force=[0.0, -0.05], ramp=20.0)],
                boundary=sides("slip", bottom="clamped", top="free"), **STILL)


def top_of_column(run):
    place, u = _measure.solid_field(run.folder, 0)
    return u[numpy.isclose(place[:, 1], HEIGHT), 1].mean()


def column(lab):
    modulus = (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
    exact = -WEIGHT / modulus * HEIGHT**2 * (3 / 8 + 1 / (8 * RATIO))
    rows = []
    for n in (4, 8) if lab.quick else (4, 8, 16, 32):
        found = [top_of_column(lab.run(f"column, {n} rows, {form}", COLUMN, [f"domain.elements=[2,{n}]", *words])) / exact - 1
                 for form, words in (("joint", [f"substrate.joint={HEIGHT / 2}"]), ("no joint", []))]
        rows.append((n, *(float(f"{error:.2g}") for error in found)))
    lab.expect("column: error of u(H) with a joint", "<= 1e-8", f"{max(abs(row[1]) for row in rows):.1e}",
               max(abs(row[1]) for row in rows) <= 1e-8)
    order = numpy.log2(abs(rows[-2][2] / rows[-1][2]))
    lab.expect("column: order of the error of u(H) without one", "1 +- 0.2", f"{order:.2f}", abs(order - 1) <= 0.2)
    lab.table(("rows of elements", "relative error of u(H) with a joint", "without"), rows, "column")


def stiff_bottom(lab):
    words = {"clamped": (layer("clamped_layer", 0.0, 1.0), []),
             "joint": (layer("layer_on_a_stiff_one", 0.125, "y < 0.125 ? 1000 : 1"), ["substrate.joint=0.125"]),
             "no joint": (layer("layer_on_a_stiff_one", 0.125, "y < 0.125 ? 1000 : 1"), [])}
    down = {form: _measure.interface(lab.run(f"layer, {form}", text, settings).folder)["displacement_y"].min()
            for form, (text, settings) in words.items()}
    off = {form: down[form] / down["clamped"] - 1 for form in ("joint", "no joint")}
    lab.expect("layer on a stiff one: its dent over the dent of the layer on a clamped bottom", "within 0.3 %",
               f"off by {100 * off['joint']:.2g} %, without a joint by {100 * off['no joint']:.2g} %", abs(off["joint"]) <= 3e-3)


def study(lab):
    column(lab)
    stiff_bottom(lab)
