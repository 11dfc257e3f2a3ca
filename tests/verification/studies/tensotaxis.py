"""Tensotaxis: pull, push, Poisson ratio 0, mirrored load.

Fig. 2 of Bueno et al. 2017. The paper gives pictures and trends. The positions of the droplet that are asked for come
from an independent solver of the same scene (docs/reference_numbers.md, docs/tensotaxis_pull_reference.csv). So do the
ranges of ridge, dimple and far field of the wall before the load (5 to 6e-3, -2.5 to -3e-3, about -3.5e-4, here with
+- 1e-5). The trends are the paper's: the droplet runs to a load that pulls and is trapped there, it runs away from a
load that pushes, ever more slowly, and it stays in its place where nu = 0.

time.tolerance is halved twice, and a run with small steps shows how far X_c is then off. This error must fall and stay
below the 0.006 that are allowed for X_c. A mirrored load must give the mirrored motion. What Newton's method leaves is
not mirrored, and it decides on the steps, so that with default tolerances the two motions differ as the errors of the
steps do. With a small solver.newton.rtol they must be the same. These two runs may take more iterations in a step: one that needs
nearly solver.newton.max makes the next step shorter, and whether it is 8 or 9 of 10 is decided by the round-off of linear solves, which
is not mirrored either. In each run at most one step in a hundred may fail in Newton's method."""

import _measure
import numpy

MINUTES = {"quick": 0.2, "full": 8}
MIRROR = ["load[0].box=[[0.2,0],[0.3,0.125]]", "load[0].force=[-0.16215,0]"]
SMALL = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "load[0].start=2", "load[0].ramp=1", "time.end=10",
         "output.fields.times=[0,10]", "solver.newton.rtol=1e-11", "solver.newton.atol=1e-14", "solver.krylov.rtol=1e-4"]
PULL = "tensotaxis_pull_2d"
EXACT = ["solver.newton.rtol=1e-8", "solver.newton.max=30"]
HALVED = {"pull": "2e-3 (default)", "half": "1e-3", "quarter": "5e-4", "fine": "5e-5"}


def study(lab):
    if lab.quick:
        start = lab.run("pull to t = 50", PULL, ["time.end=50", "output.fields.times=[0,50]"])
        beginning(lab, start)
        mirrored(lab, lab.run("right", PULL, SMALL), lab.run("left", PULL, SMALL + MIRROR), "small tolerances", 1e-9)
        return
    runs = lab.runs({"pull": (PULL, []), "half": (PULL, ["time.tolerance=1e-3"]), "quarter": (PULL, ["time.tolerance=5e-4"]),
                     "fine": (PULL, ["time.tolerance=5e-5", "solver.newton.rtol=1e-6"]),
                     "push": ("tensotaxis_push_2d", []), "nu = 0": (PULL, ["substrate.poisson=0"]),
                     "mirror": (PULL, MIRROR), "right": (PULL, EXACT), "left": (PULL, EXACT + MIRROR)}, limit=3000)
    beginning(lab, runs["pull"])
    whole_pull(lab, runs["pull"])
    convergence(lab, runs)
    push(lab, runs["push"])
    away = numpy.nanmax(numpy.abs(runs["nu = 0"].history["x_centre"] - 0.5))
    lab.expect("nu = 0: largest |X_c - 0.5|", "<= 0.01", f"{away:.4f}", away <= 0.01)
    mirrored(lab, runs["pull"], runs["mirror"], "default tolerances", 0.006)
    mirrored(lab, runs["right"], runs["left"], EXACT[0], 1e-6)
    counts = [run.record["counts"] for run in runs.values()]
    refused = max(each["rejected_by_newton"] / each["steps"] for each in counts)
    lab.expect("steps that Newton's method refuses, largest share in a run", "<= 1 %", f"{100 * refused:.1f} %", refused <= 0.01)
    angles(lab, runs["pull"])


def beginning(lab, run):
    """The first 50 and the wall before the load."""
    found = numpy.interp(50, run.history["t"], run.history["x_centre"])
    lab.expect("X_c at t = 50", "0.5048 +- 0.001", f"{found:.4f}", abs(found - 0.5048) <= 0.001)
    wall = _measure.interface(run.folder, first=True)["displacement_y"]
    for what, value, low, high in (("ridge", wall.max(), 5e-3, 6e-3), ("dimple", wall.min(), -3e-3, -2.5e-3),
                                   ("far field", wall[0], -3.6e-4, -3.4e-4)):
        lab.expect(f"{what} before the load", f"{low:g} to {high:g}", f"{value:.3g}", low <= value <= high)
    drift = numpy.abs(run.history["mass_drift"]).max()
    lab.expect("drift of the mass", "<= 1e-8", f"{drift:.2g}", drift <= 1e-8)


def whole_pull(lab, run):
    time, centre, velocity = (run.history[name] for name in ("t", "x_centre", "velocity"))
    for at, expected in _measure.PULL_CENTRE.items():
        if at == 50:
            continue
        around = numpy.linspace(at - 20, at + 20, 81) if at == 700 else at
        error = numpy.abs(numpy.interp(around, time, centre) - expected).min()
        asked = f"{expected} +- 0.006" + (", +-20 in time" if at == 700 else "")
        lab.expect(f"X_c at t = {at}", asked, f"{numpy.interp(at, time, centre):.4f}, off by {error:.4f}", error <= 0.006)
    loaded = numpy.nonzero(time > 20)[0]
    peak = loaded[numpy.argmax(velocity[loaded])]
    speed, when = velocity[peak], time[peak] - 0.5 * run.history["dt"][peak]
    value, moment = _measure.PULL_PEAK
    lab.expect("peak of V", f"{value} +- 10 %", f"{speed:.3g}", abs(speed / value - 1) <= 0.1)
    lab.expect("its time", f"{moment:g} +- 10 %", f"{when:.0f}", abs(when / moment - 1) <= 0.1)
    end = abs(velocity[-1])
    lab.expect("trapped: |V| at the end", "< 1e-5", f"{end:.2g}", end < 1e-5)


