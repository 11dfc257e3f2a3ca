"""Standing elastic waves: frequency and numerical damping.

A box of solid with slip sides carries the standing waves of the linear theory exactly: with potentials
phi = cos(k x) cos(l y) (pressure wave, u = grad phi) and psi = sin(k x) sin(l y) (shear wave, u = (psi_y, -psi_x)) the
normal displacement and the tangential traction vanish on all sides. They oscillate with c |(k, l)|,
c_p^2 = E (1 - nu)/((1 + nu)(1 - 2 nu)), c_s^2 = E/(2 (1 + nu)) (E: young, per density). A shear wave u_x(y) also fits
between periodic sides under a free top. The amplitude is 1e-6: what Saint Venant-Kirchhoff adds to the linear theory is
of that size.

The frequency is fitted to (elastic - kinetic energy), cos(2 w t) for one wave, decay to the displacement at every step.
What the time scheme makes of e^(i w t) follows from its recurrence (Jansen, Whiting, Hulbert 2000): with
y' = i w y the amplification factor is an eigenvalue of a 2 x 2 matrix; for rho_inf = 1 it gives tan(w' dt/2) = w dt/2,
which is used to take the error of time out where the error of space is shown: order 2 p for a spline of degree p."""

from math import factorial

import numpy

import _measure
import _shape
from _case import case, sides

MINUTES = {"quick": 0.1, "full": 0.1}
AMPLITUDE = 1e-6
PI = numpy.pi


def box(*waves):
    return case("A standing wave in a box of solid.", "wave",
                domain=dict(size=[1.0, 0.5], elements=[24, 12]),
                substrate=dict(thickness=0.5, young=1.0, poisson=0.3),
                wave=[dict(field=field, amplitude=AMPLITUDE * part, mode=mode) for field, part, mode in waves],
                boundary=sides("slip"),
                time=dict(rho_inf=1.0, end=1.0, tolerance=1e6),
                solver=dict(newton=dict(rtol=1e-9, atol=1e-20), krylov=dict(rtol=1e-4)))


# name: (case, further settings, wave number, is a pressure wave); L = 1, H = 1/2: (k, l) = pi (m, 2 n)
PERIODIC = ["boundary.left=periodic", "boundary.right=periodic", "boundary.top=free"]
OBLIQUE = PI * numpy.hypot(1, 2)
WAVES = {
    "P along x": (box(("displacement_x", 1, (1, 0))), [], PI, True),
    "P along y": (box(("displacement_y", 1, (0, 1))), [], 2 * PI, True),
    "S across y, free top": (box(("displacement_x", 1, (0, 1))), PERIODIC, 2 * PI, False),
    "P oblique": (box(("displacement_x", 1, (1, 1)), ("displacement_y", 2, (1, 1))), [], OBLIQUE, True),
    "S oblique": (box(("displacement_x", 2, (1, 1)), ("displacement_y", -1, (1, 1))), [], OBLIQUE, False),
    "P oblique, from velocity": (box(("velocity_x", 1, (1, 1)), ("velocity_y", 2, (1, 1))), [], OBLIQUE, True),
}


def speed(poisson, pressure):
    return numpy.sqrt((1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) if pressure else 0.5 / (1 + poisson))


def steps(dt, count, *more):
    """Settings for `count` steps of the size dt."""
    return [f"time.dt_initial={dt:.17g}", f"time.dt_max={dt:.17g}", f"time.end={count * dt:.17g}", *more]


def measured(run, omega):
    """-b + i w of a run whose wave has about the frequency omega, after the first step, one of backward Euler."""
    rows = run.history
    difference = rows["energy_elastic"] - rows["energy_kinetic"]
    return _shape.damped_wave(rows["t"][1:], difference[1:], 2j * omega, drift=False)[0] / 2


