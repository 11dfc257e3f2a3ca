"""Ripple of a droplet's speed with the period of an element, and the force below which the mesh holds it.

A droplet that moves along a mesh meets each element alike, so its speed ripples with the period of one. Part of that was how the contact
line is read. A spline swings about the interface that it resolves, so a single point of it is now ahead, now behind; the mean over
elements that history.csv takes has a tenth of that (tests/unit/observe/core/test_crossings.cpp). What remains is motion: the momentum
of the fluid, an integral, ripples as much.

Two scenes: the pull of Fig. 2 between t = 450 and 950 against a polynomial of degree 12, and a droplet on a rigid wall under a horizontal
gravity of 1e-3 between t = 100 and 500 against one of degree 3. Steps are short, so that each element is met by ten or more. Ripple:
root of the mean square, and largest value, of the difference over the polynomial, in per cent.

Last, gravities so small that the mesh decides: the droplet stops, or creeps on."""

import numpy

MINUTES = {"quick": 0.2, "full": 7}
EXPLICIT = "takes hundreds of units of time at the temperature 0.39: millions of explicit steps"
QUIET = ["output.fields.times=[]"]
PULL = [*QUIET, "time.end=960", "time.dt_max=2"]
RIGID = [*QUIET, "fluid.capillarity=1/32", "fluid.wall_law=energy"]
MESHES = {1: (32, 16), 1.5: (48, 24), 2: (64, 32), 2.5: (80, 40), 3: (96, 48)}  # elements to the capillarity 1/32
PULLS = {  # elements to the capillarity, settings
    "128 x 64": (2, []),
    "128 x 64, domain.quadrature = \"reduced\"": (2, ["domain.quadrature=reduced"]),
    "128 x 64, fluid.traction = \"blended\"": (2, ["fluid.traction=blended"]),
    "128 x 64, fluid.stabilisation = 0.02": (2, ["fluid.stabilisation=0.02"]),
    "160 x 80": (2.5, ["domain.elements=[160,80]"]),
    "192 x 96": (3, ["domain.elements=[192,96]"])}
FORESEEN = 0.013  # src/foresight/measured.hpp: with two elements to the capillarity; it falls with the fourth power


def ripple(time, values, first, last, degree):
    """(root of the mean square, largest value) of the difference to a polynomial, over it, in per cent."""
    seen = (time > first) & (time < last)
    place = (2 * time[seen] - first - last) / (last - first)
    polynomial = numpy.polynomial.chebyshev.Chebyshev.fit(place, values[seen], degree, domain=[-1, 1])
    rest = 100 * (values[seen] / polynomial(place) - 1)
    return float(numpy.sqrt(numpy.mean(rest**2))), float(numpy.abs(rest).max())


def ripples(run, *window):
    """Those of the speed, which belongs to the middle of its step, and of the momentum."""
    rows = run.history
    return ripple(rows["t"] - 0.5 * rows["dt"], rows["velocity"], *window), ripple(rows["t"], rows["momentum_x"], *window)


def foreseen(across):
    return FORESEEN * (2 / across)**4


def rigid(elements, gravity, end, longest):
    return "static_droplet_rigid_2d", [*RIGID, "domain.elements=[{},{}]".format(*elements), f"fluid.gravity=[{gravity},0]",
                                       f"time.end={end}", f"time.dt_max={longest}"]


def rigid_walls(lab):
    across = (2,) if lab.quick else tuple(MESHES)
    runs = lab.runs({f"rigid wall, {m} elements to the capillarity": rigid(MESHES[m], 1e-3, 500, 4) for m in across})
    rows = []
    for m, run in zip(across, runs.values()):
        speed, momentum = ripples(run, 100, 500, 3)
        rows.append((m, *(f"{value:.2f}" for value in (*speed, *momentum)), f"{100 * foreseen(m):.2f}"))
        if m == 2:
            lab.expect("rigid wall, two elements to the capillarity: ripple of the speed (rms)", "<= 1.1 %; a single point: 2.4 %",
                       f"{speed[0]:.2f} %", speed[0] <= 1.1)
            lab.expect("it equals the ripple of the momentum", "+- 0.1 %", f"{momentum[0]:.2f} %", abs(speed[0] - momentum[0]) <= 0.1)
    lab.title("On a rigid wall")
    lab.text("In per cent. The last column is what `softwet check` foresees: 1.3 % (2 h / gamma)^4, with the length h of an element, from the "
             "pull on 128 x 64 elements. With one element to the capillarity the droplet lurches from element to element.")
    lab.table(("elements to the capillarity", "speed, rms", "speed, largest", "momentum, rms", "momentum, largest", "foreseen"),
              rows, "rigid")