def convergence(lab, runs):
    lab.title("Convergence in time")
    rows = []
    for name, tolerance in HALVED.items():
        history, counts = runs[name].history, runs[name].record["counts"]
        rows.append((tolerance, counts["steps"], counts["newton"], counts["krylov"],
                     *(f"{numpy.interp(at, history['t'], history['x_centre']):.4f}" for at in (471, 700, 1000, 1884)),
                     f"{history['velocity'][history['t'] > 20].max():.3g}"))
    lab.table(("time.tolerance", "steps", "Newton", "Krylov", "X_c(471)", "X_c(700)", "X_c(1000)", "X_c(1884)", "peak of V"),
              rows, "convergence")
    times, fine = numpy.linspace(100, runs["fine"].history["t"][-1], 500), runs["fine"].history
    errors = [numpy.abs(numpy.interp(times, runs[name].history["t"], runs[name].history["x_centre"])
                        - numpy.interp(times, fine["t"], fine["x_centre"])).max() for name in ("pull", "half", "quarter")]
    lab.expect("error of X_c from t = 100 on, against the fine steps, when time.tolerance is halved twice",
               "falls, <= 0.006", ", ".join(f"{e:.4f}" for e in errors),
               errors[0] > errors[1] > errors[2] and errors[0] <= 0.006)
    lab.plot("position", lambda axes: draw(axes, {name: runs[name].history for name in ("pull", "push", "nu = 0")}))


def draw(axes, histories):
    for name, history in histories.items():
        axes.plot(history["t"], history["x_centre"], label=name)
    axes.plot(list(_measure.PULL_CENTRE), list(_measure.PULL_CENTRE.values()), "k.", label="pull, independent solver")
    axes.set(xlabel="t", ylabel="X_c")
    axes.legend()


def push(lab, run):
    time, centre = run.history["t"], run.history["x_centre"]
    sampled = numpy.interp(numpy.arange(0, 7849, 24), time, centre)
    lab.expect("push: moves away from the load", "X_c decreases", f"{sampled[0]:.4f} to {sampled[-1]:.4f}",
               sampled[-1] < sampled[0])
    # Averages over one element of the mesh: the speed wobbles with that period.
    far, seen = numpy.arange(0.499, centre[-1], -1 / 128), time > 0
    crossed = numpy.interp(-far, -numpy.minimum.accumulate(centre[seen]), time[seen])
    trend = 1 / 128 / numpy.diff(crossed)
    lab.expect("push: mean speed from element to element", "falls monotonically", " ".join(f"{v:.2g}" for v in trend),
               (numpy.diff(trend) < 0).all())


def mirrored(lab, right, left, settings, bound):
    a, b = right.history, left.history
    times = numpy.linspace(0, a["t"][-1], 1000)
    error = numpy.abs(numpy.interp(times, a["t"], a["x_centre"]) + numpy.interp(times, b["t"], b["x_centre"]) - 1).max()
    lab.expect(f"mirrored load, {settings}: largest |X_c + X_c' - 1|", f"<= {bound:g}", f"{error:.2g}", error <= bound)
    moved = numpy.nanmax(numpy.abs(a["x_centre"] - 0.5))
    lab.expect(f"mirrored load, {settings}: it moves", "> 1e-4", f"{moved:.2g}", moved > 1e-4)


def angles(lab, run):
    wall = _measure.cap(run.folder, 0, 1 / 64)
    flat = numpy.degrees(numpy.arccos((0.125 - wall["circle"][1]) / wall["radius"]))
    lab.text(f"Apparent angles of `history.csv` are read where the fitted circle meets the height of the contact line: "
             f"{wall['angle']:.1f} degrees before the load. The contact line is on the ridge, {wall['line'][1] - 0.125:.2g} "
             f"above the undeformed wall; at the height of that wall the same circle has {flat:.1f}. An independent solver "
             f"reports 72.2 without saying at which height; the height would explain it, but that is not shown. Read at one "
             f"common height, left and right do not differ: their difference comes from the heights of the contact lines.")


def explicit(lab):
    """The mirrored load at the temperature 0.7 on 32 x 16 elements, to t = 1.5 of a load that is twelve times larger.
    The whole pull takes hundreds of thousands of steps of rkl2 on 64 x 32 elements, and many times more of the
    others."""
    words = [word for word in SMALL if not word.startswith(("time.end", "load[0].start", "output"))]
    words += ["fluid.temperature=0.7", "droplet[0].radius=0.22", "load[0].start=0.3", "time.end=1.5", "output.fields.times=[]",
              "time.dt_initial=0.001", "time.dt_max=0.001"]  # the same steps for both, shorter than the bound
    right = lab.run("right", PULL, [*words, "load[0].force=[2,0]"])
    mirrored(lab, right, lab.run("left", PULL, [*words, *MIRROR[:1], "load[0].force=[-2,0]"]), "equal steps", 1e-9)
