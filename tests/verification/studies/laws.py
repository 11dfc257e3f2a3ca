"""Conservation laws step by step.

Mass: summed over all test functions, the fluxes of the mass equation cancel exactly. So every step conserves mass to
round-off if Newton's method is solved tightly. This is shown on a fixed mesh, on a moving mesh, and without walls.

Momentum: a droplet in a periodic box. The capillary force (w, rho grad mu) keeps the momentum for constant w only where
rho grad mu = - div Sigma holds pointwise, so the momentum drifts by an error of the mesh. (The unit test
tests/unit/scene/test_divergence_form.cpp compares the force with the force of the stress, (grad w, Sigma), which keeps it.) Inertia is
discretised in the convective form, which does not conserve momentum exactly either. The drift is the change of the momentum. For a droplet at rest it is given as a part of its mass
times the largest speed seen, for a moving droplet as a part of its momentum.

Energy: a stretched droplet on a rigid wall comes to rest. With the wall-energy law the energy lost is the dissipation;
the trapezoidal sum over the steps misses it by the error of the time scheme, which is of order 2. (The study
energy_balance does this on a soft wall.) It is looked at from t = 0.25 to 0.5, while the droplet still moves. It starts with the profile of
the equation of state and is nearly at rest at t = 1: from there to t = 2 it dissipates a sixtieth of what it does in that quarter, and what
higher orders of the steps leave of so little hides the rest. With the steps here the rest is within a tenth of its limit.

Uniform flow: solid and liquid without pressure translate along x between periodic sides. The mesh of the fluid follows
the wall and is sheared more and more; density and velocity must stay as they are."""

import _measure
import numpy
from _case import case, sides

MINUTES = {"quick": 0.2, "full": 0.6}
TIGHT = ["solver.newton.rtol=1e-11", "solver.newton.atol=1e-12", "solver.krylov.rtol=1e-4"]
MOVING = dict(field="velocity_x", amplitude=0.05, mode=[0, 0])
UNIFORM = case("Solid and liquid in uniform motion. At this density the pressure is 0: r (1 - r) = 8 theta / 27.",
               "uniform",
               domain=dict(size=[1.0, 0.5], elements=[16, 8]),
               fluid=dict(viscosity="1/256", capillarity="1/16", temperature=0.39, ambient="liquid",
                          initial=[0.00135, 0.8666666666666667]),
               substrate=dict(thickness=0.125, young=0.7554, poisson=0.45),
               wave=[MOVING],
               boundary=sides("slip", left="periodic", right="periodic"),
               time=dict(end=10.0, dt_initial=0.25, dt_max=0.25, tolerance=1e6))


def free(*waves):
    return case("A droplet between periodic sides: no wall.", "periodic_droplet",
                domain=dict(size=[1.0, 1.0], elements=[32, 32]),
                fluid=dict(viscosity="1/256", capillarity="1/16", temperature=0.39),
                droplet=[dict(centre=[0.513, 0.477], radius=0.25)],
                wave=list(waves),
                boundary=sides("periodic"),
                time=dict(end=1.0, dt_max=0.05, tolerance=1e6))


def mass(lab, *more):
    """@param more  settings of all runs"""
    pull = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "load[0].start=1", "load[0].ramp=1", "time.end=3",
            "output.fields.times=[]", *TIGHT]
    rigid = ["domain.elements=[32,16]", "fluid.capillarity=1/16", "time.end=10", "output.fields.times=[]", *TIGHT]
    runs = lab.runs({"fixed mesh": ("static_droplet_rigid_2d", rigid + [*more]),
                     "moving mesh": ("tensotaxis_pull_2d", pull + [*more]), "no wall": (free(), TIGHT + [*more])})
    for label, run in runs.items():
        value = run.history["mass"]
        step = numpy.abs(numpy.diff(value)).max() / value[0]
        lab.expect(f"mass, {label}: largest relative change in a step of {len(value) - 1}", "<= 1e-12", f"{step:.1e}", step <= 1e-12)


