"""Standing sound waves in each phase: dispersion by capillarity, damping by viscosity.

Exact: with rho = rho_0 + R cos(kx), v = V sin(kx) the linearised equations are
    s R + rho_0 k V + eps k^2 G R = 0,   s rho_0 V = rho_0 k G R - (4/3) m k^2 V,   G = W''(rho_0) + g^2 k^2,
so (s + eps k^2 G)(s + (4/3)(m/rho_0) k^2) + rho_0 k^2 G = 0: frequency^2 = c^2 k^2 + rho_0 g^2 k^4 less the damping,
since c^2 = rho_0 W''; 4/3 = 2 - 2/3. eps is the stabilisation, switched off here. The fluid starts at rest in density
with a wave of the velocity; the x-momentum of an odd mode is V (2/k) rho_0 per height, and -b + i w is fitted to it.

Generalized-alpha damps a little itself. What it makes of the exact s at the step of the run follows from its recurrence
(as in the study elastic_waves). The damping measured is compared with it, and asked for as closely as the frequency:
1 %. The wave of theta = 0.39, liquid, mode 1 shows the difference: there the scheme adds 4 %. The first ten steps are
left out: the first is one of backward Euler, and what it sets off in the second root of the scheme falls to 0.2 with
each step (rho_inf = 0.5)."""

import _measure
import _shape
import numpy
from _case import case, fields
from plane_interface import PlaneInterface

MINUTES = {"quick": 0.1, "full": 0.2}
CASE = case("A standing sound wave in one phase, in a channel between slip sides.", "sound",
            domain=dict(size=[1.0, 0.0625], elements=[64, 4]),
            fluid=dict(viscosity=1e-4, capillarity="1/64", temperature=0.85, ambient="liquid", stabilisation=0.0),
            wave=[dict(field="velocity_x", amplitude=1e-5, mode=[1, 0])],
            boundary=dict(top="slip"),
            time=dict(end=1.0, tolerance=1e3),
            output=fields(),
            solver=dict(newton=dict(rtol=1e-8, atol=1e-15)))


def exact(plane, phase, k, g, viscosity):
    """Root with positive imaginary part of the dispersion relation."""
    rho = plane.liquid if phase == "liquid" else plane.vapour
    damping = 2 / 3 * viscosity / rho * k * k
    square = plane.sound_speed(rho)**2 * k * k + rho * g * g * k**4
    return -damping + 1j * numpy.sqrt(square - damping**2)


def settings(theta, phase, mode, viscosity, s, per_period=80, periods=2, elements=64, g=64):
    step = 2 * numpy.pi / s.imag / per_period
    return [f"fluid.temperature={theta}", f'fluid.ambient="{phase}"', f"wave[0].mode=[{mode},0]",
            f"fluid.viscosity={viscosity}", f"time.dt_initial={step:.8g}", f"time.dt_max={step:.8g}",
            f"time.end={periods * per_period * step:.8g}", f"domain.elements=[{elements},4]", f"fluid.capillarity=1/{g}"]


def measure(run, s):
    return _shape.damped_wave(run.history["t"][10:], run.history["momentum_x"][10:], s, drift=False)


def study(lab):
    modes = (1, 9) if lab.quick else (1, 3, 5, 9, 15, 21)
    thetas = (0.85,) if lab.quick else (0.39, 0.85)
    wanted, asked, dampings = {}, {}, {}
    for theta in thetas:
        plane = PlaneInterface(theta)
        for phase in ("liquid", "vapour"):
            viscosity = 1e-4 if phase == "liquid" else 2e-4 * plane.vapour
            for mode in modes:
                label = f"theta = {theta}, {phase}, mode {mode}"
                s = exact(plane, phase, mode * numpy.pi, 1 / 64, viscosity)
                asked[label] = (s, plane, phase, mode * numpy.pi)
                wanted[label] = (CASE, settings(theta, phase, mode, viscosity, s, elements=64 if mode < 10 else 128))
    runs, rows = lab.runs(wanted), []
    for label, run in runs.items():
        s, plane, phase, k = asked[label]
        found, left = measure(run, s)
        theory = _measure.scheme(s, run.history["dt"][1], 0.5)
        dampings[label] = found.real / theory.real - 1
        c = plane.sound_speed(plane.liquid if phase == "liquid" else plane.vapour)
        error = found.imag / s.imag - 1
        lab.expect(f"{label}: frequency", f"{s.imag:.6g} +- 1 %", f"{found.imag:.6g}, {100 * error:+.3f} %", abs(error) <= 0.01)
        rows.append((label, f"{k:.4g}", f"{s.imag / (c * k):.5f}", f"{found.imag / (c * k):.5f}", f"{-s.real:.4g}",
                     f"{-theory.real:.4g}", f"{-found.real:.4g}", f"{left:.0e}"))
    worst = max(dampings, key=lambda label: abs(dampings[label]))
    lab.expect("damping of all waves, with damping by the scheme", "+- 1 %",
               f"at most {100 * dampings[worst]:+.3f} %, {worst}", abs(dampings[worst]) <= 0.01)
    lab.table(("wave", "k", "w/(c k) exact", "w/(c k)", "damping by viscosity, exact", "with damping by the scheme",
               "damping", "misfit"), rows, "dispersion")
    if not lab.quick:
        lab.plot("dispersion", lambda axes: draw(axes, runs, asked))
        steps(lab)


