"""Manufactured solutions: orders in space and time.

Smooth fields are chosen that obey the sides of a scene; what they leave in the strong form of the equations is added to
the discrete equations as a source, so that they are the exact solution. The sources are generated: exact derivatives of
the chosen fields by nested forward differentiation enter the strong form, which shares nothing with the kernels of the
weak form (tests/verification/mms). Scenes: fluid alone between slip sides, solid alone, and both coupled on the moving
mesh, with the traction, the contact angle (gradient law, 60 degrees) and the wall itself in motion. Errors are L2 norms
at the end. Runs start with their exact rates, not with a step of backward Euler."""

import csv
import io
import itertools
import math
import subprocess
import time

from _lab import Known

MINUTES = {"quick": 0.2, "full": 8}
EXPLICIT = "has the explicit schemes itself: orders in time with corrected, lumped and consistent masses, and orders in space with corrected and lumped ones"

TOLERANCE = 0.2
NAMES = {"velocity": "v", "density": "rho", "potential": "mu", "displacement": "u"}


class Measurement:
    """Runs softwet_mms and keeps its rows."""

    def __init__(self, lab):
        self.lab, self.rows = lab, []
        self.programs = lab.tools("softwet_mms", *([] if lab.quick else ["softwet_mms_3x3"]))

    def errors(self, **settings):
        """@return {field: L2 error} of one computation"""
        program = "softwet_mms_3x3" if (settings["dimension"], settings["degree"]) == (3, 3) else "softwet_mms"
        words = [f"{name}={value}" for name, value in settings.items()]
        start = time.monotonic()
        result = subprocess.run([str(self.programs[program]), "header=1", *words], capture_output=True, text=True, timeout=900)
        if result.returncode:
            raise RuntimeError(f"{program} {' '.join(words)}: {result.stderr.strip()}")
        rows = list(csv.DictReader(io.StringIO(result.stdout)))
        self.rows += rows
        label = " ".join(words)
        self.lab.commands[label] = f"{program} {label}"
        self.lab.seconds[label] = time.monotonic() - start
        return {row["field"]: float(row["error"]) for row in rows}

    def series(self, name, values, **settings):
        """Errors for each value of one setting. @return {field: [error]}"""
        found = [self.errors(**settings, **{name: value}) for value in values]
        return {field: [e[field] for e in found] for field in found[0]}


def orders(sizes, errors):
    """Observed orders between neighbours; sizes are h or dt."""
    return [math.log(b / a) / math.log(t / s) for (s, a), (t, b) in itertools.pairwise(zip(sizes, errors))]


def text_of(values):
    return ", ".join(f"{value:.2f}" for value in values)


def within(found, theory):
    return all(abs(order - theory) <= TOLERANCE for order in found)


ORDERS = ("computed", "over", *(f"orders of {short}" for short in NAMES.values()), "all")


def show(lab, name, title, columns, sizes, found):
    """Errors and orders in a file, and a picture of them. @return their row of a table of ORDERS"""
    observed = {field: text_of(orders(sizes, errors)) for field, errors in found.items()}
    rows = [[NAMES[field], *(f"{e:.3e}" for e in errors), observed[field]] for field, errors in found.items()]
    file = lab.numbers(["error of", *columns, "orders"], rows, name)

    def draw(axes):
        for field, errors in found.items():
            axes.loglog(sizes, errors, "o-", label=NAMES[field])
        axes.set_xlabel("h" if "dt" not in columns[0] else "dt")
        axes.set_ylabel("L2 error")
        axes.set_title(title)
        axes.legend()
        axes.grid(True, which="both", alpha=0.3)

    return summary(title, columns, observed, file, lab.plot(name, draw, shown=False))


def summary(title, columns, observed, file, picture):
    links = f"`{file}`" + (f", [picture]({picture})" if picture else "")
    first, last = columns[0].removesuffix(" elements"), columns[-1].removeprefix("dt = ")
    return (title.removesuffix(f", {LENGTHS}"), f"{first} to {last}", *(observed.get(field, "") for field in NAMES), links)


# Graded axes have a whole number of elements beside the box, so that their lengths grow faster on one mesh than on
# another. On these meshes they are the same function of the place within 3 %; on 48 and 64 elements with 1 to 3 they
# differ by a third.
GRADED, SIMILAR = {"coarsest": 2.4}, (56, 96, 136)
LENGTHS = f"graded elements, 1 to {GRADED['coarsest']} in length"