def momentum(lab):
    meshes, starts = ((24,), ("at rest",)) if lab.quick else ((24, 32, 48), ("at rest", "moving"))
    texts = {"at rest": free(), "moving": free(MOVING)}
    wanted = {(start, n): (texts[start], [f"domain.elements=[{n},{n}]", *TIGHT]) for start in starts for n in meshes}
    runs = lab.runs({", ".join(map(str, key)): value for key, value in wanted.items()}, limit=1500)
    rows, drift = [], {}
    for key in wanted:
        rows_of = runs[", ".join(map(str, key))].history
        size = rows_of["momentum_x"][0] if key[0] == "moving" else rows_of["mass"][0] * rows_of["speed_max_fluid"].max()
        drift[key] = numpy.abs(rows_of["momentum_x"] - rows_of["momentum_x"][0]).max() / abs(size)
    for start in starts:
        rows.append((start, *(f"{drift[start, n]:.1e}" for n in meshes)))
        last, bound = drift[start, meshes[-1]], 1e-2 if lab.quick else 1e-3
        lab.expect(f"momentum, {start}: drift at {meshes[-1]} x {meshes[-1]}", f"<= {bound:g}", f"{last:.1e}", last <= bound)
    lab.title("Drift of the momentum up to t = 1")
    lab.table(("droplet", *(f"{n} x {n}" for n in meshes)), rows, "momentum")


def energy(lab):
    steps = (0.02, 0.01, 0.005) if lab.quick else (0.01, 0.005, 0.0025, 0.00125)
    meshes = ("32,16",) if lab.quick else ("32,16", "64,32")
    base = ["fluid.capillarity=1/16", "fluid.wall_law=energy", "time.tolerance=1e6", *TIGHT, "droplet[0].stretch=[1.15,0.9]",
            "time.end=0.5", "output.fields.times=[]"]
    rows, rests = [], []
    for mesh in meshes:
        runs = lab.runs({f"{mesh}, dt = {dt}": ("static_droplet_rigid_2d", [
            *base, f"domain.elements=[{mesh}]", f"time.dt_initial={dt}", f"time.dt_max={dt}"]) for dt in steps})
        parts = [_measure.balance_error(run.folder, 0.25, 0.5) for run in runs.values()]
        order, rest = _measure.falls(parts)
        rests.append(rest)
        rows.append((mesh, *(f"{part:.2e}" for part in parts), f"{order:.2f}", f"{rest:.1e}"))
        lab.expect(f"energy, rigid wall, {mesh}: order in dt of what the balance leaves open, less its rest", "2 +- 0.3",
                   f"{order:.2f}", abs(order - 2) <= 0.3)
    if not lab.quick:
        lab.expect("energy, rigid wall: the rest falls with the mesh", "<= 1/4", f"{rests[1] / rests[0]:.2g}",
                   abs(rests[1]) <= rests[0] / 4)
    lab.title("Balance of the energy from t = 0.25 to 0.5")
    lab.text("Sum of what the steps leave open as a part of the dissipation; wall-energy law, rigid wall. The rest is what no "
             "step removes.")
    lab.table(("mesh", *(f"dt = {dt}" for dt in steps), "order", "rest at dt = 0"), rows, "energy")


def uniform(lab):
    run = lab.run("uniform flow", UNIFORM, TIGHT)
    rows = run.history
    spread = (rows["rho_max"] - rows["rho_min"]).max() / rows["rho_max"][0]
    lab.expect("uniform flow on a sheared mesh: spread of the density", "<= 1e-10", f"{spread:.1e}", spread <= 1e-10)
    for part in ("fluid", "solid"):
        speed = numpy.abs(rows[f"speed_max_{part}"] / 0.05 - 1).max()
        lab.expect(f"uniform flow: change of the largest speed, {part}", "<= 1e-7", f"{speed:.1e}", speed <= 1e-7)


def study(lab):
    mass(lab)
    momentum(lab)
    energy(lab)
    uniform(lab)


def explicit(lab):
    """Mass, momentum of a droplet at rest, and uniform flow at the temperature 0.85 (uniform flow: 0.39, without
    vapour); the energy of the droplet on a rigid wall falls in every step."""
    mass(lab, "fluid.temperature=0.85")
    rows = lab.run("at rest", free(), ["domain.elements=[32,32]", "fluid.temperature=0.85"]).history
    drift = numpy.abs(rows["momentum_x"]).max() / (rows["mass"][0] * rows["speed_max_fluid"].max())
    lab.expect("momentum, at rest: drift at 32 x 32", "<= 0.001", f"{drift:.1e}", drift <= 1e-3)
    rows = lab.run("stretched", "static_droplet_rigid_2d", [
        "domain.elements=[32,16]", "fluid.capillarity=1/16", "fluid.wall_law=energy", "fluid.temperature=0.85",
        "droplet[0].stretch=[1.15,0.9]", "time.end=2", "output.fields.times=[]"]).history
    rise = numpy.diff(rows["energy_total"]).max()
    lost = rows["energy_total"][0] - rows["energy_total"][-1]
    lab.expect("energy, rigid wall: largest change over a step", "<= 0", f"{rise:.1e} of {lost:.2g} lost", rise <= 0)
    uniform(lab)