def draw(axes, runs, asked):
    for theta in (0.39, 0.85):
        for phase, colour in (("liquid", "C0"), ("vapour", "C1")):
            mine = [label for label in runs if label.startswith(f"theta = {theta}, {phase}")]
            _, plane, _, _ = asked[mine[0]]
            c, k = plane.sound_speed(plane.liquid if phase == "liquid" else plane.vapour), numpy.linspace(1, 70, 200)
            curve = [exact(plane, phase, x, 1 / 64, 0.0).imag / (c * x) for x in k]
            axes.plot(k, curve, colour, ls="-" if theta == 0.39 else "--", label=f"{phase}, theta = {theta}")
            axes.plot([asked[label][3] for label in mine],
                      [measure(runs[label], asked[label][0])[0].imag / (c * asked[label][3]) for label in mine], colour + "o")
    axes.set(xlabel="k", ylabel="frequency / (c k)", title="lines: exact; dots: softwet")
    axes.legend()


def steps(lab):
    """The error left comes from the time step: second order."""
    lab.title("Convergence in time")
    plane = PlaneInterface(0.85)
    s = exact(plane, "liquid", 9 * numpy.pi, 1 / 64, 1e-4)
    counts, errors = (20, 40, 80, 160), []
    runs = lab.runs({f"{n} steps a period": (CASE, settings(0.85, "liquid", 9, 1e-4, s, per_period=n)) for n in counts})
    for run in runs.values():
        errors.append(measure(run, s)[0].imag / s.imag - 1)
    lab.table(("steps a period", "error of the frequency"), [(n, f"{e:+.2e}") for n, e in zip(counts, errors)], "steps")
    rate = numpy.log2(errors[1] / errors[2])
    lab.expect("order in time, 40 to 80 steps", "2 +- 0.2", f"{rate:.2f}", abs(rate - 2) <= 0.2)


def of_scheme(lab, s, dt):
    """What the scheme makes of the exact root s with steps of dt: kick_drift damps no waves, three stages of third
    order do. rkl2 has its damping before and after these, with the acceleration of the start, and that less between."""
    if lab.scheme == "kick_drift":
        return s
    z = s * dt
    if lab.scheme == "ssp_rk3":
        return numpy.log(1 + z + z**2 / 2 + z**3 / 6) / dt
    turn, decay = abs(z), -2 * z.real  # (displacement times the frequency, velocity)' = ((0, turn), (-turn, -decay)) of these
    kept = numpy.exp(-decay / 2)
    half, between = numpy.eye(3), numpy.zeros((3, 3))  # the third number is the acceleration of the start
    half[1] = 0, kept, (1 - kept) / decay
    between[0, 1], between[1] = turn, (-turn, 0, -1)
    step = half @ (numpy.eye(3) + between + between @ between / 2 + between @ between @ between / 6) @ half
    roots = numpy.log(numpy.linalg.eigvals(step[:2] @ [[1, 0], [0, 1], [-turn, 0]]).astype(complex)) / dt
    return max(roots, key=lambda root: root.imag)


def explicit(lab):
    """The third mode at the temperature 0.85, on 64 elements, and with lumped masses, which err by a part of (k h)^2,
    on 32 too. Damping is compared with the damping of the scheme: the three stages of ssp_rk3 add 0.5 to 0.8 % here."""
    plane, errors = PlaneInterface(0.85), {}
    for phase, viscosity in (("liquid", 1e-4), ("vapour", 2e-4 * PlaneInterface(0.85).vapour)):
        s = exact(plane, phase, 3 * numpy.pi, 1 / 64, viscosity)
        for mass, n, of_frequency, of_damping in (
                ("corrected", 64, 0.0005, 0.0015), ("lumped", 64, 0.01, 0.03), ("lumped", 32, 0.04, 0.03)):
            run = lab.run(f"{phase}, {mass}, {n}", CASE, [*settings(0.85, phase, 3, viscosity, s, elements=n), f"time.mass={mass}"])
            found, theory = measure(run, s)[0], of_scheme(lab, s, run.history["dt"][1])
            errors[mass, n], damping = abs(found.imag / s.imag - 1), found.real / theory.real - 1
            lab.expect(f"{phase}, {mass}: frequency, {n} elements", f"{s.imag:.5g} +- {100 * of_frequency:g} %",
                       f"{100 * errors[mass, n]:.3f} % off", errors[mass, n] <= of_frequency)
            lab.expect(f"{phase}, {mass}: damping, {n} elements", f"{-theory.real:.4g} +- {100 * of_damping:g} %",
                       f"{100 * damping:+.3f} %", abs(damping) <= of_damping)
        order = numpy.log2(errors["lumped", 32] / errors["lumped", 64])
        lab.expect(f"{phase}, lumped: order in h of the error of the frequency", "2 +- 0.3", f"{order:.2f}", abs(order - 2) <= 0.3)