def frequencies(lab):
    ratios = (0.3,) if lab.quick else (0.0, 0.3, 0.45, 0.49)
    wanted, exact = {}, {}
    for name, (text, settings, number, pressure) in WAVES.items():
        for poisson in ratios:
            label = f"{name}, nu = {poisson}"
            exact[label] = speed(poisson, pressure) * number
            wanted[label] = (text, [*settings, f"substrate.poisson={poisson}", *steps(2 * PI / exact[label] / 60, 180)])
    rows, worst = [], 0.0
    for label, run in lab.runs(wanted).items():
        found = measured(run, exact[label]).imag
        rows.append((label, exact[label], found, f"{100 * (found / exact[label] - 1):+.3f} %"))
        worst = max(worst, abs(found / exact[label] - 1))
    lab.title("Frequencies")
    lab.text("24 x 12 elements of degree 2, 60 steps a period, three periods, rho_inf = 1. The scheme alone makes the "
             f"frequency {100 * (_measure.scheme(1j, 2 * PI / 60, 1).imag - 1):+.3f} %.")
    lab.table(("wave", "c k", "measured", "off"), rows, "frequencies")
    lab.expect("largest error of a frequency", "<= 1 %", f"{100 * worst:.2g} %", worst <= 0.01)


def mesh_orders(lab):
    text, _, number, pressure = WAVES["P along x"]
    omega, meshes = speed(0.3, pressure) * number, (4, 8) if lab.quick else (4, 8, 16)
    dt = 2 * PI / omega / 40
    labels = {(p, n): f"degree {p}, {n} elements" for p in (2, 3) for n in meshes}
    runs = lab.runs({label: (text, [f"domain.degree={p}", f"domain.elements=[{n},4]", *steps(dt, 200)])
                     for (p, n), label in labels.items()})
    errors = {key: 2 / dt * numpy.tan(0.5 * dt * measured(runs[label], omega).imag) / omega - 1 for key, label in labels.items()}
    orders = {(p, n): numpy.log2(errors[p, n // 2] / errors[p, n]) for p, n in errors if (p, n // 2) in errors}
    lab.title("Frequency over the mesh")
    lab.text("The pressure wave along x on n elements (half a wave length), the error of the time scheme taken out.")
    lab.table(("degree", "n", "relative error", "order"),
              [(p, n, f"{e:.2e}", f"{orders[p, n]:.2f}" if (p, n) in orders else "") for (p, n), e in errors.items()], "mesh")
    for p in (2, 3):
        order = orders[p, meshes[-1]]
        lab.expect(f"order of the frequency, degree {p}", f"{2 * p} +- 0.3", f"{order:.2f}", abs(order - 2 * p) <= 0.3)


def damped(run, omega, dt):
    """-b + i w of the displacement at the middle of the top, without the first ten steps, in which the
    scheme forgets its start."""
    walls = run.output.interface
    middle = [wall["displacement_x"][wall["x_reference"] == 0.5][0] for wall in walls.values()]
    return _shape.damped_wave(numpy.array(list(walls))[10:], numpy.array(middle)[10:], 1j * omega, drift=False)[0]


def damping(lab):
    text, _, number, pressure = WAVES["P along x"]
    omega = speed(0.3, pressure) * number
    wanted = {(r, n): 2 * PI / omega / n for r in (0.0, 0.5, 1.0) for n in ((20,) if lab.quick else (10, 20, 40))}
    names = {key: f"rho_inf = {key[0]}, {key[1]} steps a period" for key in wanted}
    runs = lab.runs({names[r, n]: (text, ["domain.elements=[24,4]", f"time.rho_inf={r}", *steps(dt, 4 * n), "output.fields.times="
                                         f"{[round(i * dt, 12) for i in range(4 * n)]}"]) for (r, n), dt in wanted.items()})
    rows, worst = [], 0.0
    for (r, n), name in names.items():
        found, theory = damped(runs[name], omega, wanted[r, n]), _measure.scheme(1j * omega, wanted[r, n], r)
        lost, expected = (1 - numpy.exp(2 * PI / omega * x.real) for x in (found, theory))
        rows.append((r, n, f"{100 * lost:.3f} %", f"{100 * expected:.3f} %", f"{100 * (found.imag / omega - 1):+.3f} %",
                     f"{100 * (theory.imag / omega - 1):+.3f} %"))
        worst = max(worst, abs(found - theory) / omega)
    lab.title("Numerical damping")
    lab.text("Amplitude lost in a period and change of the frequency, measured and from the recurrence of the scheme.")
    lab.table(("rho_inf", "steps a period", "lost", "theory", "frequency", "theory"), rows, "damping")
    lab.expect("decay and frequency against the recurrence", "<= 1e-5 w", f"{worst:.1e} w", worst <= 1e-5)


def time_orders(lab):
    lab.title("Order in time of the wave itself")
    lab.text("Displacement at the middle of the top after 0.55 periods, against the semi-discrete wave (fine steps, "
             "rho_inf = 1, extrapolated).")
    omega, rows = speed(0.3, True) * PI, []
    end = 0.55 * 2 * PI / omega
    counts, fine = ((16, 32), 128) if lab.quick else ((16, 32, 64, 128), 512)

    def displacement(run):
        wall = _measure.interface(run.folder)
        return wall["displacement_x"][len(wall["displacement_x"]) // 2] / AMPLITUDE

    for start, text in (("displacement", box(("displacement_x", 1, (1, 0)))), ("velocity", box(("velocity_x", omega, (1, 0))))):
        def settings(r, n):
            return ["domain.elements=[24,4]", f"time.rho_inf={r}", *steps(end / n, n), f"output.fields.times=[{end:.17g}]"]
        wanted = {f"{start}, rho_inf = {r}, {n} steps": (text, settings(r, n)) for r in (0.0, 0.5, 1.0) for n in counts}
        wanted |= {f"{start}, {n} steps": (text, settings(1.0, n)) for n in (fine // 2, fine)}
        runs = lab.runs(wanted)
        coarse, best = (displacement(runs[f"{start}, {n} steps"]) for n in (fine // 2, fine))
        exact = best + (best - coarse) / 3
        for r in (0.0, 0.5, 1.0):
            errors = [abs(displacement(runs[f"{start}, rho_inf = {r}, {n} steps"]) - exact) for n in counts]
            order = numpy.log2(errors[-2] / errors[-1])
            rows.append((start, r, *(f"{e:.1e}" for e in errors), f"{order:.2f}"))
            lab.expect(f"order in time, start from {start}, rho_inf = {r}", ">= 1.7", f"{order:.2f}", order >= 1.7)
    lab.table(("start", "rho_inf", *(f"{n} steps" for n in counts), "order"), rows, "time")


def study(lab):
    frequencies(lab)
    mesh_orders(lab)
    damping(lab)
    time_orders(lab)


def explicit(lab):
    """Frequencies on 48 x 24 elements, nu = 0.3; decay and frequency with long steps against the
    scheme's own."""
    worst = ("", 0.0)
    for name, (text, settings, number, pressure) in WAVES.items():
        omega = speed(0.3, pressure) * number
        run = lab.run(name, text, [*settings, "domain.elements=[48,24]", *steps(2 * PI / omega / 120, 360)])
        worst = max(worst, (name, abs(measured(run, omega).imag / omega - 1)), key=lambda pair: pair[1])
    lab.expect("largest error of a frequency", "<= 1 %", f"{100 * worst[1]:.2g} %, {worst[0]}", worst[1] <= 0.01)
    text, _, number, _ = WAVES["P along x"]
    omega, found = speed(0.3, True) * number, {}
    times = [round(2 * PI / omega / 16 * i, 12) for i in range(64)]
    for n in (32, 64, 96):
        dt = 2 * PI / omega / n
        found[n] = damped(lab.run(f"{n} steps a period", text, [
            "domain.elements=[6,4]", "time.mass=lumped", *steps(dt, 4 * n), f"output.fields.times={times}"]), omega, dt)
    # Against the finest steps: what other waves, which lumped masses set off, do to the fit is in both. But the longest
    # steps damp these waves, and a part of that stays. Kick, drift, kick does not damp them, and turns them by other
    # angles.
    for n, bound in ((32, 4e-5 if lab.scheme == "kick_drift" else 1e-5), (64, 1e-5)):
        theory = [by_scheme(found[96].imag, 2 * PI / omega / m, lab.scheme) for m in (n, 96)]
        error, lost = abs(found[n] - found[96] - (theory[0] - theory[1])) / omega, 1 - numpy.exp(2 * PI / omega * found[n].real)
        lab.expect(f"{n} steps a period: decay and frequency against the scheme's", f"<= {bound:g} w",
                   f"{error:.1e} w, lost {100 * lost:.2g} % a period", error <= bound)


def by_scheme(omega, dt, scheme):
    """-b + i w of a wave of the frequency omega under steps of a scheme. ssp_rk3 and rkl2 multiply it by the sum of z^k
    / k! to k = 3, z = i omega dt. Kick, drift, kick keeps its amplitude and turns it by 2 asin(omega dt / 2)."""
    if scheme == "kick_drift":
        return 2j / dt * numpy.arcsin(omega * dt / 2)
    return numpy.log(sum((1j * omega * dt)**k / factorial(k) for k in range(4))) / dt
