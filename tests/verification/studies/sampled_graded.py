"""Sampled pulls and pushes on graded elements against equal ones: the path of the droplet.

The scenes of [sampled_pulls](sampled_pulls.md), on 128 x 64 elements with the capillarity of Fig. 2: contact angle, layer, stiffness,
Poisson ratio, size of the droplet, and place, width and force of the load are sampled from the seed that names a scene. The load of an
even seed pulls the droplet towards itself, that of an odd one pushes it away. Each scene starts at rest, ends at t = 800, and is computed
on equal elements and with domain.grading.fine = "automatic", which was chosen on other scenes.

Path: largest difference of X_c(t) - X_c(0) to equal elements, over the range of X_c there. Peak: that of the largest mean speed in 5 units
of time. The steps of time are small (time.tolerance 5e-4), for else their error would hide that of the mesh. What the two meshes differ by with default
steps is in the table as well: there both runs have the errors of their steps, which are up to 1 % of a path."""

import itertools

from _sampled import FIRST, PULL, at_rest, errors, sampled, settings, work

MINUTES = {"quick": 0.2, "full": 20}
EXPLICIT = "takes hundreds of units of time at the temperature 0.39: millions of explicit steps"
MESHES = {"equal": ["domain.grading.fine=everywhere"], "graded": ["domain.grading.fine=automatic"]}
STEPS = {"small": ["time.tolerance=5e-4"], "default": []}
PATH, PEAK = 0.5, 1  # %


def scene_of(seed):
    scene = sampled(seed)
    return {**scene, "force": scene["force"] * (-1 if seed % 2 else 1)}


def study(lab):
    elements, count, end = (64, 2, 40) if lab.quick else (128, 12, 800)
    seeds = list(itertools.islice((seed for seed in itertools.count(FIRST) if at_rest(lab, seed, elements)), count))
    scenes = {seed: scene_of(seed) for seed in seeds}
    runs = {(seed, mesh, steps): lab.run(f"{seed}, {mesh}, {steps} steps", PULL,
                                         [*settings(scene, elements), f"time.end={end}", *MESHES[mesh], *STEPS[steps]], limit=3600)
            for seed, scene in scenes.items() for steps in STEPS for mesh in MESHES}
    found = {(seed, steps): errors(runs[seed, "graded", steps], runs[seed, "equal", steps]) for seed in seeds for steps in STEPS}
    for number, what, bound in ((0, "path", PATH), (1, "largest speed", PEAK)):
        worst = max(abs(found[seed, "small"][number]) for seed in seeds)
        lab.expect(f"{what}: largest difference between graded and equal elements, %", f"<= {bound}", f"{worst:.2g}", worst <= bound)
    share = max(solved(runs[seed, "graded", "small"]) / solved(runs[seed, "equal", "small"]) for seed in seeds)
    lab.expect("unknowns over those of equal elements, largest of the scenes", "<= 0.8", f"{share:.2f}", share <= 0.8)
    for steps in STEPS:
        ratio = sum(work(runs[seed, "graded", steps]) for seed in seeds) / sum(work(runs[seed, "equal", steps]) for seed in seeds)
        lab.expect(f"iterations times unknowns over those of equal elements, {steps} steps", "<= 0.8", f"{ratio:.2f}", ratio <= 0.8)
    lab.title("Each scene")
    lab.text("Seconds are processor time of one core, equal and graded elements with default steps.")
    lab.table(("seed", "load", "way", "unknowns left", "path %", "peak %", "path %, default steps", "steps, default", "seconds, default"),
              [row(seed, runs, found) for seed in seeds], "paths")
    lab.title("Scenes")
    file = lab.numbers(("seed", *scenes[seeds[0]]), [(seed, *scene.values()) for seed, scene in scenes.items()], "scenes")
    lab.text(f"What each seed gives is in [{file}]({file}).")


def solved(run):
    return run.record["unknowns"]["solved"]


def row(seed, runs, found):
    equal, graded = (runs[seed, mesh, "default"] for mesh in MESHES)
    centre = runs[seed, "equal", "small"].history["x_centre"]
    return (seed, "pushes" if seed % 2 else "pulls", float(f"{max(centre) - min(centre):.2g}"), f"{100 * solved(graded) / solved(equal):.0f} %",
            *(float(f"{error:.2g}") for error in found[seed, "small"]), float(f"{found[seed, 'default'][0]:.2g}"),
            "{}, {}".format(*(run.record["counts"]["steps"] for run in (equal, graded))),
            "{:.1f}, {:.1f}".format(*(run.processor_seconds for run in (equal, graded))))
