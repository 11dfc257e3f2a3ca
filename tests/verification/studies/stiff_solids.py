"""The energy of stiff solids that swing freely, with steps of kick_drift that follow a bound which swings with them.

Nothing feeds these solids, so that their energy cannot rise. The bound of the steps follows the strain, and swings with the waves.
Steps that swing with them feed the shortest waves: the energy then grows by a factor of hundreds. So steps shorten at once and lengthen
late and slowly (`src/time/explicit/held_rate.hpp`). What the control of the error asks for swings too, and counts like a bound.

Twenty scenes are sampled: rectangles, solids around an axis of symmetry, and blocks; of both materials of finite strain, with Poisson's
ratios up to 0.49, most with fibres up to 3000 times as stiff as the material or with a tense face, or with both; with corrected or with
lumped masses. They start bent and at rest, and go on for thousands of steps.

The energy of the tables has consistent masses. The masses of the steps are at least as large, so that it is below the energy that the steps
keep, and touches it where nothing moves, as at the start. Steps near their limit keep that up to a few percent.

Asked: no energy beyond 1.05 of the first, no refused step, no event about the energy. With steps of one length, 0.8 of the shortest
one of the same run, the same holds."""

import numpy
from _case import case

MINUTES = {"quick": 0.2, "full": 3}
EXPLICIT = "is about the explicit schemes"
SCENES, STEPS, ALLOWED = 20, 5000, 1.05


def sampled(number):
    """A scene, always the same for its number: (text of the case, cells of the table)."""
    dice = numpy.random.default_rng(5100 + number)

    def between(low, high):
        return round(float(dice.uniform(low, high)), 3)

    def tenfold(low, high):
        return float(f"{10 ** dice.uniform(low, high):.3g}")

    shape = ("plane", "plane", "axis", "space")[number % 4]
    up = int(dice.integers(3, 7))
    wide = int(dice.integers(2, 4)) * up if shape != "space" else up + 1
    elements, size = [wide, up], [round(0.25 * wide / up, 4), 0.25]
    if shape == "space":
        elements, size = [wide, 3, min(up, 4)], [0.4, 0.3, 0.25]
    solid = dict(thickness=0.25, young=1.0, poisson=float(dice.choice([0.0, 0.3, 0.45, 0.49])),
                 material=str(dice.choice(["neo_hookean", "saint_venant_kirchhoff"])))
    kind = number % 5
    if kind in (0, 1, 3):
        solid["fibre"] = dict(stiffness=tenfold(1, 3.5), angle=between(0, 90))
    if kind in (2, 3):
        solid["surface_tension"] = tenfold(-1, 1.3)
    sides = str(dice.choice(["periodic", "clamped", "slip"] + ["free"] * ("surface_tension" not in solid)))
    stiffer = 1 + 4 * solid.get("fibre", {}).get("stiffness", 0) + 16 * solid.get("surface_tension", 0)
    bend = float(f"{min(0.004, tenfold(-2.5, -1.6) / stiffer**0.5):.3g}")  # whose energy the material can take
    mass = str(dice.choice(["corrected", "lumped"]))
    if shape == "axis":
        sides = "slip" if sides == "periodic" else sides
    k = f"pi*x/{size[0]}"
    waves = [f"{bend}*sin(2*{k})*y/0.25", f"{bend}*cos({2 if sides == 'periodic' else 1}*{k})*y/0.25"]
    if sides == "clamped":
        waves[1] = waves[1].replace("cos", "sin")
    if shape == "space":
        waves = [waves[0].replace("y/", "z/"), f"{bend}*sin(pi*y/0.3)*z/0.25", waves[1].replace("y/", "z/")]
    boundary = dict(left=sides, right=sides, bottom="clamped", top="free")
    if shape == "axis":
        del boundary["left"]
        waves[0] = waves[0].replace("2*", "1*", 1)
    if shape == "space":
        boundary.update(front="slip", back="slip")
    text = case("Sampled.", f"stiff_{number}", domain=dict(size=size, elements=elements, **(
        {"coordinates": "axisymmetric"} if shape == "axis" else {})), substrate=solid, initial=dict(displacement=waves), boundary=boundary,
                time=dict(scheme="kick_drift", mass=mass, end=1000.0, max_steps=STEPS),
                output=dict(fields=dict(times=[]), history=dict(every=1)))
    fibre = solid.get("fibre", dict(stiffness=0, angle=0))
    return text, (number, shape, " x ".join(map(str, elements)), solid["material"], solid["poisson"], fibre["stiffness"], fibre["angle"],
                  solid.get("surface_tension", 0), sides, mass, bend)


def judged(lab, label, run):
    """@return largest energy over the first, the shortest and the longest step behind the second and before the last
    one"""
    rows = run.history
    most, steps = float(rows["energy_total"].max() / rows["energy_total"][0]), rows["dt"][2:-1]
    lab.expect(f"{label}: largest energy over the first", f"<= {ALLOWED}", f"{most:.4f}", most <= ALLOWED)
    refused = run.record["counts"]["rejected_by_newton"]
    lab.expect(f"{label}: refused steps", "none", str(refused), refused == 0)
    told = [event["what"] for event in run.record["events"] if "energy" in event["what"]]
    lab.expect(f"{label}: events about the energy", "none", "; ".join(told) or "none", not told)
    return most, steps.min(), steps.max()


def study(lab):
    numbers = range(0, SCENES, 5) if lab.quick else range(SCENES)
    fewer = ["time.max_steps=1500"] if lab.quick else []
    texts = {number: sampled(number) for number in numbers}
    runs = lab.runs({f"scene {number}": (text, fewer) for number, (text, _) in texts.items()})
    rows, even = [], {}
    for number, (text, cells) in texts.items():
        most, short, long = judged(lab, f"scene {number}", runs[f"scene {number}"])
        rows.append([*cells, f"{short:.3g}", f"{long:.3g}", f"{most:.4f}"])
        even[f"scene {number}, steps of one length"] = (text, [*fewer, f"time.dt_initial={0.8 * short:.6g}", f"time.dt_max={0.8 * short:.6g}"])
    for row, (label, run) in zip(rows, lab.runs(even).items()):
        row.append(f"{judged(lab, label, run)[0]:.4f}")
    lab.title("Scenes")
    lab.text("Fibres and tension in units of the modulus; the bend is the amplitude of the displacement at the start.")
    lab.table(("scene", "shape", "elements", "material", "Poisson", "fibres", "angle", "tension", "sides", "masses", "bend", "shortest step",
               "longest step", "largest energy over the first", "with steps of one length"), rows, "scenes")