# scene, dimension, degree, elements of quick and full form, what is computed
SPACE = [
    ("fluid", 2, 2, (16, 32, 64), (16, 32, 64, 128), {"dt": 0.1, "end": 0.4, "stabilisation": 0}),
    ("fluid", 2, 3, None, (24, 36, 56, 80), {"dt": 0.1, "end": 0.4, "stabilisation": 0}),
    ("solid", 2, 2, (16, 32, 48), (16, 32, 64, 128), {"dt": 0.1, "end": 0.4}),
    ("solid", 2, 3, (12, 24, 36), (12, 24, 48, 72), {"dt": 0.1, "end": 0.4}),
    ("coupled", 2, 2, (16, 24, 32), (16, 32, 48, 64), {"dt": 0.02, "end": 0.2, "rho_inf": 1}),
    ("coupled", 2, 3, None, (16, 24, 32, 40), {"dt": 0.02, "end": 0.2, "rho_inf": 1}),
    ("coupled", 2, 2, (16, 24, 32), (16, 32, 48, 64), {"dt": 0.02, "end": 0.2, "rho_inf": 1, "quadrature": "reduced"}),
    ("coupled", 2, 3, None, (16, 24, 32, 40), {"dt": 0.02, "end": 0.2, "rho_inf": 1, "quadrature": "reduced"}),
    ("fluid", 2, 2, (56, 96), SIMILAR, {"dt": 0.1, "end": 0.4, **GRADED}),
    ("fluid", 2, 3, None, SIMILAR, {"dt": 0.1, "end": 0.4, **GRADED}),
    ("solid", 2, 2, None, SIMILAR, {"dt": 0.1, "end": 0.4, **GRADED}),
    ("solid", 2, 3, None, SIMILAR, {"dt": 0.1, "end": 0.4, **GRADED}),
    ("coupled", 2, 2, None, SIMILAR, {"dt": 0.01, "end": 0.1, "rho_inf": 1, **GRADED}),
    ("coupled", 2, 3, None, SIMILAR, {"dt": 0.01, "end": 0.1, "rho_inf": 1, **GRADED}),
    ("solid", 3, 2, None, (4, 8, 12, 16), {"dt": 0.02, "end": 0.04, "rho_inf": 1, "preconditioner": "lu"}),
    ("coupled", 3, 2, None, (4, 8, 12, 16), {"dt": 0.02, "end": 0.04, "rho_inf": 1, "preconditioner": "lu"}),
    ("solid", 3, 3, None, (4, 8, 12, 16), {"dt": 0.02, "end": 0.04, "rho_inf": 1, "preconditioner": "lu"}),
    ("coupled", 3, 3, None, (16, 20, 24, 28), {"dt": 0.02, "end": 0.04, "rho_inf": 1, "preconditioner": "schwarz"}),
]


SPACES = ("Orders over h", f"Orders over h, {LENGTHS}", "Orders over h, 3D")


def space(lab, measurement):
    shown = {heading: [] for heading in SPACES}
    for scene, dimension, degree, quick, full, settings in SPACE:
        meshes = quick if lab.quick else full
        if not meshes:
            continue
        if lab.quick and not lab.has_configuration(f"{dimension}D degree {degree}"):
            lab.text(f"This build has no {dimension}D of degree {degree}: {scene} was left out.")
            continue
        settings = {"scene": scene, "dimension": dimension, "degree": degree, **settings}
        found = measurement.series("elements", meshes, **settings)
        sizes = [1 / n for n in meshes]
        kinds = {"reduced": settings.get("quadrature") == "reduced", "graded": "coarsest" in settings}
        words = {"reduced": "reduced quadrature", "graded": LENGTHS}
        title = ", ".join([f"{scene}, {dimension}D, degree {degree}", *(words[kind] for kind in kinds if kinds[kind])])
        name = "_".join([f"{scene}_{dimension}d_degree_{degree}", *(kind for kind in kinds if kinds[kind])])
        heading = SPACES[2 if dimension == 3 else 1 if kinds["graded"] else 0]
        shown[heading].append(show(lab, name, title, [f"{n} elements" for n in meshes], sizes, found))
        judge_space(lab, title, dimension == 2 and not kinds["graded"], degree, sizes, found)
    for heading, rows in shown.items():
        if rows:
            lab.title(heading)
            lab.table(ORDERS, rows)


def judge_space(lab, title, settled, degree, sizes, found):
    """@param settled  the meshes are fine enough for the order itself. Where elements are graded, and in 3D, some
    orders are still above"""
    for field, errors in found.items():
        observed = orders(sizes, errors)
        lowest = degree - 1 if field == "potential" else degree + 1
        exact = settled and field in ("velocity", "displacement")
        asked = f"{lowest} +- {TOLERANCE}" if exact else f"{lowest - TOLERANCE:g} or more"
        lab.expect(f"{title}: order of {NAMES[field]} over h", asked, text_of(observed),
                   within(observed, lowest) if exact else min(observed) >= lowest - TOLERANCE)


