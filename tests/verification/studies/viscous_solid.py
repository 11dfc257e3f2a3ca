"""Viscous solid: decay of waves, creep of a column, rigid motion, and the energy balance

The stress of Kelvin and Voigt adds S_v = 2 eta (E' - tr E'/3 1) + zeta tr E' 1 to the elastic one. For small strains a wave e^(s t) of the
wave number k obeys rho s^2 + V k^2 s + C k^2 = 0 exactly: shear waves with V = eta, C = G, pressure waves with V = zeta + 4 eta/3, C =
lambda + 2 G. The measured s is compared with what generalized-alpha makes of the exact one (its recurrence, see elastic_waves), so that the
rest comes from the mesh. Where both roots are real the solid creeps back: each wave then is a sum of two exponentials, which are
found from three consecutive values (Prony).

A column without inertia under its weight from t = 0 creeps with u/u_inf = 1 - e^(-t/tau), tau = (zeta + 4 eta/3)/(lambda + 2 G).

A square that is free on all sides and starts to turn, bent, loses its waves to the viscosity, and then spins on as a rigid body. F = R and
v = w x x have E' = sym(F^T grad v) = 0, so that nothing is dissipated any more, although it goes on turning.

Energy: kinetic + elastic energy of a large wave changes as - dissipation, up to the error of the time scheme."""

import _layer
import _measure
import _shape
import numpy
from _case import case, sides

MINUTES = {"quick": 0.2, "full": 0.5}
YOUNG, POISSON = 0.7554, 0.45
FIRST, SHEAR = _layer.lame(YOUNG, POISSON)
SMALL = 1e-6
EXACT_STEPS = dict(newton=dict(rtol=1e-9, atol=1e-20), krylov=dict(rtol=1e-4))


def box(field, mode, height, **viscosity):
    """A wave between slip sides along x, or between periodic sides under a free top along y."""
    across = mode[0] == 0
    return case("A standing wave in a viscous solid.", "viscous_wave",
                domain=dict(size=[0.25 if across else 0.5, height], elements=[5, 48] if across else [24, 4]),
                substrate=dict(thickness=height, young=YOUNG, poisson=POISSON, **viscosity),
                wave=[dict(field=field, amplitude=SMALL, mode=mode)],
                boundary=dict(left="periodic", right="periodic", bottom="slip", top="free") if across else sides("slip"),
                time=dict(rho_inf=1.0, end=1.0, tolerance=1e6),
                output=dict(fields=dict(select=["displacement"])),
                solver=EXACT_STEPS)


def in_space(**viscosity):
    """A pressure wave along x between slip sides in three dimensions."""
    return case("A standing wave in a viscous solid.", "viscous_wave",
                domain=dict(size=[0.5, 0.125, 0.125], elements=[24, 2, 2]),
                substrate=dict(thickness=0.125, young=YOUNG, poisson=POISSON, **viscosity),
                wave=[dict(field="displacement_x", amplitude=SMALL, mode=[1, 0, 0])],
                boundary=dict(bottom="slip", top="slip"),
                time=dict(rho_inf=1.0, end=1.0, tolerance=1e6),
                output=dict(fields=dict(select=["displacement"])),
                solver=EXACT_STEPS)


def roots(viscous, elastic, k):
    return numpy.roots([1.0, viscous * k**2, elastic * k**2])


# name: (case, viscosity V of the wave, C, k, place in interface.csv)
STIFF = FIRST + 2 * SHEAR
WAVES = {
    "shear, k = 2 pi, eta = 0.01": (box("displacement_x", [0, 1], 0.5, viscosity=0.01), 0.01, SHEAR, 2 * numpy.pi),
    "pressure, k = 2 pi, eta = 0.01": (box("displacement_x", [1, 0], 0.125, viscosity=0.01), 0.04 / 3, STIFF, 2 * numpy.pi),
    "pressure, k = 2 pi, zeta = 0.02": (box("displacement_x", [1, 0], 0.125, bulk_viscosity=0.02), 0.02, STIFF, 2 * numpy.pi),
    "pressure in 3D, k = 2 pi, eta = 0.01": (in_space(viscosity=0.01), 0.04 / 3, STIFF, 2 * numpy.pi),
    "shear, k = 8 pi, eta = 0.05": (box("displacement_x", [0, 1], 0.125, viscosity=0.05), 0.05, SHEAR, 8 * numpy.pi),
}