def pulls(lab):
    runs = {name: lab.run(name, "tensotaxis_pull_2d", [*PULL, *settings]) for name, (_, settings) in PULLS.items()}
    rows, found = [], {}
    for name, run in runs.items():
        speed, momentum = ripples(run, 450, 950, 12)
        seen = (run.history["t"] > 450) & (run.history["t"] < 950)
        wobbles = []
        for column in ("angle_left", "angle_right", "ridge_left", "ridge_right"):
            values, time = run.history[column][seen], (run.history["t"][seen] - 700) / 250
            rest = values - numpy.polynomial.chebyshev.Chebyshev.fit(time, values, 12, domain=[-1, 1])(time)
            wobbles.append(rest.std() if column.startswith("angle") else 100 * rest.std() / values.mean())
        found[name] = speed[0]
        rows.append((name.replace(",", ";"), *(f"{value:.2f}" for value in (*speed, *momentum)),
                     *(f"{max(pair):.2g}" for pair in (wobbles[:2], wobbles[2:])), run.record["unknowns"]["solved"],
                     run.record["counts"]["krylov"], f"{run.processor_seconds:.0f}"))
    for name, (across, settings) in PULLS.items():
        if settings and "elements" not in settings[0]:
            continue
        share = found[name] / (100 * foreseen(across))
        lab.expect(f"pull, {name}: ripple of the speed (rms) over what check foresees", "0.7 to 1.3", f"{share:.2f}",
                   0.7 <= share <= 1.3)
    lab.title("In the pull of Fig. 2")
    lab.text("Ripples in per cent, except of the angles, in degrees. No other setting on the same elements halves the ripple of the "
             "speed; fewer points of integration raise it, so it does not come from them. Elements of 0.4 capillarities have 0.4 of it at "
             "1.5 times the cost. Angles and ridges ripple with the elements too.")
    lab.table(("elements and settings", "speed, rms", "speed, largest", "momentum, rms", "momentum, largest", "angles, rms",
               "ridges, rms", "unknowns", "GMRES iterations", "seconds of a processor"), rows, "pull")


def slopes(lab):
    scenes = {(2, 4e-6): 30000, (2, 1e-5): 20000}
    if not lab.quick:
        scenes |= {(2, 1e-6): 60000, (2, 1e-4): 2000, (3, 1e-6): 60000}
    runs = lab.runs({f"gravity {gravity:g}, {m} elements to the capillarity": rigid(MESHES[m], gravity, end, 200)
                     for (m, gravity), end in scenes.items()})
    rows = []
    for (m, gravity), run in zip(scenes, runs.values()):
        time, centre, speed = (run.history[name] for name in ("t", "x_centre", "velocity"))
        late = time > 0.5 * time[-1]
        way = (centre[-1] - centre[0]) * MESHES[m][0]
        rows.append((f"{gravity:g}", m, f"{way:.2f}", f"{speed[late].min():.2g}", f"{speed[late].max():.2g}"))
        if (m, gravity) == (2, 4e-6):
            lab.expect("gravity 4e-6, two elements to the capillarity: the mesh holds the droplet, way in elements", "< 0.5",
                       f"{way:.2f}", way < 0.5)
        if (m, gravity) == (2, 1e-5):
            lab.expect("gravity 1e-5: it creeps on, smallest speed of the second half", "> 5e-7", f"{speed[late].min():.2g}",
                       speed[late].min() > 5e-7)
    lab.title("Held by the mesh")
    lab.text("Way in elements, and smallest and largest speed in the second half of the run. Without the mesh the speed would be 0.14 times the "
             "gravity, as at 1e-4.")
    lab.table(("gravity", "elements to the capillarity", "way", "smallest speed", "largest speed"), rows, "held")


def study(lab):
    rigid_walls(lab)
    if not lab.quick:
        pulls(lab)
    slopes(lab)