def control(lab, measurement):
    """What the checkerboard control does to the potential and to what the wall takes from it."""
    lab.title("Checkerboard control and the potential")
    rows, last, meshes = [], {}, (16, 32, 64)
    for scene, settings in (("fluid", {"dt": 0.1, "end": 0.4}), ("coupled", {"dt": 0.02, "end": 0.2, "rho_inf": 0.5})):
        for strength in (0, 0.002, 0.2, 2):
            found = measurement.series("elements", meshes, scene=scene, dimension=2, degree=2, stabilisation=strength,
                                       **settings)
            rows.append([scene, strength, *(text_of(orders([1 / n for n in meshes], found[f])) if f in found else ""
                                            for f in NAMES)])
            last[scene, strength] = {field: orders((1 / 32, 1 / 64), errors[1:])[0] for field, errors in found.items()}
    lab.text("Theory: without control (C = 0) the potential has order p - 1 = 1; through the traction that takes "
             "velocity, density and displacement of the coupled scene below p + 1 = 3, and the default C = 0.002 "
             "restores them. Asked of the two finest meshes, with the tolerance of the orders above.")
    lab.table(["scene", "C", *(f"orders of {NAMES[f]}" for f in NAMES)], rows, "control")
    judge_control(lab, last)


def judge_control(lab, last):
    """@param last  {(scene, C): {field: order between the two finest meshes}}"""
    def least(scene, strength):
        return min(order for field, order in last[scene, strength].items() if field != "potential")

    potential, bare = [last[scene, 0]["potential"] for scene in ("fluid", "coupled")], least("coupled", 0)
    restored = [least(scene, 0.002) for scene in ("fluid", "coupled")]
    lab.expect("C = 0: order of mu, fluid and coupled", f"1 +- {TOLERANCE}", text_of(potential), within(potential, 1))
    lowest = 3 - TOLERANCE
    lab.expect("C = 0, coupled: least order of v, rho, u", f"below {lowest:g}", f"{bare:.2f}", bare < lowest)
    lab.expect("C = 0.002: least order of v, rho, u, fluid and coupled", f"{lowest:g} or more", text_of(restored),
               min(restored) >= lowest)


def course(lab, measurement):
    """Orders in time on a mesh fine enough for the error of time to rule."""
    if lab.quick and not lab.has_configuration("2D degree 3"):
        return lab.text("This build has no 2D of degree 3: orders over dt by generalized-alpha were left out.")
    meshes, steps = ((16, (0.05, 0.025, 0.0125)) if lab.quick else (24, (0.025, 0.0125, 0.00625, 0.003125)))
    rows = []
    for rho_inf in (0.5,) if lab.quick else (0, 0.5, 1):
        found = measurement.series("dt", steps, scene="coupled", course="harmonic", dimension=2, degree=3, elements=meshes,
                                   end=0.5, rho_inf=rho_inf)
        title = f"coupled, rho_inf = {rho_inf}, {meshes} x {meshes} elements of degree 3"
        rows.append(show(lab, f"time_{rho_inf}", title, [f"dt = {dt:g}" for dt in steps], steps, found))
        for field, errors in found.items():
            if field == "potential":
                continue
            observed = orders(steps, errors)
            lab.expect(f"rho_inf = {rho_inf}: order of {NAMES[field]} over dt", f"2 +- {TOLERANCE}", text_of(observed),
                       within(observed, 2))
    lab.title("Orders over dt, generalized-alpha")
    lab.table(ORDERS, rows)


# scheme, mass, order, elements per axis, steps, step of the computation that takes the place of the exact solution
# Consistent masses have shorter stable steps, so that their elements are longer. Below dt = 0.0005 their mass solves,
# to 1e-12, show in the potential of ssp_rk3 (about 1e-10).
EXPLICIT_COURSES = [
    ("kick_drift", "corrected", 2, 8, (0.004, 0.002, 0.001), 0.000125),
    ("ssp_rk3", "corrected", 3, 8, (0.002, 0.001, 0.0005), 0.000125),
    ("rkl2", "corrected", 2, 8, (0.004, 0.002, 0.001), 0.000125),
    ("kick_drift", "lumped", 2, 8, (0.004, 0.002, 0.001), 0.000125),
    ("ssp_rk3", "lumped", 3, 8, (0.002, 0.001, 0.0005), 0.000125),
    ("ssp_rk3", "consistent", 3, 6, (0.002, 0.001, 0.0005), 0.0000625),
    ("rkl2", "lumped", 2, 8, (0.004, 0.002, 0.001), 0.000125),
]


LAGGED = ("the source of the mass balance counts with the stabilisation, which kick_drift takes from the state before the step; without "
          "either the scheme is of second order (tests/unit/time/explicit/test_kick_drift.cpp)")


