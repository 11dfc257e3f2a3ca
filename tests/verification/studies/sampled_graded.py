"""Sampled pulls and pushes on graded elements against equal ones: the path of the droplet.

The scenes of [sampled_pulls](sampled_pulls.md): contact angle, layer, stiffness, Poisson ratio, size of the droplet, and place, width and
force of the load are sampled from the seed that names a scene. The load of an even seed pulls the droplet towards itself, that of an odd
one pushes it away. Each scene starts at rest and is computed on equal elements and with domain.grading.fine = "automatic", whose box was
chosen on other scenes: twelve on 64 x 32 elements to t = 800, and some of them on the mesh of Fig. 2, 128 x 64 elements with half of the
capillarity, to t = 400, where grading leaves fewer elements.

Path: largest difference of X_c(t) - X_c(0) to equal elements, over the range of X_c there. Peak: that of the largest mean speed in 5 units
of time. The steps of time are small (time.tolerance 5e-4), for else their error would hide that of the mesh. By what the two meshes differ
with default steps is in the table too: there both runs have the errors of their steps, which are up to 1 % of a path."""

import itertools

from _sampled import EQUAL, FIRST, GRADED, PULL, at_rest, errors, sampled, settings, work

MINUTES = {"quick": 0.2, "full": 5}
EXPLICIT = "takes hundreds of units of time at the temperature 0.39: millions of explicit steps"
MESHES = {"equal": [EQUAL], "graded": [GRADED]}
STEPS = {"small": ["time.tolerance=5e-4"], "default": []}
PATH, PEAK = 0.5, 1  # %
SHARE = {64: 0.8, 128: 0.6}  # elements along the wall: largest share of the unknowns


def scene_of(seed):
    scene = sampled(seed)
    return {**scene, "force": scene["force"] * (-1 if seed % 2 else 1)}


def study(lab):
    if lab.quick:
        return compare(lab, 64, 2, 40, STEPS)
    compare(lab, 64, 12, 800, STEPS)
    compare(lab, 128, 4, 400, ("small",))


def compare(lab, elements, count, end, steps_of_runs):
    """@param elements  along the wall;  @param count  scenes;  @param end  their last time;  @param steps_of_runs  names in STEPS"""
    seeds = list(itertools.islice((seed for seed in itertools.count(FIRST) if at_rest(lab, seed, elements, f"{elements}, ")), count))
    runs = {(seed, mesh, steps): lab.run(f"{elements}, {seed}, {mesh}, {steps} steps", PULL,
                                         [*settings(scene_of(seed), elements), f"time.end={end}", *MESHES[mesh], *STEPS[steps]], limit=3600)
            for seed in seeds for steps in steps_of_runs for mesh in MESHES}
    found = {(seed, steps): errors(runs[seed, "graded", steps], runs[seed, "equal", steps]) for seed in seeds for steps in steps_of_runs}
    name = f"{elements} x {elements // 2}"
    for number, what, bound in ((0, "path", PATH), (1, "largest speed", PEAK)):
        worst = max(abs(found[seed, "small"][number]) for seed in seeds)
        lab.expect(f"{name}: {what}, largest difference between graded and equal elements, %", f"<= {bound}", f"{worst:.2g}", worst <= bound)
    told = sum(any("fine elements" in str(event) for event in runs[seed, "graded", "small"].record.get("events", [])) for seed in seeds)
    lab.expect(f"{name}: droplets that come near the end of the fine elements", f"0 of {len(seeds)}", told, told == 0)
    share, allowed = max(solved(runs[seed, "graded", "small"]) / solved(runs[seed, "equal", "small"]) for seed in seeds), SHARE[elements]
    lab.expect(f"{name}: unknowns over those of equal elements, largest of the scenes", f"<= {allowed}", f"{share:.2f}", share <= allowed)
    work_of = {mesh: sum(work(runs[seed, mesh, "small"]) for seed in seeds) for mesh in MESHES}
    ratio = work_of["graded"] / work_of["equal"]
    lab.expect(f"{name}: iterations times unknowns over those of equal elements", f"<= {allowed}", f"{ratio:.2f}", ratio <= allowed)
    tables(lab, name, elements, seeds, runs, found)


def tables(lab, name, elements, seeds, runs, found):
    with_default = (seeds[0], "default") in found
    lab.title(f"Scenes on {name} elements")
    lab.table(("seed", "load", "way", "unknowns left", "path %", "peak %", *(("path %, default steps",) if with_default else ()), "steps", "Krylov"),
              [row(seed, runs, found) for seed in seeds], f"paths_{elements}")
    scenes = {seed: scene_of(seed) for seed in seeds}
    file = lab.numbers(("seed", *scenes[seeds[0]]), [(seed, *scene.values()) for seed, scene in scenes.items()], f"scenes_{elements}")
    lab.text(f"Steps and iterations of GMRES: equal and graded elements. What each seed gives is in [{file}]({file}).")


def solved(run):
    return run.record["unknowns"]["solved"]


def row(seed, runs, found):
    equal, graded = (runs[seed, mesh, "small"] for mesh in MESHES)
    centre = equal.history["x_centre"]
    return (seed, "pushes" if seed % 2 else "pulls", float(f"{max(centre) - min(centre):.2g}"), f"{100 * solved(graded) / solved(equal):.0f} %",
            *(float(f"{error:.2g}") for error in found[seed, "small"]),
            *(float(f"{found[seed, steps][0]:.2g}") for steps in ("default",) if (seed, steps) in found),
            *("{}, {}".format(*(run.record["counts"][of] for run in (equal, graded))) for of in ("steps", "krylov")))