def steps(dt, count, every=1):
    """Settings for `count` steps of the size dt, with rows of interface.csv for one of `every`, but the last."""
    last = (count - 1) // every
    return [f"time.dt_initial={dt:.17g}", f"time.dt_max={dt:.17g}", f"time.end={count * dt:.17g}",
            f'output.fields.times=["0:{last * every * dt:.17g}:{last + 1}"]']


def motion(run):
    """Times and the displacement u_x of the top at the middle of x."""
    walls = run.output.interface
    place = next(iter(walls.values()))["x_reference"]
    at = numpy.argmin(numpy.abs(place - 0.5 * place.max()))
    middle = [wall["displacement_x"][at] for wall in walls.values()]
    return numpy.array(list(walls)), numpy.array(middle)


def measured(run, exact):
    """The roots of a run that is near the exact ones, without its beginning, when other waves that the start sets off
    on the mesh decay."""
    t, u = motion(run)
    if exact[0].imag:
        s = _shape.damped_wave(t[len(t) // 3:], u[len(t) // 3:], max(exact, key=lambda s: s.imag), drift=False)[0]
        return numpy.array([s, s.conjugate()])
    u = u[3:]
    a, b = numpy.linalg.lstsq(numpy.stack((u[1:-1], u[:-2]), axis=1), u[2:], rcond=None)[0]
    return numpy.log(numpy.roots([1, -a, -b])) / (t[1] - t[0])


def ordered(values):
    return numpy.array(sorted(values, key=lambda s: (s.real, s.imag)), complex)


def told(s):
    return f"{s.real:.7f}" + (f" + {s.imag:.7f} i" if s.imag else "")


def waves(lab):
    wanted, exact = {}, {}
    for name, (text, viscous, elastic, k) in WAVES.items():
        exact[name] = ordered(roots(viscous, elastic, k))
        wanted[name] = (text, steps((2 * numpy.pi / 40 if exact[name][0].imag else 0.05) / abs(exact[name]).max(), 120))
    rows, worst = [], ("", 0.0)
    for name, run in lab.runs(wanted).items():
        dt = run.history["dt"][-2]
        theory = ordered([_measure.scheme(s, dt, 1.0) for s in exact[name]])
        found = ordered(measured(run, exact[name]))
        error = numpy.abs(found - theory).max() / numpy.abs(exact[name]).max()
        rows.append((name, *(told(s[-1]) for s in (exact[name], theory, found)), f"{error:.1e}"))
        worst = max(worst, (name, error), key=lambda pair: pair[1])
    lab.title("Waves")
    lab.text("The root with the largest imaginary part, or the slower one of two that are real. The error is taken of both, as a part of the "
             "larger.")
    lab.table(("wave", "exact s", "exact s under the time scheme", "measured", "error"), rows, "waves")
    lab.expect("largest error of s", "<= 1e-4", f"{worst[1]:.1e}, {worst[0]}", worst[1] <= 1e-4)


# --- creep

COLUMN = case("A column that creeps under its weight.", "creep",
              domain=dict(size=[0.25, 1.0], elements=[4, 8]),
              substrate=dict(thickness=1.0, young=YOUNG, poisson=POISSON, viscosity=0.5, inertia="none"),
              load=[dict(box=[[0.0, 0.0], [0.25, 1.0]], force=[0.0, -1e-5])],
              boundary=dict(bottom="slip", top="free"),
              time=dict(rho_inf=0.5, end=1.0, tolerance=1e6),
              output=dict(fields=dict(times=[0.1, 0.5, 1.0])),
              solver=EXACT_STEPS)


def creep(lab):
    rows, sizes = [], (0.005, 0.0025) if lab.quick else (0.01, 0.005, 0.0025, 0.00125)
    runs = lab.runs({f"column, {strain}, dt = {dt}": (COLUMN, [f"substrate.strain={strain}", f"time.dt_initial={dt}", f"time.dt_max={dt}"])
                     for strain in ("finite", "small") for dt in sizes})
    end = -1e-5 / (2 * STIFF)
    for strain in ("finite", "small"):
        errors = []
        for dt in sizes:
            walls = runs[f"column, {strain}, dt = {dt}"].output.interface
            found = [walls[t]["displacement_y"].mean() / end for t in walls]
            exact = [1 - numpy.exp(-t * STIFF / (0.5 * 4 / 3)) for t in walls]
            errors.append(numpy.abs(numpy.subtract(found, exact)).max())
            rows.append((strain, dt, *(f"{f:.6f} ({e:.6f})" for f, e in zip(found, exact)), f"{errors[-1]:.1e}"))
        lab.expect(f"creep, strain = {strain}, dt = {sizes[-1]}", "within 1e-4", f"{errors[-1]:.1e}", errors[-1] <= 1e-4)
    lab.title("Creep")
    lab.text("Displacement of the top over that at the end, and the exact one, at t = 0.1, 0.5 and 1.")
    lab.table(("strain", "dt", "t = 0.1", "t = 0.5", "t = 1", "largest error"), rows, "creep")


# --- rigid motion

SPIN = case("A square that spins and flies freely. It starts bent and comes to spin as a rigid body.", "spin",
            domain=dict(size=[1.0, 1.0], elements=[6, 6]),
            substrate=dict(thickness=1.0, young=YOUNG, poisson=POISSON, viscosity=0.5),
            wave=[dict(field="velocity_x", amplitude=0.07, mode=[0, 1]), dict(field="velocity_y", amplitude=-0.07, mode=[1, 0]),
                  dict(field="velocity_x", amplitude=0.02, mode=[0, 0])],
            boundary=sides("free"),
            time=dict(rho_inf=1.0, end=12.0, tolerance=1e6, dt_initial=0.02, dt_max=0.02),
            output=dict(fields=dict(times=[12.0])),
            solver=dict(newton=dict(rtol=1e-11, atol=1e-16), krylov=dict(rtol=1e-4)))


def spin(lab):
    run = lab.run("spinning square", SPIN)
    rows = run.history
    left = rows["dissipation_solid"][-1] / rows["dissipation_solid"][0]
    lab.title("Rigid motion")
    place, u = _measure.solid_field(run.folder, 0)
    now, first = (points - points.mean(axis=0) for points in (place + u, place))
    angle = numpy.arctan2((first[:, 0] * now[:, 1] - first[:, 1] * now[:, 0]).sum(), (first * now).sum())
    lab.text(f"At the end the square is turned by {numpy.degrees(angle):.0f} degrees and holds {rows['energy_kinetic'][-1]:.3e} of the "
             f"{rows['energy_kinetic'][0]:.3e} of kinetic energy that it began with.")
    kept = rows["energy_kinetic"][-1] / rows["energy_kinetic"][0]
    lab.expect("it spins on: kinetic energy at the end over that at the start", ">= 0.3", f"{kept:.2f}", kept >= 0.3)
    lab.expect("it is turned: |angle|", ">= 60 degrees", f"{abs(numpy.degrees(angle)):.0f}", abs(angle) >= numpy.pi / 3)
    lab.expect("dissipation at the end over that at the start", "<= 1e-8", f"{left:.1e}", left <= 1e-8)


# --- energy

def balance(lab):
    """A pressure wave and a shear wave that squeeze the solid by a tenth."""
    text = case("Large waves in a viscous solid.", "large_wave",
                domain=dict(size=[1.0, 0.5], elements=[16, 8]),
                substrate=dict(thickness=0.5, young=YOUNG, poisson=POISSON, viscosity=0.02, bulk_viscosity=0.01),
                wave=[dict(field="displacement_x", amplitude=0.03, mode=[1, 0]), dict(field="displacement_y", amplitude=0.03, mode=[2, 1])],
                boundary=sides("slip", top="free"),
                time=dict(rho_inf=1.0, end=1.0, tolerance=1e6),
                solver=dict(newton=dict(rtol=1e-10, atol=1e-15), krylov=dict(rtol=1e-4)))
    sizes, rows = (0.004, 0.002) if lab.quick else (0.008, 0.004, 0.002, 0.001), []
    for material in ("saint_venant_kirchhoff", "neo_hookean"):
        runs = lab.runs({f"{material}, dt = {dt}": (text, [f"substrate.material={material}", f"time.dt_initial={dt}", f"time.dt_max={dt}"])
                         for dt in sizes})
        parts = [_measure.balance_error(run.folder, 0.1, 1) for run in runs.values()]
        last = runs[f"{material}, dt = {sizes[-1]}"].history
        rows.append((material, *(f"{part:.2e}" for part in parts), f"{1 - last['energy_total'][-1] / last['energy_total'][0]:.2f}"))
        lab.expect(f"{material}: open at dt = {sizes[-1]} / at twice that", "<= 1/4 + 10 %", f"{parts[-1] / parts[-2]:.3f}",
                   parts[-1] <= 0.275 * parts[-2])
        differ = numpy.abs(last["dissipation"] - last["dissipation_solid"]).max()
        lab.expect(f"{material}: dissipation, of a solid alone, less dissipation_solid", "0", f"{differ:g}", differ == 0)
    lab.title("Energy")
    lab.text("The imbalance from t = 0.1 to 1, as a part of the dissipation, and the dissipated part of the energy. "
             "The first step is one of backward Euler, which takes energy of its own from the shortest waves.")
    lab.table(("material", *(f"dt = {dt}" for dt in sizes), "dissipated"), rows, "balance")


def study(lab):
    waves(lab)
    creep(lab)
    spin(lab)
    balance(lab)


def explicit(lab):
    """The decaying waves with short steps, against the exact roots; with rkl2 an overdamped one with steps that
    viscosity alone would not allow."""
    for name in ("shear, k = 2 pi, eta = 0.01", "pressure, k = 2 pi, eta = 0.01"):
        text, viscous, elastic, k = WAVES[name]
        exact = ordered(roots(viscous, elastic, k))
        run = lab.run(name, text, steps(2 * numpy.pi / abs(exact[0]) / 400, 1200, 20))
        error = numpy.abs(ordered(measured(run, exact)) - exact).max() / abs(exact[0])
        lab.expect(f"{name}: error of s", "<= 0.01 %", f"{100 * error:.2g} %", error <= 1e-4)
    if lab.scheme == "rkl2":  # which takes the viscosities of the solid and of the fluid apart
        text, end = box("displacement_x", [0, 1], 0.5, viscosity=1.0), 4.0
        runs = [lab.run(f"overdamped shear, eta = 1, safety {safety}", text, [
            f"time.end={end}", f"output.fields.times=[1,{end}]", f"time.safety={safety}"]) for safety in (0.9, 0.45)]
        slow = max(roots(1.0, SHEAR, 2 * numpy.pi).real)  # from t = 1 on there is no other
        errors = [abs(u[1] / u[0] / numpy.exp(slow * (end - 1)) - 1) for _, u in map(motion, runs)]
        lab.expect("overdamped shear, eta = 1, from t = 1 to 4", "within 1 %", f"{100 * errors[0]:.2g} %", errors[0] <= 0.01)
        lab.expect("the same with half of the steps' length, over that", "<= 1/4 + 10 %", f"{errors[1] / errors[0]:.3f}",
                   errors[1] <= 0.275 * errors[0])
        steps_taken, viscous = runs[0].history["step"][-1], end * 4 / 3 / (0.5 / 48)**2
        lab.expect("its steps, as a part of those that a viscous bound 1/(4/3 eta/h^2) would ask for", "<= 0.05",
                   f"{steps_taken / viscous:.2g}", steps_taken <= 0.05 * viscous)