def explicit_course(lab, measurement):
    """Orders in time of the explicit schemes; their error in space would hide the error of their small steps."""
    rows = []
    for scheme, mass, order, elements, steps, fine in EXPLICIT_COURSES[:2] if lab.quick else EXPLICIT_COURSES:
        found = measurement.series("dt", steps, scene="coupled", course="harmonic", dimension=2, degree=2,
                                   elements=elements, end=0.1, scheme=scheme, mass=mass, against=fine)
        title = f"{scheme}, {mass} masses, coupled, {elements} x {elements} elements of degree 2"
        rows.append(show(lab, f"time_{scheme}_{mass}", title, [f"dt = {dt:g}" for dt in steps], steps, found))
        for field, errors in found.items():
            observed = orders(steps, errors)
            lagged = Known(LAGGED, "1 or more", min(observed) >= 1) if scheme == "kick_drift" else None
            lab.expect(f"{scheme}, {mass}: order of {NAMES[field]} over dt", f"{order - TOLERANCE:g} or more",
                       text_of(observed), min(observed) >= order - TOLERANCE, lagged)
    lab.title("Orders over dt, explicit schemes")
    lab.table(ORDERS, rows)


# scheme, mass, least order of velocity, density and displacement over h. Row sums alone have the second order.
EXPLICIT_SPACE = [("ssp_rk3", "corrected", 3), ("ssp_rk3", "lumped", 2)]


def explicit_space(lab, measurement):
    """Orders in space of the masses of explicit schemes. Steps are stable, 0.004 on 8 elements and a quarter for twice
    as many, so that the error of time falls by the fourth order of h."""
    rows = []
    for scheme, mass, order in EXPLICIT_SPACE[:1] if lab.quick else EXPLICIT_SPACE:
        # With lumped masses the density on 8 elements is still above its order: 1.74 between 8 and 16.
        meshes = (16, 32) if mass == "lumped" else (8, 16) if lab.quick else (8, 16, 32)
        found = {}
        for n in meshes:
            errors = measurement.errors(scene="coupled", dimension=2, degree=2, elements=n, dt=0.256 / n**2, end=0.04, scheme=scheme,
                                        mass=mass)
            for field, error in errors.items():
                found.setdefault(field, []).append(error)
        sizes, title = [1 / n for n in meshes], f"{scheme}, {mass} masses, coupled, degree 2, over h"
        rows.append(show(lab, f"space_{scheme}_{mass}", title, [f"{n} elements" for n in meshes], sizes, found))
        for field, errors in found.items():
            if field != "potential":
                observed = orders(sizes, errors)
                lab.expect(f"{scheme}, {mass}: order of {NAMES[field]} over h", f"{order - TOLERANCE:g} or more", text_of(observed),
                           min(observed) >= order - TOLERANCE)
    lab.title("Orders over h, explicit schemes")
    lab.table(ORDERS, rows)


def study(lab):
    measurement = Measurement(lab)
    lab.text("Theory, splines of degree p: order p + 1 of velocity and displacement, and at least p + 1 of density (its error "
             "is often smaller still on uniform meshes, because the mass equation smooths what velocity errors do to it). The "
             "potential mu = W' - g^2 Lap rho has no control of its own: a density error of order p + 1 with the wave "
             "length of the mesh is an error of order p - 1 in mu. The checkerboard control eps = C h^2 rho^2 / m damps such "
             "waves at a rate that grows like C/h^2. In time: order 2.")
    lab.text("Fields are linear in time where orders in space are measured: generalized-alpha follows them exactly on a fixed "
             "mesh. On a moving one rho J is not linear in time; rho_inf = 1 and a small step keep that error below the "
             "error of space. The solid starts undeformed: the interpolant of a deformation differs from the discrete "
             "equilibrium by order p + 1 in displacement but sets off waves of order p in velocity. The meshes of 3D are "
             "coarse: most orders are still above p + 1 and are asked not to be below. That of the displacement in the coupled "
             "scene of degree 3 comes from below: 3.73 between 8 and 12 elements, 3.78 between 12 and 16, which the table "
             "leaves out. Meshes of one row keep the number of "
             "element rows of each material even (3D) or all numbers even: the potential's error differs between even and "
             "odd numbers of elements, because the wave of the mesh that it does not control fits one and not the other. "
             "Elements of graded axes grow from a box of fine ones in the middle to both sides, on all meshes of a row alike within 3 %; "
             "h is the short length.")
    space(lab, measurement)
    if not lab.quick:
        control(lab, measurement)
    course(lab, measurement)
    explicit_course(lab, measurement)
    explicit_space(lab, measurement)
    file = lab.numbers(list(measurement.rows[0]), [list(row.values()) for row in measurement.rows], "errors")
    lab.text(f"All errors, with what they were computed with: `{file}`.")
