"""Graded elements against equal ones: the same path for less.

Each scene is computed on equal elements and with domain.grading.fine = "automatic", one after the other on one core. The steps of time are
small (time.tolerance 5e-4), for else their error would hide the error of the mesh: X_c(700) of the pull depends on it by 2e-3. Equal elements are
the reference for what grading adds to their error. The mass at the start depends on the mesh by what the interface is above the droplet
where elements begin to grow, 2.2 capillarities away. The quick form asks for the share of the unknowns, not for seconds."""

import numpy
from _lab import Known

MINUTES = {"quick": 0.3, "full": 6}
EXPLICIT = "is about meshes; tests/regression/graded.py flies a droplet over the end of fine elements with kick_drift"
SMALL = ["domain.elements=[64,32]", "fluid.capillarity=1/32", "load[0].start=2", "load[0].ramp=1", "time.end=20",
         "output.fields.times=[]"]
STEPS = ["time.tolerance=5e-4"]
COARSE = "the mass of the start depends on a mesh with so few elements to the capillarity, equal or graded: it changes as much when they are halved"
DEAR = "linear solves on graded elements take a few iterations more, and the machine was shared; {} was asked"
EQUAL, AUTOMATIC = "domain.grading.fine=everywhere", "domain.grading.fine=automatic"
# name: case, settings, least ratio of the cost, greatest difference of the middle of the contact line, of its extent
# (relative)
QUICK = {"small pull": ("tensotaxis_pull_2d", [*SMALL, *STEPS], None, 2e-4, 0.01)}
FULL = {
    "pull": ("tensotaxis_pull_2d", [*STEPS, "output.fields.times=[]"], 2.2, 2e-4, 0.01),
    "push": ("tensotaxis_push_2d", [*STEPS, "output.fields.times=[]"], 2.2, 2e-4, 0.01),
    "pull, degree 3": ("tensotaxis_pull_2d", [*STEPS, "domain.degree=3", "domain.elements=[96,48]", "time.end=471",
                                              "output.fields.times=[]"], 2.0, 2e-4, 0.01),
    "needle, small": ("fig4_needle_3d_small", ["output.fields.times=[]"], 1.5, 5e-4, 0.02),
}


def study(lab):
    rows = []
    for name, (case, settings, cost, path, extent) in (QUICK if lab.quick else FULL).items():
        equal = lab.run(f"{name}, equal", case, [*settings, EQUAL], limit=3000)
        graded = lab.run(f"{name}, graded", case, [*settings, AUTOMATIC], limit=3000)
        compare(lab, name, equal, graded, cost, path, extent)
        rows += [row(f"{name}, {kind}", run) for kind, run in (("equal", equal), ("graded", graded))]
    lab.title("Cost and path")
    lab.text("Seconds of one core, which is shared with other work; steps, Newton and Krylov iterations do not depend on that.")
    lab.table(("run", "unknowns", "seconds", "steps", "refused", "Newton", "Krylov", "X_c at the end", "mass at the start"), rows, "cost")


def row(name, run):
    counts, history = run.record["counts"], run.history
    return (name, run.record["unknowns"]["solved"], round(run.processor_seconds, 1), counts["steps"], counts["rejected_by_newton"] + counts["rejected_by_error"], counts["newton"],
            counts["krylov"], float(f"{history['x_centre'][-1]:.6g}"), float(f"{history['mass'][0]:.9g}"))


def compare(lab, name, equal, graded, cost, path, extent):
    a, b = equal.history, graded.history
    times = numpy.linspace(a["t"][0], min(a["t"][-1], b["t"][-1]), 400)
    apart = max(abs(numpy.interp(times, b["t"], b["x_centre"]) - numpy.interp(times, a["t"], a["x_centre"])))
    lab.expect(f"{name}: largest difference of X_c", f"<= {path:g}", f"{apart:.1e}", apart <= path)
    width = [h["x_right"] - h["x_left"] if "x_right" in h else numpy.sqrt(h["contact_area"]) for h in (a, b)]
    wider = abs(width[1][-1] / width[0][-1] - 1)
    lab.expect(f"{name}: extent of the contact line at the end, relative difference", f"<= {extent:g}", f"{wider:.1e}", wider <= extent)
    heavier = abs(b["mass"][0] / a["mass"][0] - 1)
    bound = 1e-4 if cost is None else 1e-5
    lab.expect(f"{name}: mass at the start, relative difference", f"<= {bound:g}", f"{heavier:.1e}", heavier <= bound,
               Known(COARSE, "2e-4", heavier <= 2e-4))
    drift = abs(b["mass"][-1] / b["mass"][0] - 1)
    lab.expect(f"{name}: drift of the mass", "<= 1e-12", f"{drift:.1e}", drift <= 1e-12)
    if cost is None:
        share = graded.record["unknowns"]["solved"] / equal.record["unknowns"]["solved"]
        return lab.expect(f"{name}: unknowns over the unknowns of equal elements", "<= 0.7", f"{share:.2f}", share <= 0.7)
    ratio = equal.processor_seconds / graded.processor_seconds
    return lab.expect(f"{name}: cost of equal elements over cost of graded ones", f">= {cost:g}", f"{ratio:.2f}", ratio >= cost,
                      Known(DEAR.format(cost), "0.9 of that", ratio >= 0.9 * cost))
